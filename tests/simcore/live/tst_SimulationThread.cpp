// SPDX-License-Identifier: GPL-3.0-or-later
// The thread with steps made here: what counts is which steps are taken and what comes out, not their physics.
#include "simcore/live/SimulationThread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "simcore/live/CarryState.h"

namespace glenoid {
namespace {

using namespace std::chrono_literals;

/// One soft object whose only job is to have four numbers, and a tool.
std::shared_ptr<const Model> smallModel(const std::string& id = "object", double start = 0) {
  auto model = std::make_shared<Model>();
  SceneObject object;
  object.id = id;
  object.layout.rigid = false;
  object.layout.qOffset = 0;
  object.layout.qSize = object.layout.vSize = 3;
  model->objects.push_back(object);
  model->scenario.dt = 0.002;
  Tool tool;
  tool.id = "probe";
  model->scenario.tools.push_back(tool);
  model->start.q = VecX::Constant(3, start);
  model->start.v = VecX::Zero(3);
  return model;
}

/// q[0] counts steps, q[1] is the hand's x, q[2] stays. Takes `duration`; the report's contacts are the step.
StepMaker countingSteps(std::chrono::microseconds duration = 0us, long rejectAt = -1) {
  return [=](std::shared_ptr<const Model> model, const StepperOptions&) -> StepFunction {
    auto report = std::make_shared<StepReport>();
    return [=](const Inputs& inputs, State& state) -> const StepReport& {
      if (duration > 0us) std::this_thread::sleep_for(duration);
      report->taken = state.step != rejectAt;
      state.q[0] += 1;
      if (!inputs.hands.empty()) state.q[1] = inputs.hands[0].p_WB.x();
      state.step += 1;
      state.time += model->scenario.dt;
      report->contacts = static_cast<int>(state.step);
      return *report;
    };
  };
}

/// Reads snapshots until one is as wished; the limit is far above what any of them needs.
template <class Condition>
bool until(SimulationThread& simulation, Condition holds) {
  for (int i = 0; i < 10000; ++i) {
    if (simulation.takeSnapshot() && holds(simulation.snapshot())) return true;
    std::this_thread::sleep_for(1ms);
  }
  return false;
}

TEST(SimulationThread, showsNothingBeforeThereIsAModel) {
  SimulationThread simulation(countingSteps());
  simulation.play();
  simulation.stepOnce();
  simulation.reset();
  ASSERT_TRUE(until(simulation, [](const Snapshot&) { return true; }));
  EXPECT_EQ(simulation.snapshot().model, nullptr);
  EXPECT_FALSE(simulation.snapshot().playing);
}

/// Keeps what it is told.
class Listener final : public StepWatch {
 public:
  void look(const StepReport&, const State&, bool) override {}
  void add(const Notice& notice) override { m_notices = std::make_shared<const std::vector<Notice>>(std::vector<Notice>{notice}); }
  std::shared_ptr<const std::vector<Notice>> notices() const override { return m_notices; }

 private:
  std::shared_ptr<const std::vector<Notice>> m_notices = std::make_shared<const std::vector<Notice>>();
};

TEST(SimulationThread, aRunThatNobodyCanWaitForIsPausedAndSaysSo) {
  const WatchMaker listen = [](std::shared_ptr<const Model>, std::shared_ptr<const Recording>, std::function<void()>) { return std::make_unique<Listener>(); };
  SimulationThread slow(countingSteps(30ms), listen, 0.2);
  slow.setModel(smallModel(), {}, false);
  slow.play();
  ASSERT_TRUE(until(slow, [](const Snapshot& s) { return s.notices && !s.notices->empty() && !s.playing; }));
  const Notice& notice = slow.snapshot().notices->front();
  EXPECT_EQ(notice.kind, NoticeKind::TimeUp);
  EXPECT_EQ(notice.limit, 0.2);
  EXPECT_EQ(notice.step, slow.snapshot().step) << "what is shown is where it stopped";
  EXPECT_LT(notice.step, SimulationThread::kFewSteps);
  // Whoever wants it all the same may go on.
  const long stopped = slow.snapshot().step;
  slow.play();
  EXPECT_TRUE(until(slow, [&](const Snapshot& s) { return s.step > stopped; }));
  // Slow, but with steps enough: it goes on.
  SimulationThread bearable(countingSteps(3ms), listen, 0.5);
  bearable.setModel(smallModel(), {}, false);
  bearable.play();
  ASSERT_TRUE(until(bearable, [](const Snapshot& s) { return s.step > 60; }));
  EXPECT_TRUE(bearable.snapshot().playing);
  EXPECT_TRUE(bearable.snapshot().notices->empty());
}

TEST(SimulationThread, aNewModelIsShownAtItsStartAndRests) {
  SimulationThread simulation(countingSteps());
  simulation.setModel(smallModel("a", 5), {}, true);
  ASSERT_TRUE(until(simulation, [](const Snapshot& s) { return s.model != nullptr; }));
  EXPECT_EQ(simulation.snapshot().q[2], 5);
  EXPECT_FALSE(simulation.snapshot().playing);
  std::this_thread::sleep_for(30ms);
  EXPECT_FALSE(simulation.takeSnapshot()) << "nothing happened, so nothing is published";
}

TEST(SimulationThread, stepsAreCountedOneByOne) {
  SimulationThread simulation(countingSteps());
  simulation.setModel(smallModel(), {}, true);
  for (int i = 0; i < 7; ++i) simulation.stepOnce();
  ASSERT_TRUE(until(simulation, [](const Snapshot& s) { return s.step == 7; }));
  EXPECT_EQ(simulation.snapshot().q[0], 7);
  EXPECT_EQ(simulation.snapshot().report.contacts, 7);
  EXPECT_FALSE(simulation.snapshot().playing);
}

TEST(SimulationThread, playRunsAtTheClocksPaceAndPauseHolds) {
  SimulationThread simulation(countingSteps());
  simulation.setModel(smallModel(), {}, true);
  const auto begin = std::chrono::steady_clock::now();
  simulation.play();
  ASSERT_TRUE(until(simulation, [](const Snapshot& s) { return s.step >= 100; }));
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  // It may be late on a busy machine, never early.
  EXPECT_LE(simulation.snapshot().time, wall + 4 * 0.002);
  EXPECT_GT(simulation.snapshot().rates.stepsPerSecond, 0);
  EXPECT_LT(simulation.snapshot().rates.realTimeFactor, 1.3);
  simulation.pause();
  ASSERT_TRUE(until(simulation, [](const Snapshot& s) { return !s.playing; }));
  const long step = simulation.snapshot().step;
  std::this_thread::sleep_for(30ms);
  simulation.takeSnapshot();
  EXPECT_EQ(simulation.snapshot().step, step);
}

TEST(SimulationThread, aSlowStepSlowsTheRunDownWithoutSkipping) {
  SimulationThread simulation(countingSteps(10ms));  // five times the step's length
  simulation.setModel(smallModel(), {}, true);
  simulation.play();
  ASSERT_TRUE(until(simulation, [](const Snapshot& s) { return s.step >= 25; }));
  const Snapshot& s = simulation.snapshot();
  EXPECT_EQ(s.q[0], s.step);
  EXPECT_NEAR(s.time, s.step * 0.002, 1e-9);
  EXPECT_LT(s.rates.realTimeFactor, 0.35);
  EXPECT_GE(s.rates.msPerStep, 9.9);
  EXPECT_GT(s.rates.forgiven, 0);
}

TEST(SimulationThread, resetGoesBackToTheStartAndGoesOnPlaying) {
  SimulationThread simulation(countingSteps());
  simulation.setModel(smallModel("a", 3), {}, true);
  simulation.play();
  ASSERT_TRUE(until(simulation, [](const Snapshot& s) { return s.step >= 20; }));
  simulation.pause();
  simulation.reset();
  ASSERT_TRUE(until(simulation, [](const Snapshot& s) { return s.step == 0 && !s.playing; }));
  EXPECT_EQ(simulation.snapshot().q[0], 3);
  simulation.play();
  simulation.reset();
  ASSERT_TRUE(until(simulation, [](const Snapshot& s) { return s.playing && s.step >= 5; }));
}

TEST(SimulationThread, theNewestHandIsTakenUp) {
  SimulationThread simulation(countingSteps());
  simulation.setModel(smallModel(), {}, true);
  simulation.play();
  for (int i = 0; i <= 200; ++i) {
    simulation.setHands({{true, {Vec3(0.0005 * i, 0, 0), Quat::Identity()}}});
    std::this_thread::sleep_for(100us);
  }
  EXPECT_TRUE(until(simulation, [](const Snapshot& s) { return s.q[1] == 0.0005 * 200; }));
  EXPECT_EQ(simulation.snapshot().hands[0].p_WB.x(), 0.0005 * 200);
}

TEST(SimulationThread, aRecordingMovesTheHandByItself) {
  SimulationThread simulation(countingSteps());
  auto recording = std::make_shared<Recording>();
  recording->tracks.push_back({"probe", {{0, Pose{}}, {1, Pose{Vec3(1, 0, 0), Quat::Identity()}}}});
  simulation.setRecording(recording);
  simulation.setModel(smallModel(), {}, true);
  for (int i = 0; i < 50; ++i) simulation.stepOnce();
  ASSERT_TRUE(until(simulation, [](const Snapshot& s) { return s.step == 50; }));
  EXPECT_NEAR(simulation.snapshot().q[1], 50 * 0.002, 1e-12);
}

TEST(SimulationThread, aChangedModelCarriesStateByIdOrStartsOver) {
  SimulationThread simulation(countingSteps());
  simulation.setModel(smallModel("a"), {}, true);
  for (int i = 0; i < 9; ++i) simulation.stepOnce();
  simulation.setModel(smallModel("a", 77), {}, true);
  ASSERT_TRUE(until(simulation, [](const Snapshot& s) { return s.model && s.model->start.q[0] == 77; }));
  EXPECT_EQ(simulation.snapshot().q[0], 9) << "same id: carried";
  EXPECT_EQ(simulation.snapshot().step, 9);
  simulation.setModel(smallModel("b", 88), {}, true);
  ASSERT_TRUE(until(simulation, [](const Snapshot& s) { return s.model->start.q[0] == 88; }));
  EXPECT_EQ(simulation.snapshot().q[0], 88) << "another id: its own start";
  simulation.setModel(smallModel("b", 99), {}, false);
  ASSERT_TRUE(until(simulation, [](const Snapshot& s) { return s.model->start.q[0] == 99; }));
  EXPECT_EQ(simulation.snapshot().q[0], 99);
  EXPECT_EQ(simulation.snapshot().step, 0) << "not carried: from the beginning";
}

TEST(SimulationThread, rotationsAreCopiedOnlyWhileTheyAreWanted) {
  auto model = std::make_shared<Model>(*smallModel());
  model->start.rotations = VecX::LinSpaced(8, 1, 8);
  SimulationThread simulation(countingSteps());
  simulation.setModel(model, {}, true);
  simulation.stepOnce();
  ASSERT_TRUE(until(simulation, [](const Snapshot& s) { return s.step == 1; }));
  EXPECT_EQ(simulation.snapshot().rotations.size(), 0);
  simulation.setRotationsWanted(true);  // at once, though nothing steps
  ASSERT_TRUE(until(simulation, [](const Snapshot& s) { return s.rotations.size() > 0; }));
  EXPECT_EQ(simulation.snapshot().rotations, model->start.rotations);
  EXPECT_EQ(simulation.snapshot().step, 1);
  simulation.stepOnce();
  ASSERT_TRUE(until(simulation, [](const Snapshot& s) { return s.step == 2; }));
  EXPECT_EQ(simulation.snapshot().rotations.size(), 8);
  simulation.setRotationsWanted(false);
  ASSERT_TRUE(until(simulation, [](const Snapshot& s) { return s.rotations.size() == 0; }));
  for (int i = 0; i < 4; ++i) simulation.stepOnce();  // none is left in any of the buffers
  ASSERT_TRUE(until(simulation, [](const Snapshot& s) { return s.step == 6; }));
  EXPECT_EQ(simulation.snapshot().rotations.size(), 0);
}

TEST(SimulationThread, rejectedStepsAreCountedAndTheRunGoesOn) {
  SimulationThread simulation(countingSteps(0us, 5));
  simulation.setModel(smallModel(), {}, true);
  simulation.play();
  ASSERT_TRUE(until(simulation, [](const Snapshot& s) { return s.step > 10; }));
  EXPECT_EQ(simulation.snapshot().rejectedSteps, 1);
}

TEST(SimulationThread, canBeDestroyedAtAnyMoment) {
  for (int i = 0; i < 50; ++i) {
    SimulationThread simulation(countingSteps());
    simulation.setModel(smallModel(), {}, true);
    simulation.play();
    if (i % 3 == 0) std::this_thread::sleep_for(std::chrono::microseconds(200 * i));
  }
}

TEST(TripleBuffer, theReaderSeesWholeValuesInOrderAndTheLastOne) {
  TripleBuffer<std::array<long, 8>> buffer;
  constexpr long kLast = 200000;
  std::thread writer([&] {
    for (long i = 1; i <= kLast; ++i) {
      buffer.back().fill(i);
      buffer.publish();
    }
  });
  long last = 0;
  while (last < kLast) {
    if (!buffer.take()) continue;
    const std::array<long, 8>& value = buffer.front();
    for (const long part : value) ASSERT_EQ(part, value[0]) << "torn";
    ASSERT_GT(value[0], last) << "older than the one before";
    last = value[0];
  }
  writer.join();
  EXPECT_FALSE(buffer.take());
}

}  // namespace
}  // namespace glenoid
