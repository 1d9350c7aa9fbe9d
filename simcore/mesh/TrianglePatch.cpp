// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/TrianglePatch.h"

#include <iterator>
#include <algorithm>
namespace glenoid {
namespace {

std::vector<char> flagsOf(const TriMesh& mesh, const std::vector<int>& set) {
  std::vector<char> flags(mesh.triangles.size(), 0);
  for (const int t : set) flags[t] = 1;
  return flags;
}

std::vector<int> listOf(const std::vector<char>& flags) {
  std::vector<int> set;
  for (std::size_t t = 0; t < flags.size(); ++t)
    if (flags[t]) set.push_back(static_cast<int>(t));
  return set;
}

/// One ring more; false when there was none to add.
bool growOnce(const TriMesh& mesh, std::vector<char>& flags) {
  std::vector<char> touched(mesh.vertices.size(), 0);
  for (std::size_t t = 0; t < flags.size(); ++t)
    if (flags[t])
      for (const int v : mesh.triangles[t]) touched[v] = 1;
  bool grew = false;
  for (std::size_t t = 0; t < flags.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    if (flags[t] || !(touched[corners[0]] || touched[corners[1]] || touched[corners[2]])) continue;
    flags[t] = 1;
    grew = true;
  }
  return grew;
}

}  // namespace

std::vector<int> grown(const TriMesh& mesh, const std::vector<int>& set) {
  std::vector<char> flags = flagsOf(mesh, set);
  growOnce(mesh, flags);
  return listOf(flags);
}

std::vector<int> shrunk(const TriMesh& mesh, const std::vector<int>& set) {
  return inverted(mesh, grown(mesh, inverted(mesh, set)));
}

std::vector<int> connected(const TriMesh& mesh, const std::vector<int>& set) {
  // Pieces by joining vertices, since growing ring by ring would visit the whole mesh for each ring.
  std::vector<int> parent(mesh.vertices.size());
  for (std::size_t v = 0; v < parent.size(); ++v) parent[v] = static_cast<int>(v);
  const auto rootOf = [&parent](int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto& t : mesh.triangles) {
    parent[rootOf(t[1])] = rootOf(t[0]);
    parent[rootOf(t[2])] = rootOf(t[0]);
  }
  std::vector<char> wanted(mesh.vertices.size(), 0);
  for (const int t : set) wanted[rootOf(mesh.triangles[t][0])] = 1;
  std::vector<int> out;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (wanted[rootOf(mesh.triangles[t][0])]) out.push_back(static_cast<int>(t));
  return out;
}

std::vector<int> inverted(const TriMesh& mesh, const std::vector<int>& set) {
  std::vector<char> flags = flagsOf(mesh, set);
  for (char& flag : flags) flag = !flag;
  return listOf(flags);
}

std::vector<int> united(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> out;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
  return out;
}

std::vector<int> common(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> out;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
  return out;
}

std::vector<int> without(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> out;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
  return out;
}

double areaOf(const TriMesh& mesh, const std::vector<int>& set) {
  double area = 0;
  for (const int t : set) {
    const auto& c = mesh.triangles[t];
    const Vec3& a = mesh.vertices[c[0]];
    area += (mesh.vertices[c[1]] - a).cross(mesh.vertices[c[2]] - a).norm() / 2;
  }
  return area;
}

}  // namespace glenoid
