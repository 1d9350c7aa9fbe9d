// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/Overlaps.h"

#include <algorithm>

#include "simcore/mesh/TetMesh.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/Start.h"
#include "simcore/spatial/Intersect.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

bool excluded(const Joint& joint, const std::string& a, const std::string& b) {
  return std::any_of(joint.exclusions.begin(), joint.exclusions.end(), [&](const Exclusion& e) {
    return (e.partA == a && e.partB == b) || (e.partA == b && e.partB == a);
  });
}

/// Raises depth and place to the deepest vertex of `mesh` inside `solid`.
void deepen(const TriMesh& mesh, const TriangleTree& solid, const Box3& box, Overlap& overlap) {
  for (const Vec3& p : mesh.vertices) {
    if (!box.contains(p) || !solid.inside(p)) continue;
    const double depth = solid.closest(p).distance;
    if (depth <= overlap.depth) continue;
    overlap.depth = depth;
    overlap.deepest_W = p;
  }
}

double leastRatio(const TetMesh& rest, const std::vector<Vec3>& nodes) {
  TetMesh moved{nodes, rest.tets};
  double least = 1;
  for (int tet = 0; tet < static_cast<int>(rest.tets.size()); ++tet)
    least = std::min(least, tetVolume(moved, tet) / tetVolume(rest, tet));
  return least;
}

}  // namespace

std::vector<std::array<int, 2>> pairsThatMayCollide(const Joint& joint) {
  std::vector<std::array<int, 2>> pairs;
  const int n = static_cast<int>(joint.parts.size());
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b)
      if (!excluded(joint, joint.parts[a].id, joint.parts[b].id)) pairs.push_back({a, b});
  return pairs;
}

Result<std::vector<TriMesh>> startSurfaces(const Joint& joint, SurfaceKind kind) {
  std::vector<TriMesh> surfaces;
  for (const Part& part : joint.parts) {
    auto surface = startSurface(joint, part, kind);
    if (!surface) return surface.error();
    surfaces.push_back(std::move(*surface));
  }
  return surfaces;
}

std::vector<Overlap> findOverlaps(const Joint& joint, const std::vector<TriMesh>& surfaces) {
  std::vector<Box3> boxes;
  for (const TriMesh& mesh : surfaces) boxes.push_back(boundsOf(mesh));
  std::vector<std::unique_ptr<TriangleTree>> trees(surfaces.size());
  const auto treeOf = [&](int i) -> const TriangleTree& {
    if (!trees[i]) trees[i] = std::make_unique<TriangleTree>(surfaces[i]);
    return *trees[i];
  };
  std::vector<Overlap> overlaps;
  for (const auto& [a, b] : pairsThatMayCollide(joint)) {
    if (!boxes[a].intersects(boxes[b])) continue;
    Overlap overlap{a, b, intersectingTriangles(surfaces[a], surfaces[b]), 0, Vec3::Zero()};
    deepen(surfaces[a], treeOf(b), boxes[b], overlap);
    deepen(surfaces[b], treeOf(a), boxes[a], overlap);
    if (overlap.cuts.empty() && overlap.depth == 0) continue;
    if (overlap.depth == 0) {
      const auto& t = surfaces[a].triangles[overlap.cuts[0][0]];
      overlap.deepest_W = (surfaces[a].vertices[t[0]] + surfaces[a].vertices[t[1]] + surfaces[a].vertices[t[2]]) / 3;
    }
    overlaps.push_back(std::move(overlap));
  }
  return overlaps;
}

Result<std::vector<Overlap>> overlapsAtStart(const Joint& joint) {
  const auto surfaces = startSurfaces(joint, SurfaceKind::Collision);
  if (!surfaces) return surfaces.error();
  return findOverlaps(joint, *surfaces);
}

bool StartCheck::holds() const { return overlaps.empty() && proof.minVolumeRatio > kLeastVolumeRatio; }

Result<StartCheck> checkStart(const Joint& joint) {
  StartCheck check;
  check.proof.of = startHash(joint);
  check.proof.pairs = static_cast<int>(pairsThatMayCollide(joint).size());
  auto overlaps = overlapsAtStart(joint);
  if (!overlaps) return overlaps.error();
  check.overlaps = std::move(*overlaps);
  for (const Overlap& overlap : check.overlaps) check.proof.cuts += static_cast<int>(overlap.cuts.size());
  const auto visual = startSurfaces(joint, SurfaceKind::Visual);
  if (!visual) return visual.error();
  for (const auto& [a, b] : pairsThatMayCollide(joint))
    check.proof.visualCuts += static_cast<int>(intersectingTriangles((*visual)[a], (*visual)[b]).size());
  for (const Part& part : joint.parts) {
    if (part.kind != PartKind::Soft || !findCage(joint, part.id)) continue;
    const auto nodes = startNodes(joint, part);
    if (!nodes) return nodes.error();
    const double ratio = leastRatio(*part.volume, *nodes);
    if (ratio >= check.proof.minVolumeRatio && !check.worstPart.empty()) continue;
    check.proof.minVolumeRatio = std::min(ratio, check.proof.minVolumeRatio);
    check.worstPart = part.id;
  }
  return check;
}

}  // namespace glenoid
