// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/Tissue.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
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

/// Middle of what a set of weights holds, and their sum.
struct Middle {
  Vec3 at = Vec3::Zero();
  double weight = 0;
};

/// A muscle's fibres as a fan: they converge to a point beyond the end, in the sheet in which the muscle is widest.
/// A band's are parallel: `reach`, from that point to the middle of the muscle, is then far larger than the band.
bool layFibres(const TriMesh& mesh, const Vec3& from, const Vec3& end, double beyond, Tissue& tissue) {
  const Vec3 apex = end + beyond * (end - from);
  const double reach = (from - apex).norm();
  if (!(reach > 1e-6)) return false;
  const Vec3 axis = (from - apex) / reach;
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
    // The angle in the fan, as an arc at the middle's distance: bundles keep their number and narrow to the end.
    out.across = static_cast<float>(reach * std::atan2(d.dot(wide), std::max(d.dot(axis), 0.05 * reach)));
    out.through = static_cast<float>(d.dot(thin));
    out.along = static_cast<float>(d.dot(axis));
  }
  return true;
}

/// Middles of the regions of kind "footprint" on the visual surface, by their number of triangles, largest first.
std::vector<Middle> footprints(const TriMesh& mesh, const Part& part) {
  std::vector<Middle> list;
  for (const Region& region : part.regions) {
    if (region.kind != "footprint" || region.surface != SurfaceKind::Visual) continue;
    Middle& middle = list.emplace_back();
    for (const int t : trianglesOf(region))
      for (const int v : mesh.triangles[t]) {
        middle.at += mesh.vertices[v];
        middle.weight += 1;
      }
    if (middle.weight > 0) middle.at /= middle.weight;
    else list.pop_back();
  }
  std::stable_sort(list.begin(), list.end(), [](const Middle& a, const Middle& b) { return a.weight > b.weight; });
  return list;
}

bool layMuscle(const TriMesh& mesh, const Part& part, Tissue& tissue) {
  Middle belly, tendon;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const double share = tissue.vertices[v].tendon;
    tendon.at += share * mesh.vertices[v];
    tendon.weight += share;
    belly.at += (1 - share) * mesh.vertices[v];
    belly.weight += 1 - share;
  }
  if (!(belly.weight > 0)) return false;
  belly.at /= belly.weight;
  if (tendon.weight > 0.5) return layFibres(mesh, belly.at, tendon.at / tendon.weight, 0.7, tissue);
  const std::vector<Middle> ends = footprints(mesh, part);
  return ends.size() > 1 && layFibres(mesh, belly.at, ends[1].at, 0.7, tissue);
}

bool layBand(const TriMesh& mesh, const Part& part, Tissue& tissue) {
  constexpr double kParallel = 20;  // times the distance between the ends
  const std::vector<Middle> ends = footprints(mesh, part);
  return ends.size() > 1 && layFibres(mesh, ends[0].at, ends[1].at, kParallel, tissue);
}

}  // namespace

Tissue tissueOf(const TriMesh& mesh, const Part* part, Appearance appearance) {
  Tissue tissue;
  tissue.vertices.resize(mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    TissueVertex& out = tissue.vertices[v];
    out.across = static_cast<float>(mesh.vertices[v].x());
    out.through = static_cast<float>(mesh.vertices[v].z());
    out.along = static_cast<float>(mesh.vertices[v].y());
  }
  if (!part) {
    tissue.roughness = 0.28f;
    return tissue;
  }
  const std::vector<double> tendon = shares(mesh, *part, "tendon"),
                            cartilage = shares(mesh, *part, "cartilage");
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    tissue.vertices[v].tendon = static_cast<float>(tendon[v]);
    tissue.vertices[v].cartilage = static_cast<float>(cartilage[v]);
  }
  switch (appearance) {
    case Appearance::Bone:
      tissue.grain = Grain::Bone;
      tissue.roughness = 0.55f;
      tissue.wet = 0.25f;
      break;
    case Appearance::Muscle:
      if (layMuscle(mesh, *part, tissue)) tissue.grain = Grain::Muscle;
      tissue.wet = 0.6f;
      break;
    case Appearance::Tendon:
    case Appearance::Ligament:
      if (layBand(mesh, *part, tissue)) tissue.grain = Grain::Collagen;
      tissue.roughness = 0.36f;
      tissue.wet = 0.8f;
      break;
    case Appearance::Cartilage:
      tissue.roughness = 0.30f;
      tissue.wet = 1;
      break;
    case Appearance::Skin:
      tissue.grain = Grain::Skin;
      tissue.roughness = 0.52f;
      break;
    case Appearance::Plain: break;
  }
  return tissue;
}

}  // namespace glenoid
