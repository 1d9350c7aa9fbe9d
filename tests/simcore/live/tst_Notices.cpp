// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "simcore/live/Run.h"
#include "simcore/live/PenetrationProbe.h"
#include "simcore/live/RunWatch.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

std::vector<Notice> noticesOf(const Joint& joint, const Scenario& scenario, double seconds, const Recording* input = nullptr,
                              std::optional<double> failDepth = {}) {
  RunOptions options;
  options.seconds = seconds;
  options.input = input;
  options.failDepth = failDepth;
  return runScenario(compileModel(joint, scenario).value(), options)->report.notices;
}

const Notice* find(const std::vector<Notice>& notices, NoticeKind kind) {
  for (const Notice& notice : notices)
    if (notice.kind == kind) return &notice;
  return nullptr;
}

TEST(Notices, everyKindHasItsOwnWord) {
  std::set<std::string> words;
  for (int kind = 0; kind < kNoticeKindCount; ++kind) EXPECT_TRUE(words.insert(noticeName(static_cast<NoticeKind>(kind))).second);
  EXPECT_FALSE(words.count(""));
}

TEST(Notices, aCalmSceneHasNone) {
  EXPECT_TRUE(noticesOf(scenes::blockOnPlateJoint(), scenes::blockOnPlateScenario(), 0.3).empty());
}

TEST(Notices, wishesThatDoNothingAreNamed) {
  Scenario scenario = scenes::blockOnPlateScenario();
  scenario.effects.selfContact = scenario.effects.haptics = scenario.effects.bursa = Wish::On;
  scenario.seed = 7;
  scenario.loadRise = 0.5;
  const auto notices = noticesOf(scenes::blockOnPlateJoint(), scenario, 0.02);
  ASSERT_EQ(notices.size(), 5u);
  EXPECT_EQ(notices[0].subject, "selfContact");
  EXPECT_EQ(notices[1].subject, "haptics");
  EXPECT_EQ(notices[2].unused.why, UnusedSetting::Why::LoadRise);
  EXPECT_EQ(notices[3].unused.why, UnusedSetting::Why::Seed);
  EXPECT_EQ(notices[4].kind, NoticeKind::EffectIdle);
  EXPECT_EQ(notices[4].subject, "bursa");
}

TEST(Notices, aDepthBeyondItsLimitNamesPairAndTime) {
  Joint joint = scenes::blockOnPlateJoint();
  Scenario scenario = scenes::blockOnPlateScenario();
  // The block is so soft and loaded so that it sinks: here a limit that any contact passes.
  const auto some = noticesOf(joint, scenario, 0.5, nullptr, 1e-12);
  const auto none = noticesOf(joint, scenario, 0.5, nullptr, HUGE_VAL);
  EXPECT_EQ(find(none, NoticeKind::TooDeep), nullptr);
  if (const Notice* deep = find(some, NoticeKind::TooDeep)) {
    EXPECT_GT(deep->figure, 1e-12);
    EXPECT_GT(deep->time, 0);
  }
}

TEST(Notices, theLimitIsAThirdOfTheThicknessOfTheThinnerOne) {
  // Two fixed-size boxes, one set 4 mm into the other by hand: thickness of a box of 20 mm is 2 V/A = 6.67 mm, a third 2.22 mm.
  Joint joint;
  scenes::addMaterials(joint);
  joint.parts.push_back(scenes::boxPart("low", 1, PartKind::Rigid, {0, 0, 0}, {0.02, 0.02, 0.02}));
  joint.parts.push_back(scenes::boxPart("high", 2, PartKind::Rigid, {0.001, 0.021, 0.001}, {0.021, 0.041, 0.021}));
  Scenario scenario;
  scenario.fixedParts = {"low"};
  const auto model = compileModel(joint, scenario).value();
  for (const double deep : {0.002, 0.003}) {
    PenetrationProbe probe(*model, SurfaceKind::Collision);
    probe.setLimit(std::nullopt);
    VecX q = model->start.q;
    q[model->objects[1].layout.qOffset + 1] -= 0.001 + deep;
    probe.look(q, {}, 1.5, 300);
    const std::vector<Notice> tooDeep = probe.tooDeep();
    EXPECT_EQ(tooDeep.size(), deep > 0.0222 / 10 ? 1u : 0u) << deep;
    EXPECT_NEAR(probe.deepest(), deep, 1e-12);
    if (tooDeep.empty()) continue;
    EXPECT_NEAR(tooDeep[0].limit, 0.02 / 9, 1e-12);
    EXPECT_NEAR(tooDeep[0].figure, deep, 1e-12);
    EXPECT_EQ(tooDeep[0].time, 1.5);
  }
}

TEST(Notices, whatIsTornAwayOrStretchedIsNamedOnce) {
  const auto model = compileModel(scenes::figure4Joint(), scenes::figure4Scenario()).value();
  RunWatch watch(*model);
  State state = model->start;
  watch.look(state);
  EXPECT_TRUE(watch.notices().empty());
  const int right = findPart(model->joint, "right"), middle = findPart(model->joint, "middle");
  state.q.segment<3>(model->objects[right].layout.qOffset) += Vec3(100, 0, 0);
  const ObjectLayout& soft = model->objects[middle].layout;
  for (int node = 0; node < soft.nodeCount; ++node) state.q[soft.qOffset + 3 * node] *= 4;
  state.step = 12;
  watch.look(state);
  watch.look(state);
  ASSERT_EQ(watch.notices().size(), 2u);
  EXPECT_EQ(find(watch.notices(), NoticeKind::TornAway)->subject, "right");
  EXPECT_NEAR(find(watch.notices(), NoticeKind::TornAway)->figure, 100, 1e-9);
  EXPECT_EQ(find(watch.notices(), NoticeKind::Overstretched)->subject, "middle");
  EXPECT_NEAR(find(watch.notices(), NoticeKind::Overstretched)->figure, 4, 1e-9);  // an edge along X
  EXPECT_EQ(find(watch.notices(), NoticeKind::Overstretched)->step, 12);
}

TEST(Notices, aMarkWithoutContactIsMissedAndOneCutShortIsNotJudged) {
  const Scenario scenario = scenes::blockOnPlateScenario();
  Recording recording;
  recording.marks = {{"press", 0.05, 0.1, scenario.tools[0].id, "block"}, {"later", 0.05, 9, scenario.tools[0].id, "block"}, {"label", 0, 0.1, "", ""}};
  const auto notices = noticesOf(scenes::blockOnPlateJoint(), scenario, 0.2, &recording);
  ASSERT_EQ(notices.size(), 1u);
  EXPECT_EQ(notices[0].kind, NoticeKind::MarkMissed);
  EXPECT_EQ(notices[0].subject, "press");
}

TEST(Notices, stepsThatCutTheRecordedPathAreTooLong) {
  Scenario scenario = scenes::blockOnPlateScenario();
  const Pose home = scenario.tools[0].home;
  Pose away = home;
  away.p_WB.y() += 0.01;  // out and back again within 40 ms
  Recording recording;
  recording.tracks = {{scenario.tools[0].id, {{0.1, home}, {0.12, away}, {0.14, home}}}};
  scenario.dt = 0.005;
  EXPECT_EQ(find(noticesOf(scenes::blockOnPlateJoint(), scenario, 0.2, &recording), NoticeKind::PathCut), nullptr);
  scenario.dt = 0.05;  // samples at 0.1 and 0.15 s: the hand never leaves
  const auto notices = noticesOf(scenes::blockOnPlateJoint(), scenario, 0.2, &recording);
  ASSERT_NE(find(notices, NoticeKind::PathCut), nullptr);
  EXPECT_NEAR(find(notices, NoticeKind::PathCut)->figure, 0.01, 1e-9);
}

}  // namespace
}  // namespace glenoid
