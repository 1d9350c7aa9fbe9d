// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/Shoulder.h"

#include <cmath>

#include "resources/generate/Materials.h"
#include "resources/generate/Parts.h"
#include "resources/generate/Regions.h"

namespace glenoid::generate {

namespace {

/// What the table says about a part.
struct Row {
  const char *id, *name;
  PartKind kind;
  int tetrahedra;
  std::array<float, 3> color;
};

constexpr std::array<float, 3> kBone{0.91f, 0.87f, 0.76f}, kMuscle{0.68f, 0.25f, 0.22f},
    kLigament{0.88f, 0.88f, 0.85f};

const Row kRows[] = {
    {"scapula", "Scapula", PartKind::Rigid, 0, kBone},
    {"humerus", "Humerus", PartKind::Rigid, 0, {0.93f, 0.89f, 0.79f}},
    {"supraspinatus", "Supraspinatus", PartKind::Soft, 87, {0.72f, 0.29f, 0.25f}},
    {"infraspinatus", "Infraspinatus", PartKind::Soft, 129, kMuscle},
    {"subscapularis", "Subscapularis", PartKind::Soft, 158, {0.64f, 0.22f, 0.21f}},
    {"coracoacromial-ligament", "Coracoacromial ligament", PartKind::Soft, 65, kLigament},
    {"coracohumeral-ligament", "Coracohumeral ligament", PartKind::Soft, 86, {0.84f, 0.85f, 0.83f}},
    {"transverse-humeral-ligament", "Transverse humeral ligament", PartKind::Rigid, 0, {0.87f, 0.87f, 0.83f}},
    {"labrum", "Labrum", PartKind::Soft, 96, {0.90f, 0.90f, 0.95f}},
    {"labrum-tendon", "Labrum tendon", PartKind::Soft, 122, {0.93f, 0.90f, 0.80f}},
    {"biceps-tendon", "Biceps tendon", PartKind::Rigid, 0, {0.95f, 0.93f, 0.85f}},
};

/// Thin bands, whose cells follow them.
bool isBand(const std::string& part) { return part == "coracoacromial-ligament" || part == "coracohumeral-ligament"; }

/// Bands and a slender tendon: in cells they bend, in tetrahedra hardly.
bool bendsInCells(const std::string& part) { return isBand(part) || part == "labrum-tendon"; }

std::vector<Exclusion> exclusions() {
  const char* const belly =
      "The belly is bonded to its fossa over a large surface, so the two do not move against each other.";
  return {
      {"scapula", "supraspinatus", belly},
      {"scapula", "infraspinatus", belly},
      {"scapula", "subscapularis", belly},
      {"scapula", "coracoacromial-ligament",
       "Both ends of the ligament are bonded to the scapula, which it spans without touching it elsewhere."},
      {"scapula", "coracohumeral-ligament",
       "The ligament leaves the coracoid's edge where it is bonded and meets no other place of the scapula."},
      {"scapula", "transverse-humeral-ligament",
       "The humerus carries the ligament in front of its shaft, out of the scapula's reach."},
      {"scapula", "labrum", "The labrum is bonded to the glenoid's rim over its whole base."},
      {"scapula", "labrum-tendon",
       "The root grows from the upper rim of the glenoid, where it is held by the labrum."},
      {"humerus", "transverse-humeral-ligament", "Both ends of the ligament are bonded to the tubercles."},
      {"supraspinatus", "infraspinatus",
       "The two tendons are one sheet where they meet at the greater tubercle."},
      {"infraspinatus", "subscapularis",
       "The two muscles lie on opposite sides of the blade and never meet."},
      {"labrum", "labrum-tendon", "The root grows out of the labrum."},
      {"labrum-tendon", "biceps-tendon", "The root passes into the tendon."},
  };
}

/// Between the cuff and the roof of the shoulder. Nobody has measured its modulus; it is taken as soft as fat.
Bursa subacromialBursa() {
  Bursa bursa;
  bursa.id = "subacromial-bursa";
  bursa.name = "Bursa subacromialis (subacromial bursa)";
  bursa.floor = {{"supraspinatus", ""}, {"infraspinatus", ""}};
  bursa.roof = {{"scapula", "acromion"}, {"coracoacromial-ligament", ""}};
  bursa.thickness = 2e-3;
  bursa.youngsModulus = 5e3;
  bursa.damping = 2e-3;
  bursa.friction = 0;
  bursa.source = "1 to 2 mm thick when collapsed; modulus assumed as that of fat, without friction";
  return bursa;
}

}  // namespace

std::shared_ptr<const TriMesh> inMetres(TriMesh mesh) {
  for (Vec3& v : mesh.vertices) v *= 1e-3;
  return std::make_shared<const TriMesh>(std::move(mesh));
}

Coupling bond(const JointRecipe& recipe, const char* a, const char* region, const char* b, double total) {
  Coupling c;
  c.id = std::string(a) + "-" + region;
  c.partA = a;
  c.partB = b;
  c.regionA = region;
  c.damping = 1e-3;
  for (const PartRecipe& part : recipe.parts) {
    if (part.id != a) continue;
    Part shape;
    shape.visual = part.visual;
    for (const Region& r : part.regions)
      if (r.id == region) {
        const double perArea = total / areaOf(shape, r);
        const double unit = std::pow(10.0, std::floor(std::log10(perArea)) - 2);
        c.stiffnessPerArea = std::round(perArea / unit) * unit;
      }
  }
  return c;
}

namespace {

JointRecipe madeShoulder() {
  const Bones& bones = makeBones();
  const Surfaces biceps = bicepsTendon(bones);
  const Surfaces surfaces[] = {bones.scapula,
                               bones.humerus,
                               supraspinatus(bones),
                               infraspinatus(bones),
                               subscapularis(bones),
                               coracoacromialLigament(bones),
                               coracohumeralLigament(bones, biceps.visual),
                               transverseHumeralLigament(bones, biceps.visual),
                               labrum(bones),
                               labrumTendon(bones),
                               biceps};
  JointRecipe recipe;
  recipe.id = "shoulder";
  recipe.name = "Right shoulder";
  recipe.side = JointSide::Right;
  recipe.materials = shoulderMaterials();
  recipe.provenance = {"Glenoid Studio", "GPL-3.0-or-later",
                       "Modelled from published sizes and landmarks; see resources/generate",
                       "generate_shoulder"};
  recipe.clearance = 0.4e-3;
  for (int i = 0; i < 11; ++i) {
    PartRecipe part;
    part.id = kRows[i].id;
    part.number = i + 1;
    part.name = kRows[i].name;
    part.kind = kRows[i].kind;
    part.color = kRows[i].color;
    part.tetrahedra = kRows[i].tetrahedra;
    if (bendsInCells(part.id)) part.elements = Elements::Cells;
    part.axes = isBand(part.id) ? GridAxes::Band : part.kind == PartKind::Soft ? GridAxes::Principal : GridAxes::World;
    part.regions = regionsOf(part.id, surfaces[i].visual, bones);
    part.landmarks = landmarksOf(part.id, bones);
    part.materials = materialsOf(part.id);
    part.visual = inMetres(surfaces[i].visual);
    part.collision = inMetres(surfaces[i].collision);
    recipe.parts.push_back(std::move(part));
  }
  const auto add = [&](const char* a, const char* region, const char* b, double total) {
    recipe.couplings.push_back(bond(recipe, a, region, b, total));
  };
  for (const char* muscle : {"supraspinatus", "infraspinatus", "subscapularis"})
    add(muscle, "origin", "scapula", 2e5);
  add("coracoacromial-ligament", "acromial-end", "scapula", 5e4);
  add("coracoacromial-ligament", "coracoid-end", "scapula", 5e4);
  add("coracohumeral-ligament", "coracoid-end", "scapula", 5e4);
  add("labrum", "base", "scapula", 2e5);
  for (const char* muscle : {"supraspinatus", "infraspinatus", "subscapularis"})
    add(muscle, "insertion", "humerus", 1e5);
  add("coracohumeral-ligament", "humeral-end", "humerus", 5e4);
  add("transverse-humeral-ligament", "lesser-end", "humerus", 1e5);
  add("transverse-humeral-ligament", "greater-end", "humerus", 1e5);
  add("biceps-tendon", "distal-end", "humerus", 1e5);
  add("labrum-tendon", "root", "labrum", 5e4);
  add("labrum-tendon", "tendon-end", "biceps-tendon", 5e4);
  recipe.exclusions = exclusions();
  recipe.bursae = {subacromialBursa()};
  return recipe;
}

}  // namespace

JointRecipe shoulderRecipe() {
  static const JointRecipe made = madeShoulder();
  return made;
}

Result<Joint> makeShoulder() {
  return buildJoint(shoulderRecipe());
}

Result<Joint> makePalpation() {
  return buildJoint(palpationRecipe());
}

}  // namespace glenoid::generate
