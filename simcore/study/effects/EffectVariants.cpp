// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/effects/EffectVariants.h"

#include "simcore/base/ThreadClock.h"
#include "simcore/scene/SceneWords.h"

namespace glenoid {

Wish wishOf(EffectChoice choice) {
  return choice == EffectChoice::Off ? Wish::Off : choice == EffectChoice::On ? Wish::On : Wish::Auto;
}

Wish* wishNamed(Effects& effects, const std::string& name) {
  for (const auto& [word, wish] : scene_words::kEffects)
    if (name == word) return &(effects.*wish);
  return nullptr;
}

Result<std::shared_ptr<const Model>> modelWith(const StudyScene& scene, const std::string& effect,
                                               EffectChoice choice) {
  Scenario scenario = scene.scenario;
  Wish* wish = wishNamed(scenario.effects, effect);
  if (!wish) return Error{Fault::UnknownId, {}, {effect, "effect"}, "study of effects"};
  *wish = wishOf(choice);
  return compileModel(scene.joint, scenario);
}

std::vector<std::string> effectsMissing(const Model& without, const Model& with, const std::string& except) {
  std::vector<std::string> missing;
  for (const EffectPlan& plan : with.effects)
    if (plan.on && plan.name != except && !without.effectOn(plan.name)) missing.push_back(plan.name);
  return missing;
}

EffectPlayer::EffectPlayer(const std::shared_ptr<const Model>& base,
                           const std::shared_ptr<const Model>& model,
                           const std::shared_ptr<const Model>& judge, const Recording& input, bool felt)
    : m_player(base, model, {model->scenario.profile}, input, judge) {
  if (!felt) return;
  m_publisher = std::make_unique<LocalPublisher>(m_player.stepper());
  for (std::size_t tool = 0; tool < model->scenario.tools.size(); ++tool)
    if (model->scenario.tools[tool].link.empty()) m_hands.push_back(static_cast<int>(tool));
}

double EffectPlayer::step(State& state) {
  const Inputs& inputs = m_player.inputsAt(state);
  const double begin = threadCpuMs();
  m_report = &m_player.stepper().step(inputs, state);
  if (m_publisher) {
    m_publisher->stepped(*m_report);
    for (const int tool : m_hands) m_publisher->read(state, tool, m_problem);
  }
  return threadCpuMs() - begin;
}

}  // namespace glenoid
