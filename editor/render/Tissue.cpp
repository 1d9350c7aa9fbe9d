// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/Tissue.h"

#include <algorithm>
#include <cmath>

#include "editor/render/Fibres.h"
#include "simcore/scene/Joint.h"
#include "simcore/tool/FingerShape.h"

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

/// A muscle passes into its tendon over some way: share of tendon from the distance to the region's border, one half on
/// it, 1 and 0 this far from it. The shader makes streaks of it.
constexpr double kPassage = 0.011;  // m

std::vector<double> feathered(const TriMesh& mesh, const std::vector<char>& someInside, const std::vector<char>& someOutside) {
  std::vector<Vec3> border;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (someInside[v] && someOutside[v]) border.push_back(mesh.vertices[v]);
  std::vector<double> share(mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    double nearest = kPassage * kPassage;
    for (const Vec3& x : border) nearest = std::min(nearest, (x - mesh.vertices[v]).squaredNorm());
    const double part = 0.5 * std::sqrt(nearest) / kPassage;
    share[v] = someInside[v] && someOutside[v] ? 0.5 : someInside[v] ? 0.5 + part : 0.5 - part;
  }
  return share;
}

/// For each vertex whether one of its triangles lies in a region that `chosen` picks, and whether one does not.
template <class Chosen>
void touched(const TriMesh& mesh, const Part& part, Chosen&& chosen, std::vector<char>& someInside, std::vector<char>& someOutside) {
  std::vector<char> member(mesh.triangles.size(), 0);
  for (const Region& region : part.regions)
    if (region.surface == SurfaceKind::Visual && chosen(region))
      for (const int t : trianglesOf(region)) member[t] = 1;
  someInside.assign(mesh.vertices.size(), 0);
  someOutside.assign(mesh.vertices.size(), 0);
  for (std::size_t t = 0; t < member.size(); ++t)
    for (const int v : mesh.triangles[t]) (member[t] ? someInside : someOutside)[v] = 1;
}

/// Middle of what a set of weights holds, and their sum.
struct Middle {
  Vec3 at = Vec3::Zero();
  double weight = 0;
};

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
  // The two ends are the footprints farthest apart; others lie along the sides.
  const std::vector<Middle> ends = footprints(mesh, part);
  double farthest = -1;
  Vec3 from = Vec3::Zero(), end = Vec3::Zero();
  for (std::size_t a = 0; a < ends.size(); ++a)
    for (std::size_t b = a + 1; b < ends.size(); ++b)
      if (const double apart = (ends[a].at - ends[b].at).norm(); apart > farthest)
        farthest = apart, from = ends[a].at, end = ends[b].at;
  return farthest > 0 && layCurvedFibres(mesh, from, end, tissue);
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
  std::vector<double> tendon = shares(mesh, *part, "tendon"), cartilage = shares(mesh, *part, "cartilage");
  std::vector<char> inside, outside;
  if (appearance == Appearance::Muscle) {
    touched(mesh, *part, [](const Region& region) { return region.kind == "tendon"; }, inside, outside);
    tendon = feathered(mesh, inside, outside);
  }
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
      tissue.roughness = 0.58f;
      if (part->materials.size() > 1) {  // the default material lies below, the other one is the skin itself
        touched(mesh, *part, [&](const Region& region) { return region.id == part->materials[1].region; }, inside, outside);
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) tissue.vertices[v].fat = inside[v] ? 0.0f : 1.0f;
      }
      break;
    case Appearance::Plain: break;
  }
  return tissue;
}

void addFinger(const Tool& tool, const TriMesh& look, Tissue& tissue) {
  if (tool.kind != ToolKind::Finger) return;
  tissue.grain = Grain::Finger;
  tissue.roughness = 0.58f;
  for (std::size_t v = 0; v < look.vertices.size(); ++v)
    tissue.vertices[v].nail = static_cast<float>(std::clamp(0.5 + insideNail(tool, look.vertices[v]) / 2e-3, 0.0, 1.0));
}

}  // namespace glenoid
