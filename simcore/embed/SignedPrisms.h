// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cmath>
#include <vector>

#include "simcore/mesh/TriMesh.h"

namespace glenoid {

using Tet4 = std::array<Vec3, 4>;

/// Half space {x : normal·x ≤ offset}; the normal need not be unit.
struct HalfSpace {
  Vec3 normal;
  double offset;
};

/// What `count` half spaces leave of a tetrahedron, as tetrahedra given to `leaf`; they may be wound either way. A cut
/// leaves one tetrahedron or a wedge of three.
template <class Leaf>
void clip(const Tet4& tet, const HalfSpace* cuts, int count, Leaf&& leaf) {
  if (count == 0) return leaf(tet);
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
  if (inside == 0) return;
  if (inside == 4) return clip(tet, cuts + 1, count - 1, leaf);
  const auto cut = [&](int in, int out) -> Vec3 {
    const double t = d[in] / (d[in] - d[out]);
    return tet[in] + t * (tet[out] - tet[in]);
  };
  const int a = order[0], b = order[1], c = order[2], e = order[3];
  if (inside == 1) return clip(Tet4{tet[a], cut(a, b), cut(a, c), cut(a, e)}, cuts + 1, count - 1, leaf);
  std::array<Vec3, 6> wedge;  // triangles 0 1 2 and 3 4 5, edges 0–3, 1–4, 2–5
  if (inside == 2)
    wedge = {tet[a], cut(a, c), cut(a, e), tet[b], cut(b, c), cut(b, e)};
  else
    wedge = {tet[a], tet[b], tet[c], cut(a, e), cut(b, e), cut(c, e)};
  clip(Tet4{wedge[0], wedge[1], wedge[2], wedge[3]}, cuts + 1, count - 1, leaf);
  clip(Tet4{wedge[1], wedge[2], wedge[3], wedge[4]}, cuts + 1, count - 1, leaf);
  clip(Tet4{wedge[2], wedge[3], wedge[4], wedge[5]}, cuts + 1, count - 1, leaf);
}

/// What a closed surface encloses, as a sum over its triangles: each carries the prism below it, down along −Z without
/// end, positive where the triangle looks up (README, "Fill"). Lengths are relative to `origin`, which should be near.
/// Internal to the fill.
class SignedPrisms {
 public:
  SignedPrisms(const TriMesh& closed, const Vec3& origin);

  /// Gives `leaf(sign, piece)` pieces of a tetrahedron, ±1 each, whose signed sum is what the surface encloses of it. An
  /// integral over that is the signed sum of integrals over the pieces. One thread at a time.
  template <class Leaf>
  void visit(const Tet4& tet, Leaf&& leaf) {
    Box3 box;
    for (const Vec3& corner : tet) box.extend(corner);
    for (const int index : near(box)) {
      const double up = m_prisms[index].normal.z() > 0 ? 1 : -1;
      const std::array<HalfSpace, 4> cuts = sidesOf(m_prisms[index], up);
      clip(tet, cuts.data(), 4, [&](const Tet4& piece) { leaf(up, piece); });
    }
  }

 private:
  struct Prism {
    std::array<Vec3, 3> corners;
    Vec3 normal;
    Box3 box;
  };
  static std::array<HalfSpace, 4> sidesOf(const Prism& prism, double up);
  /// Prisms that may reach into the box, ascending.
  const std::vector<int>& near(const Box3& box);
  template <class Function>
  void forEachSquare(const Box3& box, Function&& function);

  std::vector<Prism> m_prisms;
  // Squares of the XY plane with the prisms whose boxes meet them.
  Box3 m_box;
  double m_side = 1;
  int m_count[2] = {1, 1};
  std::vector<std::vector<int>> m_squares;
  std::vector<int> m_seen, m_found;
  int m_query = 0;
};

/// Volume of a tetrahedron whichever way it is wound, m³.
inline double volumeOf(const Tet4& t) { return std::abs((t[1] - t[0]).dot((t[2] - t[0]).cross(t[3] - t[0]))) / 6; }

}  // namespace glenoid
