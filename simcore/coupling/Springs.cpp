// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/coupling/Springs.h"

#include <cstdio>

#include "simcore/coupling/RegionAnchors.h"
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
  const Part& partA = joint.parts[a];
  const Part& partB = joint.parts[b];
  const Region* region = findRegion(partA, coupling.regionA);
  if (!region) return fault(Fault::UnknownId, {coupling.regionA, "region"});

  if (const AreaMoments moments = momentsOf(partA, *region); !canHold(moments)) {
    const auto millimetres = [](double metres) {
      char text[32];
      std::snprintf(text, sizeof text, "%.3g", 1e3 * metres);
      return std::string(text);
    };
    const Vec3 radii = radiiOfGyration(moments);
    return fault(Fault::TooFewSprings, {millimetres(1e3 * moments.area), millimetres(radii(2)), millimetres(radii(1))});
  }
  const std::vector<RegionAnchor> anchors = regionAnchors({&partA, parts[a].centre}, *region, &partB, joint.axes_W);
  std::vector<Vec3> ends;
  for (const RegionAnchor& anchor : anchors) ends.push_back(anchor.rest_W);
  const std::vector<VertexBinding> bound =
      partB.kind == PartKind::Soft ? bindToTets(*partB.volume, ends) : bindToRigid(ends, parts[b].centre);
  std::vector<CouplingSpring> springs;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const double k = coupling.stiffnessPerArea * anchors[i].share;
    springs.push_back({couplingIndex, a, b, anchors[i].binding, bound[i], k, coupling.damping * k});
  }
  return springs;
}

}  // namespace glenoid
