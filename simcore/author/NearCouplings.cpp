// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/NearCouplings.h"

#include "simcore/coupling/Springs.h"
#include "simcore/scene/RegionNear.h"

namespace glenoid {

Result<Done> addNearCoupling(Joint& joint, const NearCoupling& near) {
  const Coupling& wish = near.coupling;
  const auto fail = [&](Fault fault, Arguments arguments) {
    return Error{fault, {{}, {}, wish.id, {}}, std::move(arguments), "a coupling by distance"};
  };
  const int a = findPart(joint, wish.partA), b = findPart(joint, wish.partB);
  if (a < 0) return fail(Fault::UnknownId, {wish.partA, "part"});
  if (b < 0) return fail(Fault::UnknownId, {wish.partB, "part"});
  Part& part = joint.parts[a];
  if (findRegion(part, wish.id)) return fail(Fault::DuplicateId, {wish.id});

  const TriMesh& surface = *part.visual;
  std::vector<int> triangles = trianglesNear(surface, *joint.parts[b].visual, near.within);
  if (near.radius > 0)
    std::erase_if(triangles, [&](int triangle) {
      Vec3 centre = Vec3::Zero();
      for (const int corner : surface.triangles[triangle]) centre += surface.vertices[corner] / 3;
      return (centre - near.centre_W).norm() > near.radius;
    });
  if (triangles.empty()) return fail(Fault::TooFewSprings, {"0", "0", "0"});
  Region region;
  region.id = wish.id;
  region.kind = "footprint";
  region.triangles = runsOf(std::move(triangles));
  part.regions.push_back(std::move(region));
  Coupling coupling = wish;
  coupling.regionA = wish.id;
  joint.couplings.push_back(std::move(coupling));

  std::vector<CoupledPart> parts;
  for (const Part& each : joint.parts) parts.push_back({&each, Vec3::Zero()});
  const auto springs = deriveSprings(joint, static_cast<int>(joint.couplings.size()) - 1, parts);
  if (!springs) return fail(springs.error().fault, springs.error().arguments);
  return Done{};
}

}  // namespace glenoid
