// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/CouplingHold.h"

#include <algorithm>
#include <cassert>

#include "simcore/embed/Bind.h"
#include "simcore/mesh/NodePatch.h"
#include "simcore/mesh/TrianglePatch.h"

namespace glenoid {
namespace {

constexpr double kHeldWeight = 0.5;

const TriMesh& surfaceOf(const Part& part, SurfaceKind kind) { return kind == SurfaceKind::Visual ? *part.visual : *part.collision; }

bool reaches(const Part& part, const Region& region) {
  const auto& mesh = region.surface == SurfaceKind::Visual ? part.visual : part.collision;
  if (!mesh) return false;
  const long size = static_cast<long>(mesh->triangles.size());
  return std::all_of(region.triangles.begin(), region.triangles.end(), [&](const TriangleRun& run) {
    return run.first >= 0 && run.count > 0 && static_cast<long>(run.first) + run.count <= size;
  });
}

}  // namespace

bool hasHold(const Joint& joint, const Coupling& coupling) {
  const int a = findPart(joint, coupling.partA), b = findPart(joint, coupling.partB);
  if (a < 0 || b < 0 || a == b || coupling.byNodes() != coupling.regionA.empty()) return false;
  const Part& part = joint.parts[a];
  if (!coupling.byNodes()) {
    const Region* region = findRegion(part, coupling.regionA);
    return region && reaches(part, *region);
  }
  if (part.kind != PartKind::Soft || !part.volume || part.volume->tets.empty()) return false;
  const int size = static_cast<int>(part.volume->nodes.size());
  return std::all_of(coupling.nodesA.begin(), coupling.nodesA.end(), [&](int node) { return node >= 0 && node < size; });
}

HeldSurface heldSurface(const Part& a, const Coupling& coupling, const TetMesh* authored) {
  HeldSurface held;
  if (!coupling.byNodes()) {
    const Region* region = findRegion(a, coupling.regionA);
    assert(region);
    return {region->surface, trianglesOf(*region)};
  }
  const TetMesh* volume = authored ? authored : a.volume.get();
  if (!volume || volume->tets.empty()) return held;
  std::vector<char> picked(volume->nodes.size(), 0);
  for (const int node : coupling.nodesA)
    if (node >= 0 && node < static_cast<int>(picked.size())) picked[node] = 1;
  std::vector<Vec3> centres;
  for (const auto& t : a.visual->triangles) centres.push_back((a.visual->vertices[t[0]] + a.visual->vertices[t[1]] + a.visual->vertices[t[2]]) / 3);
  const std::vector<VertexBinding> bound = bindToTets(*volume, centres);
  for (std::size_t t = 0; t < bound.size(); ++t) {
    double weight = 0;
    for (int k = 0; k < 4; ++k) weight += picked[bound[t].node[k]] ? bound[t].weight[k] : 0;
    if (weight >= kHeldWeight * (1 - 1e-9)) held.triangles.push_back(static_cast<int>(t));
  }
  return held;
}

TriMesh heldMesh(const Part& a, const HeldSurface& held) {
  const TriMesh& source = surfaceOf(a, held.surface);
  TriMesh mesh;
  for (const int triangle : held.triangles) {
    const int first = static_cast<int>(mesh.vertices.size());
    for (const int vertex : source.triangles[triangle]) mesh.vertices.push_back(source.vertices[vertex]);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

double areaOf(const Part& a, const HeldSurface& held) { return areaOf(surfaceOf(a, held.surface), held.triangles); }

std::vector<Vec3> holdPlaces(const Part& a, const Coupling& coupling) {
  if (!coupling.byNodes()) return heldMesh(a, heldSurface(a, coupling)).vertices;
  std::vector<Vec3> places;
  for (const int node : coupling.nodesA) places.push_back(a.volume->nodes[node]);
  return places;
}

double cellEdgeOf(const Part& part) {
  if (part.cellSize > 0) return part.cellSize;
  return part.volume ? meanCellEdge(*part.volume) : 0;
}

}  // namespace glenoid
