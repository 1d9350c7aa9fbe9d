// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "simcore/repair/Edges.h"
#include "simcore/repair/Topology.h"

namespace glenoid {
namespace {

int cornerOf(const TriMesh& mesh, int triangle, int vertex) {
  for (int i = 0; i < 3; ++i)
    if (mesh.triangles[triangle][i] == vertex) return 3 * triangle + i;
  return 3 * triangle;
}

struct Leaf {
  double angle;
  const TriangleSide* side;
};

/// Triangles around a crowded edge by their angle about it.
std::vector<Leaf> leavesOf(const TriMesh& mesh, std::span<const TriangleSide> edge) {
  const Vec3 &a = mesh.vertices[edge[0].low], &b = mesh.vertices[edge[0].high];
  const Vec3 e = (b - a).normalized();
  int least = 0;
  e.cwiseAbs().minCoeff(&least);
  const Vec3 u = e.cross(Vec3::Unit(least)).normalized(), v = e.cross(u);
  std::vector<Leaf> leaves;
  for (const TriangleSide& side : edge) {
    Vec3 tip = a;
    for (const int i : mesh.triangles[side.triangle])
      if (i != side.low && i != side.high) tip = mesh.vertices[i];
    leaves.push_back({std::atan2((tip - a).dot(v), (tip - a).dot(u)), &side});
  }
  std::stable_sort(leaves.begin(), leaves.end(), [](const Leaf& x, const Leaf& y) { return x.angle < y.angle; });
  return leaves;
}

}  // namespace

TriMesh withoutCrowdedEdges(const TriMesh& mesh, long& changed) {
  const auto sides = sidesOf(mesh.triangles);
  DisjointSets corners(3 * mesh.triangles.size());
  const auto joinAt = [&](const TriangleSide& s, const TriangleSide& t) {
    for (const int v : {s.low, s.high}) corners.join(cornerOf(mesh, s.triangle, v), cornerOf(mesh, t.triangle, v));
  };
  forEachEdge(sides, [&](std::span<const TriangleSide> edge) {
    if (edge.size() == 2) joinAt(edge[0], edge[1]);
    if (edge.size() <= 2) return;
    // Seen along the edge, a triangle that runs backwards has the inside on the side of growing angles, one that runs
    // forwards on the other: these two belong together when nothing is between them.
    const std::vector<Leaf> leaves = leavesOf(mesh, edge);
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      const TriangleSide &here = *leaves[i].side, &next = *leaves[(i + 1) % leaves.size()].side;
      if (!here.forward && next.forward) joinAt(here, next);
    }
  });
  TriMesh out = mesh;
  std::vector<int> owner(mesh.vertices.size(), -1);  // the set of corners that keeps the vertex
  std::vector<int> vertexOfSet(3 * mesh.triangles.size(), -1);
  for (int c = 0; c < static_cast<int>(3 * mesh.triangles.size()); ++c) {
    const int v = mesh.triangles[c / 3][c % 3], set = corners.root(c);
    if (vertexOfSet[set] < 0) {
      if (owner[v] < 0) {
        owner[v] = set;
        vertexOfSet[set] = v;
      } else {
        vertexOfSet[set] = static_cast<int>(out.vertices.size());
        out.vertices.push_back(mesh.vertices[v]);
      }
    }
    out.triangles[c / 3][c % 3] = vertexOfSet[set];
  }
  changed = static_cast<long>(out.vertices.size() - mesh.vertices.size());
  return out;
}

}  // namespace glenoid
