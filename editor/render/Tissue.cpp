// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/Tissue.h"

#include <Eigen/Eigenvalues>

#include <cmath>

#include "simcore/scene/Joint.h"

namespace glenoid {
namespace {

/// Share of each vertex' triangles that lie in a region of this kind, spread a little so that borders are
/// soft.
std::vector<double> shares(const TriMesh& mesh, const Part& part, const std::string& kind) {
  std::vector<double> inside(mesh.vertices.size(), 0), all(mesh.vertices.size(), 0);
  std::vector<char> member(mesh.triangles.size(), 0);
  for (const Region& region : part.regions) {
    if (region.kind != kind || region.surface != SurfaceKind::Visual) continue;
    for (const int t : trianglesOf(region)) member[t] = 1;
  }
  for (std::size_t t = 0; t < member.size(); ++t)
    for (const int v : mesh.triangles[t]) {
      inside[v] += member[t];
      all[v] += 1;
    }
  for (std::size_t v = 0; v < inside.size(); ++v) inside[v] = all[v] > 0 ? inside[v] / all[v] : 0;
  for (int pass = 0; pass < 2; ++pass) {
    std::vector<double> sum(inside.size(), 0);
    for (const auto& t : mesh.triangles) {
      const double mean = (inside[t[0]] + inside[t[1]] + inside[t[2]]) / 3;
      for (const int v : t) sum[v] += mean;
    }
    for (std::size_t v = 0; v < inside.size(); ++v)
      if (all[v] > 0) inside[v] = sum[v] / all[v];
  }
  return inside;
}

/// A muscle's fibres as a fan: they converge to a point beyond the tendon, in the sheet in which the muscle
/// is widest.
void layFibres(const TriMesh& mesh, Tissue& tissue) {
  Vec3 belly = Vec3::Zero(), tendon = Vec3::Zero();
  double bellyWeight = 1e-12, tendonWeight = 1e-12;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const double share = tissue.vertices[v].tendon;
    tendon += share * mesh.vertices[v];
    tendonWeight += share;
    belly += (1 - share) * mesh.vertices[v];
    bellyWeight += 1 - share;
  }
  belly /= bellyWeight;
  tendon /= tendonWeight;
  const Vec3 apex = tendon + 0.7 * (tendon - belly);
  const double reach = (belly - apex).norm();
  if (!(reach > 1e-6)) return;
  const Vec3 axis = (belly - apex) / reach;
  Mat3 spread = Mat3::Zero();
  for (const Vec3& x : mesh.vertices) {
    const Vec3 d = x - apex, aside = d - d.dot(axis) * axis;
    spread += aside * aside.transpose();
  }
  const Vec3 wide = Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors().col(2);
  const Vec3 thin = axis.cross(wide);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Vec3 d = mesh.vertices[v] - apex;
    TissueVertex& out = tissue.vertices[v];
    // The angle in the fan, as an arc at the belly's distance: bundles keep their number and narrow to the
    // tendon.
    out.across = static_cast<float>(reach * std::atan2(d.dot(wide), std::max(d.dot(axis), 0.05 * reach)));
    out.through = static_cast<float>(d.dot(thin));
    out.along = static_cast<float>(d.dot(axis));
  }
  tissue.fibres = true;
}

}  // namespace

Tissue tissueOf(const TriMesh& mesh, const Part* part) {
  Tissue tissue;
  tissue.vertices.resize(mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    TissueVertex& out = tissue.vertices[v];
    out.across = static_cast<float>(mesh.vertices[v].x());
    out.through = static_cast<float>(mesh.vertices[v].z());
    out.along = static_cast<float>(mesh.vertices[v].y());
  }
  if (!part) return tissue;
  const std::vector<double> tendon = shares(mesh, *part, "tendon"),
                            cartilage = shares(mesh, *part, "cartilage");
  bool anyTendon = false;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    tissue.vertices[v].tendon = static_cast<float>(tendon[v]);
    tissue.vertices[v].cartilage = static_cast<float>(cartilage[v]);
    anyTendon = anyTendon || tendon[v] > 0.5;
  }
  if (part->kind == PartKind::Soft && anyTendon) layFibres(mesh, tissue);
  return tissue;
}

}  // namespace glenoid
