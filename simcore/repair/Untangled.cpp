// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/repair/Untangled.h"

#include <vector>

#include "simcore/mesh/MeshHealth.h"
#include "simcore/repair/RepairStep.h"

namespace glenoid {

TriMesh untangled(TriMesh mesh) {
  if (countSelfIntersections(mesh) == 0) return mesh;
  std::vector<RepairStep> steps;
  for (const RepairKind kind : {RepairKind::RemoveSelfIntersections, RepairKind::FillHoles}) {
    RepairStep step;
    step.kind = kind;
    steps.push_back(step);
  }
  auto mended = repair(mesh, steps);
  if (!mended || !healthOf(mended->mesh).healthy() || countSelfIntersections(mended->mesh) > 0) return mesh;
  return std::move(mended->mesh);
}

}  // namespace glenoid
