// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "simcore/live/Run.h"
#include "simcore/live/RunGather.h"

namespace glenoid {
namespace {

Pose at(double x) { return {Vec3(x, 0, 0), Quat::Identity()}; }

/// A model of one part and one tool, only as much of it as gathering looks at.
Model smallModel() {
  Model model;
  model.scenario.dt = 0.01;
  model.objects.resize(2);
  model.objects[0].id = "bone";
  model.objects[1].id = "probe";
  model.objects[1].tool = true;
  model.objects[1].toolIndex = 0;
  model.scenario.tools.resize(1);
  model.scenario.tools[0].id = "probe";
  model.effects = {{"gravity", true, "auto-present"}, {"contact", true, "auto-present"}, {"friction", false, "not-built"}};
  return model;
}

/// Velocities of that model: nothing moves.
const VecX kStill = VecX::Zero(6);

StepReport stepWith(int contacts, double force) {
  StepReport step;
  step.contacts = contacts;
  step.active = step.pressing = force > 0 ? contacts : 0;
  for (int c = 0; c < contacts; ++c) step.contactViews.push_back({1, 0, Vec3::Zero(), Vec3::UnitY(), 0, force / contacts});
  return step;
}

TEST(RunReport, percentilesAreNearestRank) {
  std::vector<float> times;
  for (int i = 1000; i >= 1; --i) times.push_back(static_cast<float>(i));
  const Timing timing = timingOf(times);
  EXPECT_EQ(timing.median, 500);
  EXPECT_EQ(timing.p95, 950);
  EXPECT_EQ(timing.p99, 990);
  EXPECT_EQ(timing.p999, 999);
  EXPECT_EQ(timing.max, 1000);
  std::vector<float> one{3}, none;
  EXPECT_EQ(timingOf(one).p99, 3);
  EXPECT_EQ(timingOf(none).max, 0);
}

TEST(RunGather, contactsAtRestAreThoseOfTheHalfSecondBeforeTheFirstTouch) {
  const Model model = smallModel();
  Recording input;
  input.tracks = {{"probe", {{0, at(0)}, {2.0, at(0)}, {3.0, at(1)}}}};
  RunGather gather(model, &input, 300, Profile::Direct);
  for (int s = 0; s < 300; ++s) gather.add(stepWith(s >= 150 && s < 200 ? 7 : s == 250 ? 20 : 1, 0), s * 0.01, kStill);
  RunReport report;
  gather.finish(report);
  ASSERT_TRUE(report.contacts.rest.has_value());
  EXPECT_DOUBLE_EQ(*report.contacts.rest, 7);
  EXPECT_EQ(report.contacts.max, 20);
  EXPECT_DOUBLE_EQ(report.contacts.mean, (50 * 7 + 20 + 249) / 300.0);
  EXPECT_EQ(report.steps, 300);
}

TEST(RunGather, marksMeasureTheNetForceOfTheToolOnThePart) {
  const Model model = smallModel();
  Recording input;
  input.marks = {{"press", 1.0, 2.0, "probe", "bone"}, {"elsewhere", 1.0, 2.0, "probe", "muscle"}, {"any", 0, 3, "", "bone"}};
  RunGather gather(model, &input, 300, Profile::Direct);
  for (int s = 0; s < 300; ++s) gather.add(stepWith(2, s >= 120 && s < 150 ? 2.5 : s < 100 ? 0.9 : 0.0), s * 0.01, kStill);
  RunReport report;
  gather.finish(report);
  ASSERT_EQ(report.marks.size(), 3u);
  EXPECT_NEAR(report.marks[0].seconds, 0.3, 1e-9);
  EXPECT_DOUBLE_EQ(report.marks[0].forceMax, 2.5);
  EXPECT_NEAR(report.marks[2].seconds, 0.3, 1e-9);
}

TEST(RunGather, opposedContactsCancelInTheNetForce) {
  const Model model = smallModel();
  Recording input;
  input.marks = {{"squeeze", 0, 1, "probe", "bone"}};
  RunGather gather(model, &input, 1, Profile::Direct);
  StepReport step = stepWith(2, 4.0);  // 2 N each, the second from the other side and listed the other way round
  step.contactViews[1] = {0, 1, Vec3::Zero(), Vec3::UnitY(), 0, 2.0};
  gather.add(step, 0, kStill);
  RunReport report;
  gather.finish(report);
  EXPECT_DOUBLE_EQ(report.marks[0].forceMax, 0.0);
}

TEST(RunGather, rejectedAndDivergedStepsAreCounted) {
  const Model model = smallModel();
  RunGather gather(model, nullptr, 3, Profile::Paper);
  StepReport step = stepWith(1, 0);
  step.paper.d = "object";
  step.paper.outerIterations = 10;
  gather.add(step, 0, kStill);
  step.taken = false;
  step.paper.diverged = true;
  step.paper.outerIterations = 30;
  gather.add(step, 0.01, kStill);
  RunReport report;
  gather.finish(report);
  EXPECT_EQ(report.rejectedSteps, 1);
  EXPECT_TRUE(report.diverged);
  ASSERT_TRUE(report.paper.has_value());
  EXPECT_EQ(report.paper->objectSteps, 2);
  EXPECT_EQ(report.paper->outerIterationsMax, 30);
  EXPECT_DOUBLE_EQ(report.paper->outerIterationsMean, 20);
}

TEST(RunGather, anEffectHasATimeOnlyWhereItHasStagesOfItsOwn) {
  const Model model = smallModel();
  RunGather gather(model, nullptr, 1, Profile::Direct);
  StepReport step = stepWith(1, 0);
  step.cpuMs[static_cast<int>(Stage::Collide)] = 0.5;
  step.cpuMs[static_cast<int>(Stage::Contact)] = 0.25;
  step.cpuMs[static_cast<int>(Stage::Assemble)] = 8;
  gather.add(step, 0, kStill);
  RunReport report;
  gather.finish(report);
  ASSERT_EQ(report.effects.size(), 3u);
  EXPECT_FALSE(report.effects[0].ms);
  EXPECT_EQ(report.effects[0].timedWith, "assemble");
  EXPECT_DOUBLE_EQ(report.effects[1].ms.value(), 0.75);
  EXPECT_EQ(report.effects[2].state, "off");
  EXPECT_EQ(report.effects[2].ms.value(), 0);
}

TEST(RunReport, jsonSaysNullAndWhyInsteadOfAFigureNobodyMeasured) {
  RunReport report;
  report.contacts.restReason = "loads-still-rise";
  report.pace = PaceReport{};
  const auto json = nlohmann::json::parse(toJson(report));
  EXPECT_TRUE(json["contacts"]["rest"].is_null());
  EXPECT_EQ(json["contacts"]["restReason"], "loads-still-rise");
  EXPECT_TRUE(json["visualPenetrationMax"].is_null());
  EXPECT_TRUE(json["haptic"].is_null());
  EXPECT_EQ(json["schemaVersion"], 1);
}

TEST(Run, handsFollowTheirTracksAndStayAtHomeWithout) {
  Scenario scenario;
  scenario.tools.resize(2);
  scenario.tools[0].id = "probe";
  scenario.tools[1].id = "scope";
  scenario.tools[1].home = at(9);
  Recording input;
  input.tracks = {{"probe", {{0, at(0)}, {2, at(4)}}}};
  std::vector<Pose> hands;
  handsAt(scenario, &input, 0.5, hands);
  ASSERT_EQ(hands.size(), 2u);
  EXPECT_DOUBLE_EQ(hands[0].p_WB.x(), 1.0);
  EXPECT_DOUBLE_EQ(hands[1].p_WB.x(), 9.0);
  handsAt(scenario, nullptr, 0.5, hands);
  EXPECT_DOUBLE_EQ(hands[0].p_WB.x(), 0.0);
}

}  // namespace
}  // namespace glenoid
