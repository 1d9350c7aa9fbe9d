// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <string>

#include "simcore/file/JsonValue.h"
#include "simcore/scene/Joint.h"
#include "simcore/scene/Scenario.h"

/// Between the values people author and JSON: shared by the files of this folder, nobody else includes it. Reading
/// expects documents that fit their schema; an absent member leaves the struct's default.
namespace glenoid::scene_json {

JsonValue fromVec3(const Vec3& x);
Vec3 toVec3(const JsonValue& json, const Vec3& otherwise = Vec3::Zero());

/// {"position": […], "rotation": [x, y, z, w]}. Turns stay as they are, bit for bit, unless they are more than 1e-12
/// from unit length: then they are made unit.
JsonValue fromPose(const Pose& pose);
Pose toPose(const JsonValue& json);

/// Whether a turn is a unit quaternion to 1e-6: what a person can type.
bool isUnit(const Quat& q);

JsonValue fromMaterial(const Material& material);
Material toMaterial(const JsonValue& json);
JsonValue fromMaterialUse(const MaterialUse& use);
MaterialUse toMaterialUse(const JsonValue& json);
JsonValue fromRegion(const Region& region);
Region toRegion(const JsonValue& json);
JsonValue fromLandmark(const Landmark& landmark);
Landmark toLandmark(const JsonValue& json);
JsonValue fromCoupling(const Coupling& coupling);
Coupling toCoupling(const JsonValue& json);
JsonValue fromExclusion(const Exclusion& exclusion);
Exclusion toExclusion(const JsonValue& json);
JsonValue fromBursa(const Bursa& bursa);
Bursa toBursa(const JsonValue& json);
JsonValue fromCage(const Cage& cage);
Cage toCage(const JsonValue& json);
JsonValue fromDents(const DentTable& dents);
DentTable toDents(const JsonValue& json);
JsonValue fromProof(const StartProof& proof);
StartProof toProof(const JsonValue& json);
JsonValue fromProvenance(const Provenance& provenance);
Provenance toProvenance(const JsonValue& json);
JsonValue fromColor(const std::array<float, 3>& color);
std::array<float, 3> toColor(const JsonValue& json);

/// A list, each item by its own function.
template <class T, class Function>
JsonValue listOf(const std::vector<T>& values, Function&& from) {
  JsonValue list = JsonValue::array();
  for (const T& value : values) list.append(from(value));
  return list;
}
template <class Function>
auto vectorOf(const JsonValue& list, Function&& to) {
  std::vector<decltype(to(list))> values;
  values.reserve(list.items().size());
  for (const JsonValue& item : list.items()) values.push_back(to(item));
  return values;
}
JsonValue fromTexts(const std::vector<std::string>& texts);
std::vector<std::string> toTexts(const JsonValue& json);

/// Whether a relative path, taken from a folder, stays inside it.
bool staysInside(const std::string& path);

}  // namespace glenoid::scene_json
