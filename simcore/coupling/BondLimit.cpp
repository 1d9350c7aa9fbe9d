// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/coupling/BondLimit.h"

#include <algorithm>

#include "simcore/scene/CouplingHold.h"

namespace glenoid {

namespace {

constexpr double kThinnestLayer = 1e-4, kUsualLayer = 1e-3;  // m

double stiffestOf(const Joint& joint, const Part& part) {
  double most = 0;
  for (const MaterialUse& use : part.materials)
    if (const int material = findMaterial(joint, use.material); material >= 0)
      most = std::max(most, joint.materials[material].youngsModulus);
  return most;
}

}  // namespace

BondLimit bondLimitOf(const Joint& joint, const Coupling& coupling) {
  const Part& a = joint.parts[findPart(joint, coupling.partA)];
  const Part& b = joint.parts[findPart(joint, coupling.partB)];
  BondLimit limit;
  if (coupling.byNodes()) {
    const auto count = static_cast<double>(coupling.nodesA.size());
    limit.cell = cellEdgeOf(a) * cellEdgeOf(a);
    limit.area = count * limit.cell;
    limit.stiffness = count * coupling.stiffnessPerNode;
  } else {
    limit.area = areaOf(a, *findRegion(a, coupling.regionA));
    limit.stiffness = coupling.stiffnessPerArea * limit.area;
  }
  const bool anySoft = a.kind == PartKind::Soft || b.kind == PartKind::Soft;
  for (const Part* part : {&a, &b}) {
    if (anySoft && part->kind != PartKind::Soft) continue;
    if (part->kind == PartKind::Soft && part->cellSize > 0) {
      const double face = part->cellSize * part->cellSize;
      limit.cell = limit.cell > 0 ? std::min(limit.cell, face) : face;
    }
    if (const double modulus = stiffestOf(joint, *part); modulus > 0)
      limit.modulus = limit.modulus > 0 ? std::min(limit.modulus, modulus) : modulus;
  }
  if (!(limit.modulus > 0)) return limit;
  limit.most = limit.modulus / kThinnestLayer;
  limit.usual = limit.modulus / kUsualLayer;
  limit.areaForStiffness = limit.stiffness / limit.usual;
  return limit;
}

}  // namespace glenoid
