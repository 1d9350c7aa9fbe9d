// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>

#include "resources/generate/Bones.h"
#include "resources/generate/Materials.h"
#include "resources/generate/Regions.h"
#include "resources/generate/Shoulder.h"
#include "resources/generate/Superficial.h"

namespace glenoid::generate {
namespace {

constexpr std::array<float, 3> kBone{0.92f, 0.88f, 0.77f}, kMuscle{0.70f, 0.27f, 0.23f}, kSkin{0.90f, 0.73f, 0.62f};

/// Surfaces of a finished recipe, back in millimetres.
Surfaces surfacesOf(const PartRecipe& part) {
  Surfaces s{*part.visual, *part.collision};
  for (TriMesh* mesh : {&s.visual, &s.collision})
    for (Vec3& v : mesh->vertices) v *= 1e3;
  return s;
}

PartRecipe layer(const char* id, const char* name, int number, PartKind kind, int tetrahedra, const std::array<float, 3>& color,
                 const Surfaces& surfaces) {
  PartRecipe part;
  part.id = id;
  part.name = name;
  part.number = number;
  part.kind = kind;
  part.tetrahedra = tetrahedra;
  part.color = color;
  part.axes = kind == PartKind::Soft ? GridAxes::Principal : GridAxes::World;
  part.visual = inMetres(surfaces.visual);
  part.collision = inMetres(surfaces.collision);
  return part;
}

Region along(const TriMesh& visual, double from, double to) {
  return regionAlong(visual, kDeltoidAround, kDeltoidAlong, "", "", "", from, to);
}

/// Origin and insertion of a deltoid part: what lies on the bone near either end.
std::vector<Region> deltoidRegions(const TriMesh& visual, const Field& origin, const char* originName, const Field& humerus) {
  return {common(regionWhere(visual, "origin", originName, "footprint", [&](const Vec3& p) { return origin(p) < 3; }), along(visual, 0, 0.3)),
          common(regionWhere(visual, "insertion", "Insertion on the deltoid tuberosity", "footprint",
                             [&](const Vec3& p) { return humerus(p) < 3; }),
                 along(visual, 0.8, 1))};
}

/// Triangles of the skin's sheets: the inner ones first, then the outer, then the rim.
std::vector<Region> skinRegions(const TriMesh& visual) {
  const Vec3 insertion(-4, -95, 42);
  const auto atRim = [&](int vertex, double& along) {
    const int place = vertex % ((kSkinAcross + 1) * (kSkinAlong + 1)), i = place % (kSkinAcross + 1), j = place / (kSkinAcross + 1);
    along = double(j) / kSkinAlong;
    return i == 0 || i == kSkinAcross || j == 0 || j == kSkinAlong;
  };
  std::vector<int> trunk, arm, outer;
  for (std::size_t t = 0; t < visual.triangles.size(); ++t) {
    bool rim = true, outside = true;
    double least = 1, most = 0;
    for (const int v : visual.triangles[t]) {
      double at = 0;
      rim &= atRim(v, at);
      outside &= v >= (kSkinAcross + 1) * (kSkinAlong + 1);
      least = std::min(least, at), most = std::max(most, at);
    }
    if (rim && most < 0.55) trunk.push_back(int(t));
    if (rim && least > 0.6) arm.push_back(int(t));
    if (outside) outer.push_back(int(t));
  }
  const auto region = [](const char* id, const char* name, const char* kind, const std::vector<int>& triangles) {
    Region r;
    r.id = id, r.name = name, r.kind = kind;
    r.triangles = runsOf(triangles);
    return r;
  };
  return {region("trunk-rim", "Border on the trunk", "footprint", trunk), region("arm-rim", "Border on the arm", "footprint", arm),
          region("skin", "Skin", "other", outer)};
}

Material soft(const char* id, const char* name, Appearance appearance, double density, double megapascal, double poisson, const char* source) {
  Material m;
  m.id = id, m.name = name, m.appearance = appearance, m.density = density, m.source = source;
  m.youngsModulus = megapascal * 1e6;
  m.poissonRatio = poisson;
  m.friction = 0.01;
  m.stiffnessDamping = 5e-3;
  return m;
}

/// Which of the new layers may touch what. All other pairs with a new layer are left out.
bool mayTouch(const std::string& a, const std::string& b) {
  static const std::set<std::pair<std::string, std::string>> pairs = {
      {"deltoid-clavicular", "scapula"},  {"deltoid-clavicular", "humerus"},      {"deltoid-clavicular", "subscapularis"},
      {"deltoid-clavicular", "clavicle"}, {"deltoid-acromial", "scapula"},        {"deltoid-acromial", "humerus"},
      {"deltoid-acromial", "supraspinatus"}, {"deltoid-acromial", "infraspinatus"}, {"deltoid-spinal", "scapula"},
      {"deltoid-spinal", "humerus"},      {"deltoid-spinal", "infraspinatus"},    {"skin", "clavicle"},
      {"skin", "scapula"},                {"skin", "deltoid-clavicular"},         {"skin", "deltoid-acromial"},
      {"skin", "deltoid-spinal"},         {"skin", "infraspinatus"}};
  return pairs.count({a, b}) || pairs.count({b, a});
}

}  // namespace

JointRecipe palpationRecipe() {
  JointRecipe recipe = shoulderRecipe();
  recipe.id = "shoulder-superficial";
  recipe.name = "Right shoulder with deltoid and skin";
  recipe.side = JointSide::Right;
  const Bones& bones = makeBones();

  Ground ground = groundOf(surfacesOf(recipe.parts[0]));
  for (std::size_t i = 1; i < recipe.parts.size(); ++i) ground = over(ground, groundOf(surfacesOf(recipe.parts[i])));
  const Surfaces collarbone = clavicle(bones);
  ground = over(ground, groundOf(collarbone));
  const std::array<Surfaces, 3> heads = deltoid(ground);
  Ground top = ground;
  for (const Surfaces& head : heads) top = over(top, groundOf(head));
  const Surfaces skin = skinLayer(top);

  const Field onClavicle = fieldOf(collarbone.visual), onScapula = fieldOf(surfacesOf(recipe.parts[0]).visual),
              onHumerus = fieldOf(surfacesOf(recipe.parts[1]).visual);
  recipe.parts.push_back(layer("clavicle", "Clavicle", 12, PartKind::Rigid, 0, kBone, collarbone));
  recipe.parts.back().materials = {{"cortical-bone", ""}};
  const char* ids[] = {"deltoid-clavicular", "deltoid-acromial", "deltoid-spinal"};
  const char* names[] = {"Clavicular part of the deltoid", "Acromial part of the deltoid", "Spinal part of the deltoid"};
  const char* origins[] = {"Origin on the clavicle", "Origin on the acromion", "Origin on the scapular spine"};
  for (int i = 0; i < 3; ++i) {
    PartRecipe part = layer(ids[i], names[i], 13 + i, PartKind::Soft, 120, kMuscle, heads[i]);
    part.regions = deltoidRegions(heads[i].visual, i == 0 ? onClavicle : onScapula, origins[i], onHumerus);
    if (i == 1)
      for (const int other : {0, 2}) {
        const Field beside = fieldOf(heads[other].visual);
        part.regions.push_back(regionWhere(heads[1].visual, other == 0 ? "front-septum" : "back-septum",
                                           other == 0 ? "Septum to the clavicular part" : "Septum to the spinal part", "footprint",
                                           [&](const Vec3& p) { return beside(p) < 5; }));
      }
    part.materials = {{"muscle-relaxed", ""}};
    recipe.parts.push_back(std::move(part));
  }
  PartRecipe outermost = layer("skin", "Skin and fat", 16, PartKind::Soft, 260, kSkin, skin);
  outermost.regions = skinRegions(skin.visual);
  outermost.materials = {{"subcutaneous-fat", ""}, {"skin", "skin"}};
  recipe.parts.push_back(std::move(outermost));
  recipe.materials.push_back(soft("subcutaneous-fat", "Subcutaneous fat", Appearance::Skin, 920, 0.010, 0.45,
                                  "Alkhouli 2013 (1.6–2.9 kPa), Comley and Fleck 2010 (range 1–25 kPa)"));
  recipe.materials.push_back(soft("skin", "Skin", Appearance::Skin, 1100, 0.15, 0.45, "Pailler-Mattei 2008 (indentation); range Kalra and Lowe"));

  const auto add = [&](const char* a, const char* region, const char* b, double total) {
    recipe.couplings.push_back(bond(recipe, a, region, b, total));
  };
  // Muscle that ends on a strip of half a square centimetre and of one: more would be stiffer than a tenth of a millimetre of it.
  add("deltoid-clavicular", "origin", "clavicle", 1e4);
  add("deltoid-acromial", "origin", "scapula", 2e4);
  add("deltoid-spinal", "origin", "scapula", 1e5);
  for (const char* id : ids) add(id, "insertion", "humerus", 5e4);
  add("deltoid-acromial", "front-septum", "deltoid-clavicular", 2e4);
  add("deltoid-acromial", "back-septum", "deltoid-spinal", 2e4);
  add("skin", "trunk-rim", "scapula", 2e4);
  add("skin", "arm-rim", "humerus", 1e4);

  recipe.bursae.front().roof.push_back({"deltoid-acromial", ""});

  const auto isNew = [](const PartRecipe& part) { return part.number > 11; };
  for (std::size_t a = 0; a < recipe.parts.size(); ++a)
    for (std::size_t b = a + 1; b < recipe.parts.size(); ++b) {
      const PartRecipe &one = recipe.parts[a], &other = recipe.parts[b];
      if ((!isNew(one) && !isNew(other)) || mayTouch(one.id, other.id)) continue;
      const bool septum = one.id.rfind("deltoid", 0) == 0 && other.id.rfind("deltoid", 0) == 0;
      recipe.exclusions.push_back({one.id, other.id,
                                   septum ? "The parts of the deltoid are one muscle, joined along their septa."
                                          : "Other layers lie between the two."});
    }
  return recipe;
}

}  // namespace glenoid::generate
