// SPDX-License-Identifier: GPL-3.0-or-later
// Fixed parts that move as prescribed: what lies on them, hangs on them or is hit by them, against closed forms.
#include <gtest/gtest.h>

#include <numbers>

#include "simcore/reading/Readings.h"
#include "tests/scenes/LadderScenes.h"

namespace glenoid {
namespace {

/// A wide fixed plate with its top at y = 0 and a rigid block of 30 × 20 × 25 mm on it.
scenes::LadderScene blockOnPlate(double friction) {
  scenes::LadderScene scene;
  scene.joint.id = scene.joint.name = scene.scenario.id = scene.scenario.name = "driven";
  scenes::addMaterials(scene.joint);
  scene.joint.materials[0].friction = friction;
  scene.joint.parts = {scenes::boxPart("plate", 1, PartKind::Rigid, Vec3(-0.3, -0.02, -0.3), Vec3(0.3, 0, 0.3)),
                       scenes::boxPart("block", 2, PartKind::Rigid, Vec3(-0.013, 0, -0.011), Vec3(0.017, 0.02, 0.014))};
  // One square on each face of the plate, as wide as it is: the block stays away from its edges.
  scene.joint.parts[0].visual = scene.joint.parts[0].collision =
      std::make_shared<TriMesh>(scenes::boxSurface(Vec3(-0.3, -0.02, -0.3), Vec3(0.3, 0, 0.3), 1));
  scene.scenario.fixedParts = {"plate"};
  scene.scenario.dt = 1e-3;
  return scene;
}

struct Played {
  std::shared_ptr<const Model> model;
  State state;
  std::vector<ContactView> contacts;
  explicit Played(const scenes::LadderScene& scene) {
    const auto compiled = compileModel(scene.joint, scene.scenario);
    EXPECT_TRUE(compiled.ok()) << toLogLine(compiled.error());
    model = *compiled;
    state = model->start;
    m_stepper = std::make_unique<Stepper>(model, StepperOptions{});
  }
  void until(double time) {
    while (state.time < time - 1e-9) {
      const StepReport& report = m_stepper->step({}, state);
      ASSERT_TRUE(report.taken);
      contacts = report.contactViews;
    }
  }
  PartReading part(int object) const { return readPart(*model, state, object); }
  Vec3 forceOn(int object) const {
    Vec3 force = Vec3::Zero();
    for (const ContactView& view : contacts) {
      const Vec3 onA = view.force * view.normal_W + view.friction_W;
      if (view.objectA == object) force += onA;
      if (view.objectB == object) force -= onA;
    }
    return force;
  }

 private:
  std::unique_ptr<Stepper> m_stepper;
};

Motion steady(const std::string& part, const Vec3& velocity, double from, double to) {
  return {part, Vec3::Zero(), {{from, Vec3::Zero(), Quat::Identity()}, {to, (to - from) * velocity, Quat::Identity()}}};
}

TEST(Driven, aPlateIsWhereItsKeysSayAndItsVelocityIsRead) {
  scenes::LadderScene scene = blockOnPlate(0.3);
  const Vec3 pivot(0.1, 0, 0.05), axis = Vec3::UnitY();
  const Quat turned(Eigen::AngleAxisd(1.0, axis));
  scene.scenario.motions = {{"plate", pivot, {{0, Vec3::Zero(), Quat::Identity()}, {2, Vec3(0, 0, 0.1), turned}}}};
  Played run(scene);
  run.until(0.5);
  const PartReading plate = run.part(0);
  EXPECT_TRUE(plate.fixed);
  const Quat quarter(Eigen::AngleAxisd(0.25, axis));
  const Vec3 centre(0, -0.01, 0);
  const Vec3 expected = pivot + Vec3(0, 0, 0.025) + quarter * (centre - pivot);
  EXPECT_LT((plate.centre_W - expected).norm(), 1e-14);
  EXPECT_LT(plate.q_WB.angularDistance(quarter), 1e-12);
  EXPECT_LT((plate.angularVelocity_W - 0.5 * axis).norm(), 1e-9);
  // Over the last step the centre went along the arc's chord.
  const Vec3 velocity = Vec3(0, 0, 0.05) + 0.5 * axis.cross(quarter * (centre - pivot));
  EXPECT_LT((plate.velocity_W - velocity).norm(), 1e-3 * velocity.norm());
}

TEST(Driven, aPlateThatSetsOffDragsABlockByFriction) {
  // From rest at 0.1 s the plate runs with V: the block gains µ g until it has V, then rides along without slip.
  const double mu = 0.3, V = 0.2, g = 9.81, begin = 0.1;
  scenes::LadderScene scene = blockOnPlate(mu);
  scene.scenario.motions = {steady("plate", Vec3(V, 0, 0), begin, 1.1)};
  Played run(scene);
  run.until(begin);
  const double start = run.part(1).centre_W.x();
  run.until(begin + 0.03);
  EXPECT_NEAR(run.part(1).velocity_W.x(), mu * g * 0.03, 0.02 * V);
  EXPECT_NEAR(run.forceOn(1).x(), mu * run.part(1).mass * g, 0.01 * mu * run.part(1).mass * g);
  run.until(begin + 0.5);
  const PartReading block = run.part(1);
  EXPECT_NEAR(block.velocity_W.x(), V, 1e-6);
  // V t − V²/(2 µ g): what it lost by slipping. Backward Euler has it ahead by V Δt/2.
  EXPECT_NEAR(block.centre_W.x() - start, V * 0.5 - V * V / (2 * mu * g), V * scene.scenario.dt);
  EXPECT_LT(run.forceOn(1).head<1>().norm(), 1e-3 * block.mass * g) << "nothing drags what rides along";
}

TEST(Driven, aRisingPlateLiftsABlockWithItsWeightAlone) {
  const double V = 0.15;
  scenes::LadderScene scene = blockOnPlate(0.3);
  scene.scenario.motions = {steady("plate", Vec3(0, V, 0), 0.1, 1.1)};
  Played run(scene);
  run.until(0.1);
  const double above = run.part(1).centre_W.y();
  run.until(0.6);
  const PartReading block = run.part(1);
  EXPECT_NEAR(block.velocity_W.y(), V, 1e-6);
  EXPECT_NEAR(block.centre_W.y() - above, V * 0.5, 1e-5);  // neither pressed in nor thrown
  EXPECT_NEAR(run.forceOn(1).y(), block.mass * 9.81, 1e-3 * block.mass * 9.81);
  EXPECT_LT(block.angularVelocity_W.norm(), 1e-4);
}

TEST(Driven, aPlateThatTurnsCarriesABlockRound) {
  // Slow enough for friction to hold it on its circle: ω² r = 0.16 m/s² below µ g.
  const double omega = 2, r = 0.04;
  scenes::LadderScene scene = blockOnPlate(0.5);
  const Vec3 pivot(0.002 - r, 0, 0.0015);  // under the block's centre, r to the side
  Motion motion{"plate", pivot, {}};
  for (int k = 0; k <= 20; ++k)  // turns of a tenth of a radian: slerp between keys is the turn itself
    motion.keys.push_back({0.05 * k, Vec3::Zero(), Quat(Eigen::AngleAxisd(omega * 0.05 * k, Vec3::UnitY()))});
  scene.scenario.motions = {motion};
  Played run(scene);
  run.until(0.8);
  const PartReading block = run.part(1);
  const Vec3 arm = block.centre_W - pivot;
  EXPECT_NEAR(std::hypot(arm.x(), arm.z()), r, 0.02 * r);
  EXPECT_NEAR(std::atan2(-arm.z(), arm.x()), omega * 0.8, 0.05);  // it slipped a little while it was set going
  EXPECT_NEAR(block.angularVelocity_W.y(), omega, 0.02 * omega);
  const Vec3 force = run.forceOn(1);
  const Vec3 inwards = -Vec3(arm.x(), 0, arm.z()).normalized();
  EXPECT_NEAR(force.dot(inwards), block.mass * omega * omega * r, 0.05 * block.mass * omega * omega * r);
}

TEST(Driven, whatHangsOnAMovingPartFollowsWithoutDrag) {
  // A box glued under a fixed one that runs steadily: after the start the springs carry the weight and nothing else.
  scenes::LadderScene scene;
  scene.joint.id = scene.joint.name = scene.scenario.id = scene.scenario.name = "tow";
  scenes::addMaterials(scene.joint);
  scene.joint.parts = {scenes::boxPart("carriage", 1, PartKind::Rigid, Vec3(-0.02, 0, -0.02), Vec3(0.02, 0.02, 0.02)),
                       scenes::boxPart("load", 2, PartKind::Rigid, Vec3(-0.02, -0.04, -0.02), Vec3(0.02, 0, 0.02))};
  Part& load = scene.joint.parts[1];
  load.regions.push_back(scenes::regionIn(load, "face", Box3(Vec3(-1, -1e-6, -1), Vec3(1, 1e-6, 1))));
  scene.joint.couplings = {{"glue", "load", "carriage", "face", 1e7, 1e-2}};
  scene.joint.exclusions = {{"carriage", "load", "glued"}};
  scene.scenario.fixedParts = {"carriage"};
  scene.scenario.dt = 2e-3;
  const Vec3 V(0.3, 0, 0.1);
  scene.scenario.motions = {steady("carriage", V, 0, 3)};
  Played run(scene);
  run.until(2.9);
  const PartReading box = run.part(1);
  EXPECT_LT((box.velocity_W - V).norm(), 1e-6);
  const std::vector<CouplingReading> couplings = readCouplings(*run.model, run.state);
  EXPECT_LT((couplings.at(0).onA.force_W - box.mass * 9.81 * Vec3::UnitY()).norm(), 1e-5 * box.mass * 9.81);
  // And it hangs there as it would under a carriage that stands.
  scene.scenario.motions = {};
  Played still(scene);
  still.until(2.9);
  EXPECT_LT((box.centre_W - V * run.state.time - still.part(1).centre_W).norm(), 1e-7);
  EXPECT_LT(box.q_WB.angularDistance(still.part(1).q_WB), 1e-5);
}

TEST(Driven, aMotionThatBeginsElsewhereStartsThere) {
  scenes::LadderScene scene = blockOnPlate(0.3);
  scene.scenario.motions = {{"plate", Vec3::Zero(), {{0.5, Vec3(0, -0.1, 0), Quat::Identity()}}}};
  const auto model = compileModel(scene.joint, scene.scenario).value();
  EXPECT_EQ(model->start.q[1], -0.11);
  EXPECT_EQ(model->objects[0].motion, 0);
  EXPECT_EQ(model->objects[1].motion, -1);
}

TEST(Driven, aSoftFixedPartMovesAsAWhole) {
  scenes::LadderScene scene = blockOnPlate(0.3);
  scene.joint.parts[0] = scenes::boxPart("plate", 1, PartKind::Soft, Vec3(-0.1, -0.02, -0.1), Vec3(0.1, 0, 0.1), 2);
  const double V = 0.15;
  scene.scenario.motions = {steady("plate", Vec3(0, V, 0), 0.1, 1.1)};
  Played run(scene);
  run.until(0.4);
  EXPECT_NEAR(run.part(0).velocity_W.y(), V, 1e-9);
  EXPECT_NEAR(run.part(1).velocity_W.y(), V, 1e-3);
  EXPECT_NEAR(run.state.q[1] - run.model->start.q[1], 0.3 * V, 1e-12);
}

TEST(Driven, aMotionOfAFreePartIsRefused) {
  scenes::LadderScene scene = blockOnPlate(0.3);
  scene.scenario.motions = {steady("block", Vec3::UnitX(), 0, 1)};
  const auto model = compileModel(scene.joint, scene.scenario);
  ASSERT_FALSE(model.ok());
  EXPECT_EQ(model.error().fault, Fault::Unusable);
  EXPECT_EQ(model.error().place.pointer, "/motions/0");
}

}  // namespace
}  // namespace glenoid
