// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/coupling/Springs.h"

#include "simcore/coupling/CouplingAnchors.h"
#include "simcore/embed/Bind.h"

namespace glenoid {

Result<std::vector<CouplingSpring>> deriveSprings(const Joint& joint, int couplingIndex,
                                                  const std::vector<CoupledPart>& parts) {
  const Coupling& coupling = joint.couplings[couplingIndex];
  const int a = findPart(joint, coupling.partA), b = findPart(joint, coupling.partB);
  const auto fault = [&](Fault kind, Arguments arguments) {
    return Error{kind, {"", "/couplings/" + std::to_string(couplingIndex), coupling.id, {}}, std::move(arguments), ""};
  };
  if (a < 0) return fault(Fault::UnknownId, {coupling.partA, "part"});
  if (b < 0) return fault(Fault::UnknownId, {coupling.partB, "part"});
  const Part& partB = joint.parts[b];
  const auto anchors = couplingAnchors(joint, couplingIndex, {&joint.parts[a], parts[a].centre, parts[a].authored}, partB);
  if (!anchors) return anchors.error();
  std::vector<Vec3> ends;
  for (const CouplingAnchor& anchor : *anchors) ends.push_back(anchor.rest_W);
  const std::vector<VertexBinding> bound =
      partB.kind == PartKind::Soft ? bindToTets(*partB.volume, ends) : bindToRigid(ends, parts[b].centre);
  std::vector<CouplingSpring> springs;
  for (std::size_t i = 0; i < anchors->size(); ++i) {
    const double k = (*anchors)[i].stiffness;
    springs.push_back({couplingIndex, a, b, (*anchors)[i].binding, bound[i], k, coupling.damping * k});
  }
  return springs;
}

}  // namespace glenoid
