// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/CellGrouping.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "simcore/embed/Lattice.h"

namespace glenoid {

namespace {

constexpr double kTolerance = 1e-6;  // of an edge

bool orthogonal(const Mat3& m) {
  for (int k = 0; k < 3; ++k)
    if (std::abs(m.col(k).dot(m.col((k + 1) % 3))) > kTolerance * m.col(k).norm() * m.col((k + 1) % 3).norm()) return false;
  return true;
}

/// Axes of the box of one tetrahedron: edges of a corner one, lines between the middles of opposite edges of a regular one.
std::optional<Mat3> axesOf(const TetMesh& mesh, const std::array<int, 4>& tet) {
  const auto x = [&](int i) { return mesh.nodes[tet[i]]; };
  Mat3 axes;
  bool found = false;
  for (int i = 0; i < 4 && !found; ++i) {
    for (int k = 0; k < 3; ++k) axes.col(k) = x((i + k + 1) % 4) - x(i);
    found = orthogonal(axes);
  }
  if (!found) {
    axes << x(0) + x(1) - x(2) - x(3), x(0) + x(2) - x(1) - x(3), x(0) + x(3) - x(1) - x(2);
    found = orthogonal(axes);
  }
  if (!found || !(axes.colwise().norm().minCoeff() > 0)) return std::nullopt;
  axes.colwise().normalize();
  // In the order and with the signs that turn the frame least.
  for (int k = 0; k < 2; ++k) {
    int best = k;
    for (int o = k + 1; o < 3; ++o)
      if (std::abs(axes(k, o)) > std::abs(axes(k, best)) + kTolerance) best = o;
    axes.col(k).swap(axes.col(best));
    if (axes(k, k) < 0) axes.col(k) = -axes.col(k).eval();
  }
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

/// Distinct values of one coordinate, ascending.
class Planes {
 public:
  Planes(std::vector<double> values, double tolerance) : m_tolerance(tolerance) {
    std::sort(values.begin(), values.end());
    for (const double value : values)
      if (m_values.empty() || value > m_values.back() + tolerance) m_values.push_back(value);
  }
  int placeOf(double value) const {
    return static_cast<int>(std::upper_bound(m_values.begin(), m_values.end(), value + m_tolerance) - m_values.begin()) - 1;
  }
  double at(int place) const { return m_values[place]; }

 private:
  double m_tolerance;
  std::vector<double> m_values;
};

/// Parity and number of the fifth with these corners (a set of bits), or none.
std::optional<int> parityOf(int cornerSet) {
  for (int parity = 0; parity < 2; ++parity)
    for (const auto& five : kFive[parity]) {
      int set = 0;
      for (const int corner : five) set |= 1 << corner;
      if (set == cornerSet) return parity;
    }
  return std::nullopt;
}

}  // namespace

int CellGrouping::neighbour(int cell, const std::array<int, 3>& step) const {
  // Along each axis the other one begins where this ends, ends where this begins, or lies level; sizes may differ, so the
  // one that begins at the wanted corner is taken and its ends are looked at.
  const GroupedCell& from = cells[cell];
  std::array<int, 3> low;
  for (int k = 0; k < 3; ++k) low[k] = step[k] > 0 ? from.high[k] : step[k] < 0 ? from.low[k] - 1 : from.low[k];
  const auto found = byLow.find(low);
  if (found == byLow.end()) return -1;
  const GroupedCell& other = cells[found->second];
  for (int k = 0; k < 3; ++k)
    if ((step[k] < 0 && other.high[k] != from.low[k]) || (step[k] == 0 && other.high[k] != from.high[k])) return -1;
  return found->second;
}

Result<CellGrouping> groupIntoCells(const TetMesh& cut) {
  const auto unusable = [](std::size_t tet, const char* detail) {
    Error error{Fault::Unusable, {}, {"tetrahedra that are no fifths of cells"}, detail};
    error.place.element = static_cast<long>(tet);
    return error;
  };
  if (cut.tets.empty()) return unusable(0, "no tetrahedra");
  const std::optional<Mat3> axes = axesOf(cut, cut.tets[0]);
  if (!axes) return unusable(0, "no box around the first tetrahedron");

  const Vec3 origin = cut.nodes[cut.tets[0][0]];
  std::vector<Vec3> local;
  for (const Vec3& node : cut.nodes) local.push_back(axes->transpose() * (node - origin));
  double edge = (local[cut.tets[0][1]] - local[cut.tets[0][0]]).cwiseAbs().maxCoeff();
  for (const auto& tet : cut.tets) {
    Box3 box;
    for (const int node : tet) box.extend(local[node]);
    edge = std::min(edge, box.sizes().minCoeff());
  }
  if (!(edge > 0)) return unusable(0, "a flat tetrahedron");
  std::vector<Planes> planes;
  for (int k = 0; k < 3; ++k) {
    std::vector<double> values;
    for (const Vec3& x : local) values.push_back(x[k]);
    planes.emplace_back(std::move(values), kTolerance * edge);
  }
  const auto placeOf = [&](const Vec3& x) { return std::array{planes[0].placeOf(x.x()), planes[1].placeOf(x.y()), planes[2].placeOf(x.z())}; };

  CellGrouping grouping;
  grouping.nodes = cut.nodes;
  std::map<std::array<int, 3>, int> nodeAt;
  for (std::size_t n = 0; n < local.size(); ++n) nodeAt.try_emplace(placeOf(local[n]), static_cast<int>(n));
  for (std::size_t t = 0; t < cut.tets.size(); ++t) {
    std::array<int, 3> low = placeOf(local[cut.tets[t][0]]), high = low;
    for (const int node : cut.tets[t]) {
      const auto place = placeOf(local[node]);
      for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], place[k]), high[k] = std::max(high[k], place[k]);
    }
    int set = 0;
    for (const int node : cut.tets[t]) {
      const auto place = placeOf(local[node]);
      int corner = 0;
      for (int k = 0; k < 3; ++k) {
        if (place[k] != low[k] && place[k] != high[k]) return unusable(t, "a node within a box");
        corner |= (place[k] == high[k] ? 1 : 0) << k;
      }
      set |= 1 << corner;
    }
    const std::optional<int> parity = parityOf(set);
    if (!parity) return unusable(t, "not one of the five of its box");
    const auto known = grouping.byLow.find(low);
    if (known != grouping.byLow.end()) {
      const GroupedCell& cell = grouping.cells[known->second];
      if (cell.parity != *parity || cell.high != high) return unusable(t, "boxes that overlap");
      continue;
    }
    GroupedCell cell;
    cell.parity = *parity;
    cell.low = low;
    cell.high = high;
    Vec3 begin, end;
    for (int k = 0; k < 3; ++k) begin[k] = planes[k].at(low[k]), end[k] = planes[k].at(high[k]);
    cell.box = {origin + *axes * begin, *axes, end - begin};
    for (int i = 0; i < 8; ++i) {
      std::array<int, 3> place;
      for (int k = 0; k < 3; ++k) place[k] = i >> k & 1 ? high[k] : low[k];
      const auto [at, isNew] = nodeAt.try_emplace(place, static_cast<int>(grouping.nodes.size()));
      if (isNew)
        grouping.nodes.push_back(cell.box.origin + *axes * Vec3(i & 1, i >> 1 & 1, i >> 2).cwiseProduct(cell.box.edges));
      cell.corners[i] = at->second;
    }
    grouping.byLow[low] = static_cast<int>(grouping.cells.size());
    grouping.cells.push_back(cell);
  }
  return grouping;
}

}  // namespace glenoid
