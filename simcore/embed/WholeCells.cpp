// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/WholeCells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "simcore/embed/CellGrouping.h"
#include "simcore/embed/Lattice.h"
#include "simcore/embed/SignedPrisms.h"
#include "simcore/mesh/TetTools.h"

namespace glenoid {

namespace {

/// Below this share of its cell a sliver may go to a neighbour that holds at least twice as much.
constexpr double kSliver = 0.1;
/// How far beyond the neighbour, in halves of its edge, a sliver may reach: √3 standard deviations from its middle, which
/// is where an even slab ends.
constexpr double kReach = 0.4;
constexpr double kNothing = 1e-9;  ///< share of a cell

/// ∫ over a tetrahedron of the polynomials of BoxMoments, exactly: Gauss and Legendre with 5, 4 and 4 points on the
/// collapsed cube (Stroud, "Approximate Calculation of Multiple Integrals", 1971).
void addMoments(const CellBox& box, const Tet4& tet, double sign, BoxMoments& moments) {
  constexpr double x5[5] = {-0.90617984593866399, -0.53846931010568309, 0, 0.53846931010568309, 0.90617984593866399};
  constexpr double w5[5] = {0.23692688505618909, 0.47862867049936647, 0.56888888888888889, 0.47862867049936647, 0.23692688505618909};
  constexpr double x4[4] = {-0.86113631159405258, -0.33998104358485626, 0.33998104358485626, 0.86113631159405258};
  constexpr double w4[4] = {0.34785484513745386, 0.65214515486254614, 0.65214515486254614, 0.34785484513745386};
  std::array<Vec3, 4> xi;
  for (int i = 0; i < 4; ++i) xi[i] = box.coordinatesOf(tet[i]);
  const double six = sign * 6 * volumeOf(tet) / 8;  // an eighth: each axis is mapped from a length of two
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k) {
        const double u = 0.5 * (1 + x5[i]), v = 0.5 * (1 + x4[j]), w = 0.5 * (1 + x4[k]);
        const Vec3 p = xi[0] + u * (xi[1] - xi[0] + v * (xi[2] - xi[1] + w * (xi[3] - xi[2])));
        const double weight = six * w5[i] * w4[j] * w4[k] * u * u * v;
        const double z[3] = {weight, weight * p.z(), weight * p.z() * p.z()};
        for (int c = 0; c < 3; ++c)
          for (int b = 0; b < 3; ++b) {
            const double yz = b == 0 ? z[c] : b == 1 ? z[c] * p.y() : z[c] * p.y() * p.y();
            double* value = &moments.value[3 * b + 9 * c];
            value[0] += yz;
            value[1] += yz * p.x();
            value[2] += yz * p.x() * p.x();
          }
      }
}

/// Moments of what the surface encloses in each of a cell's five tetrahedra.
std::vector<BoxMoments> tissueOf(const CellGrouping& grouping, const TriMesh& closed) {
  const Vec3 origin = grouping.cells[0].box.origin;
  SignedPrisms prisms(closed, origin);
  std::vector<BoxMoments> tissue;
  for (const GroupedCell& cell : grouping.cells) {
    CellBox box = cell.box;
    box.origin -= origin;
    for (int five = 0; five < 5; ++five) {
      Tet4 tet;
      for (int i = 0; i < 4; ++i) {
        const int corner = kFive[cell.parity][five][i];
        tet[i] = box.origin + box.axes * Vec3(corner & 1, corner >> 1 & 1, corner >> 2).cwiseProduct(box.edges);
      }
      double inside = 0;
      prisms.visit(tet, [&](double sign, const Tet4& piece) { inside += sign * volumeOf(piece); });
      const double whole = volumeOf(tet);
      BoxMoments& moments = tissue.emplace_back();
      if (inside > (1 - 1e-12) * whole && inside < (1 + 1e-12) * whole)
        addMoments(box, tet, 1, moments);
      else if (inside > 1e-12 * whole)
        prisms.visit(tet, [&](double sign, const Tet4& piece) { addMoments(box, piece, sign, moments); });
    }
  }
  return tissue;
}

BoxMoments sumOf(const std::vector<BoxMoments>& tissue, std::size_t cell) {
  BoxMoments sum;
  for (int five = 0; five < 5; ++five) sum += tissue[5 * cell + five];
  return sum;
}

/// The neighbour that takes a sliver: of those it hardly reaches beyond the fullest, by faces, then edges, then corners.
std::optional<int> hostOf(const CellGrouping& grouping, const std::vector<BoxMoments>& all, int cell) {
  const GroupedCell& sliver = grouping.cells[cell];
  std::optional<int> best;
  double bestShare = 0;
  for (int steps = 1; steps <= 3 && !best; ++steps)
    for (int n = 0; n < 27; ++n) {
      const std::array<int, 3> step{n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
      if (std::abs(step[0]) + std::abs(step[1]) + std::abs(step[2]) != steps) continue;
      const int other = grouping.neighbour(cell, step);
      if (other < 0) continue;
      const GroupedCell& host = grouping.cells[other];
      const double share = all[other].volume() / host.box.edges.prod();
      if (share < std::max(kSliver, 2 * all[cell].volume() / sliver.box.edges.prod()) || share <= bestShare) continue;
      const BoxMoments there = inOtherBox(all[cell], sliver.box, host.box);
      const Vec3 reach = meanOf(there).cwiseAbs() + std::sqrt(3.0) * varianceOf(there).cwiseSqrt();
      if (reach.maxCoeff() > 1 + kReach) continue;
      best = other;
      bestShare = share;
    }
  return best;
}

/// Which of a cell's tetrahedra lies nearest to a place.
int nearestTet(const GroupedCell& cell, const Vec3& p_W) {
  int best = 0;
  double least = 0;
  for (int five = 0; five < 5; ++five) {
    Vec3 middle = Vec3::Zero();
    for (const int corner : kFive[cell.parity][five]) middle += 0.25 * Vec3(corner & 1, corner >> 1 & 1, corner >> 2);
    const double distance = (cell.box.origin + cell.box.axes * middle.cwiseProduct(cell.box.edges) - p_W).squaredNorm();
    if (five == 0 || distance < least) best = five, least = distance;
  }
  return best;
}

/// Five tetrahedra for each cell that stays, and the nodes these need.
CellMesh meshOf(const CellGrouping& grouping, const std::vector<char>& stays, const std::vector<BoxMoments>& tissue) {
  CellMesh cells;
  std::vector<int> number(grouping.nodes.size(), -1);
  for (std::size_t c = 0; c < grouping.cells.size(); ++c)
    if (stays[c])
      for (const int node : grouping.cells[c].corners) number[node] = 0;
  for (std::size_t n = 0; n < number.size(); ++n)
    if (number[n] == 0) number[n] = static_cast<int>(cells.mesh.nodes.size()), cells.mesh.nodes.push_back(grouping.nodes[n]);
  for (std::size_t c = 0; c < grouping.cells.size(); ++c) {
    if (!stays[c]) continue;
    const GroupedCell& cell = grouping.cells[c];
    std::array<int, 8> corners;
    for (int i = 0; i < 8; ++i) corners[i] = number[cell.corners[i]];
    for (int five = 0; five < 5; ++five) {
      std::array<int, 4> tet;
      for (int i = 0; i < 4; ++i) tet[i] = corners[kFive[cell.parity][five][i]];
      cells.mesh.tets.push_back(tet);
      cells.tissue.push_back(tissue[5 * c + five]);
    }
    cells.corners.push_back(corners);
    cells.boxes.push_back(cell.box);
  }
  return cells;
}

int piecesOf(const CellMesh& cells) {
  int count = 0;
  faceComponents(cells.mesh, &count);
  return count;
}

CellMesh cellsOf(const CellGrouping& grouping, const TriMesh& closed) {
  const std::vector<BoxMoments> tissue = tissueOf(grouping, closed);
  const int n = static_cast<int>(grouping.cells.size());
  std::vector<BoxMoments> all;
  for (int c = 0; c < n; ++c) all.push_back(sumOf(tissue, c));

  std::vector<char> stays(n, 1), every(n, 1);
  std::vector<BoxMoments> merged = tissue;
  for (int c = 0; c < n; ++c) {
    const double share = all[c].volume() / grouping.cells[c].box.edges.prod();
    if (share < kNothing) {
      stays[c] = 0;
      continue;
    }
    const std::optional<int> host = share < kSliver ? hostOf(grouping, all, c) : std::nullopt;
    if (!host) continue;
    stays[c] = 0;
    const GroupedCell &from = grouping.cells[c], &to = grouping.cells[*host];
    for (int five = 0; five < 5; ++five) {
      const BoxMoments& part = tissue[5 * c + five];
      if (part.volume() == 0) continue;
      const Vec3 middle = from.box.origin + 0.5 * from.box.axes * (meanOf(part) + Vec3::Ones()).cwiseProduct(from.box.edges);
      merged[5 * *host + nearestTet(to, middle)] += inOtherBox(part, from.box, to.box);
    }
  }
  CellMesh whole = meshOf(grouping, every, tissue), fewer = meshOf(grouping, stays, merged);
  return fewer.boxes.empty() || piecesOf(fewer) > piecesOf(whole) ? whole : fewer;
}

/// How nearly the flat surface's edges are the images of the bent one's, of the band's length. Both sides of a band leave
/// them alike, so of its volume hardly anything is lost; what is, is shared out evenly.
constexpr double kFlatness = 1e-4;

void scaleTo(double volume, std::vector<BoxMoments>& tissue) {
  double sum = 0;
  for (const BoxMoments& moments : tissue) sum += moments.volume();
  if (!(sum > 0) || !(volume > 0)) return;
  for (BoxMoments& moments : tissue)
    for (double& value : moments.value) value *= volume / sum;
}

}  // namespace

Result<CellMesh> wholeCells(const TetMesh& cut, const TriMesh& closed) {
  const Result<CellGrouping> grouping = groupIntoCells(cut);
  if (grouping) return cellsOf(*grouping, closed);
  if (cut.tets.empty() || closed.triangles.empty()) return grouping.error();
  const BandShape band = bandOf(closed);
  TetMesh flat = cut;
  for (Vec3& node : flat.nodes) node = band.flattened(node);
  const Result<CellGrouping> along = groupIntoCells(flat);
  if (!along) return grouping.error();
  CellMesh cells = cellsOf(*along, flattened(band, closed, kFlatness * band.length));
  scaleTo(enclosedVolume(closed), cells.tissue);
  for (Vec3& node : cells.mesh.nodes) node = band.bent(node);
  cells.band = band;
  return cells;
}

}  // namespace glenoid
