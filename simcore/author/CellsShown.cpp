// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/CellsShown.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glenoid {

namespace {

/// A closed box with `n` by `m` by `n` squares, its top at y = 0, wound outwards.
TriMesh gridBox(double width, double height, int n, int m) {
  TriMesh mesh;
  const auto face = [&](const Vec3& corner, const Vec3& u, const Vec3& v, int nu, int nv) {
    const int first = static_cast<int>(mesh.vertices.size());
    for (int j = 0; j <= nv; ++j)
      for (int i = 0; i <= nu; ++i) mesh.vertices.push_back(corner + u * i / nu + v * j / nv);
    for (int j = 0; j < nv; ++j)
      for (int i = 0; i < nu; ++i) {
        const int a = first + j * (nu + 1) + i, b = a + 1, c = a + nu + 1, d = c + 1;
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({a, d, c});
      }
  };
  const Vec3 low(-width / 2, -height, -width / 2), x(width, 0, 0), y(0, height, 0), z(0, 0, width);
  face(low, x, z, n, n);
  face(low + y, z, x, n, n);
  face(low, z, y, n, m);
  face(low + x, y, z, m, n);
  face(low, y, x, m, n);
  face(low + z, x, y, n, m);
  // Faces meet along equal points.
  std::vector<int> kept(mesh.vertices.size());
  std::vector<Vec3> vertices;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const auto same = std::find_if(vertices.begin(), vertices.end(), [&](const Vec3& v) { return (v - mesh.vertices[i]).norm() < 1e-9 * width; });
    kept[i] = static_cast<int>(same - vertices.begin());
    if (same == vertices.end()) vertices.push_back(mesh.vertices[i]);
  }
  for (auto& triangle : mesh.triangles)
    for (int& corner : triangle) corner = kept[static_cast<std::size_t>(corner)];
  mesh.vertices = std::move(vertices);
  return mesh;
}

/// A layer of 1 kPa glued to a rigid ground.
Joint layerOnGround(double width, double height, double poisson) {
  Joint joint;
  joint.id = "layer";
  Material tissue;
  tissue.id = "tissue";
  tissue.density = 1000;
  tissue.youngsModulus = 1e3;
  tissue.poissonRatio = poisson;
  joint.materials = {tissue};
  Part layer, ground;
  layer.id = "layer";
  layer.number = 1;
  layer.kind = PartKind::Soft;
  layer.materials = {{tissue.id, {}}};
  layer.visual = layer.collision = std::make_shared<const TriMesh>(gridBox(width, height, 24, 6));
  Region base;
  base.id = "base";
  for (std::size_t t = 0; t < layer.visual->triangles.size(); ++t) {
    const auto& c = layer.visual->triangles[t];
    if (std::all_of(c.begin(), c.end(), [&](int v) { return layer.visual->vertices[static_cast<std::size_t>(v)].y() < -0.999 * height; }))
      base.triangles.push_back({static_cast<int>(t), 1});
  }
  layer.regions = {base};
  ground.id = "ground";
  ground.number = 2;
  ground.kind = PartKind::Rigid;
  ground.materials = layer.materials;
  ground.visual = ground.collision = layer.visual;
  Coupling glue;
  glue.id = "glue";
  glue.partA = layer.id;
  glue.partB = ground.id;
  glue.regionA = base.id;
  glue.stiffnessPerArea = 1e6 * tissue.youngsModulus / height;
  joint.parts = {layer, ground};
  joint.couplings = {glue};
  return joint;
}

}  // namespace

double diskCompliance(double modulus, double radius) { return 16 / (3 * std::numbers::pi * std::numbers::pi * modulus * radius); }

Result<std::array<double, DentSample::kRadii>> cellsShown(const GradedCells& cells, const std::array<double, DentSample::kRadii>& radii, double poisson) {
  const double height = 4 * radii.back(), width = 16 * radii.back();
  const Joint joint = layerOnGround(width, height, poisson);
  GradedCells graded = cells;
  graded.coarsest = std::max(cells.coarsest, height / 4);  // as far away as that only stiffness is asked for
  std::array<TipPatch, DentSample::kRadii> patches;
  for (std::size_t k = 0; k < radii.size(); ++k) patches[k] = tipPatchAt(*joint.parts[0].visual, Vec3(1e-4, 0, 2e-4), radii[k]);
  auto mesh = embedGraded(joint.parts[0], patches.front(), graded);
  if (!mesh) return mesh.error();
  const auto part = StaticPart::make(joint, 0, std::make_shared<const TetMesh>(std::move(*mesh)), TetFilling::Whole);
  if (!part) return part.error();
  const double modulus = 1e3 / (1 - poisson * poisson);
  const double alpha = (1.2876 - 1.4678 * poisson + 1.3442 * poisson * poisson) / (1 - poisson);
  const double less = alpha / (std::numbers::pi * modulus * height);
  const std::vector<double> found = part->compliances(patches, {});
  std::array<double, DentSample::kRadii> shares{};
  for (std::size_t k = 0; k < radii.size(); ++k) shares[k] = std::clamp((found[k] + less) / diskCompliance(modulus, radii[k]), 0.5, 1.0);
  return shares;
}

}  // namespace glenoid
