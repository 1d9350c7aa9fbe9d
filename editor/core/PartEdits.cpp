// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/PartEdits.h"

#include <QCoreApplication>
#include <algorithm>

#include "editor/core/AnatomyNames.h"
#include "editor/core/CarriedText.h"
#include "editor/core/PartName.h"
#include "editor/core/SameScene.h"
#include "editor/core/Sentences.h"
#include "simcore/mesh/NodePatch.h"
#include "simcore/scene/CouplingHold.h"

namespace glenoid {
namespace {

/// Texts of this file.
struct PartEdits {
  Q_DECLARE_TR_FUNCTIONS(glenoid::PartEdits)
};

/// One step from the joint to another; false when it is the same.
template <class Change>
bool change(Document& document, const QString& text, Change&& how, const QString& gesture = {}) {
  Scene after = document.scene();
  how(after);
  ChangeSet changes = changesBetween(document.joint(), after.joint);
  if (!changes.model) return false;
  document.edit(text, changes, [&](Scene& scene) { scene = std::move(after); }, gesture);
  return true;
}

/// The same for one part that exists.
template <class Change>
bool changePart(Document& document, const std::string& part, const QString& text, Change&& how, const QString& gesture = {}) {
  const int index = findPart(document.joint(), part);
  if (index < 0) return false;
  return change(document, text, [&](Scene& scene) { how(scene.joint, scene.joint.parts[index]); }, gesture);
}

/// The same where its cells may be others: picked nodes are carried over, or nothing is done and `why` says so.
/// `numbered`: the mesh they speak of, null: the part's own before.
template <class Change>
bool changeCells(Document& document, const std::string& part, const QString& text, Change&& how, QString* why, const TetMesh* numbered = nullptr) {
  const int index = findPart(document.joint(), part);
  if (index < 0) return false;
  const Part before = document.joint().parts[index];
  Scene after = document.scene();
  how(after, after.joint.parts[index]);
  const TetMesh none;
  const auto carried = carryNodes(after.joint, part, numbered ? *numbered : before.volume ? *before.volume : none, numbered ? meanCellEdge(*numbered) : cellEdgeOf(before));
  if (!carried) {
    if (why) *why = sentenceOf(carried.error());
    return false;
  }
  return change(document, withCarried(text, *carried), [&](Scene& scene) { scene = std::move(after); });
}

bool samePair(const Exclusion& e, const std::string& a, const std::string& b) {
  return (e.partA == a && e.partB == b) || (e.partA == b && e.partB == a);
}

void dropCage(Joint& joint, const std::string& part) {
  if (std::erase_if(joint.cages, [&](const Cage& cage) { return cage.part == part; })) joint.startProof.reset();
}

/// Takes away what names a part or, where `region` is not empty, a region of it.
void dropReferences(Joint& joint, const std::string& part, const std::string& region) {
  std::erase_if(joint.couplings, [&](const Coupling& c) {
    return region.empty() ? c.partA == part || c.partB == part : c.partA == part && c.regionA == region;
  });
  for (Bursa& bursa : joint.bursae)
    for (auto* sides : {&bursa.floor, &bursa.roof})
      std::erase_if(*sides, [&](const BursaSide& side) {
        return side.part == part && (region.empty() || side.region == region);
      });
  std::erase_if(joint.bursae, [](const Bursa& bursa) { return bursa.floor.empty() || bursa.roof.empty(); });
}

void sortParts(Joint& joint) {
  std::stable_sort(joint.parts.begin(), joint.parts.end(), [](const Part& a, const Part& b) { return a.number < b.number; });
}

bool reaches(const Region& region, const TriMesh& mesh) {
  return std::all_of(region.triangles.begin(), region.triangles.end(), [&](const TriangleRun& run) {
    return static_cast<std::size_t>(run.first) + run.count <= mesh.triangles.size();
  });
}

}  // namespace

bool renamePart(Document& document, const std::string& part, const QString& name) {
  return changePart(document, part, PartEdits::tr("Rename “%1”").arg(partName(document.joint(), part)),
                    [&](Joint&, Part& p) { p.name = name.toStdString(); });
}

bool setPartNumber(Document& document, const std::string& part, int number) {
  if (number < 1) return false;
  for (const Part& other : document.joint().parts)
    if (other.number == number) return false;
  return changePart(document, part, PartEdits::tr("Number “%1”").arg(partName(document.joint(), part)),
                    [&](Joint& joint, Part& p) {
                      p.number = number;
                      sortParts(joint);
                    });
}

bool setPartKind(Document& document, const std::string& part, PartKind kind, std::shared_ptr<const TetMesh> volume,
                 double cellSize, QString* why) {
  if (kind == PartKind::Soft && (!volume || volume->tets.empty())) return false;
  const QString name = partName(document.joint(), part);
  return changeCells(document, part, kind == PartKind::Soft ? PartEdits::tr("Make “%1” soft").arg(name) : PartEdits::tr("Make “%1” rigid").arg(name),
                     [&](Scene& scene, Part& p) {
                       p.kind = kind;
                       p.volume = kind == PartKind::Soft ? volume : nullptr;
                       p.cellSize = kind == PartKind::Soft ? cellSize : 0;
                       if (kind == PartKind::Rigid) p.elements = Elements::Tetrahedra;
                       if (kind == PartKind::Rigid) dropCage(scene.joint, part);
                     }, why);
}

bool setPartColor(Document& document, const std::string& part, const std::array<float, 3>& color) {
  return changePart(document, part, PartEdits::tr("Colour “%1”").arg(partName(document.joint(), part)),
                    [&](Joint&, Part& p) { p.color = color; }, QStringLiteral("color:") + QString::fromStdString(part));
}

bool setPartMaterials(Document& document, const std::string& part, const std::vector<MaterialUse>& materials) {
  const int index = findPart(document.joint(), part);
  if (index < 0 || materials.empty() || !materials[0].region.empty()) return false;
  for (const MaterialUse& use : materials)
    if (findMaterial(document.joint(), use.material) < 0 ||
        (!use.region.empty() && !findRegion(document.joint().parts[index], use.region)))
      return false;
  return changePart(document, part, PartEdits::tr("Change the materials of “%1”").arg(partName(document.joint(), part)),
                    [&](Joint&, Part& p) { p.materials = materials; });
}

bool addPart(Document& document, const Part& part) {
  if (part.id.empty() || findPart(document.joint(), part.id) >= 0) return false;
  for (const Part& other : document.joint().parts)
    if (other.number == part.number) return false;
  const QString name = part.name.empty() ? QString::fromStdString(part.id) : anatomyName(part.name);
  return change(document, PartEdits::tr("Add “%1”").arg(name), [&](Scene& scene) {
    scene.joint.parts.push_back(part);
    sortParts(scene.joint);
  });
}

bool removePart(Document& document, const std::string& part) {
  if (findPart(document.joint(), part) < 0) return false;
  return change(document, PartEdits::tr("Remove “%1”").arg(partName(document.joint(), part)), [&](Scene& scene) {
    Joint& joint = scene.joint;
    joint.parts.erase(joint.parts.begin() + findPart(joint, part));
    dropReferences(joint, part, {});
    std::erase_if(joint.exclusions, [&](const Exclusion& e) { return e.partA == part || e.partB == part; });
    dropCage(joint, part);
    Scenario& scenario = scene.scenario;
    std::erase(scenario.fixedParts, part);
    dropActionsOn(scenario, part);
    dropFromTraining(scenario.training, part);
    for (Tool& tool : scenario.tools) std::erase(tool.perforates, part);
  });
}

bool setPartSurface(Document& document, const std::string& part, SurfaceKind kind, std::shared_ptr<const TriMesh> mesh) {
  if (!mesh || mesh->triangles.empty()) return false;
  const QString name = partName(document.joint(), part);
  const QString text = kind == SurfaceKind::Visual ? PartEdits::tr("Replace the visual surface of “%1”").arg(name)
                                                   : PartEdits::tr("Replace the collision surface of “%1”").arg(name);
  const int index = findPart(document.joint(), part);
  if (index < 0) return false;
  return change(document, text, [&](Scene& scene) {
    Part& p = scene.joint.parts[index];
    (kind == SurfaceKind::Visual ? p.visual : p.collision) = mesh;
    std::vector<std::string> lost;
    for (const Region& region : p.regions)
      if (region.surface == kind && !reaches(region, *mesh)) lost.push_back(region.id);
    for (const std::string& region : lost) {
      dropReferences(scene.joint, part, region);
      dropActionsOn(scene.scenario, part, region);
      dropFromTraining(scene.scenario.training, part, region);
      std::erase_if(p.materials, [&](const MaterialUse& use) { return use.region == region; });
      std::erase_if(p.regions, [&](const Region& r) { return r.id == region; });
    }
  });
}

bool setPartVolume(Document& document, const std::string& part, std::shared_ptr<const TetMesh> volume, double cellSize, QString* why) {
  const int index = findPart(document.joint(), part);
  if (index < 0 || document.joint().parts[index].kind != PartKind::Soft || !volume || volume->tets.empty()) return false;
  return changeCells(document, part, PartEdits::tr("Embed “%1” in other cells").arg(partName(document.joint(), part)),
                     [&](Scene&, Part& p) {
                       p.volume = volume;
                       p.cellSize = cellSize;
                     }, why);
}

bool movePart(Document& document, const std::string& part, const PartMove& move, QString* why) {
  const int index = findPart(document.joint(), part);
  if (index < 0 || move == PartMove{}) return false;
  const Part& before = document.joint().parts[index];
  const Result<Part> moved = movedPart(before, move);
  if (!moved) {
    if (why) *why = sentenceOf(moved.error());
    return false;
  }
  // Where its cells are made anew the old nodes have gone with the part before they look for new ones.
  const PartMap map = partMap(before, move);
  TetMesh nodes;
  if (before.volume) nodes = *before.volume;
  for (Vec3& node : nodes.nodes) node = map.point(node);
  const bool sameCells = moved->volume && moved->volume->tets == nodes.tets && moved->volume->nodes.size() == nodes.nodes.size() && before.elements == Elements::Tetrahedra;
  return changeCells(document, part, PartEdits::tr("Move “%1”").arg(partName(document.joint(), part)), [&](Scene& scene, Part& p) {
    // What the scenario says of places on the part goes with it, as its landmarks do.
    for (Load& load : scene.scenario.loads)
      if (load.part == part && load.point_W) load.point_W = map.point(*load.point_W);
    for (Task& task : scene.scenario.training.tasks)
      for (TaskPlace& place : task.places) {
        if (place.part != part) continue;
        if (place.point_W) place.point_W = map.point(*place.point_W);
        if (place.normal_W) place.normal_W = map.direction(*place.normal_W);
      }
    p = *moved;
    dropCage(scene.joint, part);
    scene.joint.startProof.reset();
  }, why, sameCells ? moved->volume.get() : &nodes);
}

bool setPartElements(Document& document, const std::string& part, Elements elements) {
  const int index = findPart(document.joint(), part);
  if (index < 0 || document.joint().parts[index].kind != PartKind::Soft) return false;
  return changePart(document, part, PartEdits::tr("Change the elements of “%1”").arg(partName(document.joint(), part)),
                    [&](Joint&, Part& p) { p.elements = elements; });
}

bool addMaterial(Document& document, const Material& material) {
  if (material.id.empty() || findMaterial(document.joint(), material.id) >= 0) return false;
  return change(document, PartEdits::tr("Add the material “%1”").arg(anatomyName(material.name)),
                [&](Scene& scene) { scene.joint.materials.push_back(material); });
}

bool setMaterial(Document& document, const Material& material, const QString& gesture) {
  const int index = findMaterial(document.joint(), material.id);
  if (index < 0) return false;
  return change(document, PartEdits::tr("Change the material “%1”").arg(anatomyName(material.name)),
                [&](Scene& scene) { scene.joint.materials[index] = material; }, gesture);
}

bool removeMaterial(Document& document, const std::string& material) {
  const int index = findMaterial(document.joint(), material);
  if (index < 0) return false;
  for (const Part& part : document.joint().parts)
    for (const MaterialUse& use : part.materials)
      if (use.material == material) return false;
  return change(document, PartEdits::tr("Remove the material “%1”").arg(anatomyName(document.joint().materials[index].name)),
                [&](Scene& scene) { scene.joint.materials.erase(scene.joint.materials.begin() + index); });
}

bool addExclusion(Document& document, const Exclusion& exclusion) {
  const Joint& joint = document.joint();
  if (findPart(joint, exclusion.partA) < 0 || findPart(joint, exclusion.partB) < 0 || exclusion.partA == exclusion.partB)
    return false;
  for (const Exclusion& e : joint.exclusions)
    if (samePair(e, exclusion.partA, exclusion.partB)) return false;
  return change(document, PartEdits::tr("Switch off contact between “%1” and “%2”")
                              .arg(partName(joint, exclusion.partA), partName(joint, exclusion.partB)),
                [&](Scene& scene) { scene.joint.exclusions.push_back(exclusion); });
}

bool removeExclusion(Document& document, const std::string& partA, const std::string& partB) {
  return change(document, PartEdits::tr("Switch on contact between “%1” and “%2”")
                              .arg(partName(document.joint(), partA), partName(document.joint(), partB)),
                [&](Scene& scene) {
                  std::erase_if(scene.joint.exclusions, [&](const Exclusion& e) { return samePair(e, partA, partB); });
                });
}

bool setContact(Document& document, const std::string& partA, const std::string& partB, bool on) {
  if (on) return removeExclusion(document, partA, partB);
  return addExclusion(document, {partA, partB, "switched off by the author"});
}

}  // namespace glenoid
