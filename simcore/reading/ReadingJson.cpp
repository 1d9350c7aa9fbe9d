// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/file/Schema.h"
#include "simcore/reading/Readings.h"

namespace glenoid {

namespace {

JsonValue fromVec(const Vec3& x) {
  JsonValue json = JsonValue::array();
  for (int i = 0; i < 3; ++i) json.append(x[i]);
  return json;
}

void setWrench(JsonValue& json, const Wrench& wrench) {
  json.set("point", fromVec(wrench.point_W));
  json.set("force", fromVec(wrench.force_W));
  json.set("torque", fromVec(wrench.torque_W));
}

JsonValue fromPart(const PartReading& part) {
  JsonValue json = JsonValue::object();
  json.set("id", part.id);
  json.set("kind", part.tool ? "tool" : part.rigid ? "rigid" : "soft");
  json.set("fixed", part.fixed);
  json.set("mass", part.mass);
  json.set("centre", fromVec(part.centre_W));
  json.set("velocity", fromVec(part.velocity_W));
  JsonValue rotation = JsonValue::array();
  for (const double value : part.q_WB.coeffs()) rotation.append(value);  // x, y, z, w
  json.set("rotation", std::move(rotation));
  json.set("angularVelocity", fromVec(part.angularVelocity_W));
  JsonValue inertia = JsonValue::array();
  for (int row = 0; row < 3; ++row) inertia.append(fromVec(part.inertia_W.row(row)));
  json.set("inertia", std::move(inertia));
  if (!part.peaks.empty()) {
    JsonValue peaks = JsonValue::object();
    for (const PartReading::Peak& peak : part.peaks) {
      JsonValue one = JsonValue::object();
      one.set("value", peak.most.value);
      one.set("at", fromVec(peak.most.at_W));
      peaks.set(quantityName(peak.quantity), std::move(one));
    }
    json.set("peaks", std::move(peaks));
  }
  if (part.rigid) return json;
  JsonValue nodes = JsonValue::array();
  for (const Vec3& node : part.nodes_W) nodes.append(fromVec(node));
  json.set("nodes", std::move(nodes));
  return json;
}

JsonValue fromContact(const ContactReading& contact) {
  JsonValue json = JsonValue::object();
  json.set("a", contact.a);
  json.set("b", contact.b);
  json.set("point", fromVec(contact.point_W));
  json.set("normal", fromVec(contact.normal_W));
  json.set("gap", contact.gap);
  json.set("force", contact.force);
  json.set("friction", fromVec(contact.friction_W));
  if (contact.film) json.set("film", true);
  return json;
}

JsonValue fromCoupling(const CouplingReading& coupling) {
  JsonValue json = JsonValue::object();
  json.set("id", coupling.id);
  json.set("a", coupling.a);
  json.set("b", coupling.b);
  json.set("springs", coupling.springs);
  setWrench(json, coupling.onA);
  return json;
}

JsonValue fromAction(const ActionReading& action) {
  JsonValue json = JsonValue::object();
  json.set("part", action.part);
  if (!action.region.empty()) json.set("region", action.region);
  setWrench(json, action.onPart);
  return json;
}

template <class T, class Function>
JsonValue listOf(const std::vector<T>& values, Function&& from) {
  JsonValue list = JsonValue::array();
  for (const T& value : values) list.append(from(value));
  return list;
}

}  // namespace

JsonValue toJson(const SceneReading& reading, const std::string& scenario) {
  JsonValue json = JsonValue::object();
  json.set("schemaVersion", schemaVersion(Schema::RunState));
  json.set("scenario", scenario);
  json.set("time", reading.time);
  json.set("step", reading.step);
  json.set("parts", listOf(reading.parts, fromPart));
  json.set("contacts", listOf(reading.contacts, fromContact));
  json.set("couplings", listOf(reading.couplings, fromCoupling));
  json.set("holds", listOf(reading.holds, fromAction));
  json.set("loads", listOf(reading.loads, fromAction));
  json.set("pressures", listOf(reading.pressures, fromAction));
  json.set("supports", listOf(reading.supports, fromAction));
  return json;
}

}  // namespace glenoid
