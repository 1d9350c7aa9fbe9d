// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simcore/export/ExportJoint.h"
#include "simcore/mesh/TetTools.h"

namespace glenoid {
namespace {

/// Outward normals of the faces opposite to the four corners, as long as twice the face's area.
std::array<Vec3, 4> faceNormals(const std::array<Vec3, 4>& x) {
  constexpr int kFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  std::array<Vec3, 4> normals;
  for (int f = 0; f < 4; ++f) normals[f] = (x[kFaces[f][1]] - x[kFaces[f][0]]).cross(x[kFaces[f][2]] - x[kFaces[f][0]]);
  return normals;
}

double leastDihedral(const std::array<Vec3, 4>& normals) {
  double most = -1;  // cosine of the angle inside: minus that between the outward normals
  for (int f = 0; f < 4; ++f)
    for (int g = 0; g < f; ++g) most = std::max(most, -normals[f].normalized().dot(normals[g].normalized()));
  return std::acos(std::clamp(most, -1.0, 1.0));
}

/// 3 r / R with r = 3 V / A and R from the products of opposite edges (Crelle).
double radiusRatio(const std::array<Vec3, 4>& x, const std::array<Vec3, 4>& normals, double volume) {
  double area = 0;
  for (const Vec3& normal : normals) area += normal.norm() / 2;
  const double a = (x[1] - x[0]).norm() * (x[3] - x[2]).norm(), b = (x[2] - x[0]).norm() * (x[3] - x[1]).norm(),
               c = (x[3] - x[0]).norm() * (x[2] - x[1]).norm();
  const double radius = std::sqrt(std::max(0.0, (a + b + c) * (a + b - c) * (a - b + c) * (b + c - a))) / (24 * volume);
  return radius > 0 ? 9 * volume / (area * radius) : 0;
}

}  // namespace

SolidFigures figuresOf(const Part& part) {
  const TetMesh& mesh = *part.volume;
  SolidFigures figures{part.id, static_cast<long>(mesh.tets.size()), totalVolume(mesh), enclosedVolume(*part.visual), std::numbers::pi, 1};
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    std::array<Vec3, 4> x;
    for (int k = 0; k < 4; ++k) x[k] = mesh.nodes[mesh.tets[t][k]];
    const auto normals = faceNormals(x);
    figures.leastDihedral = std::min(figures.leastDihedral, leastDihedral(normals));
    figures.leastRadiusRatio = std::min(figures.leastRadiusRatio, radiusRatio(x, normals, tetVolume(mesh, static_cast<int>(t))));
  }
  return figures;
}

}  // namespace glenoid
