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

enum class Keep { Inside, Outside };

/// The cut with one decision for each crowded edge, in the order of the edges.
TriMesh cut(const TriMesh& mesh, const std::vector<TriangleSide>& sides, const std::vector<Keep>& decisions) {
  DisjointSets corners(3 * mesh.triangles.size());
  const auto joinAt = [&](const TriangleSide& s, const TriangleSide& t) {
    for (const int v : {s.low, s.high}) corners.join(cornerOf(mesh, s.triangle, v), cornerOf(mesh, t.triangle, v));
  };
  std::size_t crowded = 0;
  forEachEdge(sides, [&](std::span<const TriangleSide> edge) {
    if (edge.size() == 2) joinAt(edge[0], edge[1]);
    if (edge.size() <= 2) return;
    // Seen along the edge, a triangle that runs backwards has the inside on the side of growing angles, one that runs
    // forwards on the other. Two that follow each other so have nothing but inside between them; the other way round
    // nothing but outside.
    const bool inside = decisions[crowded++] == Keep::Inside;
    const std::vector<Leaf> leaves = leavesOf(mesh, edge);
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      const TriangleSide &here = *leaves[i].side, &next = *leaves[(i + 1) % leaves.size()].side;
      if (here.forward != inside && next.forward == inside) joinAt(here, next);
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
  return out;
}

/// What a cut costs, as a length: rims that are left in bodies, and pieces that enclose nothing.
double costOf(const TriMesh& mesh) {
  double cost = 0;
  for (const Shell& shell : findShells(mesh, sidesOf(mesh.triangles)).list) cost += shell.sheet() ? std::sqrt(shell.area) : shell.openLength;
  return cost;
}

}  // namespace

TriMesh withoutCrowdedEdges(const TriMesh& mesh, long& changed) {
  const auto sides = sidesOf(mesh.triangles);
  // Crowded edges that hang together are decided together.
  std::vector<std::array<int, 2>> crowded;
  forEachEdge(sides, [&](std::span<const TriangleSide> edge) {
    if (edge.size() > 2) crowded.push_back({edge[0].low, edge[0].high});
  });
  DisjointSets chains(mesh.vertices.size());
  for (const auto& edge : crowded) chains.join(edge[0], edge[1]);
  std::vector<int> roots;
  for (const auto& edge : crowded) roots.push_back(chains.root(edge[0]));
  std::vector<int> each = roots;
  std::sort(each.begin(), each.end());
  each.erase(std::unique(each.begin(), each.end()), each.end());
  std::vector<Keep> decisions(crowded.size(), Keep::Inside);
  TriMesh best = cut(mesh, sides, decisions);
  if (!crowded.empty()) {
    double bestCost = costOf(best);
    const auto attempt = [&](int root) {  // −1: all
      std::vector<Keep> other = decisions;
      for (std::size_t i = 0; i < other.size(); ++i)
        if (root < 0 || roots[i] == root) other[i] = Keep::Outside;
      TriMesh tried = cut(mesh, sides, other);
      if (const double cost = costOf(tried); cost < bestCost) {
        bestCost = cost;
        best = std::move(tried);
        decisions = std::move(other);
      }
    };
    constexpr std::size_t kMostChains = 24;  // each attempt looks at the whole surface
    if (each.size() > kMostChains) attempt(-1);
    else for (const int root : each) attempt(root);
  }
  changed = static_cast<long>(best.vertices.size() - mesh.vertices.size());
  return best;
}

}  // namespace glenoid
