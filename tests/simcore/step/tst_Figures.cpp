// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's Figure 4 (coupled objects) and Figure 5 (a contact island of two tools and a coupling island of three).
#include <gtest/gtest.h>

#include "simcore/step/Stepper.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

Vec3 meanOf(const Model& model, const State& state, int object) {
  std::vector<Vec3> points(model.objects[object].collision.vertices.size());
  surfacePositions(model.objects[object].collision, model.objects[object].layout, state.q, points);
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / static_cast<double>(points.size());
  return mean;
}

TEST(Figure4, rigidSoftRigidMakeOneCouplingIsland) {
  Scenario scenario = scenes::figure4Scenario();
  scenario.fixedParts.clear();
  const auto model = compileModel(scenes::figure4Joint(), scenario).value();
  EXPECT_EQ(model->couplingIslandCount, 1);
  EXPECT_EQ(model->couplingIslandOfObject, (std::vector<int>{0, 0, 0}));
  scenario.effects.couplings = Wish::Off;
  EXPECT_EQ(compileModel(scenes::figure4Joint(), scenario).value()->couplingIslandCount, 3);
}

TEST(Figure4, theChainHangsFromItsFixedEndAndComesToRest) {
  Scenario scenario = scenes::figure4Scenario();
  scenario.effects.contact = Wish::Off;
  Joint joint = scenes::figure4Joint();
  joint.materials[1].youngsModulus = 5e5;
  const auto model = compileModel(joint, scenario).value();
  Stepper stepper(model, {});
  State state = model->start;
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const StepReport& report = stepper.step({}, state);
    ASSERT_TRUE(report.taken);
    worst = std::max(worst, report.residual);
  }
  EXPECT_LT(worst, 1e-9) << "momentum of each step is balanced";
  EXPECT_LT(meanOf(*model, state, 2).y(), 0.0095) << "the free end sags";
  EXPECT_GT(meanOf(*model, state, 2).y(), -0.02);
  EXPECT_LT(state.v.norm(), 1e-3);
  // Springs of 4e4 N/m hold 0.024 kg and 0.016 kg with far less than a tenth of a millimetre of gap.
  for (const SpringView& spring : model->springs) {
    const auto place = [&](int object, const VertexBinding& binding) {
      SurfaceBinding one;
      one.vertices = {binding};
      Vec3 p;
      surfacePositions(one, model->objects[object].layout, state.q, std::span(&p, 1));
      return p;
    };
    EXPECT_LT((place(spring.objectA, spring.a) - place(spring.objectB, spring.b)).norm(), 2e-4);
  }
}

TEST(Figure5, twoToolsAndACouplingIslandOfThreeShareOneContactIsland) {
  const auto model = compileModel(scenes::figure4Joint(), scenes::figure5Scenario()).value();
  ASSERT_EQ(model->couplingIslandCount, 3);
  EXPECT_EQ(model->couplingIslandOfObject, (std::vector<int>{0, 0, 0, 1, 2}));
  for (const Profile profile : {Profile::Direct, Profile::Reference, Profile::Paper}) {
    Stepper stepper(model, {profile});
    State state = model->start;
    Inputs hands;
    bool sawOne = false;
    for (int i = 0; i < 60; ++i) {
      hands.hands.clear();
      for (const Tool& tool : model->scenario.tools) {
        Pose hand = tool.home;
        hand.p_WB.y() -= 4e-5 * i;  // both press down, 8 mm/s
        hands.hands.push_back(hand);
      }
      const StepReport& report = stepper.step(hands, state);
      ASSERT_TRUE(report.taken);
      const bool first = report.toolForces[0].y() > 0.01, second = report.toolForces[1].y() > 0.01;
      if (first && second) {
        EXPECT_EQ(report.contactIslands, 1);
        sawOne = true;
      }
    }
    EXPECT_TRUE(sawOne) << static_cast<int>(profile);
  }
}

TEST(Figure5, toolsApartMakeIslandsOfTheirOwn) {
  Scenario scenario = scenes::figure5Scenario();
  scenario.tools[1].home.p_WB.y() += 0.1;
  const auto model = compileModel(scenes::figure4Joint(), scenario).value();
  Stepper stepper(model, {});
  State state = model->start;
  const StepReport& report = stepper.step({}, state);
  EXPECT_LE(report.contactIslands, 1);
  EXPECT_EQ(report.toolForces[1].norm(), 0);
}

}  // namespace
}  // namespace glenoid
