// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/Fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace glenoid {
namespace {

using Tet4 = std::array<Vec3, 4>;

/// Half space {x : normal·x ≤ offset}; the normal need not be unit.
struct HalfSpace {
  Vec3 normal;
  double offset;
};

double volumeOf(const Tet4& t) {
  return std::abs((t[1] - t[0]).dot((t[2] - t[0]).cross(t[3] - t[0]))) / 6;
}

/// Volume of what `count` half spaces leave of a tetrahedron. A cut leaves one tetrahedron or a wedge of
/// three.
double clippedVolume(const Tet4& tet, const HalfSpace* cuts, int count) {
  if (count == 0) return volumeOf(tet);
  std::array<double, 4> d;
  std::array<int, 4> order;  // inside first
  int inside = 0, outside = 4;
  for (int i = 0; i < 4; ++i) {
    d[i] = cuts->normal.dot(tet[i]) - cuts->offset;
    if (d[i] <= 0)
      order[inside++] = i;
    else
      order[--outside] = i;
  }
  if (inside == 0) return 0;
  if (inside == 4) return clippedVolume(tet, cuts + 1, count - 1);
  const auto cut = [&](int in, int out) -> Vec3 {
    const double t = d[in] / (d[in] - d[out]);
    return tet[in] + t * (tet[out] - tet[in]);
  };
  const int a = order[0], b = order[1], c = order[2], e = order[3];
  if (inside == 1) return clippedVolume({tet[a], cut(a, b), cut(a, c), cut(a, e)}, cuts + 1, count - 1);
  std::array<Vec3, 6> wedge;  // triangles 0 1 2 and 3 4 5, edges 0–3, 1–4, 2–5
  if (inside == 2)
    wedge = {tet[a], cut(a, c), cut(a, e), tet[b], cut(b, c), cut(b, e)};
  else
    wedge = {tet[a], tet[b], tet[c], cut(a, e), cut(b, e), cut(c, e)};
  return clippedVolume({wedge[0], wedge[1], wedge[2], wedge[3]}, cuts + 1, count - 1) +
         clippedVolume({wedge[1], wedge[2], wedge[3], wedge[4]}, cuts + 1, count - 1) +
         clippedVolume({wedge[2], wedge[3], wedge[4], wedge[5]}, cuts + 1, count - 1);
}

/// Volume of the part of a tetrahedron below a triangle, within the triangle's shadow along Z.
double volumeBelow(const Tet4& tet, const std::array<Vec3, 3>& triangle, const Vec3& normal) {
  const double up = normal.z() > 0 ? 1 : -1;
  std::array<HalfSpace, 4> cuts;
  for (int i = 0; i < 3; ++i) {
    const Vec3 &p = triangle[i], edge = triangle[(i + 1) % 3] - p;
    const Vec3 out = up * Vec3(edge.y(), -edge.x(), 0);
    cuts[i] = {out, out.dot(p)};
  }
  cuts[3] = {up * normal, up * normal.dot(triangle[0])};
  return clippedVolume(tet, cuts.data(), 4);
}

}  // namespace

namespace {

struct Prism {
  std::array<Vec3, 3> corners;
  Vec3 normal;
  Box3 box;
};

/// Squares of the XY plane with the prisms whose boxes meet them.
class Squares {
 public:
  explicit Squares(const std::vector<Prism>& prisms) {
    for (const Prism& prism : prisms) m_box.extend(prism.box);
    const double area = std::max(1e-300, m_box.sizes().x() * m_box.sizes().y());
    m_side = std::sqrt(area / (1 + static_cast<double>(prisms.size()) / 8));
    for (int k = 0; k < 2; ++k) m_count[k] = 1 + static_cast<int>(std::min(2000.0, m_box.sizes()[k] / m_side));
    m_lists.resize(static_cast<std::size_t>(m_count[0]) * m_count[1]);
    for (std::size_t p = 0; p < prisms.size(); ++p) forEach(prisms[p].box, [&](auto& list) { list.push_back(static_cast<int>(p)); });
    m_seen.assign(prisms.size(), -1);
  }
  /// Those whose squares meet the box, ascending, into `found`. `query`: another number each time.
  void near(const Box3& box, int query, std::vector<int>& found) {
    found.clear();
    forEach(box, [&](const auto& list) {
      for (const int p : list)
        if (m_seen[p] != query) m_seen[p] = query, found.push_back(p);
    });
    std::sort(found.begin(), found.end());
  }

 private:
  template <class Function>
  void forEach(const Box3& box, Function&& function) {
    int low[2], high[2];
    for (int k = 0; k < 2; ++k) {
      const auto at = [&](double x) {
        return std::clamp(static_cast<int>((x - m_box.min()[k]) / m_side), 0, m_count[k] - 1);
      };
      low[k] = at(box.min()[k]), high[k] = at(box.max()[k]);
    }
    for (int y = low[1]; y <= high[1]; ++y)
      for (int x = low[0]; x <= high[0]; ++x) function(m_lists[static_cast<std::size_t>(y) * m_count[0] + x]);
  }
  Box3 m_box;
  double m_side = 1;
  int m_count[2] = {1, 1};
  std::vector<std::vector<int>> m_lists;
  std::vector<int> m_seen;
};

}  // namespace

std::vector<double> enclosedVolumes(const TetMesh& mesh, const TriMesh& closed) {
  std::vector<double> volumes(mesh.tets.size(), 0.0);
  if (mesh.tets.empty()) return volumes;
  const Vec3 origin = mesh.nodes[mesh.tets[0][0]];  // near the part, to keep digits
  std::vector<Prism> prisms;
  for (const auto& t : closed.triangles) {
    Prism prism;
    for (int i = 0; i < 3; ++i) {
      prism.corners[i] = closed.vertices[t[i]] - origin;
      prism.box.extend(prism.corners[i]);
    }
    const auto& c = prism.corners;
    prism.normal = (c[1] - c[0]).cross(c[2] - c[0]);
    if (prism.normal.z() != 0) prisms.push_back(prism);
  }
  if (prisms.empty()) return volumes;
  Squares squares(prisms);
  std::vector<int> found;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    Tet4 tet;
    Box3 box;
    for (int k = 0; k < 4; ++k) tet[k] = mesh.nodes[mesh.tets[i][k]] - origin, box.extend(tet[k]);
    squares.near(box, static_cast<int>(i), found);
    for (const int index : found) {
      const Prism& p = prisms[index];
      if (p.box.max().x() <= box.min().x() || p.box.min().x() >= box.max().x() ||
          p.box.max().y() <= box.min().y() || p.box.min().y() >= box.max().y() ||
          p.box.max().z() <= box.min().z())
        continue;
      const double below = volumeBelow(tet, p.corners, p.normal);
      volumes[i] += p.normal.z() > 0 ? below : -below;
    }
  }
  return volumes;
}

std::vector<double> fillFractions(const TetMesh& mesh, const TriMesh& closed) {
  const std::size_t n = mesh.tets.size();
  const std::vector<double> enclosed = enclosedVolumes(mesh, closed);
  std::vector<double> fill(n), whole(n);
  double wanted = 0;
  for (std::size_t i = 0; i < n; ++i) {
    whole[i] = std::abs(tetVolume(mesh, static_cast<int>(i)));
    fill[i] = whole[i] > 0 ? std::clamp(enclosed[i] / whole[i], 0.0, 1.0) : 0.0;
    wanted += fill[i] * whole[i];
  }
  // Scaling the rest down may push further ones below the floor, hence the loop; each turn fixes one at
  // least.
  std::vector<char> floored(n, 0);
  double scale = 1;
  for (bool changed = true; changed;) {
    changed = false;
    double fixed = 0, rest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (!floored[i] && scale * fill[i] < kFillFloor) floored[i] = 1, changed = true;
      (floored[i] ? fixed : rest) += floored[i] ? kFillFloor * whole[i] : fill[i] * whole[i];
    }
    scale = rest > 0 ? std::clamp((wanted - fixed) / rest, 0.0, 1.0) : 0.0;
  }
  for (std::size_t i = 0; i < n; ++i) fill[i] = floored[i] ? kFillFloor : scale * fill[i];
  return fill;
}

}  // namespace glenoid
