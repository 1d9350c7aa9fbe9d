// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/NearCouplings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "simcore/coupling/Springs.h"
#include "simcore/mesh/TrianglePatch.h"
#include "simcore/scene/RegionNear.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {

namespace {

bool inBall(const NearCoupling& near, const Vec3& p_W) { return !(near.radius > 0) || (p_W - near.centre_W).norm() <= near.radius; }

Vec3 centreOf(const TriMesh& mesh, int triangle) {
  Vec3 centre = Vec3::Zero();
  for (const int corner : mesh.triangles[triangle]) centre += mesh.vertices[corner] / 3;
  return centre;
}

/// `limit`: the region that they must lie in, or null.
std::vector<int> trianglesOf(const TriMesh& surface, const TriMesh& other, const NearCoupling& near, const Region* limit) {
  std::vector<int> triangles = trianglesNear(surface, other, near.within);
  std::erase_if(triangles, [&](int triangle) { return !inBall(near, centreOf(surface, triangle)); });
  return limit ? common(triangles, trianglesOf(*limit)) : triangles;
}

/// The region that a coupling names beside its distance; null where it names none.
template <class AnyPart>
const Region* limitOf(const AnyPart& part, const NearCoupling& near) {
  const auto found = std::find_if(part.regions.begin(), part.regions.end(), [&](const Region& region) { return region.id == near.coupling.regionA; });
  return found == part.regions.end() ? nullptr : &*found;
}

std::string millimetres(double metres) {
  char out[32];
  std::snprintf(out, sizeof out, "%.3g mm", 1e3 * metres);
  return out;
}

/// “lower” (nearest 7.4 mm, within 1 mm): what an author needs to see which figure is wrong.
std::string nothingNear(const TriMesh& surface, const TriMesh& other, const NearCoupling& near, const Region* limit) {
  double nearest = HUGE_VAL;
  const TriangleTree tree(other);
  for (const int t : limit ? trianglesOf(*limit) : inverted(surface, {}))
    if (const Vec3 centre = centreOf(surface, t); inBall(near, centre)) nearest = std::min(nearest, tree.closest(centre).distance);
  const std::string name = "“" + near.coupling.id + "” of " + near.coupling.partA + " to " + near.coupling.partB;
  if (nearest == HUGE_VAL) return name + " (nothing of " + near.coupling.partA + " lies in its ball" + (limit ? " and its region)" : ")");
  return name + " (nearest " + millimetres(nearest) + ", within " + millimetres(near.within) + ")";
}

}  // namespace

Result<Done> checkNearCouplings(std::span<const PartRecipe> parts, std::span<const NearCoupling> couplings) {
  std::string lost;
  const auto find = [&](const std::string& id) { return std::find_if(parts.begin(), parts.end(), [&](const PartRecipe& p) { return p.id == id; }); };
  for (const NearCoupling& near : couplings) {
    const auto a = find(near.coupling.partA), b = find(near.coupling.partB);
    for (const auto& [found, id] : {std::pair{a, near.coupling.partA}, {b, near.coupling.partB}})
      if (found == parts.end()) return Error{Fault::UnknownId, {{}, {}, near.coupling.id, {}}, {id, "part"}, "a coupling by distance"};
    const Region* limit = limitOf(*a, near);
    if (!near.coupling.regionA.empty() && !limit) return Error{Fault::UnknownId, {{}, {}, near.coupling.id, {}}, {near.coupling.regionA, "region"}, "a coupling by distance"};
    if (!a->visual || !b->visual || !trianglesOf(*a->visual, *b->visual, near, limit).empty()) continue;
    lost += (lost.empty() ? "" : "; ") + nothingNear(*a->visual, *b->visual, near, limit);
  }
  if (!lost.empty()) return Error{Fault::NothingNear, {}, {lost}, "a coupling by distance"};
  return Done{};
}

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
  const TriMesh& other = *joint.parts[b].visual;
  const Region* limit = limitOf(part, near);
  if (!wish.regionA.empty() && !limit) return fail(Fault::UnknownId, {wish.regionA, "region"});
  std::vector<int> triangles = trianglesOf(surface, other, near, limit);
  if (triangles.empty()) return fail(Fault::NothingNear, {nothingNear(surface, other, near, limit)});
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
