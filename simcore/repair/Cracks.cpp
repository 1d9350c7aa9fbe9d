// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/repair/Cracks.h"

#include <cmath>
#include <set>

#include "simcore/repair/Weld.h"

namespace glenoid {
namespace {

constexpr double kLips = 0.2;      ///< distance of the lips over an edge
constexpr double kLidMost = 0.05;  ///< of the shell's area

double areaOf(const TriMesh& mesh, int a, int b, int c) {
  return (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm() / 2;
}

}  // namespace

RimLid lidOfEars(const TriMesh& mesh, const std::vector<int>& loop) {
  RimLid lid;
  const int n = static_cast<int>(loop.size());
  if (n < 3) return lid;
  std::vector<int> before(n), after(n);
  std::vector<double> cost(n);
  std::set<std::pair<double, int>> ears;  // least area first, then least place, so that the order of a set does not matter
  const auto weigh = [&](int i) { return areaOf(mesh, loop[before[i]], loop[i], loop[after[i]]); };
  for (int i = 0; i < n; ++i) before[i] = (i + n - 1) % n, after[i] = (i + 1) % n;
  for (int i = 0; i < n; ++i) ears.emplace(cost[i] = weigh(i), i);
  for (int left = n; left > 2; --left) {
    const int i = ears.begin()->second, a = before[i], b = after[i];
    lid.triangles.push_back({loop[a], loop[i], loop[b]});
    lid.area += cost[i];
    if (left == 3) break;
    ears.erase(ears.begin());
    after[a] = b, before[b] = a;
    for (const int end : {a, b}) {
      ears.erase({cost[end], end});
      ears.emplace(cost[end] = weigh(end), end);
    }
  }
  return lid;
}

bool isCrack(const TriMesh& mesh, const std::vector<int>& loop, double area) {
  if (loop.size() < 4) return false;
  const double length = lengthOf(mesh, loop), lid = lidOfEars(mesh, loop).area;
  return 2 * lid * static_cast<double>(loop.size()) < kLips * length * length && lid < kLidMost * area;
}

TriMesh zipped(const TriMesh& mesh, long& changed) {
  changed = 0;
  TriMesh out = mesh;
  std::vector<int> becomes(mesh.vertices.size());
  for (std::size_t v = 0; v < becomes.size(); ++v) becomes[v] = static_cast<int>(v);
  const auto sides = sidesOf(mesh.triangles);
  const Shells shells = findShells(mesh, sides);
  std::vector<int> shellOf(mesh.vertices.size(), -1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const int v : mesh.triangles[t]) shellOf[v] = shells.ofTriangle[t];
  for (const auto& loop : openLoops(mesh, sides).loops) {
    const Shell& shell = shells.list[shellOf[loop[0]]];
    if (shell.sheet() || !isCrack(mesh, loop, shell.area)) continue;
    const int n = static_cast<int>(loop.size());
    const auto at = [&](int i) -> const Vec3& { return mesh.vertices[loop[(i + n) % n]]; };
    // Nearest other vertex of the rim that is no neighbour on it, within a share of the edges here.
    std::vector<int> nearest(n, -1);
    for (int i = 0; i < n; ++i) {
      double best = 2 * kLips * std::min((at(i) - at(i - 1)).norm(), (at(i + 1) - at(i)).norm());
      for (int j = 0; j < n; ++j) {
        const int apart = std::min((j - i + n) % n, (i - j + n) % n);
        if (apart < 2) continue;
        if (const double distance = (at(j) - at(i)).norm(); distance < best) best = distance, nearest[i] = j;
      }
    }
    for (int i = 0; i < n; ++i) {
      const int j = nearest[i];
      if (j < i || nearest[j] != i) continue;
      becomes[loop[j]] = loop[i];
      out.vertices[loop[i]] = 0.5 * (at(i) + at(j));
      ++changed;
    }
  }
  if (changed == 0) return mesh;
  std::vector<char> keep(out.triangles.size());
  for (std::size_t t = 0; t < keep.size(); ++t) {
    auto& c = out.triangles[t];
    for (int& corner : c) corner = becomes[corner];
    keep[t] = c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
  }
  return withTriangles(out, keep);
}

}  // namespace glenoid
