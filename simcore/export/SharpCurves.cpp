// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/export/SharpCurves.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace glenoid::exporting {
namespace {

// Cosines with a little room, so that a corner of exactly 60° is one.
const double kSharp = std::cos(0.999 * std::numbers::pi / 3), kKnife = std::cos(1.001 * 2 * std::numbers::pi / 3);

using Graph = std::map<int, std::set<int>>;  ///< who is joined to a vertex by a sharp edge

/// `knife`: vertices of edges that are too sharp.
Graph sharpEdges(const TriMesh& surface, std::set<int>& knife) {
  std::map<std::pair<int, int>, std::vector<Vec3>> normals;
  for (const auto& t : surface.triangles) {
    const auto& x = surface.vertices;
    const Vec3 normal = (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).normalized();
    for (int k = 0; k < 3; ++k) normals[std::minmax(t[k], t[(k + 1) % 3])].push_back(normal);
  }
  Graph graph;
  for (const auto& [edge, sides] : normals)
    if (sides.size() == 2 && sides[0].dot(sides[1]) < kSharp) {
      graph[edge.first].insert(edge.second);
      graph[edge.second].insert(edge.first);
      if (sides[0].dot(sides[1]) < kKnife) knife.insert(edge.first);
    }
  return graph;
}

/// Whether two edges of a vertex run more nearly the same way than a mesher can follow.
bool turnsBack(const TriMesh& surface, int vertex, const std::set<int>& joined) {
  for (const int a : joined)
    for (const int b : joined) {
      const Vec3 u = surface.vertices[a] - surface.vertices[vertex], v = surface.vertices[b] - surface.vertices[vertex];
      if (a < b && u.normalized().dot(v.normalized()) > kSharp) return true;
    }
  return false;
}

/// Takes out of the graph what hangs together and cannot be kept.
void dropUnfit(Graph& graph, const TriMesh& surface, const std::set<int>& knife, double least) {
  std::set<int> seen;
  std::vector<int> dropped;
  for (const auto& [start, unused] : graph) {
    if (!seen.insert(start).second) continue;
    std::vector<int> group{start};
    double twice = 0;
    bool unfit = false;
    for (std::size_t i = 0; i < group.size(); ++i) {
      const std::set<int>& joined = graph.at(group[i]);
      unfit = unfit || knife.count(group[i]) || turnsBack(surface, group[i], joined);
      for (const int next : joined) {
        twice += (surface.vertices[next] - surface.vertices[group[i]]).norm();
        if (seen.insert(next).second) group.push_back(next);
      }
    }
    if (unfit || twice < 2 * least) dropped.insert(dropped.end(), group.begin(), group.end());
  }
  for (const int vertex : dropped) graph.erase(vertex);
}

/// From `start` by way of `next` to where the curve ends; its edges leave the graph.
std::vector<int> walk(Graph& graph, const std::set<int>& ends, int start, int next) {
  std::vector<int> curve{start};
  for (int at = start;;) {
    graph[at].erase(next);
    graph[next].erase(at);
    curve.push_back(next);
    if (ends.count(next) || graph[next].empty()) return curve;
    at = next;
    next = *graph[at].begin();
  }
}

}  // namespace

std::vector<std::vector<int>> sharpCurves(const TriMesh& surface, double least) {
  std::set<int> knife;
  Graph graph = sharpEdges(surface, knife);
  dropUnfit(graph, surface, knife, least);
  std::set<int> ends;
  for (const auto& [vertex, joined] : graph)
    if (joined.size() != 2) ends.insert(vertex);
  std::vector<std::vector<int>> curves;
  for (const int end : ends)
    while (!graph[end].empty()) curves.push_back(walk(graph, ends, end, *graph[end].begin()));
  for (auto& [vertex, joined] : graph)  // what is left are rings
    if (!joined.empty()) curves.push_back(walk(graph, ends, vertex, *joined.begin()));
  return curves;
}

}  // namespace glenoid::exporting
