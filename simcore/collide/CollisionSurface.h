// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// A point of a surface feature: a vertex (count 1), on an edge (2) or in a triangle (3), as a convex
/// combination of surface vertices.
struct FeaturePoint {
  int count = 1;
  std::array<int, 3> vertex{0, 0, 0};
  std::array<double, 3> weight{1, 0, 0};
};

/// Two features of two surfaces that are near each other: one contact constraint.
struct Proximity {
  int pair = 0;                   ///< index of the CollisionPair
  FeaturePoint a, b;              ///< on the pair's first and second surface
  Vec3 normal_W = Vec3::UnitY();  ///< unit, from b to a: gap = normal · (p_a − p_b)
  double gap = 0;                 ///< m; negative when inside
  std::uint64_t key = 0;          ///< unique in a step, same features give the same key in every step
};

/// What is constant about a collision surface: topology, edges, adjacency. Built once at compile time;
/// positions are not kept here. Triangles are counter-clockwise seen from outside. Meant for closed
/// manifold surfaces; an open edge has triangle −1, and an edge of more than two triangles keeps its first
/// two (`closed` says whether either occurs). Triangles without area and repetitions of a triangle are kept in
/// the lists, since others count by them, but carry nothing: they come last at an edge and in no vertex's row.
struct CollisionSurface {
  struct Edge {
    std::array<int, 2> vertices;   ///< ascending
    std::array<int, 2> triangles;  ///< ascending; second is −1 at an open edge
    std::array<int, 2> opposite;   ///< the vertex of each triangle that is not on the edge; −1 if none
  };

  int vertexCount = 0;
  bool deforms = false;                           ///< its edges may bend, so what is flat now may be dented next
  bool closed = false;                            ///< every edge has exactly two triangles, wound alike
  std::vector<std::array<int, 3>> triangles;      ///< indices of vertices
  std::vector<Edge> edges;                        ///< ascending by their vertices
  std::vector<std::array<int, 3>> triangleEdges;  ///< edge k joins corners k and (k+1) mod 3
  std::vector<char> empty;                        ///< a triangle without area at rest, or one that is there already
  std::vector<Vec3> restVertices;                 ///< m, for building trees only
  double size = 0;                                ///< diagonal of its box at rest, m
  /// How thick it is on the whole, m: twice the volume over the area, two thirds of a ball's radius and the whole of a
  /// sheet's thickness; where it encloses nothing, the shortest side of its box. At rest.
  double thickness = 0;

  std::span<const int> trianglesOf(int vertex) const { return row(triangleStart, triangleList, vertex); }
  std::span<const int> edgesOf(int vertex) const { return row(edgeStart, edgeList, vertex); }

  std::vector<int> triangleStart, triangleList;  ///< CSR vertex → triangles, ascending in each row
  std::vector<int> edgeStart, edgeList;          ///< CSR vertex → edges, ascending in each row

 private:
  static std::span<const int> row(const std::vector<int>& start, const std::vector<int>& list, int i) {
    return {list.data() + start[i], static_cast<std::size_t>(start[i + 1] - start[i])};
  }
};

/// Whether a triangle has no area that a normal could be taken from.
bool isFlatTriangle(const Vec3& a, const Vec3& b, const Vec3& c);

/// Indices must lie inside the mesh (MeshHealth says so); anything else is a bug of the caller.
std::shared_ptr<const CollisionSurface> makeCollisionSurface(const TriMesh& mesh, bool deforms = false);

/// Two surfaces that may touch, by their index in the list of surfaces; the same one twice: a surface that may touch itself
/// (SelfRest says which of its features then count). Triangles marked in a skip
/// set take no part: coupling regions, where the parts are glued, and perforations by a portal. A vertex or
/// edge takes part as long as one of its triangles does.
struct CollisionPair {
  int surfaceA = 0, surfaceB = 1;
  std::vector<char> skipTriangleA, skipTriangleB;  ///< one flag for each triangle, or empty: none
  /// Of a surface with itself: which cell of its body drives each vertex (−1: none that is known); empty: no two share one. Features of one cell make
  /// no contact: what lies between them is the cell's own stretch.
  std::vector<int> cellOfVertex = {};

  bool self() const { return surfaceA == surfaceB; }
};

}  // namespace glenoid
