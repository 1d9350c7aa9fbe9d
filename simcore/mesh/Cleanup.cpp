// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/Cleanup.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace glenoid {
namespace {

/// Same oriented triangle whatever corner comes first: the lowest index leads.
std::array<int, 3> rotated(std::array<int, 3> t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

}  // namespace

TriMesh weldVertices(const TriMesh& mesh, double tolerance) {
  const int n = static_cast<int>(mesh.vertices.size());
  std::vector<int> parent(n);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  // Sorted along X, only neighbours within the tolerance need comparing. NaN sorts nowhere sensible: left
  // alone.
  std::vector<int> order;
  for (int i = 0; i < n; ++i)
    if (mesh.vertices[i].allFinite()) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const double x = mesh.vertices[a].x(), y = mesh.vertices[b].x();
    return x != y ? x < y : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const Vec3 d = mesh.vertices[order[j]] - mesh.vertices[order[i]];
      if (d.x() > tolerance) break;
      if (d.norm() > tolerance) continue;
      const int a = root(order[i]), b = root(order[j]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  TriMesh welded;
  welded.vertices = mesh.vertices;
  std::set<std::array<int, 3>> seen;
  for (const auto& t : mesh.triangles) {
    const std::array<int, 3> u{root(t[0]), root(t[1]), root(t[2])};
    if (u[0] != u[1] && u[1] != u[2] && u[2] != u[0] && seen.insert(rotated(u)).second)
      welded.triangles.push_back(u);
  }
  return compact(welded);
}

TriMesh compact(const TriMesh& mesh) {
  TriMesh out;
  std::vector<int> number(mesh.vertices.size(), -1);
  for (const auto& t : mesh.triangles)
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) {
      out.triangles.push_back(t);
      for (const int i : t) number[i] = 0;
    }
  for (std::size_t i = 0; i < number.size(); ++i)
    if (number[i] == 0) {
      number[i] = static_cast<int>(out.vertices.size());
      out.vertices.push_back(mesh.vertices[i]);
    }
  for (auto& t : out.triangles)
    for (int& i : t) i = number[i];
  return out;
}

TriMesh reversed(const TriMesh& mesh) {
  TriMesh out = mesh;
  for (auto& t : out.triangles) std::swap(t[1], t[2]);
  return out;
}

}  // namespace glenoid
