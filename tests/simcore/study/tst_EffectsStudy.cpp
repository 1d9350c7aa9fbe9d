// SPDX-License-Identifier: GPL-3.0-or-later
// What the study of effects says is lost, beside closed forms; that it measures nothing where there is
// nothing.
#include <gtest/gtest.h>

#include <cmath>

#include "simcore/study/effects/EffectsTables.h"
#include "tests/scenes/BlockScenes.h"
#include "tests/scenes/SlideScenes.h"

namespace glenoid::test {
namespace {

EffectsOptions few() {
  EffectsOptions options;
  options.windows.count = 3;
  options.windows.seconds = 0.1;
  options.repeats = 7;
  return options;
}

const EffectRow& rowOf(const EffectsResult& result, const std::string& name) {
  for (const EffectRow& row : result.rows)
    if (row.name == name) return row;
  throw std::out_of_range(name);
}

/// A block that friction holds on a slope.
StudyScene held() {
  scenes::Slide slide;
  slide.friction = 0.5;
  return {scenes::slideJoint(slide), scenes::slideScenario(slide), {}};
}

TEST(EffectsStudy, whatIsLostWithoutFrictionIsTheSlideOfTheClosedForm) {
  const EffectsResult result = studyEffects(held(), few()).value();
  const EffectRow& row = rowOf(result, "friction");
  ASSERT_TRUE(row.acts);
  ASSERT_TRUE(row.loss);
  // From rest n steps of backward Euler under a = g sin α go a Δt² n (n + 1) / 2; looked at after 4, 8 … 20.
  const double a = scenes::kSlideGravity * std::sin(scenes::Slide().angle), dt = scenes::Slide().dt;
  double squares = 0;
  const auto slid = [&](int n) { return 0.5 * a * dt * dt * n * (n + 1); };
  for (int n = 4; n <= 20; n += 4) squares += slid(n) * slid(n);
  const AccuracyError& moved = row.loss->apart[AccuracyQuantity::Displacement];
  EXPECT_NEAR(moved.most, slid(20), 0.01 * slid(20));
  EXPECT_NEAR(moved.value, std::sqrt(squares / 5), 0.01 * std::sqrt(squares / 5));
  EXPECT_EQ(moved.where, result.base->objects[1].id);
  // What friction carries is the weight along the slope, m g sin α; the rest of the contact's force is the
  // same.
  const double pull = result.base->objects[1].mass * a;
  EXPECT_NEAR(row.loss->apart[AccuracyQuantity::ContactForce].value, pull, 0.02 * pull);
  // The picture holds the same: every vertex of the block as far off, none of the plate.
  const EffectMoment& moment = row.loss->moment;
  for (const float apart : moment.apart[1]) EXPECT_NEAR(apart, slid(20), 0.01 * slid(20));
  for (const float apart : moment.apart[0]) EXPECT_EQ(apart, 0);
  EXPECT_TRUE(row.automatic.on);
  EXPECT_EQ(row.automatic.reason, "auto-present");
}

TEST(EffectsStudy, everyEffectHasARowAndTimesOfEqualNumber) {
  const EffectsOptions options = few();
  const EffectsResult result = studyEffects(held(), options).value();
  ASSERT_EQ(result.rows.size(), result.base->effects.size());
  for (const EffectRow& row : result.rows) {
    EXPECT_EQ(row.times.has_value(), row.acts) << row.name;
    EXPECT_EQ(row.loss.has_value(), row.acts) << row.name;
    if (!row.times) continue;
    EXPECT_EQ(row.times->pairs,
              static_cast<long>(result.windows.size()) * options.repeats * options.stepsTimed)
        << row.name;
    for (const Timing& step : row.times->step) EXPECT_GT(step.median, 0) << row.name;
  }
  for (const char* none : {"couplings", "selfContact", "bursa", "dent", "haptics"})
    EXPECT_FALSE(rowOf(result, none).acts) << none;
  EXPECT_EQ(rowOf(result, "contact").with, std::vector<std::string>{"friction"});
  const std::vector<StudyTable> tables = effectsTables(result);
  for (const StudyTable& table : tables)
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << table.id;
}

TEST(EffectsStudy, whatIsSwitchedOffInTheSceneIsComparedWithItOn) {
  StudyScene scene = held();
  scene.scenario.effects.friction = Wish::Off;
  EffectsOptions options = few();
  options.only = {"friction"};
  const EffectsResult result = studyEffects(scene, options).value();
  ASSERT_EQ(result.rows.size(), 1u);
  EXPECT_EQ(result.rows[0].wish, Wish::Off);
  EXPECT_TRUE(result.rows[0].automatic.on);  // what auto would make of it
  ASSERT_TRUE(result.rows[0].loss);
  EXPECT_GT(result.rows[0].loss->apart[AccuracyQuantity::Displacement].value, 1e-3);
}

/// With contact off nothing keeps a block from falling into the plate; the depth is told all the same, by the
/// scene's own pairs.
TEST(EffectsStudy, withoutContactTheDepthIsToldByThePairsOfTheScene) {
  EffectsOptions options = few();
  options.only = {"contact"};
  options.windows.seconds = 0.02;  // four steps: it falls less than it is thick
  const EffectsResult result = studyEffects(held(), options).value();
  const EffectLoss& loss = *result.rows.at(0).loss;
  EXPECT_LT(loss.deepestWith, 1e-4);
  const double fall = scenes::kSlideGravity * std::cos(scenes::Slide().angle) * 0.005 * 0.005 * 10;
  EXPECT_NEAR(loss.deepestWithout, fall, 0.1 * fall);
}

TEST(EffectsStudy, hapticsMovesNothingAndFollowsTheHand) {
  StudyScene scene{scenes::blockOnPlateJoint(), scenes::blockOnPlateScenario(), {}};
  EffectsOptions options = few();
  options.only = {"haptics"};
  const EffectsResult result = studyEffects(scene, options).value();
  const EffectRow& row = result.rows.at(0);
  ASSERT_TRUE(row.acts);
  EXPECT_EQ(row.automatic.reason, "run-felt");
  for (const AccuracyError& apart : row.loss->apart.by) EXPECT_EQ(apart.most, 0);
  EXPECT_GT(row.times->pairs, 0);
  EXPECT_GT(row.times->price.median, 0) << "what it publishes after each step takes time";
}

TEST(EffectsStudy, refusesEffectsThatAreNotThereAndStopsWhenAsked) {
  EffectsOptions options = few();
  options.only = {"magic"};
  const auto unknown = studyEffects(held(), options);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().fault, Fault::UnknownId);
  options.only.clear();
  int asked = 0;
  options.progress = [&](double) { return ++asked < 30; };
  const auto stopped = studyEffects(held(), options);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().fault, Fault::Cancelled);
}

TEST(EffectFacts, countWhatTheEffectsActOn) {
  const StudyScene scene = held();
  const auto model = compileModel(scene.joint, scene.scenario).value();
  for (const EffectFacts& facts : effectFacts(*model)) {
    if (facts.name == "gravity") {
      EXPECT_EQ(facts.count("movingParts"), 1);
      EXPECT_NEAR(facts.count("acceleration"), scenes::kSlideGravity, 1e-12);
    }
    if (facts.name == "contact") EXPECT_EQ(facts.count("pairs"), 1);
    if (facts.name == "friction") EXPECT_GT(facts.count("materials"), 0);
    EXPECT_EQ(facts.on, model->effectOn(facts.name)) << facts.name;
  }
  Scenario without = scene.scenario;
  without.effects.contact = Wish::Off;
  const auto still = compileModel(scene.joint, without).value();
  for (const EffectFacts& facts : effectFacts(*still))
    if (facts.name == "friction") EXPECT_EQ(facts.reason, "no-contact");
}

}  // namespace
}  // namespace glenoid::test
