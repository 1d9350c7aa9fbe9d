// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/accuracy/AccuracyWindows.h"

#include <algorithm>
#include <cmath>

namespace glenoid {
namespace {

/// What happens from one place of the grid to the next.
struct Rate {
  double speed = 0, force = 0;
};

std::string markDuring(const Recording& input, double begin, double end) {
  for (const RecordingMark& mark : input.marks)
    if (begin < mark.end && mark.begin < end) return mark.name;
  return {};
}

/// Of the object that is fastest as a whole: a rigid one by its centre, a soft one by the root mean square of its nodes.
double speedOf(const Model& model, const VecX& v) {
  double fastest = 0;
  for (const SceneObject& object : model.objects) {
    const ObjectLayout& layout = object.layout;
    if (!layout.free) continue;
    const double speed = layout.rigid ? v.segment<3>(layout.vOffset).norm()
                                      : v.segment(layout.vOffset, layout.vSize).norm() / std::sqrt(std::max(1, layout.nodeCount));
    fastest = std::max(fastest, speed);
  }
  return fastest;
}

double forceOf(const StepReport& report) {
  double force = 0;
  if (!report.toolForces.empty())
    for (const Vec3& one : report.toolForces) force += one.norm();
  else
    for (const ContactView& contact : report.contactViews) force += contact.force;
  return force;
}

/// Plays from the start, and shows every place of the grid: its number, the state there, and what came about on the way to it.
Result<Done> play(const StudyScene& scene, const std::shared_ptr<const Model>& model, double grid, long places,
                  const std::function<bool(long place, const State& state, const Rate& rate)>& show) {
  StepperOptions options;
  options.profile = scene.scenario.profile;
  Stepper stepper(model, options);
  State state = model->start;
  Inputs inputs;
  const double dt = scene.scenario.dt;
  const long each = std::lround(grid / dt);
  Rate none;
  if (!show(0, state, none)) return Error{Fault::Cancelled, {}, {}, "looking for windows"};
  for (long place = 1; place <= places; ++place) {
    Rate rate;
    for (long s = 0; s < each; ++s) {
      handsAt(scene.scenario, &scene.input, static_cast<double>(state.step + 1) * dt, inputs.hands);
      const StepReport& report = stepper.step(inputs, state);
      if (!report.taken) return Error{Fault::Unusable, {}, {"a run that does not stay finite"}, "looking for windows"};
      rate.speed += speedOf(*model, state.v) / static_cast<double>(each);
      rate.force += forceOf(report) / static_cast<double>(each);
    }
    if (!show(place, state, rate)) return Error{Fault::Cancelled, {}, {}, "looking for windows"};
  }
  return Done{};
}

}  // namespace

double playedSeconds(const StudyScene& scene, const WindowWishes& wishes) {
  double seconds = inputSeconds(scene.input);
  for (const Motion& motion : scene.scenario.motions)
    if (!motion.keys.empty()) seconds = std::max(seconds, motion.keys.back().time);
  return std::max({seconds, 2 * scene.scenario.loadRise, wishes.idleSeconds});
}

Result<std::vector<AccuracyWindow>> findWindows(const StudyScene& scene, std::shared_ptr<const Model> model, const WindowWishes& wishes,
                                                const std::function<bool(double)>& progress) {
  const long places = std::lround(std::floor(playedSeconds(scene, wishes) / wishes.grid + 1e-9)), length = std::lround(wishes.seconds / wishes.grid);
  const long beginnings = places - length + 1;
  if (beginnings < 1) return Error{Fault::Unusable, {}, {"a run that is shorter than the windows that are compared"}, "looking for windows"};
  const auto goOn = [&](double share) { return !progress || progress(share); };
  std::vector<Rate> rates(static_cast<std::size_t>(places) + 1);
  const auto rated = play(scene, model, wishes.grid, places, [&](long place, const State&, const Rate& rate) {
    rates[static_cast<std::size_t>(place)] = rate;
    return goOn(0.5 * static_cast<double>(place) / static_cast<double>(places));
  });
  if (!rated) return rated.error();

  const auto over = [&](long begin, double Rate::*what) {
    double sum = 0;
    for (long k = begin + 1; k <= begin + length; ++k) sum += rates[static_cast<std::size_t>(k)].*what;
    return sum / static_cast<double>(length);
  };
  const long stretches = std::max(1L, (wishes.count + 1) / 2L);
  // Apart by their length, or by what room there is.
  const long apart = std::max(1L, std::min(length, beginnings / std::max(1, 2 * wishes.count)));
  std::vector<AccuracyWindow> windows;
  std::vector<long> taken;
  const auto takeBest = [&](long from, long to, bool loaded) {
    long best = -1;
    double most = -1;
    for (long begin = from; begin < to; ++begin) {
      const bool free = std::all_of(taken.begin(), taken.end(), [&](long other) { return std::abs(other - begin) >= apart; });
      const double rate = over(begin, loaded ? &Rate::force : &Rate::speed);
      if (free && rate > most) {
        most = rate;
        best = begin;
      }
    }
    if (best < 0) return;
    AccuracyWindow window;
    window.time = static_cast<double>(best) * wishes.grid;
    window.speed = over(best, &Rate::speed);
    window.force = over(best, &Rate::force);
    window.loaded = loaded && window.force > 0;
    window.mark = markDuring(scene.input, window.time, window.time + wishes.seconds);
    windows.push_back(std::move(window));
    taken.push_back(best);
  };
  for (long stretch = 0; stretch < stretches; ++stretch)
    for (const bool loaded : {false, true})
      if (static_cast<int>(windows.size()) < wishes.count)
        takeBest(beginnings * stretch / stretches, beginnings * (stretch + 1) / stretches, loaded);
  std::sort(windows.begin(), windows.end(), [](const AccuracyWindow& a, const AccuracyWindow& b) { return a.time < b.time; });

  const long last = std::lround(windows.back().time / wishes.grid);
  const auto taking = play(scene, std::move(model), wishes.grid, last, [&](long place, const State& state, const Rate&) {
    for (AccuracyWindow& window : windows)
      if (std::lround(window.time / wishes.grid) == place) {
        window.state = state;
        window.stateHash = toHex(stateHash(state));
      }
    return goOn(0.5 + 0.5 * static_cast<double>(place) / static_cast<double>(std::max(1L, last)));
  });
  if (!taking) return taking.error();
  return windows;
}

}  // namespace glenoid
