// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/MakeDents.h"

#include <cmath>

#include "simcore/scene/JointFile.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {

namespace {

constexpr double kElements = 4000;   ///< cells of the whole part, about
constexpr double kDepthMost = 2.5e-3;  ///< m: the search for contacts sees no deeper than 4 mm
constexpr double kThicknessShare = 0.4;  ///< a tip past the middle of a band would come out on its other side

Error inPart(Error error, const std::string& part) {
  error.place.part = part;
  return error;
}

/// Vertices far from each other: each next one is the farthest from those taken.
std::vector<int> spread(const std::vector<Vec3>& points, int count) {
  std::vector<double> distance(points.size(), 1e300);
  std::vector<int> taken;
  std::size_t next = 0;
  while (static_cast<int>(taken.size()) < count && taken.size() < points.size()) {
    taken.push_back(static_cast<int>(next));
    for (std::size_t i = 0; i < points.size(); ++i) distance[i] = std::min(distance[i], (points[i] - points[next]).norm());
    next = static_cast<std::size_t>(std::max_element(distance.begin(), distance.end()) - distance.begin());
  }
  return taken;
}

/// Tissue under a place of the surface, along the normal into the part, m.
double thicknessAt(const TriangleTree& surface, const TipPatch& patch) {
  constexpr double kBelow = 1e-5;
  const auto hit = surface.cast(patch.middle_W - kBelow * patch.normal_W, -patch.normal_W);
  return hit ? kBelow + hit->distance : kBelow;
}

}  // namespace

GradedCells fineCells(const Part& part, double radius) {
  GradedCells cells;
  cells.finest = radius / 2.5;
  cells.core = 1.6 * radius;
  cells.coarsest = std::max(cells.finest, std::cbrt(enclosedVolume(*part.visual) / kElements));
  return cells;
}

Result<Done> makeDents(Joint& joint, const DentWishes& wishes) {
  for (std::size_t index = 0; index < joint.parts.size(); ++index) {
    Part& part = joint.parts[index];
    if (part.kind != PartKind::Soft) continue;
    const auto coarse = StaticPart::make(joint, static_cast<int>(index), part.volume, TetFilling::Partial);
    if (!coarse) return inPart(coarse.error(), part.id);
    const TriangleTree surface(*part.visual);
    DentTable table;
    table.radius = wishes.radius;
    for (const int vertex : spread(part.visual->vertices, wishes.places)) {
      const TipPatch patch = tipPatchAt(*part.visual, part.visual->vertices[static_cast<std::size_t>(vertex)], wishes.radius);
      auto mesh = embedGraded(part, patch, fineCells(part, wishes.radius));
      if (!mesh) return inPart(mesh.error(), part.id);
      const auto fine = StaticPart::make(joint, static_cast<int>(index), std::make_shared<const TetMesh>(std::move(*mesh)), TetFilling::Whole);
      if (!fine) return inPart(fine.error(), part.id);
      const double more = std::max(0.0, fine->compliance(patch) - coarse->compliance(patch));
      table.samples.push_back({patch.middle_W, more, std::min(kDepthMost, kThicknessShare * thicknessAt(surface, patch))});
    }
    table.basis = dentBasis(joint, part);
    part.dents = std::make_shared<const DentTable>(std::move(table));
  }
  return Done{};
}

}  // namespace glenoid
