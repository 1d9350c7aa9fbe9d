// SPDX-License-Identifier: GPL-3.0-or-later
// What a run against the clock says is what a run without a window says of the same steps.
#include "simcore/live/LiveWatch.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>

#include "simcore/live/Run.h"
#include "simcore/live/SimulationThread.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

using namespace std::chrono_literals;
using Matter = std::array<std::string, 3>;  // kind, subject, other

std::set<Matter> mattersOf(const std::vector<Notice>& notices) {
  std::set<Matter> matters;
  for (const Notice& n : notices) EXPECT_TRUE(matters.insert({noticeName(n.kind), n.subject, n.other}).second) << "said twice: " << n.subject;
  return matters;
}

/// Cubes that start too deep in a slab, with every other thing that can be said: settings that do nothing, an effect with nothing to act on.
Scenario wishfulScenario() {
  Scenario scenario = scenes::sunkenCubesScenario();
  scenario.seed = 7;
  scenario.effects.haptics = scenario.effects.bursa = Wish::On;
  return scenario;
}

std::shared_ptr<const Model> cubesModel(const Scenario& scenario) { return compileModel(scenes::sunkenCubesJoint(), scenario).value(); }

/// Takes steps of a run and shows them to the watch, one after another.
struct Steps {
  explicit Steps(std::shared_ptr<const Model> m) : model(std::move(m)), stepper(model, {}), state(model->start) {}
  void take(int count, LiveWatch& watch, bool onPath = true) {
    for (int i = 0; i < count; ++i) {
      handsAt(model->scenario, nullptr, 0, inputs.hands);
      const StepReport& report = stepper.step(inputs, state);
      watch.look(report, state, onPath);
    }
  }
  std::shared_ptr<const Model> model;
  Stepper stepper;
  State state;
  Inputs inputs;
};

template <class Condition>
bool until(Condition holds) {
  for (int i = 0; i < 10000; ++i) {
    if (holds()) return true;
    std::this_thread::sleep_for(1ms);
  }
  return false;
}

TEST(LiveWatch, saysWhatARunWithoutAWindowSays) {
  const auto model = cubesModel(wishfulScenario());
  RunOptions options;
  options.steps = 10;
  const std::vector<Notice> said = runScenario(model, options)->report.notices;
  ASSERT_EQ(said.size(), 5u);
  LiveWatch watch(model, nullptr, {});
  EXPECT_EQ(mattersOf(*watch.notices()).size(), 3u) << "what is known before any step";
  Steps steps(model);
  steps.take(1, watch);
  EXPECT_TRUE(until([&] { return watch.notices()->size() == 5; }));
  EXPECT_EQ(mattersOf(*watch.notices()), mattersOf(said));
  EXPECT_DOUBLE_EQ(watch.notices()->back().figure, said.back().figure);
  EXPECT_EQ(watch.notices()->back().step, 1);
  steps.take(9, watch);
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(watch.notices()->size(), 5u);
}

TEST(LiveWatch, aDepthIsToldAgainOnlyOnceItIsATenthDeeper) {
  const auto model = cubesModel(scenes::sunkenCubesScenario());
  std::atomic<int> told = 0;
  LiveWatch watch(model, nullptr, [&] { ++told; });
  State state = model->start;
  const int deep = model->objects[findPart(model->joint, "deep")].layout.qOffset + 1;
  const StepReport report;
  constexpr double kEnd = 0.0045;  // m
  for (int i = 0; i <= 100; ++i) {  // from 2 mm on; the second cube stays 3 mm deep
    state.q[deep] = 0.01 - 0.002 - (kEnd - 0.002) * i / 100;
    state.step = i;
    watch.look(report, state, true);
    std::this_thread::sleep_for(2ms);
  }
  const auto deepest = [&] {
    const auto notices = watch.notices();  // held while it is read
    for (const Notice& n : *notices)
      if (n.other == "deep") return n.figure;
    return 0.0;
  };
  ASSERT_TRUE(until([&] { return deepest() * LiveWatch::kDeeper >= kEnd; }));
  EXPECT_LE(deepest(), kEnd + 1e-12);
  EXPECT_EQ(watch.notices()->size(), 2u) << "once a pair";
  // From 20/9 mm to 4.5 mm it is seven times a tenth, and each of the two is told a first time.
  EXPECT_GE(told, 3);
  EXPECT_LE(told, 9);
}

TEST(LiveWatch, aMarkIsMissedOnlyWhereTheHandsKeptToTheRecording) {
  Scenario scenario = scenes::blockOnPlateScenario();
  const auto model = compileModel(scenes::blockOnPlateJoint(), scenario).value();
  const auto recording = std::make_shared<Recording>();
  recording->marks = {{"first", 0.02, 0.05, "finger", "block"}, {"second", 0.06, 0.1, "finger", "block"}, {"third", 0.11, 0.15, "finger", "block"},
                      {"label", 0, 0.15, "", ""}};
  LiveWatch watch(model, recording, {});
  Steps steps(model);
  const auto missed = [&] {
    std::vector<std::string> names;
    const auto notices = watch.notices();  // held while it is read
    for (const Notice& n : *notices)
      if (n.kind == NoticeKind::MarkMissed) names.push_back(n.subject);
    return names;
  };
  steps.take(9, watch);
  EXPECT_TRUE(missed().empty()) << "it is not over yet";
  steps.take(1, watch);
  EXPECT_EQ(missed(), std::vector<std::string>{"first"});
  steps.take(4, watch);
  steps.take(1, watch, false);  // a hand takes the tool, in the middle of the second mark
  steps.take(20, watch);
  EXPECT_EQ(missed(), (std::vector<std::string>{"first", "third"}));
  EXPECT_DOUBLE_EQ(watch.notices()->back().figure, scenario.dt);
}

TEST(LiveWatch, reachesTheSnapshotAndBeginsAnewWithTheRun) {
  const auto model = cubesModel(wishfulScenario());
  SimulationThread simulation(makeStepperStep, makeLiveWatch);
  const auto shows = [&](std::size_t count) {
    return until([&] {
      simulation.takeSnapshot();
      return simulation.snapshot().notices && simulation.snapshot().notices->size() == count;
    });
  };
  simulation.setModel(model, {}, false);
  ASSERT_TRUE(shows(3));
  simulation.stepOnce();  // no step follows: what is found about it must come by itself
  ASSERT_TRUE(shows(5));
  simulation.reset();
  ASSERT_TRUE(shows(3));
  simulation.setModel(cubesModel(scenes::sunkenCubesScenario()), {}, true);
  ASSERT_TRUE(shows(0)) << "another model without such wishes, and no step since";
  simulation.stepOnce();
  ASSERT_TRUE(shows(2));
}

TEST(LiveWatch, knowsWhetherTheRunIsAtRest) {
  Scenario scenario = scenes::sunkenCubesScenario();  // they leave at ten times the speed that counts as rest
  scenario.loads = {{"deep", Vec3(0, 1e-9, 0)}};
  scenario.loadRise = 0.02;
  const auto model = cubesModel(scenario);
  LiveWatch watch(model, nullptr, {});
  EXPECT_FALSE(watch.rest().stepped);
  Steps steps(model);
  steps.take(4, watch);
  EXPECT_TRUE(watch.rest().stepped);
  EXPECT_TRUE(watch.rest().loadsRise);
  steps.take(1, watch);
  EXPECT_FALSE(watch.rest().loadsRise);
  EXPECT_FALSE(watch.rest().slow);
  EXPECT_NEAR(watch.rest().speed, scenes::kRecovery, 0.1 * scenes::kRecovery);
  scenario.recoverySpeedMax = 0.5e-3;
  scenario.loads.clear();
  const auto slowly = cubesModel(scenario);
  LiveWatch other(slowly, nullptr, {});
  Steps more(slowly);
  more.take(3, other);
  EXPECT_TRUE(other.rest().slow);
}

TEST(LiveWatch, canBeDestroyedWhileItLooks) {
  const auto model = cubesModel(scenes::sunkenCubesScenario());
  for (int i = 0; i < 30; ++i) {
    SimulationThread simulation(makeStepperStep, makeLiveWatch);
    simulation.setModel(model, {}, true);
    simulation.play();
    simulation.reset();
    if (i % 3 == 0) std::this_thread::sleep_for(std::chrono::microseconds(300 * i));
  }
}

}  // namespace
}  // namespace glenoid
