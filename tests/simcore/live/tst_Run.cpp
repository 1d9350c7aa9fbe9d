// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <set>
#include <thread>

#include "simcore/live/Pacer.h"
#include "simcore/live/PenetrationProbe.h"
#include "simcore/live/Run.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

std::shared_ptr<const Model> blockModel() {
  const auto model = compileModel(scenes::blockOnPlateJoint(), scenes::blockOnPlateScenario());
  EXPECT_TRUE(model.ok()) << (model ? "" : toLogLine(model.error()));
  return model ? *model : nullptr;
}

/// The first tool sinks by `depth` from 1.6 s to 2 s and stays.
Recording pressing(const Scenario& scenario, double depth) {
  const Tool& tool = scenario.tools.at(0);
  Pose down = tool.home;
  down.p_WB.y() -= depth;
  Recording input;
  input.tracks = {{tool.id, {{0, tool.home}, {1.6, tool.home}, {2.0, down}}}};
  input.marks = {{"press", 1.6, 2.6, tool.id, ""}};
  return input;
}

TEST(Run, sameBitsTwiceAndForAnyNumberOfThreads) {
  const auto model = blockModel();
  ASSERT_TRUE(model);
  const Recording input = pressing(model->scenario, 0.023);
  RunOptions options;
  options.steps = 450;
  options.input = &input;
  options.checks = false;
  const auto one = runScenario(model, options);
  const auto again = runScenario(model, options);
  options.stepper.threads = 2;
  const auto two = runScenario(model, options);
  ASSERT_TRUE(one && again && two);
  EXPECT_TRUE(one->report.finite);
  EXPECT_EQ(one->report.stateHash, again->report.stateHash);
  EXPECT_EQ(one->report.stateHash, two->report.stateHash);
  EXPECT_EQ(one->report.stateHash, toHex(stateHash(one->state)));
  options.input = nullptr;
  const auto still = runScenario(model, options);
  ASSERT_TRUE(still);
  EXPECT_NE(one->report.stateHash, still->report.stateHash);  // the hands matter
}

TEST(Run, aLimitOfTimeEndsItWithTheReportUpToThere) {
  const auto model = blockModel();
  ASSERT_TRUE(model);
  RunOptions options;
  options.steps = 2000;
  options.timeLimit = 0.3;
  options.record = true;
  options.observe = [](const StepReport&, const State& state, std::span<const Penetration>) {
    if (state.step > 300) std::this_thread::sleep_for(std::chrono::milliseconds(40));  // the block lies on its plate by then
  };
  const auto stopped = runScenario(model, options);
  ASSERT_TRUE(stopped);
  const long reached = stopped->report.steps;
  EXPECT_GT(reached, 0);
  EXPECT_LT(reached, 400);
  EXPECT_EQ(stopped->state.step, reached);
  ASSERT_FALSE(stopped->report.notices.empty());
  const Notice* notice = nullptr;
  for (const Notice& each : stopped->report.notices)
    if (each.kind == NoticeKind::TimeUp) notice = &each;
  ASSERT_TRUE(notice);
  EXPECT_EQ(notice->step, reached);
  EXPECT_EQ(notice->limit, 0.3);
  if (reached > 300) {
    EXPECT_GT(notice->figure, 0);
    EXPECT_EQ((std::set<std::string>{notice->subject, notice->other}), (std::set<std::string>{"block", "plate"}));
    EXPECT_FALSE(stopped->contacts.empty());
  }
  // What was done until then is what a run of that length does.
  options.steps = reached;
  options.observe = nullptr;
  options.timeLimit = 1e6;
  const auto whole = runScenario(model, options);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->report.stateHash, stopped->report.stateHash);
  EXPECT_EQ(whole->recording->stateHash, stopped->recording->stateHash);
  EXPECT_EQ(whole->recording->steps, reached);
  for (const Notice& each : whole->report.notices) EXPECT_NE(each.kind, NoticeKind::TimeUp);
  // The last step may end late.
  options.steps = 1;
  options.timeLimit = 1e-9;
  const auto one = runScenario(model, options);
  ASSERT_TRUE(one);
  for (const Notice& each : one->report.notices) EXPECT_NE(each.kind, NoticeKind::TimeUp);
}

TEST(Run, aToolThatIsPressedInPressesBack) {
  const auto model = blockModel();
  ASSERT_TRUE(model);
  const Recording input = pressing(model->scenario, 0.025);
  RunOptions options;
  options.seconds = 2.6;
  options.input = &input;
  const auto run = runScenario(model, options);
  ASSERT_TRUE(run) << toLogLine(run.error());
  const RunReport& report = run->report;
  EXPECT_EQ(report.steps, std::lround(2.6 / model->scenario.dt));
  ASSERT_EQ(report.marks.size(), 1u);
  EXPECT_GT(report.marks[0].forceMax, 0.1);
  EXPECT_GT(report.contacts.pressingMax, 0);
  ASSERT_TRUE(report.contacts.rest.has_value());
  EXPECT_GT(*report.contacts.rest, 0);  // the block lies on the plate
  EXPECT_LT(report.penetrationMax, 1e-3);
  EXPECT_GT(report.step.median, 0);
  EXPECT_GE(report.stepWall.max, report.stepWall.median);
}

TEST(Run, aRecordingRepeatsTheRun) {
  const auto model = blockModel();
  ASSERT_TRUE(model);
  const Recording input = pressing(model->scenario, 0.023);
  RunOptions options;
  options.steps = 400;
  options.input = &input;
  options.record = true;
  options.checks = false;
  const auto run = runScenario(model, options);
  ASSERT_TRUE(run && run->recording);
  EXPECT_EQ(run->recording->stateHash, run->report.stateHash);
  EXPECT_EQ(run->recording->steps, 400);
  RunOptions repeat;
  repeat.steps = run->recording->steps;
  repeat.input = &*run->recording;
  repeat.checks = false;
  const auto repeated = runScenario(model, repeat);
  ASSERT_TRUE(repeated);
  EXPECT_EQ(repeated->report.stateHash, run->recording->stateHash);
}

TEST(Run, checksChangeNothing) {
  const auto model = blockModel();
  ASSERT_TRUE(model);
  RunOptions options;
  options.steps = 60;
  options.visualEvery = 1;
  const auto with = runScenario(model, options);
  options.checks = false;
  const auto without = runScenario(model, options);
  ASSERT_TRUE(with && without);
  EXPECT_EQ(with->report.stateHash, without->report.stateHash);
  EXPECT_TRUE(with->report.visualPenetrationMax.has_value());
  EXPECT_EQ(with->report.visualPenetrationPair.empty(), *with->report.visualPenetrationMax == 0);
  EXPECT_FALSE(without->report.visualPenetrationMax.has_value());
}

TEST(Run, refusesWhatItCannotRun) {
  const auto model = blockModel();
  ASSERT_TRUE(model);
  const auto faultOf = [&](const RunOptions& options) {
    const auto run = runScenario(model, options);
    EXPECT_FALSE(run);
    return run ? Fault::Internal : run.error().fault;
  };
  RunOptions options;
  for (const double seconds : {0.0, -1.0, 1e300, std::nan("")}) {
    options.seconds = seconds;
    EXPECT_EQ(faultOf(options), Fault::OutOfRange) << seconds;
  }
  options.steps = kRunStepsMax + 1;
  EXPECT_EQ(faultOf(options), Fault::OutOfRange);
  options.steps = 5;
  Recording input;
  input.tracks = {{"spoon", {{0, Pose{}}}}};
  options.input = &input;
  EXPECT_EQ(faultOf(options), Fault::UnknownId);
  input.tracks = {{model->scenario.tools[0].id, {}}};
  EXPECT_EQ(faultOf(options), Fault::Unusable);
  options.input = nullptr;
  options.progress = [](double) { return false; };
  EXPECT_EQ(faultOf(options), Fault::Cancelled);
}

TEST(PenetrationProbe, findsATipThatWasPutInsideAndKeepsTheDeepest) {
  const auto model = blockModel();
  ASSERT_TRUE(model);
  PenetrationProbe probe(*model, SurfaceKind::Collision);
  probe.look(model->start.q);
  const double before = probe.deepest();
  EXPECT_EQ(before, 0);
  // The tip stands at 60 mm, the block's top is at 40.5 mm: moved down by 30 mm it is 10.5 mm inside.
  for (const SceneObject& object : model->objects)
    if (object.tool) {
      VecX q = model->start.q;
      q[object.layout.qOffset + 1] -= 0.03;
      probe.look(q);
      EXPECT_NEAR(probe.deepest(), 0.0105, 1e-9);
      EXPECT_NE(probe.where().find(object.id), std::string::npos) << probe.where();
    }
  const double deepest = probe.deepest();
  probe.look(model->start.q);
  EXPECT_EQ(probe.deepest(), deepest);
}

TEST(Pacer, stepsBeginOnTimeAndALateRunSlowsDownInsteadOfSkipping) {
  using Clock = std::chrono::steady_clock;
  Pacer onTime(0.005);
  const auto start = Clock::now();
  for (int s = 0; s < 21; ++s) onTime.waitForStep();
  EXPECT_GE(std::chrono::duration<double>(Clock::now() - start).count(), 0.0999);  // 20 whole steps lie between

  Pacer late(0.002);
  late.waitForStep();
  std::this_thread::sleep_for(std::chrono::milliseconds(60));  // thirty steps late, four may be caught up
  late.waitForStep();
  EXPECT_GE(late.report().lateSteps, 1);
  EXPECT_GE(late.report().slowedSeconds, 0.060 - 0.002 - 4 * 0.002 - 1e-9);
}

}  // namespace
}  // namespace glenoid
