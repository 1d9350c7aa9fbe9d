// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "resources/generate/Materials.h"
#include "resources/generate/Regions.h"
#include "resources/generate/Shoulder.h"
#include "resources/generate/capsule/Capsule.h"
#include "resources/generate/capsule/Portals.h"

/// The shoulder of eleven parts with what an arthroscopy sees besides: capsule, glenohumeral ligaments, teres
/// minor, portals.
namespace glenoid::generate {
namespace {

using Colour = std::array<float, 3>;

TriMesh inMillimetres(TriMesh mesh) {
  for (Vec3& v : mesh.vertices) v *= 1e3;
  return mesh;
}

const TriMesh& visualOf(const JointRecipe& recipe, const std::string& id) {
  return *std::find_if(recipe.parts.begin(), recipe.parts.end(), [&](const PartRecipe& p) {
            return p.id == id;
          })->visual;
}

PartRecipe softPart(const char* id, const char* name, int number, int tetrahedra, const Colour& colour,
                    const Surfaces& surfaces, const char* material) {
  PartRecipe part;
  part.id = id, part.name = name, part.number = number;
  part.kind = PartKind::Soft;
  part.tetrahedra = tetrahedra;
  part.color = colour;
  part.axes = GridAxes::Principal;
  part.elements = Elements::Cells;
  part.materials = {{material, ""}};
  part.visual = inMetres(surfaces.visual);
  part.collision = inMetres(surfaces.collision);
  return part;
}

/// Which of the new parts may touch what. All other pairs with a new part are left out.
bool mayTouch(const std::string& a, const std::string& b) {
  static const std::set<std::pair<std::string, std::string>> pairs = {
      {"teres-minor", "humerus"},
      {"capsule", "humerus"},
      {"capsule", "biceps-tendon"},
      {"superior-glenohumeral-ligament", "humerus"},
      {"middle-glenohumeral-ligament", "humerus"},
      {"inferior-glenohumeral-ligament", "humerus"}};
  return pairs.count({a, b}) || pairs.count({b, a});
}

/// Why a pair with a new part is left out.
const char* reasonFor(const std::string& a, const std::string& b) {
  const auto is = [&](const char* x, const char* y) { return (a == x && b == y) || (a == y && b == x); };
  const auto one = [&](const char* x) { return a == x || b == x; };
  if (is("teres-minor", "scapula"))
    return "The belly is bonded to the border of the blade, so the two do not move against each other.";
  if (is("teres-minor", "infraspinatus")) return "The two muscles lie side by side in one fascia.";
  if (is("capsule", "scapula")) return "The capsule is bonded to the neck of the glenoid.";
  if (is("capsule", "labrum") || is("capsule", "labrum-tendon"))
    return "Labrum and biceps anchor lie against the capsule's beginning, which holds them.";
  if (one("capsule") &&
      (one("supraspinatus") || one("infraspinatus") || one("subscapularis") || one("teres-minor")))
    return "The capsule is the innermost layer of the tendon where the two meet.";
  if (is("capsule", "coracohumeral-ligament"))
    return "The ligament thickens the capsule over the rotator interval.";
  if (a.find("glenohumeral") != std::string::npos || b.find("glenohumeral") != std::string::npos) {
    if (one("capsule")) return "The ligament is a fold of the capsule.";
    if (one("scapula") || one("labrum"))
      return "The ligament begins at the labrum and the rim, where it is bonded.";
    return "The ligament lies in the wall of the capsule, which keeps it apart from this part.";
  }
  return "Other layers lie between the two.";
}

Material soft(const char* id, const char* name, double literature, double used, const char* source) {
  Material m;
  m.id = id, m.name = name, m.source = source;
  m.appearance = Appearance::Ligament;
  m.density = 1100;
  m.youngsModulus = used * 1e6;
  m.literatureYoungsModulus = literature * 1e6;
  m.reason =
      "Scaled down as the other ligaments are, which keep the order of the tissues: what stiffer tissue "
      "would add cannot be felt through a tool.";
  m.poissonRatio = 0.45;
  m.friction = 0.01;
  m.stiffnessDamping = 1e-3;
  return m;
}

void addTeresMinor(JointRecipe& recipe, const Bones& bones) {
  const Surfaces surfaces = teresMinor(bones, inMillimetres(visualOf(recipe, "infraspinatus")));
  PartRecipe part =
      softPart("teres-minor", "Teres minor", 12, 110, {0.66f, 0.24f, 0.22f}, surfaces, "muscle-relaxed");
  part.elements = Elements::Tetrahedra;
  part.materials = materialsOf("teres-minor");
  part.regions = regionsOf("teres-minor", surfaces.visual, bones);
  const Field beside = fieldOf(inMillimetres(visualOf(recipe, "infraspinatus")));
  part.regions.push_back(regionWhere(surfaces.visual, "septum", "Septum to the infraspinatus", "footprint",
                                     [&](const Vec3& p) { return beside(p) < 1.6; }));
  recipe.parts.push_back(std::move(part));
}

}  // namespace

JointRecipe capsuleRecipe() {
  JointRecipe recipe = shoulderRecipe();
  recipe.id = "shoulder-capsule";
  recipe.name = "Right shoulder with capsule";
  const Bones& bones = makeBones();
  // Seen from nearby the anchor of the table is all corners: here it is round.
  for (PartRecipe& part : recipe.parts)
    if (part.id == "labrum-tendon") {
      constexpr int kAround = 24, kAlong = 26;
      const TriMesh round = labrumTendon(bones, kAround, kAlong).visual;
      part.regions = labrumTendonRegions(round, kAround, kAlong);
      part.visual = inMetres(round);
    }
  addTeresMinor(recipe, bones);

  const auto field = [&](const char* id) { return fieldOf(inMillimetres(visualOf(recipe, id))); };
  std::vector<TriMesh> inside;
  for (const char* id : {"labrum", "labrum-tendon", "biceps-tendon"})
    inside.push_back(inMillimetres(visualOf(recipe, id)));
  Field over = field("supraspinatus");
  for (const char* id : {"infraspinatus", "subscapularis", "teres-minor", "coracohumeral-ligament"}) over = unionOf(over, field(id));
  const CapsuleShapes shapes(bones, inside, over);
  const Surfaces wall = shapes.capsule();
  PartRecipe capsule =
      softPart("capsule", "Capsule of the shoulder joint", 13, 600, {0.86f, 0.78f, 0.72f}, wall, "capsule");
  // Its wall only grazes many cells, whose far corners are then held by next to nothing: as cells they swing
  // to thrice their edge while the tissue stretches by a quarter. Tetrahedra scaled by their fill hold them
  // (1.05), at the price of a wall stiffer to bend.
  capsule.elements = Elements::Tetrahedra;
  capsule.regions = shapes.capsuleRegions(
      wall.visual,
      {{"under-supraspinatus", "Under the supraspinatus", field("supraspinatus")},
       {"under-infraspinatus", "Under the infraspinatus", field("infraspinatus")},
       {"under-subscapularis", "Under the subscapularis", field("subscapularis")},
       {"under-teres-minor", "Under the teres minor", field("teres-minor")},
       {"under-coracohumeral", "Under the coracohumeral ligament", field("coracohumeral-ligament")}});
  recipe.parts.push_back(std::move(capsule));
  const auto ligament = [&](const char* id, const char* name, int number, int tetrahedra,
                            const Surfaces& surfaces, const char* which) {
    PartRecipe part = softPart(id, name, number, tetrahedra, {0.90f, 0.87f, 0.80f}, surfaces, "glenohumeral");
    part.regions = shapes.ligamentRegions(surfaces.visual, which);
    recipe.parts.push_back(std::move(part));
  };
  ligament("superior-glenohumeral-ligament", "Superior glenohumeral ligament", 14, 80, shapes.superior(),
           "superior");
  ligament("middle-glenohumeral-ligament", "Middle glenohumeral ligament", 15, 80, shapes.middle(), "middle");
  ligament("inferior-glenohumeral-ligament", "Inferior glenohumeral ligament", 16, 200, shapes.inferior(),
           "inferior");
  recipe.materials.push_back(
      soft("capsule", "Capsule of the shoulder joint", 10, 2,
           "Range 2 to 60 MPa; the axillary pouch nearly isotropic (J Biomech Eng 131:031007)"));
  recipe.materials.push_back(soft("glenohumeral", "Glenohumeral ligaments", 38, 3.5,
                                  "Bigliani 1992 (inferior ligament, 30 to 45 MPa)"));

  const auto add = [&](const char* a, const char* region, const char* b, double total) {
    recipe.couplings.push_back(bond(recipe, a, region, b, total));
  };
  add("teres-minor", "origin", "scapula", 2e5);
  add("teres-minor", "insertion", "humerus", 1e5);
  add("teres-minor", "septum", "infraspinatus", 2e4);
  add("capsule", "glenoid-end", "scapula", 1e5);
  add("capsule", "humeral-end", "humerus", 1e5);
  for (const auto& [region, part] : {std::pair{"under-supraspinatus", "supraspinatus"},
                                     {"under-infraspinatus", "infraspinatus"},
                                     {"under-subscapularis", "subscapularis"},
                                     {"under-teres-minor", "teres-minor"}})
    add("capsule", region, part, 5e4);
  add("capsule", "under-coracohumeral", "coracohumeral-ligament", 2e4);
  for (const char* id :
       {"superior-glenohumeral-ligament", "middle-glenohumeral-ligament", "inferior-glenohumeral-ligament"}) {
    add(id, "glenoid-end", "scapula", 2e4);
    add(id, "humeral-end", "humerus", 2e4);
    add(id, "capsule-side", "capsule", 5e4);
  }
  for (std::size_t a = 0; a < recipe.parts.size(); ++a)
    for (std::size_t b = std::max<std::size_t>(a + 1, 11); b < recipe.parts.size(); ++b)
      if (const std::string& one = recipe.parts[a].id, &other = recipe.parts[b].id; !mayTouch(one, other))
        recipe.exclusions.push_back({one, other, reasonFor(one, other)});
  for (Landmark& portal : portals()) recipe.parts.front().landmarks.push_back(std::move(portal));
  return recipe;
}

Result<Joint> makeWithCapsule() {
  return buildJoint(capsuleRecipe());
}

}  // namespace glenoid::generate
