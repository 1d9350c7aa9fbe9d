// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/MeshHealth.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include "simcore/mesh/TriangleOverlap.h"

namespace glenoid {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

/// One side of a triangle; `forward` when it runs from the lower vertex to the higher.
struct Side {
  int low, high, triangle;
  bool forward;
  bool operator<(const Side& o) const {
    return std::tie(low, high, triangle) < std::tie(o.low, o.high, o.triangle);
  }
  bool sameEdge(const Side& o) const { return low == o.low && high == o.high; }
};

std::vector<Side> sidesOf(const Triangles& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    for (int i = 0; i < 3; ++i) {
      const int a = triangles[t][i], b = triangles[t][(i + 1) % 3];
      if (a != b) sides.push_back({std::min(a, b), std::max(a, b), t, a < b});
    }
  std::sort(sides.begin(), sides.end());
  return sides;
}

int rootOf(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

void join(std::vector<int>& parent, int a, int b) {
  a = rootOf(parent, a), b = rootOf(parent, b);
  parent[std::max(a, b)] = std::min(a, b);
}

/// Vertices whose triangles fall into several fans. Corners (triangle, vertex) are joined where two triangles
/// share an edge at the vertex; a vertex with two classes of corners is pinched.
int countPinched(const Triangles& triangles, const std::vector<Side>& sides, int vertices) {
  std::vector<int> parent(3 * triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto corner = [&](int t, int v) {
    for (int i = 0; i < 3; ++i)
      if (triangles[t][i] == v) return 3 * t + i;
    return 3 * t;
  };
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i].sameEdge(sides[i - 1]))
      for (const int v : {sides[i].low, sides[i].high})
        join(parent, corner(sides[i].triangle, v), corner(sides[i - 1].triangle, v));
  std::vector<int> fans(vertices, 0);
  for (int c = 0; c < static_cast<int>(parent.size()); ++c)
    if (parent[c] == c) ++fans[triangles[c / 3][c % 3]];
  return static_cast<int>(std::count_if(fans.begin(), fans.end(), [](int n) { return n > 1; }));
}

double diagonalOf(const TriMesh& mesh) {
  const Box3 box = boundsOf(mesh);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

}  // namespace

double meanThickness(const TriMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles)
    area += 0.5 * (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).norm();
  const double volume = enclosedVolume(mesh);
  return volume > 0 && area > 0 ? 2 * volume / area : HUGE_VAL;
}

MeshHealth healthOf(const TriMesh& mesh) {
  MeshHealth health;
  const int n = health.vertices = static_cast<int>(mesh.vertices.size());
  health.triangles = static_cast<int>(mesh.triangles.size());
  for (const Vec3& v : mesh.vertices) health.notFinite += !v.allFinite();
  Triangles good;
  good.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    if (std::all_of(t.begin(), t.end(), [n](int i) { return i >= 0 && i < n; }))
      good.push_back(t);
    else
      ++health.badIndices;

  std::vector<char> used(n, 0);
  const double flat = 1e-9 * diagonalOf(mesh);
  for (const auto& t : good) {
    for (const int i : t) used[i] = 1;
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const double twice = (b - a).cross(c - a).norm();
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    health.area += twice / 2;
    health.volume += a.dot(b.cross(c)) / 6;
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0] || !(twice > flat * longest))
      ++health.degenerateTriangles;
  }
  const int usedVertices = static_cast<int>(std::count(used.begin(), used.end(), 1));
  health.unusedVertices = n - usedVertices;

  const std::vector<Side> sides = sidesOf(good);
  std::vector<int> parent(good.size());
  std::iota(parent.begin(), parent.end(), 0);
  int edges = 0;
  for (std::size_t i = 0, end; i < sides.size(); i = end) {
    for (end = i + 1; end < sides.size() && sides[end].sameEdge(sides[i]); ++end)
      join(parent, sides[end].triangle, sides[i].triangle);
    ++edges;
    if (end - i == 1) ++health.openEdges;
    if (end - i == 2 && sides[i].forward == sides[i + 1].forward) ++health.misorientedEdges;
    if (end - i > 2) ++health.nonManifoldEdges;
  }
  for (int t = 0; t < static_cast<int>(parent.size()); ++t) health.components += parent[t] == t;
  health.nonManifoldVertices = countPinched(good, sides, n);
  if (health.closed() && health.manifold()) {
    const int euler = usedVertices - edges + static_cast<int>(good.size());
    health.genus = health.components - euler / 2;
  }
  return health;
}

Result<Done> requireClosed(const TriMesh& mesh, const std::string& part) {
  const MeshHealth h = healthOf(mesh);
  const auto fail = [&](Fault fault, const std::string& argument, const char* detail) {
    Error error;
    error.fault = fault;
    error.place.part = part;
    error.arguments = {argument};
    error.detail = detail;
    return Result<Done>(error);
  };
  if (h.triangles == 0) return fail(Fault::BadMesh, "no triangles", "surface without triangles");
  if (h.badIndices > 0) {
    for (const auto& t : mesh.triangles)
      for (const int i : t)
        if (i < 0 || i >= h.vertices) {
          Error error{
              Fault::BadIndex, {}, {std::to_string(i), std::to_string(h.vertices)}, "vertex of a triangle"};
          error.place.part = part;
          return error;
        }
  }
  if (h.notFinite > 0) return fail(Fault::NotFinite, std::to_string(h.notFinite), "vertices of a surface");
  if (h.openEdges > 0)
    return fail(Fault::MeshNotClosed, std::to_string(h.openEdges), "surface with open edges");
  if (h.nonManifoldEdges > 0)
    return fail(Fault::BadMesh, std::to_string(h.nonManifoldEdges) + " edges of more than two triangles",
                "surface");
  if (h.misorientedEdges > 0)
    return fail(Fault::BadMesh, std::to_string(h.misorientedEdges) + " edges with contrary winding",
                "surface");
  if (h.nonManifoldVertices > 0)
    return fail(Fault::BadMesh, std::to_string(h.nonManifoldVertices) + " pinched vertices", "surface");
  if (!(h.volume > 0)) return fail(Fault::BadMesh, "encloses no volume or is wound inwards", "surface");
  return Done{};
}

int countSelfIntersections(const TriMesh& mesh) {
  const int n = static_cast<int>(mesh.triangles.size());
  const double tolerance = 1e-12 * diagonalOf(mesh);
  std::vector<Box3> boxes(n);
  for (int t = 0; t < n; ++t)
    for (const int v : mesh.triangles[t]) boxes[t].extend(mesh.vertices[v]);
  // Sweep along the longest axis of the mesh.
  int axis = 0;
  if (n > 0) boundsOf(mesh).diagonal().maxCoeff(&axis);
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const double x = boxes[a].min()[axis], y = boxes[b].min()[axis];
    return x != y ? x < y : a < b;
  });
  int count = 0;
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n && boxes[order[j]].min()[axis] <= boxes[order[i]].max()[axis]; ++j)
      if (boxes[order[i]].intersects(boxes[order[j]]))
        count += trianglesCut(mesh, order[i], order[j], tolerance);
  return count;
}

}  // namespace glenoid
