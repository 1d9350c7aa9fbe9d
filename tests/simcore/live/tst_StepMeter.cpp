// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/StepMeter.h"

#include <gtest/gtest.h>

#include <numeric>

#include "simcore/body/State.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

std::shared_ptr<const Model> figure5() { return compileModel(scenes::figure4Joint(), scenes::figure5Scenario()).value(); }

TEST(StepMeter, stepsAreTheSameBitByBitWhetherSomebodyLooksOrNot) {
  const auto model = figure5();
  StepMeter meter;
  State watched = model->start, plain = model->start;
  const StepFunction own = meter.maker()(model, {}), other = makeStepperStep(model, {});
  meter.setWanted(true);
  for (int k = 0; k < 20; ++k) {
    if (k == 12) meter.setWanted(false);
    own({}, watched);
    other({}, plain);
  }
  EXPECT_EQ(toHex(stateHash(watched)), toHex(stateHash(plain)));
}

TEST(StepMeter, keepsEveryStepWhileItIsWantedAndNothingElse) {
  const auto model = figure5();
  StepMeter meter;
  State state = model->start;
  const StepFunction step = meter.maker()(model, {});
  for (int k = 0; k < 3; ++k) step({}, state);
  EXPECT_TRUE(meter.take().steps.empty());
  meter.setWanted(true);
  for (int k = 0; k < 5; ++k) step({}, state);
  const StepMeter::Reading reading = meter.take();
  ASSERT_EQ(reading.steps.size(), 5u);
  EXPECT_EQ(reading.model, model);
  EXPECT_NEAR(reading.steps[0].time, 4 * model->scenario.dt, 1e-12);
  EXPECT_EQ(reading.steps.back().time, state.time);
  for (const StepMeter::Step& one : reading.steps) {
    const float sum = std::accumulate(one.stages.begin(), one.stages.end(), 0.0f);
    EXPECT_GT(sum, 0);
    EXPECT_LE(sum, one.cpuMs * 1.01f + 0.01f) << "stages are parts of the step";
  }
  EXPECT_TRUE(meter.take().steps.empty());
  for (std::size_t k = 0; k < StepMeter::kMost + 10; ++k) step({}, state);
  EXPECT_LE(meter.take().steps.size(), StepMeter::kMost);
}

/// The paper's Figure 5: three coupled bodies and two fingers that rest on the middle one are one contact island of three.
TEST(IslandViews, sayWhatJoinsFigureFive) {
  const auto model = figure5();
  Stepper stepper(model, {});
  watchIslands(stepper, true);
  State state = model->start;
  const StepReport* report = nullptr;
  for (int k = 0; k < 40; ++k) report = &stepper.step({}, state);
  const IslandViews* views = islandViews(stepper);
  ASSERT_NE(views, nullptr);
  ASSERT_EQ(views->coupling.size(), 3u);  // the chain, and each finger
  int unknowns = 0;
  for (const CouplingIslandView& island : views->coupling) unknowns += island.unknowns;
  EXPECT_EQ(unknowns, model->start.v.size());
  ASSERT_EQ(views->contact.size(), 1u);
  const ContactIslandView& island = views->contact[0];
  EXPECT_EQ(island.couplingIslands.size(), 3u);
  EXPECT_EQ(island.contacts, report->contacts);
  EXPECT_EQ(island.pressing, report->pressing);
  ASSERT_EQ(island.joinedBy.size(), 2u);  // each finger with the soft middle
  double force = 0, viewed = 0;
  int contacts = 0;
  for (const ContactView& contact : report->contactViews) viewed += contact.force;
  for (const ContactIslandView::Joint& joint : island.joinedBy) {
    EXPECT_EQ(model->objects[static_cast<std::size_t>(joint.objectA)].id, "middle");
    EXPECT_TRUE(model->objects[static_cast<std::size_t>(joint.objectB)].tool);
    contacts += joint.contacts;
    force += joint.force;
  }
  EXPECT_EQ(contacts, island.contacts);
  EXPECT_NEAR(force, viewed, 1e-12 * std::max(1.0, viewed));
  EXPECT_NEAR(island.residual, report->residual, 1e-9) << "one island holds everything";
  EXPECT_EQ(island.error, report->complementarity);
  watchIslands(stepper, false);
  EXPECT_EQ(islandViews(stepper), nullptr);
}

}  // namespace
}  // namespace glenoid
