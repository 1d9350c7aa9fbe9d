// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/AuthorEdits.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

#include "editor/core/AnatomyNames.h"
#include "editor/core/CarriedText.h"
#include "editor/core/Sentences.h"
#include "simcore/coupling/CouplingAnchors.h"
#include "simcore/scene/CouplingHold.h"

namespace glenoid {
namespace {

/// Texts of this file.
struct AuthorEdits {
  Q_DECLARE_TR_FUNCTIONS(glenoid::AuthorEdits)
};

ChangeSet ofParts(std::set<std::string> parts) {
  ChangeSet changes;
  changes.model = true;
  changes.parts = std::move(parts);
  return changes;
}

ChangeSet ofCoupling(const std::string& id) {
  ChangeSet changes;
  changes.model = true;
  changes.couplings = {id};
  return changes;
}

int indexOf(const std::vector<Coupling>& couplings, const std::string& id) {
  const auto found =
      std::find_if(couplings.begin(), couplings.end(), [&](const Coupling& c) { return c.id == id; });
  return found == couplings.end() ? -1 : static_cast<int>(found - couplings.begin());
}

int regionIndex(const Joint& joint, int part, const std::string& id) {
  if (part < 0) return -1;
  const auto& regions = joint.parts[part].regions;
  const auto found =
      std::find_if(regions.begin(), regions.end(), [&](const Region& r) { return r.id == id; });
  return found == regions.end() ? -1 : static_cast<int>(found - regions.begin());
}

std::vector<std::string> regionIds(const Part& part) {
  std::vector<std::string> ids;
  for (const Region& region : part.regions) ids.push_back(region.id);
  return ids;
}

QString nameOf(const Joint& joint, const std::string& part) {
  const int index = findPart(joint, part);
  return anatomyName(index < 0 ? part : joint.parts[index].name);
}

// lupdate loses the namespace in functions that answer a std::string, so these texts stand alone.
QString makeText(const QString& region) {
  return AuthorEdits::tr("Make the region “%1”").arg(region);
}
QString coupleText(const QString& a, const QString& b) {
  return AuthorEdits::tr("Couple %1 to %2").arg(a, b);
}

Region makeRegion(const Part& part, const std::string& name, const std::string& kind, SurfaceKind surface,
                  const std::vector<int>& triangles) {
  return {freshId(name, regionIds(part)), name, kind, surface, runsOf(triangles)};
}

}  // namespace

std::string freshId(const std::string& wish, const std::vector<std::string>& taken) {
  std::string slug;
  for (const char c : wish) {
    const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    const bool keeps = (lower >= 'a' && lower <= 'z') || (lower >= '0' && lower <= '9');
    if (keeps)
      slug += lower;
    else if (!slug.empty() && slug.back() != '-')
      slug += '-';
  }
  while (!slug.empty() && slug.back() == '-') slug.pop_back();
  if (slug.empty()) slug = "item";
  std::string id = slug;
  for (int n = 2; std::find(taken.begin(), taken.end(), id) != taken.end(); ++n)
    id = slug + "-" + std::to_string(n);
  return id;
}

std::string addRegion(Document& document, const std::string& part, const QString& name, SurfaceKind surface,
                      const std::vector<int>& triangles) {
  const int index = findPart(document.joint(), part);
  if (index < 0 || triangles.empty()) return {};
  const Region region =
      makeRegion(document.joint().parts[index], name.toStdString(), "other", surface, triangles);
  document.edit(makeText(name), ofParts({part}),
                [&](Scene& scene) { scene.joint.parts[index].regions.push_back(region); });
  return region.id;
}

bool setRegion(Document& document, const std::string& part, const std::string& region, SurfaceKind surface,
               const std::vector<int>& triangles) {
  const int p = findPart(document.joint(), part), r = regionIndex(document.joint(), p, region);
  if (r < 0 || triangles.empty()) return false;
  Region changed = document.joint().parts[p].regions[r];
  changed.surface = surface;
  changed.triangles = runsOf(triangles);
  if (changed == document.joint().parts[p].regions[r]) return false;
  document.edit(AuthorEdits::tr("Change the region “%1”").arg(QString::fromStdString(changed.name)),
                ofParts({part}), [&](Scene& scene) { scene.joint.parts[p].regions[r] = changed; });
  return true;
}

bool renameRegion(Document& document, const std::string& part, const std::string& region,
                  const QString& name) {
  const int p = findPart(document.joint(), part), r = regionIndex(document.joint(), p, region);
  if (r < 0 || name.isEmpty() || document.joint().parts[p].regions[r].name == name.toStdString())
    return false;
  document.edit(AuthorEdits::tr("Rename a region to “%1”").arg(name), ofParts({part}),
                [&](Scene& scene) { scene.joint.parts[p].regions[r].name = name.toStdString(); });
  return true;
}

bool isRegionUsed(const Joint& joint, const std::string& part, const std::string& region) {
  for (const Coupling& coupling : joint.couplings)
    if (coupling.partA == part && coupling.regionA == region) return true;
  for (const Bursa& bursa : joint.bursae)
    for (const auto* sides : {&bursa.floor, &bursa.roof})
      for (const BursaSide& side : *sides)
        if (side.part == part && side.region == region) return true;
  const int index = findPart(joint, part);
  if (index >= 0)
    for (const MaterialUse& use : joint.parts[index].materials)
      if (use.region == region) return true;
  return false;
}

bool removeRegion(Document& document, const std::string& part, const std::string& region) {
  const int p = findPart(document.joint(), part), r = regionIndex(document.joint(), p, region);
  if (r < 0 || isRegionUsed(document.joint(), part, region)) return false;
  const QString name = QString::fromStdString(document.joint().parts[p].regions[r].name);
  document.edit(AuthorEdits::tr("Remove the region “%1”").arg(name), ofParts({part}), [&](Scene& scene) {
    auto& regions = scene.joint.parts[p].regions;
    regions.erase(regions.begin() + r);
    dropActionsOn(scene.scenario, part, region);
    dropFromTraining(scene.scenario.training, part, region);
  });
  return true;
}

std::string addCoupling(Document& document, const CouplingWish& wish) {
  const Joint& joint = document.joint();
  const int a = findPart(joint, wish.partA), b = findPart(joint, wish.partB);
  const bool byNodes = !wish.nodes.empty();
  if (a < 0 || b < 0 || a == b || !((byNodes ? wish.stiffnessPerNode : wish.stiffnessPerArea) > 0)) return {};
  const bool fresh = !byNodes && wish.region.empty();
  if (byNodes ? !wish.region.empty() || !wish.triangles.empty() : fresh ? wish.triangles.empty() : regionIndex(joint, a, wish.region) < 0) return {};
  Region region;
  if (fresh)
    region = makeRegion(joint.parts[a], "on-" + wish.partB, "footprint", wish.surface, wish.triangles);
  std::vector<std::string> taken;
  for (const Coupling& coupling : joint.couplings) taken.push_back(coupling.id);
  Coupling coupling;
  coupling.id = freshId(wish.partA + "-" + wish.partB, taken);
  coupling.partA = wish.partA;
  coupling.partB = wish.partB;
  coupling.regionA = fresh ? region.id : wish.region;
  coupling.nodesA = wish.nodes;
  (byNodes ? coupling.stiffnessPerNode : coupling.stiffnessPerArea) = byNodes ? wish.stiffnessPerNode : wish.stiffnessPerArea;
  coupling.damping = wish.damping;
  coupling.reason = wish.reason;
  if (byNodes && !canHoldAt(joint, coupling)) return {};
  ChangeSet changes = ofCoupling(coupling.id);
  changes.parts = {wish.partA};
  document.edit(coupleText(nameOf(joint, wish.partA), nameOf(joint, wish.partB)), changes, [&](Scene& scene) {
    if (fresh) scene.joint.parts[a].regions.push_back(region);
    scene.joint.couplings.push_back(coupling);
  });
  return coupling.id;
}

bool setCouplingNodes(Document& document, const std::string& coupling, const std::vector<int>& nodes) {
  const Joint& joint = document.joint();
  const int index = indexOf(joint.couplings, coupling);
  if (index < 0 || !joint.couplings[index].byNodes() || joint.couplings[index].nodesA == nodes) return false;
  Coupling changed = joint.couplings[index];
  changed.nodesA = nodes;
  if (!canHoldAt(joint, changed)) return false;
  document.edit(AuthorEdits::tr("Pick other nodes for the coupling of %1 to %2").arg(nameOf(joint, changed.partA), nameOf(joint, changed.partB)),
                ofCoupling(coupling), [&](Scene& scene) { scene.joint.couplings[index] = changed; });
  return true;
}

bool canHoldAt(const Joint& joint, const Coupling& coupling) {
  Joint one = joint;
  one.couplings = {coupling};
  const int a = findPart(joint, coupling.partA), b = findPart(joint, coupling.partB);
  return a >= 0 && b >= 0 && coupling.byNodes() && couplingAnchors(one, 0, {&joint.parts[a], Vec3::Zero()}, joint.parts[b]).ok();
}

bool removeCoupling(Document& document, const std::string& coupling) {
  const Joint& joint = document.joint();
  const int index = indexOf(joint.couplings, coupling);
  if (index < 0) return false;
  const Coupling& old = joint.couplings[index];
  document.edit(
      AuthorEdits::tr("Uncouple %1 from %2").arg(nameOf(joint, old.partA), nameOf(joint, old.partB)),
      ofCoupling(coupling),
      [&](Scene& scene) { scene.joint.couplings.erase(scene.joint.couplings.begin() + index); });
  return true;
}

bool setCouplingReason(Document& document, const std::string& coupling, const QString& reason) {
  const int index = indexOf(document.joint().couplings, coupling);
  if (index < 0 || document.joint().couplings[index].reason == reason.toStdString()) return false;
  ChangeSet changes = ofCoupling(coupling);
  changes.model = false;
  document.edit(AuthorEdits::tr("Say why two parts are coupled"), changes,
                [&](Scene& scene) { scene.joint.couplings[index].reason = reason.toStdString(); });
  return true;
}

bool setCouplingDamping(Document& document, const std::string& coupling, double seconds) {
  const int index = indexOf(document.joint().couplings, coupling);
  if (index < 0 || seconds < 0 || document.joint().couplings[index].damping == seconds) return false;
  document.edit(
      AuthorEdits::tr("Change the damping of a coupling"), ofCoupling(coupling),
      [&](Scene& scene) { scene.joint.couplings[index].damping = seconds; },
      QStringLiteral("damping:") + QString::fromStdString(coupling));
  return true;
}

bool excludePair(Document& document, const ExclusionProposal& proposal) {
  const Joint& joint = document.joint();
  for (const Exclusion& e : joint.exclusions)
    if ((e.partA == proposal.partA && e.partB == proposal.partB) ||
        (e.partA == proposal.partB && e.partB == proposal.partA))
      return false;
  // Written into the file once and for all, so in the language of the files.
  const std::string reason = QStringLiteral("bonded over %1 mm²: couplings hold the two together")
                                 .arg(QLocale::c().toString(1e6 * proposal.bonded, 'f', 0))
                                 .toStdString();
  ChangeSet changes = ofParts({proposal.partA, proposal.partB});
  document.edit(AuthorEdits::tr("Switch the collision of %1 and %2 off")
                    .arg(nameOf(joint, proposal.partA), nameOf(joint, proposal.partB)),
                changes, [&](Scene& scene) {
                  scene.joint.exclusions.push_back({proposal.partA, proposal.partB, reason});
                });
  return true;
}

// ---- Cages

bool setCage(Document& document, const Cage& cage, const QString& text) {
  const int part = findPart(document.joint(), cage.part);
  if (part < 0 || document.joint().parts[part].kind != PartKind::Soft ||
      cage.rest_W.size() != cage.moved_W.size())
    return false;
  for (const Cage& other : document.joint().cages)
    if ((other.id == cage.id && other.part != cage.part) || other == cage) return false;
  document.edit(text, ofParts({cage.part}), [&](Scene& scene) {
    auto& cages = scene.joint.cages;
    const auto found =
        std::find_if(cages.begin(), cages.end(), [&](const Cage& c) { return c.part == cage.part; });
    if (found == cages.end())
      cages.push_back(cage);
    else
      *found = cage;
    scene.joint.startProof.reset();
  });
  return true;
}

bool moveHandles(Document& document, const std::string& part, const std::vector<Vec3>& moved_W,
                 const QString& gesture) {
  const auto& cages = document.joint().cages;
  const auto found = std::find_if(cages.begin(), cages.end(), [&](const Cage& c) { return c.part == part; });
  if (found == cages.end() || found->moved_W == moved_W || found->moved_W.size() != moved_W.size())
    return false;
  const std::size_t index = found - cages.begin();
  document.edit(
      AuthorEdits::tr("Move the cage of %1").arg(nameOf(document.joint(), part)), ofParts({part}),
      [&](Scene& scene) {
        scene.joint.cages[index].moved_W = moved_W;
        scene.joint.startProof.reset();
      },
      gesture);
  return true;
}

bool removeCage(Document& document, const std::string& part) {
  if (!findCage(document.joint(), part)) return false;
  document.edit(AuthorEdits::tr("Remove the cage of %1").arg(nameOf(document.joint(), part)), ofParts({part}),
                [&](Scene& scene) {
                  std::erase_if(scene.joint.cages, [&](const Cage& c) { return c.part == part; });
                  scene.joint.startProof.reset();
                });
  return true;
}

bool setStart(Document& document, const std::vector<Cage>& cages, const std::optional<StartProof>& proof,
              const QString& text) {
  if (document.joint().cages == cages && document.joint().startProof == proof) return false;
  std::set<std::string> parts;
  for (const auto* list : {&document.joint().cages, &cages})
    for (const Cage& cage : *list) parts.insert(cage.part);
  ChangeSet changes = ofParts(std::move(parts));
  changes.model = document.joint().cages != cages;
  document.edit(text, changes, [&](Scene& scene) {
    scene.joint.cages = cages;
    scene.joint.startProof = proof;
  });
  return true;
}

// ---- Bodies

bool setBody(Document& document, const std::string& part, const BodyWish& wish, const Body& body, QString* said) {
  const int index = findPart(document.joint(), part);
  if (index < 0) return false;
  const Part before = document.joint().parts[index], after = withBody(before, wish, body);
  for (const Region& region : before.regions)
    if (!findRegion(after, region.id) && isRegionUsed(document.joint(), part, region.id)) return false;
  Joint joint = document.joint();
  joint.parts[index] = after;
  const TetMesh none;
  const auto carried = carryNodes(joint, part, before.volume ? *before.volume : none, cellEdgeOf(before));
  if (said) *said = carried ? carriedText(*carried) : sentenceOf(carried.error());
  if (!carried) return false;
  ChangeSet changes = ofParts({part});
  for (const Coupling& coupling : joint.couplings)
    if (coupling.byNodes() && coupling.partA == part) changes.couplings.insert(coupling.id);
  document.edit(withCarried(AuthorEdits::tr("Make the body of %1").arg(nameOf(document.joint(), part)), *carried), changes,
                [&](Scene& scene) {
                  scene.joint.parts[index] = after;
                  scene.joint.couplings = joint.couplings;
                  std::erase_if(scene.joint.cages, [&](const Cage& cage) { return cage.part == part; });
                  scene.joint.startProof.reset();
                });
  return true;
}

std::array<float, 3> usualColor(Appearance appearance) {
  switch (appearance) {
    case Appearance::Bone: return {0.89f, 0.85f, 0.76f};
    case Appearance::Cartilage: return {0.84f, 0.87f, 0.9f};
    case Appearance::Muscle: return {0.66f, 0.26f, 0.23f};
    case Appearance::Tendon: return {0.9f, 0.87f, 0.8f};
    case Appearance::Ligament: return {0.87f, 0.83f, 0.7f};
    case Appearance::Skin: return {0.85f, 0.66f, 0.56f};
    case Appearance::Plain: break;
  }
  return Part{}.color;
}

bool setMaterial(Document& document, const std::string& part, const Material& material) {
  const int index = findPart(document.joint(), part);
  if (index < 0) return false;
  const auto& uses = document.joint().parts[index].materials;
  const bool known = findMaterial(document.joint(), material.id) >= 0;
  if (known && !uses.empty() && uses[0].material == material.id && uses[0].region.empty()) return false;
  ChangeSet changes = ofParts({part});
  changes.materials = {material.id};
  const std::array<float, 3> usual = usualColor(appearanceOf(document.joint(), document.joint().parts[index]));
  document.edit(
      AuthorEdits::tr("Make %1 of “%2”").arg(nameOf(document.joint(), part), anatomyName(material.name)),
      changes, [&](Scene& scene) {
        if (!known) scene.joint.materials.push_back(material);
        Part& changed = scene.joint.parts[index];
        auto& own = changed.materials;
        if (own.empty() || !own[0].region.empty()) own.insert(own.begin(), MaterialUse{});
        own[0] = {material.id, {}};
        // A colour that nobody chose goes with the tissue.
        if (changed.color == usual) changed.color = usualColor(material.appearance);
      });
  return true;
}

std::string ownMaterial(Document& document, const std::string& part) {
  const Joint& joint = document.joint();
  const int index = findPart(joint, part);
  if (index < 0 || joint.parts[index].materials.empty()) return {};
  const int from = findMaterial(joint, joint.parts[index].materials[0].material);
  if (from < 0) return {};
  std::vector<std::string> taken;
  for (const Material& each : joint.materials) taken.push_back(each.id);
  Material own = joint.materials[from];
  own.id = freshId(own.id + "-" + part, taken);
  own.name += " (" + joint.parts[index].name + ")";
  setMaterial(document, part, own);
  return own.id;
}

}  // namespace glenoid
