// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <memory>
#include <span>
#include <tuple>
#include <vector>

#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// Bookkeeping that diagnosis and repairs share. Indices must be valid; triangles that repeat an index have no side
/// there.

/// One side of a triangle; `forward` when it runs from the lower vertex to the higher.
struct TriangleSide {
  int low, high, triangle;
  bool forward;
  bool operator<(const TriangleSide& o) const { return std::tie(low, high, triangle) < std::tie(o.low, o.high, o.triangle); }
  bool sameEdge(const TriangleSide& o) const { return low == o.low && high == o.high; }
};

using Triangles = std::vector<std::array<int, 3>>;

/// All sides, those of one edge beside each other.
std::vector<TriangleSide> sidesOf(const Triangles& triangles);

/// Calls visit(span of the sides) for every edge.
template <class Visit>
void forEachEdge(const std::vector<TriangleSide>& sides, Visit&& visit) {
  for (std::size_t i = 0, end; i < sides.size(); i = end) {
    for (end = i + 1; end < sides.size() && sides[end].sameEdge(sides[i]);) ++end;
    visit(std::span(sides).subspan(i, end - i));
  }
}

/// Sets that grow together; the least member stands for all.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : m_parent(n) {
    for (std::size_t i = 0; i < n; ++i) m_parent[i] = static_cast<int>(i);
  }
  int root(int i) {
    while (m_parent[i] != i) i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }
  bool join(int a, int b) {
    a = root(a), b = root(b);
    m_parent[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<int> m_parent;
};

/// Shell of each triangle (those joined through edges, any number of triangles at one), numbered from 0 in the order of
/// their first triangles. `openEdges`, `area`, `volume` by shell; the volume about the shell's own middle.
struct Shell {
  int first = 0;           ///< triangle
  int triangles = 0;
  long openEdges = 0, crowdedEdges = 0;  ///< of one, of more than two triangles
  double openLength = 0;                 ///< of its rims that are no cracks
  double area = 0, volume = 0;
  Box3 box;
  bool closed() const { return openEdges == 0 && crowdedEdges == 0; }
  /// Nothing that encloses: an open piece with a rim long for its area (a disc has 4π, a ball with a hole next to
  /// nothing, half a ball 2π), or two walls on each other.
  bool sheet() const {
    if (openEdges > 0) return openLength * openLength > 4 * area;
    return 2 * std::abs(volume) < 1e-6 * area * box.diagonal().norm() || !(area > 0);
  }
};
struct Shells {
  std::vector<int> ofTriangle;
  std::vector<Shell> list;
};
Shells findShells(const TriMesh& mesh, const std::vector<TriangleSide>& sides);

/// Loops of open edges as vertices, each in the direction that a filling would have. Edges that do not chain (a vertex
/// with several fans, contrary windings) are left out and counted.
struct OpenLoops {
  std::vector<std::vector<int>> loops;
  long unchained = 0;
};
OpenLoops openLoops(const TriMesh& mesh, const std::vector<TriangleSide>& sides);

double lengthOf(const TriMesh& mesh, const std::vector<int>& loop);

/// Signs +1 or −1 that the volume of each closed shell should have: cavities are those inside an odd number of others.
/// 0 for shells that enclose nothing (sheets).
std::vector<int> wantedSigns(const TriMesh& mesh, const Shells& shells);

/// Pairs of triangles that cut each other, as trianglesCut sees it (touching does not count), ascending; no more than
/// `most` are looked for.
std::vector<std::array<int, 2>> selfCuts(const TriMesh& mesh, std::size_t most = 1'000'000);

}  // namespace glenoid
