// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/ContactState.h"

#include <cmath>
#include <cstdlib>

namespace glenoid {
namespace {

constexpr double kNearEnough = 0.03;    ///< of the wanted number
constexpr double kDistanceFactor = 4;   ///< most that the contact distance is changed
constexpr int kBisections = 24;

std::string markAt(const Recording& input, double time) {
  for (const RecordingMark& mark : input.marks)
    if (time >= mark.begin && time < mark.end) return mark.name;
  return {};
}

int contactsWith(const Model& model, const ContactState& found, double distance, int& active) {
  const auto other = std::make_shared<Model>(model);  // shares everything that the distance does not touch
  other->scenario.contactDistance = distance;
  Stepper stepper(other, {});
  State state = found.state;
  const StepReport& report = stepper.step(found.inputs, state);
  active = report.active;
  return report.contacts;
}

void changeDistance(const Model& model, ContactState& found) {
  double low = model.scenario.contactDistance / kDistanceFactor, high = model.scenario.contactDistance * kDistanceFactor;
  for (int i = 0; i < kBisections; ++i) {
    const double distance = 0.5 * (low + high);
    int active = 0;
    const int contacts = contactsWith(model, found, distance, active);
    if (std::abs(contacts - found.wanted) < std::abs(found.contacts - found.wanted)) {
      found.contacts = contacts;
      found.active = active;
      found.contactDistance = distance;
      found.distanceChanged = true;
    }
    if (contacts == found.wanted) return;
    (contacts < found.wanted ? low : high) = distance;
  }
}

}  // namespace

Result<std::vector<ContactState>> findContactStates(const StudyScene& scene, const std::vector<int>& wanted,
                                                    const std::function<bool(double)>& progress) {
  const auto model = compileModel(scene.joint, scene.scenario);
  if (!model) return model.error();
  std::vector<ContactState> best(wanted.size());
  Stepper stepper(*model, {});
  State state = (*model)->start, before = state;
  Inputs inputs;
  const double dt = scene.scenario.dt;
  const long steps = std::lround(inputSeconds(scene.input) / dt);
  for (long s = 0; s < steps; ++s) {
    handsAt(scene.scenario, &scene.input, static_cast<double>(s + 1) * dt, inputs.hands);
    before = state;
    const StepReport& report = stepper.step(inputs, state);
    const std::string mark = markAt(scene.input, before.time);
    if (progress && !progress(static_cast<double>(s + 1) / static_cast<double>(steps)))
      return Error{Fault::Cancelled, {}, {}, "looking for states"};
    if (mark.empty() || report.active == 0) continue;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const int miss = std::abs(report.contacts - wanted[i]), known = std::abs(best[i].contacts - wanted[i]);
      if (best[i].contacts > 0 && (miss > known || (miss == known && report.active <= best[i].active))) continue;
      best[i] = {wanted[i], report.contacts, report.active, before.time, scene.scenario.contactDistance, false, mark, before, inputs};
    }
  }
  for (ContactState& found : best) {
    if (found.contacts == 0) return Error{Fault::Unusable, {}, {"the input never presses on anything"}, "looking for states"};
    if (std::abs(found.contacts - found.wanted) > kNearEnough * found.wanted) changeDistance(**model, found);
  }
  return best;
}

Scenario scenarioOf(const StudyScene& scene, const ContactState& state) {
  Scenario scenario = scene.scenario;
  scenario.contactDistance = state.contactDistance;
  return scenario;
}

}  // namespace glenoid
