// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/repair/Thickness.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "simcore/repair/Edges.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

constexpr double kFacing = 0.5;

/// Along `inwards` to the wall behind; HUGE_VAL where none faces away.
double wallBehind(const TriangleTree& tree, const Vec3& from, const Vec3& inwards, double start, double sign) {
  const auto hit = tree.cast(from + start * inwards, inwards);
  if (!hit || sign * hit->normal.dot(inwards) < kFacing) return HUGE_VAL;
  return hit->distance + start;
}

double startOf(const TriMesh& mesh) { return 1e-7 * boundsOf(mesh).diagonal().norm(); }

}  // namespace

std::vector<Vec3> vertexNormals(const TriMesh& mesh) {
  std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
  for (const auto& t : mesh.triangles) {
    const Vec3 n = (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    const double length = n.norm();
    if (!(length > 0)) continue;
    for (int i = 0; i < 3; ++i) {
      const Vec3 a = mesh.vertices[t[(i + 1) % 3]] - mesh.vertices[t[i]], b = mesh.vertices[t[(i + 2) % 3]] - mesh.vertices[t[i]];
      normals[t[i]] += std::atan2(a.cross(b).norm(), a.dot(b)) * n / length;
    }
  }
  for (Vec3& n : normals)
    if (n.norm() > 0) n.normalize();
  return normals;
}

ThicknessReport measureThickness(const TriMesh& mesh, double limit, std::size_t most) {
  ThicknessReport report;
  const std::size_t n = mesh.triangles.size();
  if (n == 0) return report;
  const Shells shells = findShells(mesh, sidesOf(mesh.triangles));
  const TriangleTree tree(mesh);
  const double start = startOf(mesh);
  std::vector<double> until(n);
  double total = 0;
  std::vector<Vec3> normals(n);
  for (std::size_t t = 0; t < n; ++t) {
    const auto& c = mesh.triangles[t];
    normals[t] = (mesh.vertices[c[1]] - mesh.vertices[c[0]]).cross(mesh.vertices[c[2]] - mesh.vertices[c[0]]);
    total += normals[t].norm() / 2;
    until[t] = total;
  }
  std::vector<std::pair<double, double>> found;  // thickness, weight
  const auto ask = [&](std::size_t t, double weight) {
    const double length = normals[t].norm();
    if (!(length > 0)) return;
    const auto& c = mesh.triangles[t];
    const double sign = shells.list[shells.ofTriangle[t]].volume < 0 ? -1 : 1;
    const Vec3 middle = (mesh.vertices[c[0]] + mesh.vertices[c[1]] + mesh.vertices[c[2]]) / 3;
    const double thickness = wallBehind(tree, middle, -sign * normals[t] / length, start, sign);
    if (thickness == HUGE_VAL) return;
    found.push_back({thickness, weight});
    if (thickness < limit) report.thin.push_back(static_cast<int>(t));
  };
  if (n <= most) {
    for (std::size_t t = 0; t < n; ++t) ask(t, normals[t].norm() / 2);
  } else {
    for (std::size_t i = 0; i < most; ++i) {
      const double at = total * (static_cast<double>(i) + 0.5) / static_cast<double>(most);
      const auto t = std::min<std::size_t>(n - 1, static_cast<std::size_t>(std::lower_bound(until.begin(), until.end(), at) - until.begin()));
      ask(t, 1);
    }
  }
  report.thin.erase(std::unique(report.thin.begin(), report.thin.end()), report.thin.end());
  if (found.empty()) return report;
  std::sort(found.begin(), found.end());
  double sum = 0, weight = 0, thin = 0;
  for (const auto& [thickness, w] : found) {
    sum += w;
    if (thickness < limit) thin += w;
  }
  report.thinShare = thin / sum;
  for (const auto& [thickness, w] : found) {
    const double before = weight;
    weight += w;
    if (before < 0.01 * sum && weight >= 0.01 * sum) report.least = thickness;
    if (before < 0.5 * sum && weight >= 0.5 * sum) report.median = thickness;
  }
  return report;
}

std::vector<double> wallBehindVertices(const TriMesh& mesh, const std::vector<Vec3>& normals) {
  const TriangleTree tree(mesh);
  const double start = startOf(mesh);
  std::vector<double> walls(mesh.vertices.size(), HUGE_VAL);
  for (std::size_t v = 0; v < walls.size(); ++v)
    if (normals[v].norm() > 0) walls[v] = wallBehind(tree, mesh.vertices[v], -normals[v], start, 1);
  return walls;
}

}  // namespace glenoid
