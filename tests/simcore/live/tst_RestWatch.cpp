// SPDX-License-Identifier: GPL-3.0-or-later
// When a scene is at rest, at the edges of the rule: loads, speed, touch, length.
#include "simcore/live/RestWatch.h"

#include <gtest/gtest.h>

#include "simcore/live/Run.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

constexpr double kDt = 0.01;

Pose at(double x) { return {Vec3(x, 0, 0), Quat::Identity()}; }

/// A soft part of two nodes, a rigid one of which a point lies 0.5 m from its centre, a probe and what it carries.
Model smallModel() {
  Model model;
  model.scenario.dt = kDt;
  model.objects.resize(4);
  model.objects[0].id = "muscle";
  model.objects[0].layout = {false, true, 0, 6, 0, 6, 2};
  model.objects[1].id = "bone";
  model.objects[1].layout = {true, true, 6, 7, 6, 6, 0};
  TriMesh mesh;
  mesh.vertices = {Vec3(1, 0, 0), Vec3(1.5, 0, 0), Vec3(1, 0.25, 0)};
  mesh.triangles = {{0, 1, 2}};
  model.objects[1].visual.mesh = std::make_shared<TriMesh>(mesh);
  model.start.q = VecX::Zero(13);
  model.start.q[6] = 1;
  for (int t = 0; t < 2; ++t) {
    SceneObject& tool = model.objects[2 + t];
    tool.tool = true;
    tool.toolIndex = t;
    tool.layout = {true, true, 0, 7, 12, 6, 0};  // moves as it likes
    model.scenario.tools.emplace_back();
    tool.id = model.scenario.tools.back().id = t == 0 ? "probe" : "tip";
  }
  model.scenario.tools[1].link = "probe";
  return model;
}

/// Velocities of that model: the second node of the muscle, the bone's centre, its turning. Its tools race about.
VecX moving(double node, double centre = 0, double turn = 0) {
  VecX v = VecX::Zero(18);
  v[4] = node;
  v[6] = centre;
  v[10] = turn;
  v.tail(6).setConstant(3);
  return v;
}

StepReport rows(int contacts, int objectA = 0, int objectB = 1) {
  StepReport step;
  step.contacts = contacts;
  step.pressing = contacts / 2;
  for (int c = 0; c < contacts; ++c) step.contactViews.push_back({objectA, objectB});
  return step;
}

TEST(RestWatch, firstMotionIsWhereAKeyBeginsToChange) {
  EXPECT_FALSE(firstMotion(HandTrack{}));
  EXPECT_EQ(firstMotion(HandTrack{"a", {{0, at(1)}, {2, at(1)}, {3, at(2)}, {4, at(2)}}}).value(), 2.0);
  EXPECT_FALSE(firstMotion(HandTrack{"a", {{0, at(1)}, {2, at(1)}}}));
}

TEST(RestWatch, loadsMustBeWhole) {
  Model model = smallModel();
  model.scenario.loadRise = 0.3;
  const auto after = [&](int steps) {
    RestWatch watch(model, nullptr);
    for (int s = 0; s < steps; ++s) watch.add(rows(s < 30 ? 50 : 4), s * kDt, moving(0));
    return watch;
  };
  EXPECT_TRUE(after(10).contacts()) << "a time to rise without any load holds nothing up";
  model.scenario.loads = {{"bone", Vec3(1, 0, 0)}};
  EXPECT_EQ(after(30).reason(), "loads-still-rise");
  EXPECT_FALSE(after(30).isAtRest());
  EXPECT_TRUE(after(31).isAtRest());
  EXPECT_FALSE(after(39).contacts());
  ASSERT_TRUE(after(40).contacts()) << "a tenth of a second later";
  EXPECT_DOUBLE_EQ(after(40).contacts()->rows, 4);
  EXPECT_DOUBLE_EQ(after(40).contacts()->pressing, 2);
  EXPECT_EQ(after(40).reason(), "");
}

TEST(RestWatch, noPointOfAPartMovesFasterThanAMillimetreInASecond) {
  const Model model = smallModel();
  const auto rests = [&](const VecX& v) {
    RestWatch watch(model, nullptr);
    for (int s = 0; s < 20; ++s) watch.add(rows(1), s * kDt, v);
    EXPECT_EQ(watch.reason(), watch.contacts() ? "" : "parts-still-move");
    return watch.contacts().has_value();
  };
  EXPECT_TRUE(rests(moving(0.999e-3)));
  EXPECT_FALSE(rests(moving(1.001e-3)));
  EXPECT_FALSE(rests(moving(0, 1.001e-3)));
  EXPECT_TRUE(rests(moving(0, 0, 1.999e-3))) << "half a metre from the centre";
  EXPECT_FALSE(rests(moving(0, 0, 2.001e-3)));
  EXPECT_FALSE(rests(moving(0, 0.6e-3, 0.9e-3))) << "both together";
}

TEST(RestWatch, theTurnOfASwingIsNoRest) {
  const Model model = smallModel();
  RestWatch watch(model, nullptr);
  for (int s = 0; s < 200; ++s) watch.add(rows(9), s * kDt, moving(s % 10 == 0 ? 0.1 : 0));  // nine slow steps in a row
  EXPECT_FALSE(watch.contacts());
  EXPECT_EQ(watch.reason(), "parts-still-move");
  for (int s = 200; s < 210; ++s) watch.add(rows(9), s * kDt, moving(0));
  EXPECT_TRUE(watch.contacts());
}

TEST(RestWatch, ofALongStretchTheLastHalfSecondCountsAndOnlyOfTheFirst) {
  const Model model = smallModel();
  RestWatch watch(model, nullptr);
  for (int s = 0; s < 100; ++s) watch.add(rows(s < 50 ? 100 : s < 75 ? 10 : 20), s * kDt, moving(0));
  EXPECT_DOUBLE_EQ(watch.contacts()->rows, 15);
  watch.add(rows(40), 1.0, moving(1));
  for (int s = 101; s < 300; ++s) watch.add(rows(2), s * kDt, moving(0));
  EXPECT_DOUBLE_EQ(watch.contacts()->rows, 15);
}

TEST(RestWatch, aToolInTheAirDisturbsNoneAndATouchEndsIt) {
  const Model model = smallModel();
  Recording input;
  input.tracks = {{"probe", {{0, at(0)}, {0.3, at(0)}, {0.6, at(1)}}}};
  for (const int tool : {2, 3}) {  // the probe, and what it carries
    RestWatch watch(model, &input);
    for (int s = 0; s < 30; ++s) watch.add(rows(6, tool, 0), s * kDt, moving(0));  // it lies there from the start
    EXPECT_TRUE(watch.isAtRest());
    RestWatch other(model, &input);
    for (int s = 0; s < 20; ++s) other.add(rows(30), s * kDt, moving(1));
    for (int s = 20; s < 55; ++s) other.add(rows(6), s * kDt, moving(0));  // its hand moves on the way
    EXPECT_TRUE(other.isAtRest());
    other.add(rows(8, 0, tool), 0.55, moving(0));
    EXPECT_FALSE(other.isAtRest());
    EXPECT_DOUBLE_EQ(other.contacts()->rows, 6);
  }
  RestWatch touched(model, &input);
  for (int s = 30; s < 200; ++s) touched.add(rows(3, 2, 1), s * kDt, moving(0));
  EXPECT_FALSE(touched.contacts());
  EXPECT_EQ(touched.reason(), "tools-touch");
  for (int s = 200; s < 250; ++s) touched.add(rows(5), s * kDt, moving(0));
  EXPECT_DOUBLE_EQ(touched.contacts()->rows, 5) << "it has let go";
}

TEST(RestWatch, aDrivenPartMovesToo) {
  Model model = smallModel();
  model.objects[1].layout.free = false;
  model.objects[1].layout.vSize = 0;
  model.objects[1].motion = 0;
  Motion motion;
  motion.part = "bone";
  motion.keys = {{0, Vec3::Zero()}, {1, Vec3(0, 0.1, 0)}};
  model.scenario.motions = {motion};
  RestWatch watch(model, nullptr);
  const VecX v = moving(0);
  for (int s = 0; s < 100; ++s) watch.add(rows(1), s * kDt, v);
  EXPECT_FALSE(watch.contacts());
  EXPECT_NEAR(watch.speed(), 0.1, 1e-12);
  for (int s = 100; s < 120; ++s) watch.add(rows(1), s * kDt, v);
  EXPECT_TRUE(watch.contacts());
}

TEST(RestWatch, aBlockThatFallsComesToRestOnItsPlate) {
  Scenario scenario = scenes::blockOnPlateScenario();
  const auto model = compileModel(scenes::blockOnPlateJoint(), scenario).value();
  const auto reportOf = [&](double seconds) {
    RunOptions options;
    options.seconds = seconds;
    options.checks = false;
    return runScenario(model, options)->report.contacts;
  };
  EXPECT_EQ(reportOf(0.05).restReason, "parts-still-move") << "in the air, or just down";
  const ContactCounts settled = reportOf(2);
  ASSERT_TRUE(settled.rest);
  EXPECT_GT(*settled.rest, 0);
}

}  // namespace
}  // namespace glenoid
