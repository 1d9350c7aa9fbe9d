// SPDX-License-Identifier: GPL-3.0-or-later
// Each kind of task in a real run over a fixed slab: done when it should be, and not when it should not.
#include <gtest/gtest.h>

#include "simcore/train/TrainingWatch.h"
#include "tests/simcore/train/TrainingScenes.h"

namespace glenoid {
namespace {

using namespace scenes;

const Vec3 kLeft(-0.03, 0, 0), kMiddle(0, 0, 0), kRight(0.03, 0, 0);
Vec3 over(const Vec3& x, double height = 0.02) { return x + Vec3(0, height, 0); }
/// The hand this far below the top presses with 800 N/m of it.
Vec3 into(const Vec3& x, double newtons) { return x - Vec3(0, newtons / 800, 0); }

TrainingReport after(Scenario scenario, const std::vector<Task>& tasks, const std::vector<HandStop>& stops, bool ordered = false,
                     const std::string& tool = "finger") {
  scenario.training.tasks = tasks;
  scenario.training.ordered = ordered;
  Recording input;
  input.tracks = {handThrough(scenario, tool, stops)};
  return trainingRun(scenario, input).report.training.value_or(TrainingReport{});
}

TrainingReport after(const std::vector<Task>& tasks, const std::vector<HandStop>& stops, bool ordered = false) {
  return after(slabScenario(), tasks, stops, ordered);
}

std::vector<HandStop> pressAt(const Vec3& x, double newtons, double seconds) {
  return {{over(x), 0.5}, {into(x, newtons), 0.8, seconds}, {over(x), 0.2}};
}

TEST(Touch, isDoneAtItsPlaceAndNowhereElse) {
  const Task task = taskAt("touch", TaskKind::Touch, "left");
  const auto there = after({task}, pressAt(kLeft, 2, 1)), beside = after({task}, pressAt(kRight, 2, 1));
  ASSERT_EQ(there.tasks.size(), 1u);
  EXPECT_EQ(there.tasks[0].record.outcome, TaskOutcome::Done);
  EXPECT_EQ(there.tasks[0].tool, "finger");
  EXPECT_DOUBLE_EQ(there.tasks[0].score, 1);
  EXPECT_LT(*there.tasks[0].record.distance, 3e-3);  // the tip that collides has eight corners round, so it stands beside its middle
  EXPECT_TRUE(there.finished && there.passed);
  EXPECT_DOUBLE_EQ(there.score, 100);
  // The hand passes the surface, and with it 0.1 N, at 1.7 s; half a second is asked for.
  EXPECT_NEAR(*there.tasks[0].record.ended, 2.25, 0.1);
  EXPECT_EQ(beside.tasks[0].record.outcome, TaskOutcome::Open);
  EXPECT_FALSE(beside.finished);
  EXPECT_DOUBLE_EQ(*beside.value("tasks"), 0);
}

TEST(Touch, tooShortIsNotDoneAndTooHardIsAnError) {
  Task task = taskAt("touch", TaskKind::Touch, "left");
  task.forceMax = 3;
  EXPECT_EQ(after({task}, pressAt(kLeft, 2, 0.1)).tasks[0].record.outcome, TaskOutcome::Open);
  const auto hard = after({task}, pressAt(kLeft, 6, 1));
  EXPECT_EQ(hard.tasks[0].record.outcome, TaskOutcome::Done);
  EXPECT_EQ(hard.tasks[0].record.errors, 1);
  EXPECT_NEAR(hard.tasks[0].record.forceMax, 6, 0.6);
  EXPECT_DOUBLE_EQ(hard.tasks[0].score, 0.75);
}

TEST(Touch, aRegionIsAnyPlaceOnIt) {
  Task task = taskAt("touch", TaskKind::Touch, "");
  task.places[0].region = "right-half";
  task.tolerance = 0.002;
  EXPECT_EQ(after({task}, pressAt(Vec3(0.045, 0, 0.02), 2, 1)).tasks[0].record.outcome, TaskOutcome::Done);
  EXPECT_EQ(after({task}, pressAt(Vec3(-0.01, 0, 0), 2, 1)).tasks[0].record.outcome, TaskOutcome::Open);
}

TEST(Press, wantsTheForceInItsBandWithoutABreak) {
  Task task = taskAt("press", TaskKind::Press, "middle");
  task.forceMin = 1;
  task.forceMax = 3;
  task.hold = 1;
  EXPECT_EQ(after({task}, pressAt(kMiddle, 2, 1.5)).tasks[0].record.outcome, TaskOutcome::Done);
  EXPECT_EQ(after({task}, pressAt(kMiddle, 0.5, 1.5)).tasks[0].record.outcome, TaskOutcome::Open);
  const auto hard = after({task}, pressAt(kMiddle, 5, 1.5));
  EXPECT_EQ(hard.tasks[0].record.outcome, TaskOutcome::Open);
  EXPECT_EQ(hard.tasks[0].record.errors, 1);
  // Twice 0.8 s with a break between is no second.
  std::vector<HandStop> twice = pressAt(kMiddle, 2, 0.7), more = twice;
  twice.insert(twice.end(), more.begin(), more.end());
  EXPECT_EQ(after({task}, twice).tasks[0].record.outcome, TaskOutcome::Open);
}

TEST(Look, goesByTheLensAndByWhatLiesBetween) {
  // The lens is turned by 30° to the tool's +X: upright over a place, it sees what lies 40 mm · tan 30° beside.
  const Quat turn = upright(Vec3::Zero()).q_WB;
  const Vec3 beside = 0.04 * std::tan(slabScenario().tools[1].lens) * (turn * Vec3::UnitX());
  Task task = taskAt("look", TaskKind::Look, "middle");
  task.angle = 0.1;
  const auto seen = after(slabScenario(), {task}, {{over(kMiddle - beside, 0.04), 0.5, 1}}, false, "scope");
  EXPECT_EQ(seen.tasks[0].record.outcome, TaskOutcome::Done);
  EXPECT_LT(*seen.tasks[0].record.distance, 2e-3);
  EXPECT_GT(*seen.value("inView"), 0.3);
  EXPECT_EQ(after(slabScenario(), {task}, {{over(kMiddle, 0.04), 0.5, 1}}, false, "scope").tasks[0].record.outcome, TaskOutcome::Open);
  // Under the top of the slab it is hidden.
  Task hidden = taskAt("look", TaskKind::Look, "below");
  hidden.angle = 0.1;
  hidden.tolerance = 0.002;
  const Vec3 eye = Vec3(0.02, 0.03, 0) - beside;
  EXPECT_EQ(after(slabScenario(), {hidden}, {{eye, 0.5, 1}}, false, "scope").tasks[0].record.outcome, TaskOutcome::Open);
  hidden.tolerance = 0.02;  // as near to the surface as this it shows
  EXPECT_EQ(after(slabScenario(), {hidden}, {{eye, 0.5, 1}}, false, "scope").tasks[0].record.outcome, TaskOutcome::Done);
  // And beyond its range nothing is recognised.
  task.range = 0.03;
  EXPECT_EQ(after(slabScenario(), {task}, {{over(kMiddle - beside, 0.04), 0.5, 1}}, false, "scope").tasks[0].record.outcome, TaskOutcome::Open);
}

TEST(Trace, isDoneAlongItsWholePathAndLettingGoIsAnError) {
  Task task = taskAt("trace", TaskKind::Trace, "left");
  task.places.push_back(taskAt("", TaskKind::Trace, "right").places[0]);
  const auto drawn = after({task}, {{over(kLeft), 0.5}, {into(kLeft, 1), 0.2, 0.3}, {into(kRight, 1), 2, 0.2}});
  EXPECT_EQ(drawn.tasks[0].record.outcome, TaskOutcome::Done);
  EXPECT_EQ(drawn.tasks[0].record.errors, 0);
  // Only to the middle, off, and on from there to the end.
  const auto broken = after({task}, {{over(kLeft), 0.5}, {into(kLeft, 1), 0.2, 0.3}, {into(kMiddle, 1), 1}, {over(kMiddle), 0.2}, {into(kMiddle, 1), 0.3}, {into(kRight, 1), 1, 0.2}});
  EXPECT_EQ(broken.tasks[0].record.outcome, TaskOutcome::Done);
  EXPECT_EQ(broken.tasks[0].record.errors, 1);
  // The other way round, or from the left to the right through the air: no.
  const auto back = after({task}, {{over(kRight), 0.5}, {into(kRight, 1), 0.2, 0.3}, {into(kMiddle, 1), 2}, {over(kMiddle), 0.2}});
  EXPECT_EQ(back.tasks[0].record.outcome, TaskOutcome::Open);
  const auto jump = after({task}, {{over(kLeft), 0.5}, {into(kLeft, 1), 0.2, 0.3}, {over(kLeft), 0.2}, {over(kRight), 0.5}, {into(kRight, 1), 0.2, 0.3}});
  EXPECT_EQ(jump.tasks[0].record.outcome, TaskOutcome::Open);
  EXPECT_LT(jump.tasks[0].record.progress, 0.2);
}

TEST(Follow, waitsForTheTipThenGoesItsWay) {
  Task task = taskAt("follow", TaskKind::Follow, "left");
  task.places[0] = {};
  task.places[0].point_W = Vec3(-0.03, 0.03, 0);
  task.keys = {{0, Vec3::Zero()}, {2, Vec3(0.06, 0, 0)}};
  task.tolerance = 0.006;
  const Vec3 begin(-0.03, 0.03, 0), end(0.03, 0.03, 0);
  const auto with = after({task}, {{begin, 0.7}, {end, 2, 0.5}});
  EXPECT_EQ(with.tasks[0].record.outcome, TaskOutcome::Done);
  EXPECT_EQ(with.tasks[0].record.errors, 0);
  const auto stays = after({task}, {{begin, 0.7, 3}});
  EXPECT_EQ(stays.tasks[0].record.outcome, TaskOutcome::Open);
  EXPECT_GE(stays.tasks[0].record.errors, 1);
  const auto never = after({task}, {{over(kRight), 0.7, 3}});
  EXPECT_EQ(never.tasks[0].record.errors, 0);
  EXPECT_DOUBLE_EQ(never.tasks[0].record.progress, 0);
}

TEST(Find, takesStandingStillForAnAnswerAndMeasuresBesideThePush) {
  Task task = taskAt("find", TaskKind::Find, "below");
  task.hidden = true;
  const Vec3 above(0.02, 0, 0), wrong(-0.02, 0, 0);
  const auto found = after({task}, pressAt(above + Vec3(0.002, 0, 0), 2, 1));
  EXPECT_EQ(found.tasks[0].record.outcome, TaskOutcome::Done);
  EXPECT_NEAR(*found.tasks[0].record.distance, 0.002, 0.4e-3);
  EXPECT_NEAR(*found.tasks[0].record.depth, 0.01, 0.4e-3);
  EXPECT_NEAR(*found.value("distance"), 0.002, 0.4e-3);
  std::vector<HandStop> twice = pressAt(wrong, 2, 2), then = pressAt(above, 2, 1);
  twice.insert(twice.end(), then.begin(), then.end());
  const auto second = after({task}, twice);
  EXPECT_EQ(second.tasks[0].record.outcome, TaskOutcome::Done);
  EXPECT_EQ(second.tasks[0].record.errors, 1);  // one answer, however long it stands there
  // Drawn along without standing still is no answer.
  const auto drawn = after({task}, {{over(kRight), 0.5}, {into(kRight, 2), 0.2}, {into(kLeft, 2), 2}, {over(kLeft), 0.2}});
  EXPECT_EQ(drawn.tasks[0].record.outcome, TaskOutcome::Open);
  EXPECT_EQ(drawn.tasks[0].record.errors, 0);
}

TEST(Find, asksForOnePlaceAtATimeInAnyOrderOfTasks) {
  Task left = taskAt("left", TaskKind::Find, "left"), right = taskAt("right", TaskKind::Find, "right");
  std::vector<HandStop> both = pressAt(Vec3(-0.03, 0, 0), 2, 1), then = pressAt(Vec3(0.03, 0, 0), 2, 1);
  both.insert(both.end(), then.begin(), then.end());
  const auto found = after({left, right}, both);
  EXPECT_TRUE(found.finished);
  EXPECT_DOUBLE_EQ(*found.value("errors"), 0);
}

TEST(Pass, takesRingsInTheirOrderAndTheirDirection) {
  Task task = taskAt("pass", TaskKind::Pass, "");
  const auto ring = [](double x) {
    TaskPlace place;
    place.point_W = Vec3(x, 0.03, 0);
    place.normal_W = Vec3::UnitX();
    return place;
  };
  task.places = {ring(-0.02), ring(0.02)};
  task.tolerance = 0.005;
  const Vec3 left(-0.04, 0.03, 0), right(0.04, 0.03, 0);
  const auto through = after({task}, {{left, 0.7}, {right, 1, 0.3}});
  EXPECT_EQ(through.tasks[0].record.outcome, TaskOutcome::Done);
  EXPECT_EQ(through.tasks[0].record.errors, 0);
  const auto back = after({task}, {{right, 0.7}, {left, 1, 0.3}});
  EXPECT_EQ(back.tasks[0].record.outcome, TaskOutcome::Open);
  const Vec3 aside(0, 0, 0.01);
  const auto beside = after({task}, {{left + aside, 0.7}, {right + aside, 1}, {right, 0.2, 0.3}});
  EXPECT_EQ(beside.tasks[0].record.outcome, TaskOutcome::Open);
  EXPECT_EQ(beside.tasks[0].record.errors, 1);  // the first ring, missed by twice its radius
}

TEST(Order, thatIsAskedForOpensOneTaskAfterTheOther) {
  const std::vector<Task> tasks = {taskAt("first", TaskKind::Touch, "left"), taskAt("second", TaskKind::Touch, "right")};
  std::vector<HandStop> wrongWay = pressAt(kRight, 2, 1), then = pressAt(kLeft, 2, 1);
  wrongWay.insert(wrongWay.end(), then.begin(), then.end());
  const auto ordered = after(tasks, wrongWay, true);
  EXPECT_EQ(ordered.tasks[0].record.outcome, TaskOutcome::Done);
  EXPECT_EQ(ordered.tasks[1].record.outcome, TaskOutcome::Open);
  EXPECT_DOUBLE_EQ(*ordered.value("errors"), 1);
  const auto free = after(tasks, wrongWay, false);
  EXPECT_TRUE(free.finished);
  EXPECT_DOUBLE_EQ(*free.value("errors"), 0);
  EXPECT_DOUBLE_EQ(*free.value("order"), 1);
}

TEST(Order, aPressThatBeganForTheTaskBeforeIsNoErrorOfTheNext) {
  // The third has the first's place: while the finger leaves that, the second is open.
  const std::vector<Task> tasks = {taskAt("first", TaskKind::Touch, "left"), taskAt("second", TaskKind::Touch, "right"), taskAt("third", TaskKind::Touch, "left")};
  std::vector<HandStop> stops;
  for (const Vec3& x : {kLeft, kRight, kLeft})
    for (const HandStop& stop : pressAt(x, 2, 1)) stops.push_back(stop);
  const auto report = after(tasks, stops, true);
  EXPECT_TRUE(report.finished);
  EXPECT_DOUBLE_EQ(*report.value("errors"), 0);
}

TEST(Time, missesATaskAndScoresSlowOnesLess) {
  Task task = taskAt("touch", TaskKind::Touch, "left");
  task.timeMax = 1;
  const auto late = after({task}, pressAt(kLeft, 2, 1));
  EXPECT_EQ(late.tasks[0].record.outcome, TaskOutcome::Missed);
  EXPECT_NEAR(*late.tasks[0].record.ended, 1, 0.006);
  EXPECT_TRUE(late.finished);
  EXPECT_FALSE(late.passed);
  task.timeMax = 0;
  task.timeGood = 0.5;
  const auto slow = after({task}, pressAt(kLeft, 2, 1));
  EXPECT_NEAR(slow.tasks[0].score, 0.5 / *slow.tasks[0].record.ended, 1e-12);
}

TEST(Limits, countEachTimeTheForcePassesThemWhateverTheTask) {
  Scenario scenario = slabScenario();
  scenario.training.limits = {{"slab-hard", "Slab", "slab", "", 3}, {"right-hard", "Right", "slab", "right-half", 3}};
  std::vector<HandStop> stops = pressAt(kLeft, 6, 0.5), more = pressAt(kRight, 6, 0.5), soft = pressAt(kRight, 2, 0.5);
  stops.insert(stops.end(), more.begin(), more.end());
  stops.insert(stops.end(), soft.begin(), soft.end());
  Task never = taskAt("never", TaskKind::Touch, "below");
  never.tolerance = 1e-4;
  const auto report = after(scenario, {never}, stops);
  EXPECT_DOUBLE_EQ(*report.value("slab-hard.tooHard"), 2);
  EXPECT_DOUBLE_EQ(*report.value("right-hard.tooHard"), 1);
  EXPECT_DOUBLE_EQ(*report.value("errors"), 3);
  EXPECT_NEAR(*report.value("slab-hard.forceMax"), 6, 0.6);
  EXPECT_NEAR(*report.value("right-hard.tooHardSeconds"), 0.6, 0.1);
}

/// What a changed model or recording does in the window: a watch that comes to a run under way.
TEST(TakenUp, beginsItsClocksAndTrailsWhereTheRunIs) {
  Scenario scenario = slabScenario();
  Task touch = taskAt("touch", TaskKind::Touch, "left");
  touch.timeMax = 3;
  touch.timeGood = 3;
  scenario.training.tasks = {touch};
  const auto model = compileModel(slabJoint(), scenario).value();
  Recording input;
  std::vector<HandStop> stops = {{over(kLeft), 4.0}};
  for (const HandStop& stop : pressAt(kLeft, 2, 1)) stops.push_back(stop);
  input.tracks = {handThrough(scenario, "finger", stops)};
  TrainingWatch late = TrainingWatch::make(*model).value();
  RunOptions options;
  options.seconds = inputSeconds(input);
  options.input = &input;
  options.checks = false;
  options.observe = [&](const StepReport& step, const State& state, std::span<const Penetration>) {
    if (state.time > 4.5) late.add(step, state);
  };
  ASSERT_TRUE(runScenario(model, options));
  const TrainingReport report = late.report();
  EXPECT_EQ(report.tasks[0].record.outcome, TaskOutcome::Done) << "three seconds from 4.5 s, not from 0";
  EXPECT_LT(*report.value("time"), 3);
  EXPECT_LT(*report.value("finger.path"), 0.06) << "not the way from home";
}

TEST(Limits, onARegionCountOnlyWhatTouchesThat) {
  // Two tools of which only one is on it; and one contact on each side of its border at once.
  Scenario scenario = slabScenario();
  scenario.training.limits = {{"right-hard", "Right", "slab", "right-half", 0.2}};
  Task never = taskAt("never", TaskKind::Touch, "below");
  never.tolerance = 1e-4;
  const auto left = after(scenario, {never}, pressAt(kLeft, 6, 0.5));
  EXPECT_DOUBLE_EQ(*left.value("right-hard.forceMax"), 0);
  const auto border = after(scenario, {never}, pressAt(Vec3(0.0005, 0, 0), 4, 0.5));
  EXPECT_GT(*border.value("right-hard.forceMax"), 0.5) << "some of its contacts are on it";
}

}  // namespace
}  // namespace glenoid
