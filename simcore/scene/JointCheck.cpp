// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/JointCheck.h"

#include <set>

#include "simcore/file/JsonValue.h"
#include "simcore/file/Vtk.h"

namespace glenoid::joint_check {
namespace {

/// Where the check stands: pointer and part of what is looked at.
struct At {
  const std::string& file;
  std::string pointer, part;

  At in(const char* member, std::size_t index) const {
    return {file, pointerTo(pointerTo(pointer, member), index), part};
  }
  At in(const char* member) const { return {file, pointerTo(pointer, member), part}; }
  At of(const std::string& id) const { return {file, pointer, id}; }
  Error fail(Fault fault, Arguments arguments = {}, std::optional<long> element = {}) const {
    return {fault, {file, pointer, part, element}, std::move(arguments), {}};
  }
};

/// Fails at the second of two equal ids.
template <class T>
Result<Done> checkIds(const std::vector<T>& things, const At& at, const char* member) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < things.size(); ++i)
    if (!seen.insert(things[i].id).second)
      return at.in(member, i).in("id").fail(Fault::DuplicateId, {things[i].id});
  return Done{};
}

Result<Done> checkRuns(const Region& region, const At& at) {
  long long end = 0;
  for (std::size_t i = 0; i < region.triangles.size(); ++i) {
    const TriangleRun& run = region.triangles[i];
    if (run.count < 1)
      return at.in("triangles", i).fail(Fault::OutOfRange, {std::to_string(run.count), "1", ""});
    if (run.first < end)
      return at.in("triangles", i)
          .fail(Fault::OutOfRange, {std::to_string(run.first), std::to_string(end), ""});
    end = static_cast<long long>(run.first) + run.count;
  }
  return Done{};
}

Result<Done> checkPart(const Joint& joint, const Part& part, const At& at) {
  if (const auto ids = checkIds(part.regions, at, "regions"); !ids) return ids;
  if (const auto ids = checkIds(part.landmarks, at, "landmarks"); !ids) return ids;
  for (std::size_t i = 0; i < part.regions.size(); ++i)
    if (const auto runs = checkRuns(part.regions[i], at.in("regions", i)); !runs) return runs;
  if (part.materials.empty()) return at.in("materials").fail(Fault::Unusable, {"no material"});
  for (std::size_t i = 0; i < part.materials.size(); ++i) {
    const MaterialUse& use = part.materials[i];
    if (findMaterial(joint, use.material) < 0)
      return at.in("materials", i).in("material").fail(Fault::UnknownId, {use.material, "material"});
    if (!use.region.empty() && !findRegion(part, use.region))
      return at.in("materials", i).in("region").fail(Fault::UnknownId, {use.region, "region"});
    if (use.thickness > 0 && (part.kind != PartKind::Rigid || use.region.empty()))
      return at.in("materials", i).in("thickness").fail(Fault::Unusable, {"a layer needs a region of a rigid part"});
  }
  if (!part.materials[0].region.empty())
    return at.in("materials", 0)
        .in("region")
        .fail(Fault::Unusable, {"the first material must be for the whole part"});
  return Done{};
}

Result<Done> checkPair(const Joint& joint, const std::string& partA, const std::string& partB, const At& at) {
  if (findPart(joint, partA) < 0) return at.in("partA").fail(Fault::UnknownId, {partA, "part"});
  if (findPart(joint, partB) < 0) return at.in("partB").fail(Fault::UnknownId, {partB, "part"});
  if (partA == partB) return at.in("partB").fail(Fault::BadReference, {partB});
  return Done{};
}

/// A coupling holds over a region or at nodes of a soft part, with the stiffness that goes with it.
Result<Done> checkHold(const Joint& joint, const Coupling& coupling, const At& at) {
  const Part& a = joint.parts[findPart(joint, coupling.partA)];
  const auto missing = [&](const char* member) { return at.fail(Fault::SchemaMismatch, {"member \"" + std::string(member) + "\" is missing"}); };
  if (!coupling.byNodes()) {
    if (coupling.regionA.empty()) return at.fail(Fault::BadNodes, {"neither"});
    if (!findRegion(a, coupling.regionA)) return at.in("regionA").fail(Fault::UnknownId, {coupling.regionA, "region"});
    if (coupling.stiffnessPerNode != 0) return at.in("stiffnessPerNode").fail(Fault::BadNodes, {"unit"});
    if (!(coupling.stiffnessPerArea > 0)) return missing("stiffnessPerArea");
    return Done{};
  }
  if (!coupling.regionA.empty()) return at.in("nodesA").fail(Fault::BadNodes, {"both"});
  if (a.kind == PartKind::Rigid) return at.in("nodesA").fail(Fault::BadNodes, {"rigid", coupling.partA});
  if (coupling.stiffnessPerArea != 0) return at.in("stiffnessPerArea").fail(Fault::BadNodes, {"unit"});
  if (!(coupling.stiffnessPerNode > 0)) return missing("stiffnessPerNode");
  std::set<int> seen;
  for (std::size_t i = 0; i < coupling.nodesA.size(); ++i)
    if (!seen.insert(coupling.nodesA[i]).second) return at.in("nodesA", i).fail(Fault::BadNodes, {"twice", std::to_string(coupling.nodesA[i])});
  return Done{};
}

/// The sides of a bursa name parts, and visual regions of them.
Result<Done> checkSides(const Joint& joint, const std::vector<BursaSide>& sides, const At& at, const char* member) {
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const int part = findPart(joint, sides[i].part);
    if (part < 0) return at.in(member, i).in("part").fail(Fault::UnknownId, {sides[i].part, "part"});
    if (sides[i].region.empty()) continue;
    const Region* region = findRegion(joint.parts[part], sides[i].region);
    if (!region) return at.in(member, i).in("region").fail(Fault::UnknownId, {sides[i].region, "region"});
    if (region->surface != SurfaceKind::Visual)
      return at.in(member, i).in("region").fail(Fault::BadReference, {sides[i].region});
  }
  return Done{};
}

/// A cage is around a part, which no other cage has, and its triangles name vertices that exist.
Result<Done> checkCage(const Joint& joint, std::size_t index, const At& at) {
  const Cage& cage = joint.cages[index];
  const int part = findPart(joint, cage.part);
  if (part < 0) return at.in("part").fail(Fault::UnknownId, {cage.part, "part"});
  if (findCage(joint, cage.part) != &cage) return at.in("part").fail(Fault::DuplicateId, {cage.part});
  const std::size_t size = cage.rest_W.size();
  if (cage.moved_W.size() != size)
    return at.in("moved").fail(Fault::BadIndex, {std::to_string(cage.moved_W.size()), std::to_string(size)});
  for (std::size_t t = 0; t < cage.triangles.size(); ++t)
    for (const int corner : cage.triangles[t])
      if (corner < 0 || corner >= static_cast<int>(size))
        return at.in("triangles", t).fail(Fault::BadIndex, {std::to_string(corner), std::to_string(size)});
  return Done{};
}

Result<Done> checkSurface(const std::shared_ptr<const TriMesh>& mesh, const At& at) {
  if (!mesh || mesh->triangles.empty()) return at.fail(Fault::BadMesh, {"no triangles"});
  const auto size = static_cast<int>(mesh->vertices.size());
  for (int i = 0; i < size; ++i)
    if (!mesh->vertices[i].allFinite()) return at.fail(Fault::NotFinite, {}, i);
  for (std::size_t i = 0; i < mesh->triangles.size(); ++i)
    for (const int index : mesh->triangles[i])
      if (index < 0 || index >= size)
        return at.fail(Fault::BadIndex, {std::to_string(index), std::to_string(size)}, static_cast<long>(i));
  return Done{};
}

Result<Done> checkVolume(const Part& part, const At& at) {
  if (part.kind == PartKind::Rigid) {
    if (part.volume) return at.fail(Fault::BadMesh, {"a rigid part has no volume mesh"});
    return Done{};
  }
  if (!part.volume) return at.fail(Fault::BadMesh, {"a soft part needs a volume mesh"});
  Result<Done> good = checkTetMesh(*part.volume, at.file);
  if (!good) {
    good.error().place.pointer = at.pointer;
    good.error().place.part = at.part;
  }
  return good;
}

Result<Done> checkDents(const Part& part, const At& at) {
  if (!part.dents) return Done{};
  if (part.kind == PartKind::Rigid) return at.fail(Fault::BadReference, {"dents"});
  const DentTable& dents = *part.dents;
  for (std::size_t k = 0; k < dents.radii.size(); ++k)
    if (const double least = k ? dents.radii[k - 1] : 0.0; !(dents.radii[k] > least))
      return at.in("radii", k).fail(Fault::OutOfRange, {std::to_string(dents.radii[k]), std::to_string(least), "1"});
  for (std::size_t i = 0; i < dents.samples.size(); ++i) {
    const DentSample& sample = dents.samples[i];
    if (!sample.at_W.allFinite()) return at.in("samples", i).fail(Fault::NotFinite);
    bool good = sample.modulus > 0 && sample.depthMost >= 0;
    for (const double compliance : sample.compliance) good = good && compliance > 0;
    if (!good) return at.in("samples", i).fail(Fault::OutOfRange, {"a modulus, compliance or depth", "0", "1e15"});
  }
  return Done{};
}

Result<Done> checkRegionRange(const Part& part, const Region& region, const At& at) {
  const TriMesh& mesh = region.surface == SurfaceKind::Visual ? *part.visual : *part.collision;
  const auto size = static_cast<long long>(mesh.triangles.size());
  for (std::size_t i = 0; i < region.triangles.size(); ++i) {
    const long long last = static_cast<long long>(region.triangles[i].first) + region.triangles[i].count - 1;
    if (last >= size)
      return at.in("triangles", i).fail(Fault::BadIndex, {std::to_string(last), std::to_string(size)});
  }
  return Done{};
}

/// Picked nodes are there.
Result<Done> checkNodeRange(const Joint& joint, const Coupling& coupling, const At& at) {
  if (!coupling.byNodes()) return Done{};
  const auto size = static_cast<int>(joint.parts[findPart(joint, coupling.partA)].volume->nodes.size());
  for (std::size_t i = 0; i < coupling.nodesA.size(); ++i)
    if (const int node = coupling.nodesA[i]; node < 0 || node >= size)
      return at.in("nodesA", i).fail(Fault::BadNodes, {"outside", std::to_string(node), std::to_string(size - 1)});
  return Done{};
}

}  // namespace

Result<Done> checkValues(const Joint& joint, const std::string& file) {
  const At root{file, {}, {}};
  if (!((joint.axes_W * joint.axes_W.transpose() - Mat3::Identity()).norm() < 1e-6))
    return root.in("axes").fail(Fault::Unusable, {"axes that are not three orthogonal directions of length one"});
  if (const auto ids = checkIds(joint.materials, root, "materials"); !ids) return ids;
  if (const auto ids = checkIds(joint.parts, root, "parts"); !ids) return ids;
  if (const auto ids = checkIds(joint.couplings, root, "couplings"); !ids) return ids;
  std::set<int> numbers;
  for (std::size_t i = 0; i < joint.parts.size(); ++i) {
    const Part& part = joint.parts[i];
    const At at = root.in("parts", i).of(part.id);
    if (!numbers.insert(part.number).second)
      return at.in("number").fail(Fault::DuplicateId, {std::to_string(part.number)});
    if (const auto good = checkPart(joint, part, at); !good) return good;
  }
  for (std::size_t i = 0; i < joint.couplings.size(); ++i) {
    const Coupling& coupling = joint.couplings[i];
    const At at = root.in("couplings", i).of(coupling.id);
    if (const auto pair = checkPair(joint, coupling.partA, coupling.partB, at); !pair) return pair;
    if (const auto hold = checkHold(joint, coupling, at); !hold) return hold;
  }
  for (std::size_t i = 0; i < joint.exclusions.size(); ++i) {
    const Exclusion& exclusion = joint.exclusions[i];
    if (const auto pair = checkPair(joint, exclusion.partA, exclusion.partB, root.in("exclusions", i)); !pair)
      return pair;
  }
  if (const auto ids = checkIds(joint.bursae, root, "bursae"); !ids) return ids;
  for (std::size_t i = 0; i < joint.bursae.size(); ++i) {
    const Bursa& bursa = joint.bursae[i];
    const At at = root.in("bursae", i).of(bursa.id);
    if (const auto good = checkSides(joint, bursa.floor, at, "floor"); !good) return good;
    if (const auto good = checkSides(joint, bursa.roof, at, "roof"); !good) return good;
  }
  if (const auto ids = checkIds(joint.cages, root, "cages"); !ids) return ids;
  for (std::size_t i = 0; i < joint.cages.size(); ++i)
    if (const auto good = checkCage(joint, i, root.in("cages", i).of(joint.cages[i].id)); !good) return good;
  return Done{};
}

Result<Done> checkMeshes(const Joint& joint, const std::string& file) {
  for (std::size_t i = 0; i < joint.parts.size(); ++i) {
    const Part& part = joint.parts[i];
    const At at = At{file, {}, {}}.in("parts", i).of(part.id);
    if (const auto good = checkSurface(part.visual, at.in("visual")); !good) return good;
    if (const auto good = checkSurface(part.collision, at.in("collision")); !good) return good;
    if (const auto good = checkVolume(part, at.in("volume")); !good) return good;
    if (const auto good = checkDents(part, at.in("dents")); !good) return good;
    for (std::size_t r = 0; r < part.regions.size(); ++r)
      if (const auto good = checkRegionRange(part, part.regions[r], at.in("regions", r)); !good) return good;
  }
  for (std::size_t i = 0; i < joint.couplings.size(); ++i)
    if (const auto good = checkNodeRange(joint, joint.couplings[i], At{file, {}, {}}.in("couplings", i).of(joint.couplings[i].id)); !good) return good;
  for (std::size_t i = 0; i < joint.cages.size(); ++i)
    if (!joint.parts[findPart(joint, joint.cages[i].part)].volume)
      return At{file, {}, {}}.in("cages", i).of(joint.cages[i].id).in("part").fail(Fault::BadReference, {joint.cages[i].part});
  return Done{};
}

}  // namespace glenoid::joint_check
