// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/step/EffectFacts.h"

#include <algorithm>

#include "simcore/step/Model.h"

namespace glenoid {
namespace {

template <class List, class Test>
double howMany(const List& list, const Test& test) {
  return static_cast<double>(std::count_if(list.begin(), list.end(), test));
}

std::vector<EffectFacts::Count> countsOf(const Model& model, const std::string& effect) {
  const Joint& joint = model.joint;
  const Scenario& scenario = model.scenario;
  if (effect == "gravity")
    return {{"movingParts",
             howMany(model.objects,
                     [](const SceneObject& object) { return object.layout.free && !object.tool; })},
            {"acceleration", scenario.gravity_W.norm()}};
  if (effect == "couplings")
    return {{"couplings", static_cast<double>(joint.couplings.size())},
            {"springs", static_cast<double>(model.springs.size())}};
  if (effect == "contact")
    return {{"pairs", howMany(model.collisionPairs, [](const CollisionPair& pair) { return !pair.self(); })}};
  if (effect == "selfContact")
    return {{"parts", howMany(model.collisionPairs, [](const CollisionPair& pair) { return pair.self(); })},
            {"softParts", howMany(model.objects, [](const SceneObject& object) {
               return object.layout.free && !object.layout.rigid;
             })}};
  if (effect == "friction")
    return {{"materials",
             howMany(joint.materials, [](const Material& material) { return material.friction > 0; })},
            {"tools", howMany(scenario.tools, [](const Tool& tool) { return tool.friction > 0; })}};
  if (effect == "damping")
    return {{"materials", howMany(joint.materials,
                                  [](const Material& material) {
                                    return material.massDamping > 0 || material.stiffnessDamping > 0;
                                  })},
            {"couplings",
             howMany(joint.couplings, [](const Coupling& coupling) { return coupling.damping > 0; })}};
  if (effect == "bursa") return {{"bursae", static_cast<double>(joint.bursae.size())}};
  if (effect == "dent")
    return {{"parts", howMany(joint.parts,
                              [](const Part& part) { return part.dents && !part.dents->samples.empty(); })},
            {"tools", howMany(scenario.tools, [](const Tool& tool) { return tool.kind != ToolKind::Bar; })}};
  if (effect == "haptics")
    return {{"tools", howMany(scenario.tools, [](const Tool& tool) { return tool.link.empty(); })}};
  return {};
}

/// Effects that are about what touches.
bool actsOnContact(const std::string& effect) {
  return effect == "selfContact" || effect == "friction" || effect == "bursa" || effect == "dent";
}

}  // namespace

std::vector<EffectFacts> effectFacts(const Model& model) {
  std::vector<EffectFacts> facts;
  for (const EffectPlan& plan : model.effects) {
    EffectFacts& one =
        facts.emplace_back(EffectFacts{plan.name, plan.on, plan.reason, countsOf(model, plan.name)});
    if (!one.on && one.reason == "nothing-to-act-on" && actsOnContact(one.name) && !model.effectOn("contact"))
      one.reason = "no-contact";
    // The plan of a step knows no haptic thread: the step has none.
    if (one.name == "haptics" && one.reason == "not-built") one.reason = "run-felt";
  }
  return facts;
}

}  // namespace glenoid
