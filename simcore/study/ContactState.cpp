// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/ContactState.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "simcore/spatial/TriangleTree.h"

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

/// One play of the input with held parts pressed, for all states that want it so.
Result<Done> search(const StudyScene& scene, double press, const std::vector<ContactState*>& found,
                    const std::function<bool(double)>& progress) {
  ContactState pressed;
  pressed.pressed = press;
  pressed.contactDistance = scene.scenario.contactDistance;
  const Scenario scenario = scenarioOf(scene, pressed);
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
      // First that enough press, then that there are as many as wanted, then that more press.
      const auto rank = [best](int contacts, int pressing) {
        return std::array{std::max(0, best->pressingWanted - pressing), std::abs(contacts - best->wanted), -pressing};
      };
      if (best->contacts > 0 && rank(report.contacts, report.pressing) >= rank(best->contacts, best->pressing)) continue;
      *best = {best->wanted, best->pressingWanted, report.contacts, report.pressing, before.time, scenario.contactDistance, press, false, mark, before, inputs};
    }
  }
  for (ContactState* best : found) {
    if (best->contacts == 0) return Error{Fault::Unusable, {}, {"the input never presses on anything"}, "looking for states"};
    if (std::abs(best->contacts - best->wanted) > kNearEnough * best->wanted) changeDistance(**model, *best);
  }
  return Done{};
}

}  // namespace

std::vector<Load> pressingLoads(const Joint& joint, const Scenario& scenario, double newtons) {
  const auto among = [](const auto& list, const std::string& id) { return std::find(list.begin(), list.end(), id) != list.end(); };
  std::vector<Load> loads;
  for (const Part& part : joint.parts) {
    if (among(scenario.fixedParts, part.id)) continue;
    Vec3 way_W = Vec3::Zero();
    if (std::any_of(scenario.holds.begin(), scenario.holds.end(), [&](const Hold& hold) { return hold.part == part.id; })) {
      double least = std::numeric_limits<double>::infinity();
      for (const std::string& id : scenario.fixedParts) {
        const auto nearest = TriangleTree(*joint.parts[findPart(joint, id)].collision).closest(Vec3::Zero());
        if (nearest.triangle < 0 || nearest.distance >= least) continue;
        least = nearest.distance;
        way_W = nearest.point;
      }
    } else {
      for (const Vec3& x : part.visual->vertices) way_W -= x;
    }
    if (way_W.norm() > 0) loads.push_back({part.id, newtons * way_W.normalized(), Vec3::Zero()});
  }
  return loads;
}

Result<std::vector<ContactState>> findContactStates(const StudyScene& scene, const std::vector<ContactWish>& wanted,
                                                    const std::function<bool(double)>& progress) {
  std::vector<ContactState> found(wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    found[i].wanted = wanted[i].contacts;
    found[i].pressingWanted = wanted[i].pressing;
    found[i].pressed = wanted[i].press;
  }
  std::vector<double> presses;
  for (const ContactWish& wish : wanted)
    if (std::find(presses.begin(), presses.end(), wish.press) == presses.end()) presses.push_back(wish.press);
  for (std::size_t p = 0; p < presses.size(); ++p) {
    std::vector<ContactState*> group;
    for (ContactState& state : found)
      if (state.pressed == presses[p]) group.push_back(&state);
    const auto part = [&](double done) { return !progress || progress((static_cast<double>(p) + done) / static_cast<double>(presses.size())); };
    if (Result<Done> searched = search(scene, presses[p], group, part); !searched) return searched.error();
  }
  return found;
}

Scenario scenarioOf(const StudyScene& scene, const ContactState& state) {
  Scenario scenario = scene.scenario;
  scenario.contactDistance = state.contactDistance;
  if (state.pressed > 0)
    for (const Load& load : pressingLoads(scene.joint, scenario, state.pressed)) scenario.loads.push_back(load);
  return scenario;
}

}  // namespace glenoid
