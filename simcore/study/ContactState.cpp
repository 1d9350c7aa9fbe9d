// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/ContactState.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>


namespace glenoid {
namespace {

constexpr double kNearEnough = 0.03;    ///< of the wanted number
constexpr double kDistanceFactor = 10;   ///< most that the contact distance is changed
constexpr int kBisections = 24;

std::string markAt(const Recording& input, double time) {
  for (const RecordingMark& mark : input.marks)
    if (time >= mark.begin && time < mark.end) return mark.name;
  return {};
}

int contactsWith(const Model& model, const ContactState& found, double distance, int& pressing) {
  const auto other = std::make_shared<Model>(model);  // shares everything that the distance does not touch
  other->scenario.contactDistance = distance;
  Stepper stepper(other, {});
  State state = found.state;
  const StepReport& report = stepper.step(found.inputs, state);
  pressing = report.pressing;
  return report.contacts;
}

void changeDistance(const Model& model, ContactState& found) {
  double low = model.scenario.contactDistance / kDistanceFactor, high = model.scenario.contactDistance * kDistanceFactor;
  for (int i = 0; i < kBisections; ++i) {
    const double distance = 0.5 * (low + high);
    int pressing = 0;
    const int contacts = contactsWith(model, found, distance, pressing);
    if (std::abs(contacts - found.wanted) < std::abs(found.contacts - found.wanted)) {
      found.contacts = contacts;
      found.pressing = pressing;
      found.contactDistance = distance;
      found.distanceChanged = true;
    }
    if (contacts == found.wanted) return;
    (contacts < found.wanted ? low : high) = distance;
  }
}

/// One play of the input under so many times the scenario's loads, for all states that want it so.
Result<Done> search(const StudyScene& scene, double factor, const std::vector<ContactState*>& found,
                    const std::function<bool(double)>& progress) {
  ContactState loaded;
  loaded.loadFactor = factor;
  loaded.contactDistance = scene.scenario.contactDistance;
  const Scenario scenario = scenarioOf(scene, loaded);
  const auto model = compileModel(scene.joint, scenario);
  if (!model) return model.error();
  Stepper stepper(*model, {});
  State state = (*model)->start, before = state;
  Inputs inputs;
  const double dt = scenario.dt;
  const long steps = std::lround(inputSeconds(scene.input) / dt);
  for (long s = 0; s < steps; ++s) {
    handsAt(scenario, &scene.input, static_cast<double>(s + 1) * dt, inputs.hands);
    before = state;
    const StepReport& report = stepper.step(inputs, state);
    const std::string mark = markAt(scene.input, before.time);
    if (!progress(static_cast<double>(s + 1) / static_cast<double>(steps)))
      return Error{Fault::Cancelled, {}, {}, "looking for states"};
    if (mark.empty() || report.pressing == 0) continue;
    for (ContactState* best : found) {
      // What is missing of those that press counts like what is off in all; of equals more press.
      const auto rank = [best](int contacts, int pressing) {
        return std::array{std::max(0, best->pressingWanted - pressing) + std::abs(contacts - best->wanted), -pressing};
      };
      if (best->contacts > 0 && rank(report.contacts, report.pressing) >= rank(best->contacts, best->pressing)) continue;
      *best = {best->wanted, best->pressingWanted, report.contacts, report.pressing, before.time, scenario.contactDistance, factor, false, mark, before, inputs};
    }
  }
  for (ContactState* best : found) {
    if (best->contacts == 0) return Error{Fault::Unusable, {}, {"the input never presses on anything"}, "looking for states"};
    if (std::abs(best->contacts - best->wanted) > kNearEnough * best->wanted) changeDistance(**model, *best);
  }
  return Done{};
}

}  // namespace

Result<std::vector<ContactState>> findContactStates(const StudyScene& scene, const std::vector<ContactWish>& wanted,
                                                    const std::function<bool(double)>& progress) {
  std::vector<ContactState> found(wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    found[i].wanted = wanted[i].contacts;
    found[i].pressingWanted = wanted[i].pressing;
    found[i].loadFactor = wanted[i].loadFactor;
  }
  std::vector<double> factors;
  for (const ContactWish& wish : wanted)
    if (std::find(factors.begin(), factors.end(), wish.loadFactor) == factors.end()) factors.push_back(wish.loadFactor);
  for (std::size_t p = 0; p < factors.size(); ++p) {
    std::vector<ContactState*> group;
    for (ContactState& state : found)
      if (state.loadFactor == factors[p]) group.push_back(&state);
    const auto part = [&](double done) { return !progress || progress((static_cast<double>(p) + done) / static_cast<double>(factors.size())); };
    if (Result<Done> searched = search(scene, factors[p], group, part); !searched) return searched.error();
  }
  return found;
}

Scenario scenarioOf(const StudyScene& scene, const ContactState& state) {
  Scenario scenario = scene.scenario;
  scenario.contactDistance = state.contactDistance;
  for (Load& load : scenario.loads) {
    load.force_W *= state.loadFactor;
    load.torque_W *= state.loadFactor;
  }
  return scenario;
}

}  // namespace glenoid
