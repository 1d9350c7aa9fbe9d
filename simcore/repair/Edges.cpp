// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/repair/Edges.h"

#include <unordered_map>

#include "simcore/mesh/TriangleOverlap.h"
#include "simcore/repair/Cracks.h"
#include "simcore/spatial/BoxTree.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {

std::vector<TriangleSide> sidesOf(const Triangles& triangles) {
  std::vector<TriangleSide> sides;
  sides.reserve(3 * triangles.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    for (int i = 0; i < 3; ++i) {
      const int a = triangles[t][i], b = triangles[t][(i + 1) % 3];
      if (a != b) sides.push_back({std::min(a, b), std::max(a, b), t, a < b});
    }
  std::sort(sides.begin(), sides.end());
  return sides;
}

Shells findShells(const TriMesh& mesh, const std::vector<TriangleSide>& sides) {
  const std::size_t n = mesh.triangles.size();
  DisjointSets sets(n);
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i].sameEdge(sides[i - 1])) sets.join(sides[i].triangle, sides[i - 1].triangle);
  Shells shells;
  shells.ofTriangle.assign(n, -1);
  for (int t = 0; t < static_cast<int>(n); ++t) {
    const int root = sets.root(t);
    if (root == t) {
      shells.ofTriangle[t] = static_cast<int>(shells.list.size());
      shells.list.emplace_back().first = t;
    }
    shells.ofTriangle[t] = shells.ofTriangle[root];
    Shell& shell = shells.list[shells.ofTriangle[t]];
    ++shell.triangles;
    for (const int v : mesh.triangles[t]) shell.box.extend(mesh.vertices[v]);
  }
  for (std::size_t t = 0; t < n; ++t) {
    Shell& shell = shells.list[shells.ofTriangle[t]];
    const Vec3 middle = shell.box.center();
    const auto& c = mesh.triangles[t];
    const Vec3 a = mesh.vertices[c[0]] - middle, b = mesh.vertices[c[1]] - middle, d = mesh.vertices[c[2]] - middle;
    shell.area += (b - a).cross(d - a).norm() / 2;
    shell.volume += a.dot(b.cross(d)) / 6;
  }
  forEachEdge(sides, [&](std::span<const TriangleSide> edge) {
    Shell& shell = shells.list[shells.ofTriangle[edge[0].triangle]];
    if (edge.size() == 1) {
      ++shell.openEdges;
      shell.openLength += (mesh.vertices[edge[0].low] - mesh.vertices[edge[0].high]).norm();
    }
    shell.crowdedEdges += edge.size() > 2;
  });
  if (std::none_of(shells.list.begin(), shells.list.end(), [](const Shell& shell) { return shell.openEdges > 0 && shell.sheet(); })) return shells;
  // A long crack in a body makes no sheet of it.
  std::unordered_map<int, int> shellOf;
  for (std::size_t t = 0; t < n; ++t)
    for (const int v : mesh.triangles[t]) shellOf.try_emplace(v, shells.ofTriangle[t]);
  for (const auto& loop : openLoops(mesh, sides).loops)
    if (Shell& shell = shells.list[shellOf[loop[0]]]; shell.sheet() && isCrack(mesh, loop, shell.area)) shell.openLength -= lengthOf(mesh, loop);
  return shells;
}

OpenLoops openLoops(const TriMesh& mesh, const std::vector<TriangleSide>& sides) {
  (void)mesh;
  OpenLoops out;
  std::unordered_map<int, int> next;
  std::vector<int> starts;
  long edges = 0;
  forEachEdge(sides, [&](std::span<const TriangleSide> edge) {
    if (edge.size() != 1) return;
    ++edges;
    // The filling runs against the triangle.
    const int from = edge[0].forward ? edge[0].high : edge[0].low, to = edge[0].forward ? edge[0].low : edge[0].high;
    const auto [at, isNew] = next.try_emplace(from, to);
    if (isNew) starts.push_back(from);
    else at->second = -1;  // two ways on: not a simple rim
  });
  std::sort(starts.begin(), starts.end());
  std::unordered_map<int, char> seen;
  long chained = 0;
  for (const int start : starts) {
    std::vector<int> loop;
    int at = start;
    while (at >= 0 && !seen.count(at) && next.count(at) && next[at] >= 0) {
      seen[at] = 1;
      loop.push_back(at);
      at = next[at];
    }
    if (at != start || loop.size() < 3) continue;
    chained += static_cast<long>(loop.size());
    out.loops.push_back(std::move(loop));
  }
  out.unchained = edges - chained;
  return out;
}

double lengthOf(const TriMesh& mesh, const std::vector<int>& loop) {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    length += (mesh.vertices[loop[i]] - mesh.vertices[loop[(i + 1) % loop.size()]]).norm();
  return length;
}

std::vector<int> wantedSigns(const TriMesh& mesh, const Shells& shells) {
  const std::size_t n = shells.list.size();
  std::vector<int> signs(n, 0);
  std::vector<std::unique_ptr<TriangleTree>> trees(n);
  const auto treeOf = [&](std::size_t s) -> const TriangleTree& {
    if (!trees[s]) {
      TriMesh own;
      own.vertices = mesh.vertices;
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (shells.ofTriangle[t] == static_cast<int>(s)) own.triangles.push_back(mesh.triangles[t]);
      trees[s] = std::make_unique<TriangleTree>(own);
    }
    return *trees[s];
  };
  for (std::size_t s = 0; s < n; ++s) {
    if (shells.list[s].sheet()) continue;
    const Vec3 point = mesh.vertices[mesh.triangles[shells.list[s].first][0]];
    int around = 0;
    for (std::size_t o = 0; o < n; ++o) {
      const Shell& other = shells.list[o];
      if (o == s || !other.closed() || other.sheet() || !other.box.contains(shells.list[s].box)) continue;
      around += treeOf(o).inside(point);
    }
    signs[s] = around % 2 ? -1 : 1;
  }
  return signs;
}

std::vector<std::array<int, 2>> selfCuts(const TriMesh& mesh, std::size_t most) {
  std::vector<std::array<int, 2>> pairs;
  if (mesh.triangles.empty()) return pairs;
  std::vector<Box3> boxes(mesh.triangles.size());
  for (std::size_t t = 0; t < boxes.size(); ++t)
    for (const int v : mesh.triangles[t]) boxes[t].extend(mesh.vertices[v]);
  const double tolerance = 1e-12 * boundsOf(mesh).diagonal().norm();
  const BoxTree tree(boxes);
  BoxTree::walkPairs(tree, tree, [&](int a, int b) {
    if (a >= b || pairs.size() >= most || !boxes[a].intersects(boxes[b])) return;
    const auto &s = mesh.triangles[a], &t = mesh.triangles[b];
    if (s[0] == s[1] || s[1] == s[2] || s[2] == s[0] || t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
    if (trianglesCut(mesh, a, b, tolerance)) pairs.push_back({a, b});
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace glenoid
