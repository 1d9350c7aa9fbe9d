// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scenes/EffectScenes.h"

#include "simcore/scene/JointFile.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid::scenes {
namespace {

/// Says the same everywhere: some tenth of a millimetre for a newton.
std::shared_ptr<const DentTable> evenDents(const Joint& joint, const Part& part) {
  DentTable table;
  table.radii = {1e-3, 2e-3, 4e-3};
  DentSample sample;
  sample.modulus = 6e4;
  sample.depthMost = 2e-3;
  sample.compliance = {9e-3, 4.5e-3, 2.3e-3};
  table.samples = {sample, sample};
  table.samples[1].at_W = Vec3(0.01, 0, 0);
  table.basis = dentBasis(joint, part);
  return std::make_shared<const DentTable>(std::move(table));
}

void excludeAllPairs(Joint& joint) {
  joint.exclusions.clear();
  for (std::size_t a = 0; a < joint.parts.size(); ++a)
    for (std::size_t b = a + 1; b < joint.parts.size(); ++b)
      joint.exclusions.push_back({joint.parts[a].id, joint.parts[b].id, {}});
}

void excludeCoupledPairs(Joint& joint) {
  for (const Coupling& coupling : joint.couplings)
    joint.exclusions.push_back({coupling.partA, coupling.partB, {}});
}

void smooth(EffectScene& scene) {
  for (Material& material : scene.joint.materials) material.friction = 0;
  for (Tool& tool : scene.scenario.tools) tool.friction = 0;
}

void undamp(Joint& joint) {
  for (Material& material : joint.materials) material.massDamping = material.stiffnessDamping = 0;
  for (Coupling& coupling : joint.couplings) coupling.damping = 0;
}

/// Nothing is left for the effect to act on.
void takeAway(EffectScene& scene, const std::string& effect) {
  Joint& joint = scene.joint;
  Scenario& scenario = scene.scenario;
  if (effect == "gravity") scenario.gravity_W.setZero();
  if (effect == "couplings") joint.couplings.clear();
  if (effect == "contact") {
    excludeAllPairs(joint);
    joint.bursae.clear();
    for (Tool& tool : scenario.tools) {
      tool.perforates.clear();
      for (const Part& part : joint.parts) tool.perforates.push_back(part.id);
    }
  }
  if (effect == "selfContact") scenario.selfContactParts.clear();
  if (effect == "friction") smooth(scene);
  if (effect == "damping") undamp(joint);
  if (effect == "bursa") joint.bursae.clear();
  if (effect == "dent")
    for (Part& part : joint.parts) part.dents = nullptr;
}

Wish& wishIn(Effects& effects, const std::string& effect) {
  if (effect == "gravity") return effects.gravity;
  if (effect == "couplings") return effects.couplings;
  if (effect == "contact") return effects.contact;
  if (effect == "selfContact") return effects.selfContact;
  if (effect == "friction") return effects.friction;
  if (effect == "damping") return effects.damping;
  if (effect == "bursa") return effects.bursa;
  return effects.dent;
}

}  // namespace

EffectScene wholeScene() {
  EffectScene scene;
  Joint& joint = scene.joint;
  joint.id = joint.name = "whole";
  addMaterials(joint);
  for (Material& material : joint.materials) material.friction = 0.3;
  joint.parts = {boxPart("plate", 1, PartKind::Rigid, Vec3(-0.03, -0.01, -0.03), Vec3(0.03, 0, 0.03)),
                 boxPart("block", 2, PartKind::Soft, Vec3(-0.02, 0, -0.02), Vec3(0.02, 0.02, 0.02), 3),
                 boxPart("slab", 3, PartKind::Soft, Vec3(-0.02, 0.0205, -0.02), Vec3(0.02, 0.0405, 0.02), 3)};
  Part& block = joint.parts[1];
  block.regions.push_back(regionIn(block, "base", Box3(Vec3(-1, -1e-4, -1), Vec3(1, 1e-4, 1))));
  joint.couplings.push_back({"glue", "block", "plate", "base", 1e8, 1e-3});
  Bursa bursa;
  bursa.id = "bursa";
  bursa.floor = {{"block", ""}};
  bursa.roof = {{"slab", ""}};
  joint.bursae = {bursa};
  joint.parts[2].dents = evenDents(joint, joint.parts[2]);
  Scenario& scenario = scene.scenario;
  scenario.id = scenario.name = "whole";
  scenario.fixedParts = {"plate"};
  Tool finger;
  finger.id = finger.name = "finger";
  finger.kind = ToolKind::Finger;
  finger.length = 0.06;
  finger.radius = 0.006;
  finger.friction = 0.3;
  finger.home = {Vec3(0, 0.043, 0), Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitY())};
  scenario.tools = {finger};
  return scene;
}

Pose pressedHand() { return {Vec3(0.002, 0.036, 0.001), Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitY())}; }

EffectScene effectScene(Joint joint, Scenario scenario, const std::string& effect, EffectForm form) {
  EffectScene scene{std::move(joint), std::move(scenario)};
  if (effect != "dent")
    for (Part& part : scene.joint.parts) part.dents = nullptr;
  if (effect == "gravity") smooth(scene);  // where a friction solve ends is scaled by the scenario's gravity, whether that acts or not
  if (effect == "couplings") excludeCoupledPairs(scene.joint);
  if (effect == "contact" && scene.scenario.tools.size() > 1) scene.scenario.tools.resize(1);
  if (effect == "selfContact")
    for (const Part& part : scene.joint.parts)
      if (part.kind == PartKind::Soft) scene.scenario.selfContactParts.push_back(part.id);
  if (effect == "friction") scene.joint.bursae.clear();  // a film has friction of its own
  Wish& wish = wishIn(scene.scenario.effects, effect);
  wish = form == EffectForm::Off ? Wish::Off : form == EffectForm::On ? Wish::On : Wish::Auto;
  if (form == EffectForm::Never) takeAway(scene, effect);
  return scene;
}

}  // namespace glenoid::scenes
