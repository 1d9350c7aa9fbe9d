// SPDX-License-Identifier: GPL-3.0-or-later
// What is read off a scene against closed forms and sums made here.
#include "simcore/reading/Readings.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <numbers>

#include "simcore/file/Schema.h"
#include "simcore/step/StepModel.h"
#include "tests/scenes/LadderScenes.h"

namespace glenoid {
namespace {

struct Played {
  std::shared_ptr<const Model> model;
  State state;
  std::vector<ContactView> contacts;

  explicit Played(const scenes::LadderScene& scene) : model(compileModel(scene.joint, scene.scenario).value()), state(model->start), m_stepper(model, {}) {}
  void steps(int count) {
    for (int i = 0; i < count; ++i) {
      const StepReport& report = m_stepper.step({}, state);
      ASSERT_TRUE(report.taken);
      contacts = report.contactViews;
    }
  }
  SceneReading read() const { return readScene(*model, state, contacts); }

 private:
  Stepper m_stepper;
};

scenes::LadderScene blocks() {
  scenes::LadderScene scene;
  scene.joint.id = scene.joint.name = scene.scenario.id = scene.scenario.name = "readings";
  scenes::addMaterials(scene.joint);
  return scene;
}

Mat3 boxInertia(double mass, const Vec3& size) {
  const Vec3 squares = size.cwiseAbs2();
  return mass / 12 * Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y()).asDiagonal();
}

TEST(Readings, aRigidBoxHasTheMassCentreAndInertiaOfABoxHoweverItIsTurned) {
  scenes::LadderScene scene = blocks();
  const Vec3 low(0.1, 0.2, -0.3), size(0.02, 0.05, 0.03);
  scene.joint.parts = {scenes::boxPart("box", 1, PartKind::Rigid, low, low + size)};
  Played run(scene);
  const double mass = 2000 * size.prod();
  const Quat turn(Eigen::AngleAxisd(0.8, Vec3(1, -2, 0.5).normalized()));
  setPoseAt(run.state.q, 0, {Vec3(1, 2, 3), turn});
  const Vec3 velocity(0.3, -0.1, 0.2), omega(4, -1, 2);
  run.state.v << velocity, omega;
  const PartReading box = readPart(*run.model, run.state, 0);
  // Sums of a few numbers of the inertia's size: round-off.
  const Mat3 R = turn.toRotationMatrix(), inertia = R * boxInertia(mass, size) * R.transpose();
  EXPECT_NEAR(box.mass, mass, 1e-13 * mass);
  EXPECT_EQ(box.centre_W, Vec3(1, 2, 3));
  EXPECT_LT((box.inertia_W - inertia).norm(), 1e-10 * inertia.norm());
  EXPECT_LT((box.velocity_W - velocity).norm(), 1e-14);
  EXPECT_LT((box.angularVelocity_W - omega).norm(), 1e-9);
  EXPECT_LT(box.q_WB.angularDistance(turn), 1e-14);
}

TEST(Readings, aSoftPartThatMovesAsOneIsReadLikeARigidBodyOfItsNodes) {
  scenes::LadderScene scene = blocks();
  scene.joint.parts = {scenes::boxPart("cube", 1, PartKind::Soft, Vec3(0.1, 0, 0), Vec3(0.14, 0.02, 0.03), 3)};
  Played run(scene);
  const ObjectLayout& layout = run.model->objects[0].layout;
  const std::vector<Vec3>& rest = run.model->objects[0].volume->nodes;
  const Quat turn(Eigen::AngleAxisd(2.5, Vec3(0.3, 1, -0.7).normalized()));
  const Vec3 shift(0.4, -0.2, 0.9), velocity(0.3, -0.1, 0.2), omega(4, -1, 2);
  for (int node = 0; node < layout.nodeCount; ++node) {
    const Vec3 x = turn * rest[node] + shift;
    run.state.q.segment<3>(3 * node) = x;
    run.state.v.segment<3>(3 * node) = velocity + omega.cross(x);
  }
  const PartReading cube = readPart(*run.model, run.state, 0);
  EXPECT_NEAR(cube.mass, 1000 * 0.04 * 0.02 * 0.03, 1e-13);
  // Bricks of five tetrahedra are symmetric in the mass about the middle in each direction.
  EXPECT_LT((cube.centre_W - (turn * Vec3(0.12, 0.01, 0.015) + shift)).norm(), 1e-3 * 0.02);
  EXPECT_LT((cube.velocity_W - (velocity + omega.cross(cube.centre_W))).norm(), 1e-12);
  EXPECT_LT((cube.angularVelocity_W - omega).norm(), 1e-9);
  EXPECT_LT(cube.q_WB.angularDistance(turn), 1e-7);  // acos of nearly one
  // The energy of the same motion, which the object sums over its own mass, is that of the rigid body that was read.
  const double energy = run.model->inside->objects[0]->kineticEnergy(run.state);
  EXPECT_NEAR(0.5 * cube.mass * cube.velocity_W.squaredNorm() + 0.5 * omega.dot(cube.inertia_W * omega), energy, 1e-11 * energy);
  ASSERT_EQ(cube.nodes_W.size(), rest.size());
  EXPECT_EQ(cube.nodes_W[5], run.state.q.segment<3>(15));
}

TEST(Readings, freeFallIsReadBack) {
  // Backward Euler: v = n Δt g, way = n (n + 1)/2 Δt² g.
  Played run(scenes::twoFallingBoxes());
  const SceneReading start = run.read();
  const int n = 100;
  run.steps(n);
  const SceneReading end = run.read();
  const double dt = run.model->scenario.dt;
  const Vec3 g = run.model->scenario.gravity_W;
  EXPECT_EQ(end.step, n);
  EXPECT_DOUBLE_EQ(end.time, n * dt);
  for (const int part : {0, 1}) {
    EXPECT_LT((end.parts[part].velocity_W - n * dt * g).norm(), 1e-11);
    EXPECT_LT((end.parts[part].centre_W - start.parts[part].centre_W - 0.5 * n * (n + 1) * dt * dt * g).norm(), 1e-11);
    EXPECT_LT(end.parts[part].angularVelocity_W.norm(), 1e-9);
  }
}

TEST(Readings, aPendulumSwingsWithItsPeriod) {
  // A box that hangs from the origin by a hold of its place alone, and rests 2° off the vertical of a gravity that leans:
  // it swings by ±2° with ω² = m g d / (I + m d²). A quarter period ahead it passes the vertical, at half it turns back.
  scenes::LadderScene scene = blocks();
  const double d = 0.1, lean = 2 * std::numbers::pi / 180;
  const Vec3 size(0.02, 0.04, 0.02);
  scene.joint.parts = {scenes::boxPart("bob", 1, PartKind::Rigid, Vec3(-0.01, -d - 0.02, -0.01), Vec3(0.01, -d + 0.02, 0.01))};
  scene.scenario.gravity_W = 9.81 * Vec3(std::sin(lean), -std::cos(lean), 0);
  scene.scenario.holds = {{"bob", 1e7, 0, 1e-3}};
  scene.scenario.dt = 2.5e-4;
  const double mass = 2000 * size.prod(), inertia = boxInertia(mass, size)(2, 2) + mass * d * d, omega = std::sqrt(mass * 9.81 * d / inertia);
  Played run(scene);
  const auto angle = [&] {
    const Vec3 c = run.read().parts[0].centre_W;
    return std::atan2(c.x(), -c.y()) - lean;  // from the vertical
  };
  double worst = 0;
  const int quarter = static_cast<int>(std::lround(0.5 * std::numbers::pi / omega / 2.5e-4));
  for (int k = 1; k <= 4; ++k) {
    run.steps(quarter);
    worst = std::max(worst, std::abs(angle() + lean * std::cos(omega * run.state.time)));
    const PartReading bob = run.read().parts[0];
    // It turns as it swings: the centre's velocity is ω × lever about the origin, to what 10 MN/m give under 0.3 N.
    EXPECT_LT((bob.velocity_W - bob.angularVelocity_W.cross(bob.centre_W)).norm(), 1e-4);
    EXPECT_NEAR(bob.angularVelocity_W.z(), lean * omega * std::sin(omega * run.state.time), 0.02 * lean * omega);
  }
  // Backward Euler damps by ω²Δt/2 = 1.2e-2 1/s over 0.63 s, and lags by as much of Δt: below 1 % of the swing.
  EXPECT_LT(worst, 0.015 * lean);
  const SceneReading end = run.read();
  ASSERT_EQ(end.holds.size(), 1u);
  EXPECT_EQ(end.holds[0].part, "bob");
  EXPECT_EQ(end.holds[0].onPart.torque_W, Vec3::Zero());  // it holds no orientation
  // The pivot bears the weight and ω² d; at the turning point (a whole period) only the weight along the string.
  EXPECT_NEAR(end.holds[0].onPart.force_W.norm(), mass * 9.81, 0.01 * mass * 9.81);
}

TEST(Readings, contactForcesOfABlockAtRestAddUpToItsWeight) {
  scenes::LadderScene scene = blocks();
  scene.joint.parts = {scenes::boxPart("plate", 1, PartKind::Rigid, Vec3(-0.05, -0.01, -0.05), Vec3(0.05, 0, 0.05)),
                       scenes::boxPart("block", 2, PartKind::Rigid, Vec3(-0.012, 0, -0.017), Vec3(0.023, 0.03, 0.011))};
  scene.scenario.fixedParts = {"plate"};
  Played run(scene);
  run.steps(200);
  const SceneReading end = run.read();
  const Vec3 c = end.parts[1].centre_W;
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  for (const ContactReading& contact : end.contacts) {
    EXPECT_NE(contact.a, contact.b);
    const Vec3 onA = contact.force * contact.normal_W + contact.friction_W, onBlock = contact.a == "block" ? onA : Vec3(-onA);
    force += onBlock;
    torque += (contact.point_W - c).cross(onBlock);
  }
  const double weight = end.parts[1].mass * 9.81;
  // It rests to the millionth of g that the step leaves, and the sum has to carry it about its centre as well.
  EXPECT_LT((force - weight * Vec3::UnitY()).norm(), 1e-5 * weight);
  EXPECT_LT(torque.norm(), 1e-5 * weight * 0.03);
}

TEST(Readings, aCouplingBearsWhatHangsOnItWithItsTorque) {
  // A box hangs on a fixed one by a face that is not above its centre: the coupling pulls with the weight, and about the
  // region's centroid it turns against the weight's lever.
  scenes::LadderScene scene = blocks();
  scene.joint.parts = {scenes::boxPart("top", 1, PartKind::Rigid, Vec3(-0.02, 0, -0.02), Vec3(0.02, 0.02, 0.02)),
                       scenes::boxPart("hung", 2, PartKind::Rigid, Vec3(-0.02, -0.05, -0.02), Vec3(0.08, 0, 0.04))};
  Part& hung = scene.joint.parts[1];
  hung.regions.push_back(scenes::regionIn(hung, "face", Box3(Vec3(-0.021, -1e-6, -0.021), Vec3(0.03, 1e-6, 0.011))));
  scene.joint.couplings = {{"glue", "hung", "top", "face", 1e9, 1e-2}};
  scene.joint.exclusions = {{"top", "hung", "glued"}};
  scene.scenario.fixedParts = {"top"};
  Played run(scene);
  run.steps(2000);
  const SceneReading end = run.read();
  ASSERT_EQ(end.couplings.size(), 1u);
  const CouplingReading& glue = end.couplings[0];
  EXPECT_EQ(glue.id, "glue");
  EXPECT_EQ(glue.a, "hung");
  EXPECT_EQ(glue.b, "top");
  const Vec3 weight = end.parts[1].mass * Vec3(0, -9.81, 0), lever = end.parts[1].centre_W - glue.onA.point_W;
  ASSERT_GT(lever.cross(weight).norm(), 1e-3);
  // At rest to what 2000 damped steps leave.
  EXPECT_LT((glue.onA.force_W + weight).norm(), 1e-8 * weight.norm());
  EXPECT_LT((glue.onA.torque_W + lever.cross(weight)).norm(), 1e-8 * lever.norm() * weight.norm());
  // And the point is the middle of what the region's squares cover: x in [−20, 30) by halves of 25 mm, z by 15 mm.
  EXPECT_LT((glue.onA.point_W - Vec3(0.005, 0, -0.005)).norm(), 5e-3);
}

TEST(Readings, theDocumentFitsItsSchemaAndKeepsEveryDigit) {
  scenes::LadderScene scene{scenes::figure4Joint(), scenes::figure4Scenario()};
  scene.scenario.loads = {{"right", Vec3(0, -1, 0), Vec3::Zero(), Vec3(0.05, 0.01, 0.01)}};
  Played run(scene);
  run.steps(20);
  const SceneReading reading = run.read();
  const JsonValue json = toJson(reading, "a.scenario.json");
  const auto valid = validate(json, Schema::RunState, "state");
  EXPECT_TRUE(valid.ok()) << toLogLine(valid.error());
  const auto back = parseJson(toText(json), "state");
  ASSERT_TRUE(back.ok());
  EXPECT_EQ((*back)["parts"].items().size(), 3u);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ((*back)["parts"][1]["centre"][axis].number(), reading.parts[1].centre_W[axis]);
    EXPECT_EQ((*back)["couplings"][1]["torque"][axis].number(), reading.couplings[1].onA.torque_W[axis]);
    EXPECT_EQ((*back)["parts"][1]["nodes"][7][axis].number(), reading.parts[1].nodes_W[7][axis]);
  }
  EXPECT_EQ((*back)["loads"][0]["part"].text(), "right");
}

}  // namespace
}  // namespace glenoid
