// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/ScenarioJson.h"

#include "simcore/file/Schema.h"
#include "simcore/scene/SceneJson.h"
#include "simcore/scene/SceneWords.h"
#include "simcore/scene/training/TrainingJson.h"

namespace glenoid::scene_json {
namespace {

using namespace scene_words;

JsonValue fromAxes(const Axes& axes) {
  JsonValue json = JsonValue::array();
  for (const AxisWord& axis : kAxes)
    if (axes.*axis.axis) json.append(axis.word);
  return json;
}

Axes toAxes(const JsonValue& json) {
  if (!json.isArray()) return {};
  Axes axes{false, false, false};
  for (const JsonValue& word : json.items())
    for (const AxisWord& axis : kAxes)
      if (word.text() == axis.word) axes.*axis.axis = true;
  return axes;
}

JsonValue fromHold(const Hold& hold) {
  JsonValue json = JsonValue::object();
  json.set("part", hold.part);
  json.set("stiffness", hold.stiffness);
  json.set("angularStiffness", hold.angularStiffness);
  json.set("damping", hold.damping);
  if (hold.axes != Axes{}) json.set("axes", fromAxes(hold.axes));
  if (hold.angularAxes != Axes{}) json.set("angularAxes", fromAxes(hold.angularAxes));
  return json;
}

Hold toHold(const JsonValue& json) {
  Hold hold;
  hold.part = json["part"].text();
  hold.stiffness = json["stiffness"].number(hold.stiffness);
  hold.angularStiffness = json["angularStiffness"].number(hold.angularStiffness);
  hold.damping = json["damping"].number(hold.damping);
  hold.axes = toAxes(json["axes"]);
  hold.angularAxes = toAxes(json["angularAxes"]);
  return hold;
}

JsonValue fromLoad(const Load& load) {
  JsonValue json = JsonValue::object();
  json.set("part", load.part);
  json.set("force", fromVec3(load.force_W));
  json.set("torque", fromVec3(load.torque_W));
  if (load.point_W) json.set("point", fromVec3(*load.point_W));
  return json;
}

Load toLoad(const JsonValue& json) {
  Load load{json["part"].text(), toVec3(json["force"], Vec3::Zero()), toVec3(json["torque"], Vec3::Zero()), {}};
  if (json.find("point")) load.point_W = toVec3(json["point"], Vec3::Zero());
  return load;
}

JsonValue fromPressure(const Pressure& pressure) {
  JsonValue json = JsonValue::object();
  json.set("part", pressure.part);
  json.set("region", pressure.region);
  json.set("pressure", pressure.pressure);
  return json;
}

Pressure toPressure(const JsonValue& json) {
  return {json["part"].text(), json["region"].text(), json["pressure"].number()};
}

JsonValue fromSupport(const Support& support) {
  JsonValue json = JsonValue::object();
  json.set("part", support.part);
  json.set("region", support.region);
  json.set("axes", fromAxes(support.axes));
  json.set("stiffnessPerArea", support.stiffnessPerArea);
  json.set("damping", support.damping);
  return json;
}

Support toSupport(const JsonValue& json) {
  Support support{json["part"].text(), json["region"].text(), toAxes(json["axes"]), json["stiffnessPerArea"].number()};
  support.damping = json["damping"].number(support.damping);
  return support;
}

JsonValue fromMotionKey(const MotionKey& key) {
  JsonValue json = JsonValue::object();
  json.set("time", key.time);
  json.set("displacement", fromVec3(key.displacement_W));
  json.set("rotation", fromPose({key.displacement_W, key.turn_W})["rotation"]);
  return json;
}

MotionKey toMotionKey(const JsonValue& json) {
  return {json["time"].number(), toVec3(json["displacement"], Vec3::Zero()), toPose(json).q_WB};
}

JsonValue fromMotion(const Motion& motion) {
  JsonValue json = JsonValue::object();
  json.set("part", motion.part);
  json.set("centre", fromVec3(motion.centre_W));
  json.set("keys", listOf(motion.keys, fromMotionKey));
  return json;
}

Motion toMotion(const JsonValue& json) {
  return {json["part"].text(), toVec3(json["centre"], Vec3::Zero()), vectorOf(json["keys"], toMotionKey)};
}

JsonValue fromTool(const Tool& tool) {
  JsonValue json = JsonValue::object();
  json.set("id", tool.id);
  json.set("name", tool.name);
  json.set("kind", wordOf(kToolKinds, tool.kind));
  json.set("length", tool.length);
  json.set("radius", tool.radius);
  json.set("mass", tool.mass);
  json.set("stiffness", tool.stiffness);
  json.set("angularStiffness", tool.angularStiffness);
  json.set("dampingRatio", tool.dampingRatio);
  json.set("forceMax", tool.forceMax);
  json.set("friction", tool.friction);
  const Tool usual;
  if (tool.lens != usual.lens) json.set("lens", tool.lens);
  if (tool.lensTurn != usual.lensTurn) json.set("lensTurn", tool.lensTurn);
  if (tool.fieldOfView != usual.fieldOfView) json.set("fieldOfView", tool.fieldOfView);
  if (tool.inAir) json.set("inAir", tool.inAir);
  json.set("home", fromPose(tool.home));
  json.set("perforates", fromTexts(tool.perforates));
  if (!tool.link.empty()) {
    json.set("link", tool.link);
    json.set("linkStiffness", tool.linkStiffness);
  }
  return json;
}

Tool toTool(const JsonValue& json) {
  Tool tool;
  tool.id = json["id"].text();
  tool.name = json["name"].text();
  tool.kind = valueOf(kToolKinds, json["kind"].text(), tool.kind);
  tool.length = json["length"].number(tool.length);
  tool.radius = json["radius"].number(tool.radius);
  tool.mass = json["mass"].number(tool.mass);
  tool.stiffness = json["stiffness"].number(tool.stiffness);
  tool.angularStiffness = json["angularStiffness"].number(tool.angularStiffness);
  tool.dampingRatio = json["dampingRatio"].number(tool.dampingRatio);
  tool.forceMax = json["forceMax"].number(tool.forceMax);
  tool.friction = json["friction"].number(tool.friction);
  tool.lens = json["lens"].number(tool.lens);
  tool.lensTurn = json["lensTurn"].number(tool.lensTurn);
  tool.fieldOfView = json["fieldOfView"].number(tool.fieldOfView);
  tool.inAir = json["inAir"].boolean(tool.inAir);
  tool.home = toPose(json["home"]);
  tool.perforates = toTexts(json["perforates"]);
  tool.link = json["link"].text();
  tool.linkStiffness = json["linkStiffness"].number(tool.linkStiffness);
  return tool;
}

JsonValue fromCamera(const Camera& camera) {
  JsonValue json = JsonValue::object();
  json.set("id", camera.id);
  json.set("name", camera.name);
  json.set("eye", fromVec3(camera.eye_W));
  json.set("target", fromVec3(camera.target_W));
  json.set("up", fromVec3(camera.up_W));
  json.set("fieldOfView", camera.fieldOfView);
  return json;
}

Camera toCamera(const JsonValue& json) {
  Camera camera;
  camera.id = json["id"].text();
  camera.name = json["name"].text();
  camera.eye_W = toVec3(json["eye"], camera.eye_W);
  camera.target_W = toVec3(json["target"], camera.target_W);
  camera.up_W = toVec3(json["up"], camera.up_W);
  camera.fieldOfView = json["fieldOfView"].number(camera.fieldOfView);
  return camera;
}

}  // namespace

JsonValue fromScenario(const Scenario& scenario) {
  JsonValue json = JsonValue::object();
  json.set("schemaVersion", schemaVersion(Schema::Scenario));
  json.set("id", scenario.id);
  json.set("name", scenario.name);
  json.set("description", scenario.description);
  json.set("joint", scenario.joint);
  json.set("dt", scenario.dt);
  json.set("gravity", fromVec3(scenario.gravity_W));
  json.set("profile", wordOf(kProfiles, scenario.profile));
  if (scenario.elements) json.set("elements", wordOf(kElements, *scenario.elements));
  if (scenario.contactDistance > 0) json.set("contactDistance", scenario.contactDistance);
  if (scenario.recoverySpeedMax > 0) json.set("recoverySpeedMax", scenario.recoverySpeedMax);
  json.set("fixedParts", fromTexts(scenario.fixedParts));
  json.set("holds", listOf(scenario.holds, fromHold));
  json.set("loads", listOf(scenario.loads, fromLoad));
  if (scenario.loadRise != 0) json.set("loadRise", scenario.loadRise);
  if (!scenario.pressures.empty()) json.set("pressures", listOf(scenario.pressures, fromPressure));
  if (!scenario.supports.empty()) json.set("supports", listOf(scenario.supports, fromSupport));
  if (!scenario.motions.empty()) json.set("motions", listOf(scenario.motions, fromMotion));
  json.set("tools", listOf(scenario.tools, fromTool));
  JsonValue effects = JsonValue::object();
  for (const EffectWord& effect : kEffects)
    effects.set(effect.word, wordOf(kWishes, scenario.effects.*effect.wish));
  json.set("effects", std::move(effects));
  if (!scenario.selfContactParts.empty()) json.set("selfContactParts", fromTexts(scenario.selfContactParts));
  json.set("cameras", listOf(scenario.cameras, fromCamera));
  if (scenario.training != Training{}) json.set("training", fromTraining(scenario.training));
  json.set("input", scenario.input);
  json.set("seed", scenario.seed);
  return json;
}

Scenario toScenario(const JsonValue& json) {
  Scenario scenario;
  scenario.id = json["id"].text();
  scenario.name = json["name"].text();
  scenario.description = json["description"].text();
  scenario.joint = json["joint"].text();
  scenario.dt = json["dt"].number(scenario.dt);
  scenario.gravity_W = toVec3(json["gravity"], scenario.gravity_W);
  scenario.profile = valueOf(kProfiles, json["profile"].text(), scenario.profile);
  if (json.find("elements")) scenario.elements = valueOf(kElements, json["elements"].text(), Elements::Tetrahedra);
  // What a file leaves open follows the joint; the first form of the file meant the shoulder's figures.
  const bool fixedLengths = json["schemaVersion"].integer(2) < 2;
  scenario.contactDistance = json["contactDistance"].number(fixedLengths ? scenario.contactDistance : 0);
  scenario.recoverySpeedMax = json["recoverySpeedMax"].number(fixedLengths ? scenario.recoverySpeedMax : 0);
  scenario.loadRise = json["loadRise"].number(scenario.loadRise);
  scenario.fixedParts = toTexts(json["fixedParts"]);
  scenario.holds = vectorOf(json["holds"], toHold);
  scenario.loads = vectorOf(json["loads"], toLoad);
  scenario.pressures = vectorOf(json["pressures"], toPressure);
  scenario.supports = vectorOf(json["supports"], toSupport);
  scenario.motions = vectorOf(json["motions"], toMotion);
  scenario.tools = vectorOf(json["tools"], toTool);
  for (const EffectWord& effect : kEffects) {
    Wish& wish = scenario.effects.*effect.wish;
    wish = valueOf(kWishes, json["effects"][effect.word].text(), wish);
  }
  scenario.selfContactParts = toTexts(json["selfContactParts"]);
  scenario.cameras = vectorOf(json["cameras"], toCamera);
  scenario.training = toTraining(json["training"]);
  scenario.input = json["input"].text();
  scenario.seed = static_cast<unsigned>(json["seed"].integer(scenario.seed));
  return scenario;
}

}  // namespace glenoid::scene_json
