// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/collide/Penetration.h"
#include "simcore/step/Stepper.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

struct Session {
  explicit Session(Profile profile = Profile::Direct, int threads = 1, bool portable = false, Scenario scenario = scenes::blockOnPlateScenario())
      : model(compileModel(scenes::blockOnPlateJoint(), scenario).value()), stepper(model, {profile, threads, portable}), state(model->start) {}

  const StepReport& step(double handY = 0.06) {
    Pose hand = model->scenario.tools[0].home;
    hand.p_WB.y() = handY;
    return stepper.step({{hand}}, state);
  }

  double penetration() {
    std::vector<std::vector<Vec3>> positions;
    std::vector<std::span<const Vec3>> spans;
    for (const SceneObject& object : model->objects) {
      positions.emplace_back(object.collision.vertices.size());
      surfacePositions(object.collision, object.layout, state.q, positions.back());
    }
    for (const auto& list : positions) spans.emplace_back(list);
    return deepestPenetration(model->collisionSurfaces, model->collisionPairs, spans).depth;
  }

  std::shared_ptr<const Model> model;
  Stepper stepper;
  State state;
};

TEST(Stepper, theBlockComesToRestOnThePlateAndTheWeightIsCarried) {
  Session run;
  double support = 0, worst = 0;
  for (int i = 0; i < 600; ++i) {
    const StepReport& report = run.step();
    ASSERT_TRUE(report.taken);
    worst = std::max(worst, run.penetration());
    support = 0;
    for (const ContactView& contact : report.contactViews) support += std::abs(contact.normal_W.y()) * contact.force;
  }
  EXPECT_NEAR(support, run.model->objects[1].mass * 9.81, 1e-3 * run.model->objects[1].mass * 9.81);
  EXPECT_LT(worst, 1e-4);
  EXPECT_LT(run.state.v.norm(), 1e-4);
}

TEST(Stepper, aFingerPressesTheBlockWithTheForceOfItsCoupling) {
  Session run;
  double force = 0, worst = 0;
  for (int i = 0; i < 800; ++i) {
    const double y = i < 400 ? 0.06 - 0.03 * i / 400.0 : 0.03;  // 10 mm below the top
    const StepReport& report = run.step(y);
    ASSERT_TRUE(report.taken);
    force = report.toolForces[0].y();
    worst = std::max(worst, run.penetration());
  }
  const int offset = run.model->objects[2].layout.qOffset;
  const Pose start = poseAt(run.model->start.q, offset);
  const Vec3 tip_B = start.q_WB.conjugate() * (run.model->scenario.tools[0].home.p_WB - start.p_WB);
  const Vec3 tip = poseAt(run.state.q, offset) * tip_B;
  EXPECT_NEAR(force, 800 * (tip.y() - 0.03), 0.02 * force);
  EXPECT_GT(force, 1.0);
  EXPECT_LT(worst, 1e-3);
}

TEST(Stepper, aCarriedFingerFeelsWhatItsCarrierCannotTouch) {
  // The finger that the hand holds passes through the block; the one it carries, by 4000 N/m, does not.
  Scenario scenario = scenes::blockOnPlateScenario();
  Tool inner = scenario.tools[0];
  inner.id = "inner";
  inner.link = scenario.tools[0].id;
  inner.linkStiffness = 4000;
  scenario.tools[0].perforates = {"block", "plate"};
  scenario.tools.push_back(inner);
  Session run(Profile::Direct, 1, false, scenario);
  EXPECT_EQ(run.model->couplingIslandOfObject[2], run.model->couplingIslandOfObject[3]);
  StepReport report;
  for (int i = 0; i < 800; ++i) {
    report = run.step(i < 400 ? 0.06 - 0.03 * i / 400.0 : 0.03);
    ASSERT_TRUE(report.taken);
  }
  EXPECT_EQ(report.toolForces[0].norm(), 0);
  const auto tipOf = [&](int object, const Tool& tool) {
    const Pose start = poseAt(run.model->start.q, run.model->objects[object].layout.qOffset);
    return Vec3(poseAt(run.state.q, run.model->objects[object].layout.qOffset) * (start.q_WB.conjugate() * (tool.home.p_WB - start.p_WB)));
  };
  const double outer = tipOf(2, scenario.tools[0]).y(), carried = tipOf(3, inner).y(), force = report.toolForces[1].y();
  EXPECT_GT(force, 1);
  // One force goes through both springs.
  EXPECT_NEAR(force, 4000 * (carried - outer), 0.02 * force);
  EXPECT_NEAR(force, 800 * (outer - 0.03), 0.02 * force);
}

TEST(Stepper, directAgreesWithTheReferenceInOneStep) {
  Session direct, reference(Profile::Reference);
  for (int i = 0; i < 300; ++i) direct.step(std::max(0.035, 0.06 - 1e-4 * i));
  reference.state = direct.state;
  const StepReport a = direct.step(0.035), b = reference.step(0.035);
  EXPECT_GT(a.active, 0);
  EXPECT_EQ(a.contacts, b.contacts);
  EXPECT_LT((direct.state.v - reference.state.v).norm(), 1e-8 * (1e-3 + reference.state.v.norm()));
}

TEST(Stepper, sameInputSameBitsForAnyThreadCountAndAgain) {
  const auto hashOf = [](int threads, bool portable) {
    Session run(Profile::Direct, threads, portable);
    for (int i = 0; i < 300; ++i) run.step(std::max(0.03, 0.06 - 1e-4 * i));
    return toHex(stateHash(run.state));
  };
  const std::string once = hashOf(1, false);
  EXPECT_EQ(once, hashOf(1, false));
  EXPECT_EQ(once, hashOf(2, false));
  EXPECT_EQ(hashOf(1, true), hashOf(2, true));
}

TEST(Stepper, aStepIsAFunctionOfTheState) {
  Session first;
  for (int i = 0; i < 200; ++i) first.step(0.035);
  Session second;  // a stepper that has seen nothing continues from the same state
  second.state = first.state;
  first.step(0.035);
  second.step(0.035);
  EXPECT_EQ(toHex(stateHash(first.state)), toHex(stateHash(second.state)));
}

TEST(Stepper, aStateThatIsNotFiniteIsNotStepped) {
  Session run;
  run.step();
  State broken = run.state;
  broken.v[0] = NAN;
  const VecX before = broken.q;
  Inputs inputs;
  const StepReport& report = run.stepper.step(inputs, broken);
  EXPECT_FALSE(report.taken);
  EXPECT_EQ(broken.q, before);
  EXPECT_TRUE(isFinite(broken));
  EXPECT_TRUE(run.stepper.step(inputs, broken).taken) << "the run goes on";
}

TEST(Stepper, effectsThatAreOffDoNothing) {
  Scenario scenario = scenes::blockOnPlateScenario();
  scenario.effects.contact = Wish::Off;
  Session run(Profile::Direct, 1, false, scenario);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(run.step().contacts, 0);
  EXPECT_LT(run.state.q[run.model->objects[1].layout.qOffset + 1], -0.5) << "it falls through the plate";
  scenario.effects.gravity = Wish::Off;
  Session floating(Profile::Direct, 1, false, scenario);
  for (int i = 0; i < 100; ++i) floating.step();
  EXPECT_LT((floating.state.q - floating.model->start.q).norm(), 1e-9);
}

TEST(Stepper, paperReportsHowItWent) {
  Session run(Profile::Paper);
  for (int i = 0; i < 150; ++i) run.step(std::max(0.035, 0.06 - 2e-4 * i));
  const StepReport& report = run.step(0.035);
  ASSERT_TRUE(report.taken);
  EXPECT_GT(report.paper.cgIterations, 0);
  EXPECT_LE(report.paper.cgResidual, 1e-6);
  EXPECT_GT(report.paper.outerIterations, 0);
  EXPECT_GT(report.paper.lambdaMax, 0.9);
  EXPECT_TRUE(report.paper.d == "node" || report.paper.d == "object");
  EXPECT_TRUE(isFinite(run.state));
}

TEST(Stepper, aHandThatIsNoneIsReportedAndTheLastOneStands) {
  Session run, still;
  for (int i = 0; i < 5; ++i) run.step(), still.step();
  for (const double wrong : {std::nan(""), 1e30}) {
    const StepReport& report = run.step(wrong);
    EXPECT_TRUE(report.taken);
    EXPECT_EQ(report.refusedHands, 1);
    EXPECT_EQ(still.step().refusedHands, 0);
    EXPECT_EQ(toHex(stateHash(run.state)), toHex(stateHash(still.state)));
  }
}

TEST(Stepper, aHandThatJumpsIntoTheBlockDoesNotTakeTheToolThere) {
  for (const double dt : {1e-3, 5e-3, 2e-2}) {
    Scenario scenario = scenes::blockOnPlateScenario();
    scenario.dt = dt;
    Session run(Profile::Direct, 1, false, scenario);
    run.step();
    double worst = 0;
    for (double t = 0; t < 0.2; t += dt) {
      ASSERT_TRUE(run.step(0.02).taken);
      worst = std::max(worst, run.penetration());
    }
    // Half a millimetre: the face that a tip presses in bends within the step; without the look along the motion the
    // tip ends 15 mm inside at 20 ms.
    EXPECT_LT(worst, 5e-4) << dt;
  }
}

/// Figure 4's chain thrown with a spin of 60 rad/s.
State thrown(const Model& model) {
  State state = model.start;
  const Vec3 omega(0, 0, 60);
  for (const SceneObject& object : model.objects) {
    const ObjectLayout& layout = object.layout;
    if (layout.rigid) state.v.segment<3>(layout.vOffset + 3) = omega;
    for (int node = 0; node < (layout.rigid ? 1 : layout.nodeCount); ++node)
      state.v.segment<3>(layout.vOffset + 3 * node) = omega.cross(Vec3(state.q.segment<3>(layout.qOffset + 3 * node)));
  }
  return state;
}

TEST(Stepper, aStepThatTurnsTooFarIsCutAndSaysSo) {
  Scenario scenario;
  scenario.dt = 0.02;
  scenario.gravity_W.setZero();
  const auto model = compileModel(scenes::figure4Joint(), scenario).value();
  std::string hashes[2];
  for (const int threads : {1, 2}) {
    State state = thrown(*model);
    int parts = 0;
    double length = 0;
    StepperOptions options{Profile::Direct, threads};
    options.afterPart = [&](const State& part, double dt) {
      ++parts;
      length += dt;
      EXPECT_TRUE(isFinite(part));
    };
    Stepper stepper(model, options);
    const StepReport& report = stepper.step({}, state);
    EXPECT_GE(report.parts, 8) << "1.2 rad in parts of at most 0.15";
    EXPECT_EQ(report.parts, parts);
    EXPECT_NEAR(length, 0.02, 1e-15);
    EXPECT_EQ(state.step, 1);
    for (int i = 0; i < 20; ++i) stepper.step({}, state);
    hashes[threads - 1] = toHex(stateHash(state));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  Stepper calm(model, {});
  State rest = model->start;
  EXPECT_EQ(calm.step({}, rest).parts, 1);
}

}  // namespace
}  // namespace glenoid
