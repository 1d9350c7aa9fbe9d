// SPDX-License-Identifier: GPL-3.0-or-later
// What a step hands to a haptic loop, against the step itself: the same step with the hand a little elsewhere.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <memory>

#include "simcore/base/Turns.h"
#include "simcore/step/LocalPublisher.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

std::shared_ptr<const Model> compiled(const Joint& joint, const Scenario& scenario) {
  auto model = compileModel(joint, scenario);
  EXPECT_TRUE(model) << toLogLine(model.error());
  return *model;
}

/// A finger that pressed a soft block onto its plate for a while.
struct Pressed {
  std::shared_ptr<const Model> model;
  StepperOptions options;
  State state;
  Inputs inputs;

  explicit Pressed(double depth, bool flat = false, Profile profile = Profile::Direct) {
    Scenario scenario = scenes::blockOnPlateScenario();
    scenario.effects.friction = Wish::Off;
    if (flat) {  // with its whole face on a fine grid
      scenario.tools[0].kind = ToolKind::Bar;
      scenario.tools[0].radius = 0.015;
    }
    Joint joint = scenes::blockOnPlateJoint();
    if (flat)
      joint.parts[1].collision = std::make_shared<const TriMesh>(scenes::boxSurface(Vec3(-0.02, 0.0005, -0.02), Vec3(0.02, 0.0405, 0.02), 12));
    model = compiled(joint, scenario);
    options.profile = profile;
    state = model->start;
    inputs.hands = {scenario.tools[0].home};
    Stepper stepper(model, {});
    for (int s = 0; s < 150; ++s) {
      inputs.hands[0].p_WB.y() = 0.045 - (0.0045 + depth) * std::min(1.0, s / 60.0);
      stepper.step(inputs, state);
    }
  }

  /// One step from the same state with the hand moved, and what it publishes.
  LocalProblem stepWith(const Vec3& off, StepReport* report = nullptr) const {
    Stepper stepper(model, options);
    LocalPublisher publisher(stepper);
    State next = state;
    Inputs moved = inputs;
    moved.hands[0].p_WB += off;
    const StepReport& done = stepper.step(moved, next);
    publisher.stepped(done);
    LocalProblem problem;
    publisher.read(next, 0, problem);
    if (report) *report = done;
    return problem;
  }
};

// In one step everything is linear while the same rows press: between two of them the tool went J Δx against the far side, which
// gave C Δf. Not a number of that is the publisher's own: Δx and Δf are the steps'.
TEST(LocalPublisher, theFarSideGivesInAStepWhatItSays) {
  for (const Profile profile : {Profile::Direct, Profile::Reference}) {
    const Pressed pressed(0.003, false, profile);
    const LocalProblem a = pressed.stepWith(Vec3::Zero()), b = pressed.stepWith(Vec3(0, -2e-5, 0));
    ASSERT_TRUE(a.valid && b.valid);
    ASSERT_EQ(a.rowCount, b.rowCount);
    ASSERT_GT(a.force[0], 0.01);
    Vec6 moved;
    moved << b.pose[0].p_WB - a.pose[0].p_WB, rotationVector(b.pose[0].q_WB * a.pose[0].q_WB.conjugate());
    // They are sorted by force: found again by their J, and where one corner touches two triangles by the nearer force.
    std::vector<int> twin(static_cast<std::size_t>(a.rowCount), -1);
    std::vector<char> taken(static_cast<std::size_t>(b.rowCount), 0);
    for (int i = 0; i < a.rowCount; ++i) {
      double least = 1e300;
      for (int j = 0; j < b.rowCount; ++j) {
        const double off = std::abs(a.force[static_cast<std::size_t>(i)] - b.force[static_cast<std::size_t>(j)]);
        if (taken[static_cast<std::size_t>(j)] || (a.J.row(i) - b.J.row(j)).norm() > 1e-12 || off >= least) continue;
        least = off;
        twin[static_cast<std::size_t>(i)] = j;
      }
      ASSERT_GE(twin[static_cast<std::size_t>(i)], 0);
      taken[static_cast<std::size_t>(twin[static_cast<std::size_t>(i)])] = 1;
    }
    int pressing = 0;
    double scale = 0;
    for (int i = 0; i < a.rowCount; ++i) {
      if (!(a.force[static_cast<std::size_t>(i)] > 0)) continue;
      ++pressing;
      const double went = a.J.row(i).head<6>().dot(moved);
      double gave = 0;
      for (int k = 0; k < a.rowCount; ++k) {
        const auto kk = static_cast<std::size_t>(k), kb = static_cast<std::size_t>(twin[kk]);
        EXPECT_EQ(a.force[kk] > 0, b.force[kb] > 0) << "the same rows must press";
        gave += a.C(i, k) * (b.force[kb] - a.force[kk]);
      }
      scale = std::max(scale, std::abs(went));
      EXPECT_NEAR(went + gave, 0, 1e-6 * std::abs(went)) << i;
    }
    EXPECT_GE(pressing, 1);
    EXPECT_GT(scale, 1e-7) << "there was something to see";
  }
}

// A spring that never gives energy out: symmetric, and nothing below zero.
TEST(LocalPublisher, whatTheFarSideGivesIsAPassiveSpring) {
  const Pressed pressed(0.003);
  const LocalProblem on = pressed.stepWith(Vec3::Zero());
  ASSERT_TRUE(on.valid);
  const MatX C = on.C.topLeftCorner(on.rowCount, on.rowCount);
  EXPECT_GT(C(0, 0), 0);
  EXPECT_LT((C - C.transpose()).norm(), 1e-12 * C.norm());
  EXPECT_GE(Eigen::SelfAdjointEigenSolver<MatX>(C).eigenvalues().minCoeff(), -1e-9 * C.norm());
}

TEST(LocalPublisher, forcesAreThoseThatTheStepReports) {
  const Pressed pressed(0.003);
  StepReport report;
  const LocalProblem problem = pressed.stepWith(Vec3::Zero(), &report);
  Vec3 force = Vec3::Zero();
  for (int i = 0; i < problem.rowCount; ++i) force += problem.force[static_cast<std::size_t>(i)] * problem.J.row(i).head<3>().transpose();
  EXPECT_GT(force.norm(), 0.05);
  EXPECT_LT((force - report.toolForces[0]).norm(), 1e-9 * force.norm());
}

TEST(LocalPublisher, rowsBeyondTheRoomAreCountedAndTheLoadedOnesKept) {
  const Pressed few(0.003), many(0.003, true);
  EXPECT_EQ(few.stepWith(Vec3::Zero()).overflow, 0);
  StepReport report;
  const LocalProblem problem = many.stepWith(Vec3::Zero(), &report);
  int rows = 0, pressing = 0;
  for (const ContactView& view : report.contactViews) {
    if (!many.model->objects[static_cast<std::size_t>(view.objectA)].tool && !many.model->objects[static_cast<std::size_t>(view.objectB)].tool) continue;
    ++rows;
    pressing += view.force > 0;
  }
  ASSERT_GT(rows, LocalProblem::kRows);
  EXPECT_EQ(problem.rowCount, LocalProblem::kRows);
  EXPECT_EQ(problem.overflow, rows - LocalProblem::kRows);
  int kept = 0;
  for (int i = 0; i < problem.rowCount; ++i) kept += problem.force[static_cast<std::size_t>(i)] > 0;
  EXPECT_EQ(kept, std::min(pressing, LocalProblem::kRows));
}

TEST(LocalPublisher, theProfilePaperPublishesNothing) {
  Pressed pressed(0.003, false, Profile::Paper);
  EXPECT_FALSE(pressed.stepWith(Vec3::Zero()).valid);
}

/// Steps of a finger that presses on the block and slides, with what is published after the last of them.
LocalProblem slidOn(double stepsAhead, std::string* hash) {
  Scenario scenario = scenes::blockOnPlateScenario();
  scenario.effects.friction = Wish::Off;
  const auto model = compiled(scenes::blockOnPlateJoint(), scenario);
  Stepper stepper(model, {});
  std::unique_ptr<LocalPublisher> publisher;
  if (stepsAhead >= 0) publisher = std::make_unique<LocalPublisher>(stepper, stepsAhead);
  State state = model->start;
  Inputs inputs;
  inputs.hands = {scenario.tools[0].home};
  LocalProblem problem;
  for (int s = 0; s < 160; ++s) {
    inputs.hands[0].p_WB.y() = 0.045 - 0.0075 * std::min(1.0, s / 60.0);
    inputs.hands[0].p_WB.x() = scenario.tools[0].home.p_WB.x() + 4e-4 * std::max(0, std::min(s - 100, 30));
    const StepReport& report = stepper.step(inputs, state);
    if (!publisher) continue;
    publisher->stepped(report);
    publisher->read(state, 0, problem);
  }
  *hash = toHex(stateHash(state));
  return problem;
}

// Looking ahead is looking, not stepping: the run has the bits of one that nobody looks at. And at rest there is nothing to foresee: the rows to come
// hold the tool where the step's own do, under the same force.
TEST(LocalPublisher, lookingAheadChangesNoBitAndFindsTheSameForceAtRest) {
  std::string none, step, ahead;
  slidOn(-1, &none);
  const LocalProblem a = slidOn(0, &step), b = slidOn(1.5, &ahead);
  EXPECT_EQ(none, step);
  EXPECT_EQ(none, ahead);
  ASSERT_TRUE(a.valid && b.valid);
  const auto felt = [](const LocalProblem& problem) {
    Vec3 force = Vec3::Zero();
    for (int i = 0; i < problem.rowCount; ++i) force += problem.force[static_cast<std::size_t>(i)] * problem.J.row(i).head<3>().transpose();
    return force;
  };
  EXPECT_GT(felt(a).norm(), 0.05);
  EXPECT_LT((felt(a) - felt(b)).norm(), 1e-3 * felt(a).norm());
  // With the step's forces every row that presses is closed, to a hundredth of what the far side gave under them.
  for (int i = 0; i < b.rowCount; ++i) {
    double gave = 0;
    for (int j = 0; j < b.rowCount; ++j) gave += b.C(i, j) * b.force[static_cast<std::size_t>(j)];
    if (b.force[static_cast<std::size_t>(i)] > 0) EXPECT_LT(std::abs(b.slack[static_cast<std::size_t>(i)]), 0.01 * gave) << i;
  }
}

// A finger that carries another: two bodies and the four springs between them.
TEST(LocalPublisher, aCarriedToolIsASecondBody) {
  Scenario scenario = scenes::blockOnPlateScenario();
  Tool inside = scenario.tools[0];
  inside.id = "inside";
  inside.link = "finger";
  inside.linkStiffness = 1200;
  inside.length = 0.03;
  scenario.tools.push_back(inside);
  const auto model = compiled(scenes::blockOnPlateJoint(), scenario);
  Stepper stepper(model, {});
  LocalPublisher publisher(stepper);
  State state = model->start;
  Inputs inputs;
  inputs.hands = {scenario.tools[0].home, scenario.tools[1].home};
  LocalProblem problem;
  for (int s = 0; s < 60; ++s) {
    inputs.hands[0].p_WB.y() -= 5e-4;
    publisher.stepped(stepper.step(inputs, state));
  }
  publisher.read(state, 0, problem);
  ASSERT_TRUE(problem.valid);
  EXPECT_EQ(problem.bodyCount, 2);
  EXPECT_EQ(problem.linkCount, 4);
  double stiffness = 0;
  for (int l = 0; l < problem.linkCount; ++l) stiffness += problem.links[static_cast<std::size_t>(l)].stiffness;
  EXPECT_DOUBLE_EQ(stiffness, 1200);
  bool onSecond = false;
  for (int i = 0; i < problem.rowCount; ++i) onSecond = onSecond || problem.J.row(i).segment<6>(6).norm() > 0;
  EXPECT_TRUE(onSecond);
  publisher.read(state, 1, problem);
  EXPECT_FALSE(problem.valid) << "no hand holds it";
}

}  // namespace
}  // namespace glenoid
