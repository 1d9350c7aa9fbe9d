// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/SceneJson.h"

#include <charconv>
#include <filesystem>

#include "simcore/scene/SceneWords.h"

namespace glenoid::scene_json {
namespace {

/// Members that say nothing are left out, so that a file shows what was meant.
void setText(JsonValue& json, const char* key, const std::string& text) {
  if (!text.empty()) json.set(key, text);
}

/// The shortest decimal that is this float, not the long one of its double.
double plainDouble(float value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  double plain = value;
  std::from_chars(digits, end, plain);
  return plain;
}

}  // namespace

JsonValue fromVec3(const Vec3& x) {
  JsonValue json = JsonValue::array();
  for (const double value : x) json.append(value);
  return json;
}

Vec3 toVec3(const JsonValue& json, const Vec3& otherwise) {
  if (json.items().size() != 3) return otherwise;
  return {json[0].number(), json[1].number(), json[2].number()};
}

JsonValue fromPose(const Pose& pose) {
  JsonValue json = JsonValue::object();
  json.set("position", fromVec3(pose.p_WB));
  JsonValue rotation = JsonValue::array();
  for (const double value : pose.q_WB.coeffs()) rotation.append(value);  // x, y, z, w
  json.set("rotation", std::move(rotation));
  return json;
}

Pose toPose(const JsonValue& json) {
  Pose pose;
  pose.p_WB = toVec3(json["position"]);
  const JsonValue& r = json["rotation"];
  if (r.items().size() == 4) pose.q_WB = Quat(r[3].number(), r[0].number(), r[1].number(), r[2].number());
  if (isUnit(pose.q_WB) && std::abs(pose.q_WB.norm() - 1) > 1e-12) pose.q_WB.normalize();
  return pose;
}

bool isUnit(const Quat& q) {
  return std::abs(q.norm() - 1) <= 1e-6;
}

JsonValue fromMaterial(const Material& material) {
  JsonValue json = JsonValue::object();
  json.set("id", material.id);
  setText(json, "name", material.name);
  if (material.appearance != Appearance::Plain)
    json.set("appearance", scene_words::wordOf(scene_words::kAppearances, material.appearance));
  json.set("density", material.density);
  json.set("youngsModulus", material.youngsModulus);
  json.set("poissonRatio", material.poissonRatio);
  json.set("friction", material.friction);
  json.set("massDamping", material.massDamping);
  json.set("stiffnessDamping", material.stiffnessDamping);
  if (material.literatureYoungsModulus)
    json.set("literatureYoungsModulus", *material.literatureYoungsModulus);
  setText(json, "reason", material.reason);
  setText(json, "source", material.source);
  return json;
}

Material toMaterial(const JsonValue& json) {
  Material material;
  material.id = json["id"].text();
  material.name = json["name"].text();
  material.appearance =
      scene_words::valueOf(scene_words::kAppearances, json["appearance"].text(), material.appearance);
  material.density = json["density"].number(material.density);
  material.youngsModulus = json["youngsModulus"].number(material.youngsModulus);
  material.poissonRatio = json["poissonRatio"].number(material.poissonRatio);
  material.friction = json["friction"].number(material.friction);
  material.massDamping = json["massDamping"].number(material.massDamping);
  material.stiffnessDamping = json["stiffnessDamping"].number(material.stiffnessDamping);
  if (const JsonValue* value = json.find("literatureYoungsModulus"))
    material.literatureYoungsModulus = value->number();
  material.reason = json["reason"].text();
  material.source = json["source"].text();
  return material;
}

JsonValue fromMaterialUse(const MaterialUse& use) {
  JsonValue json = JsonValue::object();
  json.set("material", use.material);
  setText(json, "region", use.region);
  if (use.thickness > 0) json.set("thickness", use.thickness);
  return json;
}

MaterialUse toMaterialUse(const JsonValue& json) {
  return {json["material"].text(), json["region"].text(), json["thickness"].number()};
}

JsonValue fromRegion(const Region& region) {
  JsonValue json = JsonValue::object();
  json.set("id", region.id);
  setText(json, "name", region.name);
  setText(json, "kind", region.kind);
  json.set("surface", region.surface == SurfaceKind::Visual ? "visual" : "collision");
  json.set("triangles", listOf(region.triangles, [](const TriangleRun& run) {
             JsonValue pair = JsonValue::array();
             pair.append(run.first);
             pair.append(run.count);
             return pair;
           }));
  return json;
}

Region toRegion(const JsonValue& json) {
  Region region;
  region.id = json["id"].text();
  region.name = json["name"].text();
  region.kind = json["kind"].text();
  region.surface = json["surface"].text() == "collision" ? SurfaceKind::Collision : SurfaceKind::Visual;
  region.triangles = vectorOf(json["triangles"], [](const JsonValue& run) {
    return TriangleRun{static_cast<int>(run[0].integer()), static_cast<int>(run[1].integer())};
  });
  return region;
}

JsonValue fromLandmark(const Landmark& landmark) {
  JsonValue json = JsonValue::object();
  json.set("id", landmark.id);
  setText(json, "name", landmark.name);
  json.set("position", fromVec3(landmark.position_W));
  return json;
}

Landmark toLandmark(const JsonValue& json) {
  return {json["id"].text(), json["name"].text(), toVec3(json["position"])};
}

JsonValue fromCoupling(const Coupling& coupling) {
  JsonValue json = JsonValue::object();
  json.set("id", coupling.id);
  json.set("partA", coupling.partA);
  if (!coupling.regionA.empty()) json.set("regionA", coupling.regionA);
  if (coupling.byNodes()) json.set("nodesA", listOf(coupling.nodesA, [](int node) { return JsonValue(node); }));
  json.set("partB", coupling.partB);
  if (!coupling.byNodes() || coupling.stiffnessPerArea != 0) json.set("stiffnessPerArea", coupling.stiffnessPerArea);
  if (coupling.byNodes() || coupling.stiffnessPerNode != 0) json.set("stiffnessPerNode", coupling.stiffnessPerNode);
  json.set("damping", coupling.damping);
  setText(json, "reason", coupling.reason);
  return json;
}

Coupling toCoupling(const JsonValue& json) {
  Coupling coupling;
  coupling.id = json["id"].text();
  coupling.partA = json["partA"].text();
  coupling.partB = json["partB"].text();
  coupling.regionA = json["regionA"].text();
  coupling.nodesA = vectorOf(json["nodesA"], [](const JsonValue& node) { return static_cast<int>(node.integer()); });
  coupling.stiffnessPerArea = json["stiffnessPerArea"].number();
  coupling.stiffnessPerNode = json["stiffnessPerNode"].number();
  coupling.damping = json["damping"].number(coupling.damping);
  coupling.reason = json["reason"].text();
  return coupling;
}

JsonValue fromExclusion(const Exclusion& exclusion) {
  JsonValue json = JsonValue::object();
  json.set("partA", exclusion.partA);
  json.set("partB", exclusion.partB);
  setText(json, "reason", exclusion.reason);
  return json;
}

Exclusion toExclusion(const JsonValue& json) {
  return {json["partA"].text(), json["partB"].text(), json["reason"].text()};
}

namespace {
JsonValue fromSide(const BursaSide& side) {
  JsonValue json = JsonValue::object();
  json.set("part", side.part);
  setText(json, "region", side.region);
  return json;
}
BursaSide toSide(const JsonValue& json) {
  return {json["part"].text(), json["region"].text()};
}
}  // namespace

JsonValue fromDents(const DentTable& dents) {
  JsonValue json = JsonValue::object();
  json.set("radii", listOf(std::vector<double>(dents.radii.begin(), dents.radii.end()), [](double radius) { return JsonValue(radius); }));
  json.set("samples", listOf(dents.samples, [](const DentSample& sample) {
             JsonValue row = fromVec3(sample.at_W);
             row.append(sample.modulus);
             for (const double compliance : sample.compliance) row.append(compliance);
             row.append(sample.depthMost);
             return row;
           }));
  json.set("basis", dents.basis);
  return json;
}

DentTable toDents(const JsonValue& json) {
  DentTable dents;
  for (std::size_t k = 0; k < dents.radii.size(); ++k) dents.radii[k] = json["radii"][k].number();
  dents.samples = vectorOf(json["samples"], [](const JsonValue& row) {
    DentSample sample{Vec3(row[0].number(), row[1].number(), row[2].number()), row[3].number()};
    for (std::size_t k = 0; k < sample.compliance.size(); ++k) sample.compliance[k] = row[4 + k].number();
    sample.depthMost = row[4 + sample.compliance.size()].number();
    return sample;
  });
  dents.basis = json["basis"].text();
  return dents;
}

JsonValue fromBursa(const Bursa& bursa) {
  JsonValue json = JsonValue::object();
  json.set("id", bursa.id);
  setText(json, "name", bursa.name);
  json.set("floor", listOf(bursa.floor, fromSide));
  json.set("roof", listOf(bursa.roof, fromSide));
  json.set("thickness", bursa.thickness);
  json.set("youngsModulus", bursa.youngsModulus);
  json.set("damping", bursa.damping);
  json.set("friction", bursa.friction);
  setText(json, "source", bursa.source);
  return json;
}

Bursa toBursa(const JsonValue& json) {
  Bursa bursa;
  bursa.id = json["id"].text();
  bursa.name = json["name"].text();
  bursa.floor = vectorOf(json["floor"], toSide);
  bursa.roof = vectorOf(json["roof"], toSide);
  bursa.thickness = json["thickness"].number(bursa.thickness);
  bursa.youngsModulus = json["youngsModulus"].number(bursa.youngsModulus);
  bursa.damping = json["damping"].number(bursa.damping);
  bursa.friction = json["friction"].number(bursa.friction);
  bursa.source = json["source"].text();
  return bursa;
}

JsonValue fromCage(const Cage& cage) {
  JsonValue json = JsonValue::object();
  json.set("id", cage.id);
  json.set("part", cage.part);
  json.set("triangles", listOf(cage.triangles, [](const std::array<int, 3>& corners) {
             JsonValue list = JsonValue::array();
             for (const int corner : corners) list.append(corner);
             return list;
           }));
  json.set("rest", listOf(cage.rest_W, fromVec3));
  json.set("moved", listOf(cage.moved_W, fromVec3));
  return json;
}

Cage toCage(const JsonValue& json) {
  Cage cage;
  cage.id = json["id"].text();
  cage.part = json["part"].text();
  cage.triangles = vectorOf(json["triangles"], [](const JsonValue& list) {
    std::array<int, 3> corners;
    for (int i = 0; i < 3; ++i) corners[i] = static_cast<int>(list[i].integer());
    return corners;
  });
  cage.rest_W = vectorOf(json["rest"], [](const JsonValue& x) { return toVec3(x); });
  cage.moved_W = vectorOf(json["moved"], [](const JsonValue& x) { return toVec3(x); });
  return cage;
}

JsonValue fromProof(const StartProof& proof) {
  JsonValue json = JsonValue::object();
  json.set("of", proof.of);
  json.set("pairs", proof.pairs);
  json.set("cuts", proof.cuts);
  json.set("visualCuts", proof.visualCuts);
  json.set("minVolumeRatio", proof.minVolumeRatio);
  return json;
}

StartProof toProof(const JsonValue& json) {
  StartProof proof;
  proof.of = json["of"].text();
  proof.pairs = static_cast<int>(json["pairs"].integer());
  proof.cuts = static_cast<int>(json["cuts"].integer());
  proof.visualCuts = static_cast<int>(json["visualCuts"].integer());
  proof.minVolumeRatio = json["minVolumeRatio"].number(proof.minVolumeRatio);
  return proof;
}

JsonValue fromProvenance(const Provenance& provenance) {
  JsonValue json = JsonValue::object();
  setText(json, "author", provenance.author);
  setText(json, "license", provenance.license);
  setText(json, "source", provenance.source);
  setText(json, "made", provenance.made);
  return json;
}

Provenance toProvenance(const JsonValue& json) {
  return {json["author"].text(), json["license"].text(), json["source"].text(), json["made"].text()};
}

JsonValue fromColor(const std::array<float, 3>& color) {
  JsonValue json = JsonValue::array();
  for (const float channel : color) json.append(plainDouble(channel));
  return json;
}

std::array<float, 3> toColor(const JsonValue& json) {
  std::array<float, 3> color = Part{}.color;
  for (std::size_t i = 0; i < 3; ++i) color[i] = static_cast<float>(json[i].number(color[i]));
  return color;
}

JsonValue fromTexts(const std::vector<std::string>& texts) {
  return listOf(texts, [](const std::string& text) { return JsonValue(text); });
}

std::vector<std::string> toTexts(const JsonValue& json) {
  return vectorOf(json, [](const JsonValue& item) { return item.text(); });
}

bool staysInside(const std::string& path) {
  if (path.empty() || path.find('\\') != std::string::npos || path.find('\0') != std::string::npos)
    return false;
  const std::filesystem::path parts(path);
  if (parts.is_absolute()) return false;
  for (const auto& part : parts)
    if (part == "..") return false;
  return true;
}

}  // namespace glenoid::scene_json
