// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/Joint.h"

#include <algorithm>

namespace glenoid {

int findPart(const Joint& joint, const std::string& id) {
  const auto it = std::find_if(joint.parts.begin(), joint.parts.end(), [&](const Part& part) { return part.id == id; });
  return it == joint.parts.end() ? -1 : static_cast<int>(it - joint.parts.begin());
}

int findMaterial(const Joint& joint, const std::string& id) {
  const auto it = std::find_if(joint.materials.begin(), joint.materials.end(),
                               [&](const Material& material) { return material.id == id; });
  return it == joint.materials.end() ? -1 : static_cast<int>(it - joint.materials.begin());
}

Appearance appearanceOf(const Joint& joint, const Part& part) {
  const int material = part.materials.empty() ? -1 : findMaterial(joint, part.materials[0].material);
  return material < 0 ? Appearance::Plain : joint.materials[material].appearance;
}

const Cage* findCage(const Joint& joint, const std::string& part) {
  for (const Cage& cage : joint.cages)
    if (cage.part == part) return &cage;
  return nullptr;
}

const Region* findRegion(const Part& part, const std::string& id) {
  for (const Region& region : part.regions)
    if (region.id == id) return &region;
  return nullptr;
}

std::vector<int> trianglesOf(const Region& region) {
  std::vector<int> triangles;
  for (const TriangleRun& run : region.triangles)
    for (int i = 0; i < run.count; ++i) triangles.push_back(run.first + i);
  return triangles;
}

std::vector<TriangleRun> runsOf(std::vector<int> triangles) {
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  std::vector<TriangleRun> runs;
  for (const int triangle : triangles) {
    if (!runs.empty() && runs.back().first + runs.back().count == triangle)
      ++runs.back().count;
    else
      runs.push_back({triangle, 1});
  }
  return runs;
}

double areaOf(const Part& part, const Region& region) {
  const TriMesh& mesh = region.surface == SurfaceKind::Visual ? *part.visual : *part.collision;
  double area = 0;
  for (const int index : trianglesOf(region)) {
    const auto& t = mesh.triangles[index];
    const Vec3& x0 = mesh.vertices[t[0]];
    area += 0.5 * (mesh.vertices[t[1]] - x0).cross(mesh.vertices[t[2]] - x0).norm();
  }
  return area;
}

}  // namespace glenoid
