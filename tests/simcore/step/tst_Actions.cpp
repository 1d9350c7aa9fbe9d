// SPDX-License-Identifier: GPL-3.0-or-later
// Loads, pressures, supports and holds against what statics and the momentum of a body say.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "simcore/body/RigidObject.h"
#include "simcore/reading/Readings.h"
#include "simcore/step/Actions.h"
#include "tests/scenes/LadderScenes.h"

namespace glenoid {
namespace {

/// A rigid box of 40 × 20 × 30 mm off the origin, and a soft cube, both free in space without weight.
scenes::LadderScene twoBodies() {
  scenes::LadderScene scene;
  scene.joint.id = scene.joint.name = scene.scenario.id = scene.scenario.name = "actions";
  scenes::addMaterials(scene.joint);
  scene.joint.parts = {scenes::boxPart("bone", 1, PartKind::Rigid, Vec3(0.1, 0.2, -0.3), Vec3(0.14, 0.22, -0.27)),
                       scenes::boxPart("cube", 2, PartKind::Soft, Vec3(-0.02, 0, 0), Vec3(0.01, 0.03, 0.03), 3)};
  Part& bone = scene.joint.parts[0];
  bone.regions = {scenes::regionIn(bone, "top", Box3(Vec3(-1, 0.22 - 1e-6, -1), Vec3(1, 0.22 + 1e-6, 1)))};
  scene.scenario.gravity_W.setZero();
  return scene;
}

struct Steps {
  std::shared_ptr<const Model> model;
  State state;
  explicit Steps(const scenes::LadderScene& scene, int count, const StepperOptions& options = {}) {
    const auto compiled = compileModel(scene.joint, scene.scenario);
    EXPECT_TRUE(compiled.ok()) << toLogLine(compiled.error());
    model = *compiled;
    state = model->start;
    Stepper stepper(model, options);
    for (int i = 0; i < count; ++i) EXPECT_TRUE(stepper.step({}, state).taken);
  }
  PartReading part(int object) const { return readPart(*model, state, object); }
};

TEST(Loads, aForceAtAPointOfARigidPartPushesAndTurnsIt) {
  scenes::LadderScene scene = twoBodies();
  const Vec3 force(3, -4, 1), point(0.14, 0.21, -0.3);
  scene.scenario.loads = {{"bone", force, Vec3::Zero(), point}};
  const Steps one(scene, 1);
  const PartReading start = readPart(*one.model, one.model->start, 0), end = one.part(0);
  const double dt = scene.scenario.dt;
  EXPECT_LT((end.velocity_W - dt / start.mass * force).norm(), 1e-12);
  const Vec3 turned = start.inertia_W.ldlt().solve(dt * (point - start.centre_W).cross(force));
  EXPECT_LT((end.inertia_W * end.angularVelocity_W - start.inertia_W * turned).norm(), 1e-12 * start.inertia_W.norm() * turned.norm());
}

TEST(Loads, severalLoadsOnOnePartAddUp) {
  // A couple: two forces against each other at two points of the part, beside a torque that undoes them.
  scenes::LadderScene scene = twoBodies();
  const Vec3 force(0, 0.5, 0.2), a(0.1, 0.2, -0.28), b(0.14, 0.21, -0.3);
  scene.scenario.loads = {{"bone", force, Vec3::Zero(), a}, {"bone", -force, Vec3::Zero(), b}, {"bone", Vec3::Zero(), (b - a).cross(force), {}}};
  const Steps one(scene, 1);
  EXPECT_LT(one.part(0).velocity_W.norm(), 1e-15);
  EXPECT_LT(one.part(0).angularVelocity_W.norm(), 1e-10);
}

TEST(Loads, whatRisesGivesTheMomentumOfItsRise) {
  // Free of everything else: m v = F ∑ Δt min(1, t_n / T), the sum over steps; half of F T after the rise, up to Δt.
  scenes::LadderScene scene = twoBodies();
  const Vec3 force(3, -4, 1);
  scene.scenario.loads = {{"bone", force}};
  const double dt = scene.scenario.dt, rise = 10 * dt;
  scene.scenario.loadRise = rise;
  for (const int count : {4, 10, 25}) {
    double impulse = 0;
    for (int n = 1; n <= count; ++n) impulse += dt * std::min(1.0, n * dt / rise);
    const Steps run(scene, count);
    EXPECT_LT((run.part(0).mass * run.part(0).velocity_W - impulse * force).norm(), 1e-12) << count;
    const SceneReading reading = readScene(*run.model, run.state, {});
    EXPECT_LT((reading.loads[0].onPart.force_W - std::min(1.0, count * dt / rise) * force).norm(), 1e-12);
  }
}

TEST(Loads, aForceAtAPointOfASoftPartGivesItsMomentumAndItsMoment) {
  scenes::LadderScene scene = twoBodies();
  const Vec3 force(0.02, -0.01, 0.03), point(-0.013, 0.011, 0.022);
  scene.scenario.loads = {{"cube", force, Vec3::Zero(), point}};
  const Steps one(scene, 1);
  const Vec6 momentum = one.model->inside->objects[1]->momentum(one.state);
  const double dt = scene.scenario.dt;
  // The internal forces add nothing; the positions that the angular one is taken about moved by Δt v in the step.
  EXPECT_LT((momentum.head<3>() - dt * force).norm(), 1e-12 * dt * force.norm());
  EXPECT_LT((momentum.tail<3>() - dt * point.cross(force)).norm(), 1e-2 * dt * point.norm() * force.norm());
  EXPECT_GT((one.state.v.segment<3>(6) - one.state.v.segment<3>(9)).norm(), 1e-9);  // it acts at a place, not everywhere
}

TEST(Loads, aForceWithoutAPointIsSpreadOverTissueAsWeightIs) {
  scenes::LadderScene scene = twoBodies();
  const Vec3 force(0.2, -0.1, 0.3);
  scene.scenario.loads = {{"cube", force, Vec3::Zero(), {}}};
  const int n = 20;
  const Steps many(scene, n);
  const Vec3 v = n * scene.scenario.dt / many.model->objects[1].mass * force;
  const ObjectLayout& layout = many.model->objects[1].layout;
  for (int node = 0; node < layout.nodeCount; ++node)
    EXPECT_LT((many.state.v.segment<3>(layout.vOffset + 3 * node) - v).norm(), 1e-9 * v.norm());
}

TEST(Loads, whatCannotBeTakenIsRefused) {
  const auto faultOf = [](const Load& load) {
    scenes::LadderScene scene = twoBodies();
    scene.scenario.loads = {load};
    const auto model = compileModel(scene.joint, scene.scenario);
    EXPECT_FALSE(model.ok());
    return model.ok() ? Error{} : model.error();
  };
  const Error outside = faultOf({"cube", Vec3::UnitX(), Vec3::Zero(), Vec3(0.02, 0.01, 0.01)});
  EXPECT_EQ(outside.fault, Fault::Unusable);
  EXPECT_EQ(outside.place.pointer, "/loads/0");
  EXPECT_EQ(outside.place.part, "cube");
  EXPECT_EQ(faultOf({"cube", Vec3::Zero(), Vec3::UnitX(), {}}).fault, Fault::Unusable);
  EXPECT_EQ(faultOf({"nobody", Vec3::UnitX(), Vec3::Zero(), {}}).fault, Fault::UnknownId);
}

TEST(Holds, withoutStiffnessOnlyTheOrientationIsHeld) {
  scenes::LadderScene scene = twoBodies();
  const double kTheta = 5;
  const Vec3 force(0.01, -0.02, 0.005), torque(0.2, 0.1, -0.3);
  const Vec3 centre(0.12, 0.21, -0.285);
  scene.scenario.holds = {{"bone", 0, kTheta, 0.05}};
  scene.scenario.loads = {{"bone", force, torque, centre}};
  const int n = 4000;
  const Steps many(scene, n);
  const PartReading bone = many.part(0);
  const double dt = scene.scenario.dt;
  EXPECT_LT((bone.centre_W - centre - 0.5 * n * (n + 1.0) * dt * dt / bone.mass * force).norm(), 1e-9) << "it flies freely";
  const Eigen::AngleAxisd turn(bone.q_WB);
  EXPECT_LT((turn.angle() * turn.axis() - torque / kTheta).norm(), 1e-9) << "and turns by torque over stiffness";
  const SceneReading reading = readScene(*many.model, many.state, {});
  EXPECT_LT(reading.holds[0].onPart.force_W.norm(), 1e-15);
  EXPECT_LT((reading.holds[0].onPart.torque_W + torque).norm(), 1e-8);
}

TEST(Holds, axesThatAreLeftFreeAreFree) {
  scenes::LadderScene scene = twoBodies();
  const double k = 2e3;
  scene.scenario.holds = {{"bone", k, 50, 0.05, {true, false, true}, {}}};
  const Vec3 centre(0.12, 0.21, -0.285), force(1, 0.01, -2);
  scene.scenario.loads = {{"bone", force, Vec3::Zero(), Vec3::Zero()}};  // at the hold's own point
  const int n = 2000;
  const Steps many(scene, n);
  const auto& body = static_cast<const RigidObject&>(*many.model->inside->objects[0]);
  const Vec3 held = body.pose(many.state.q) * Vec3(-centre);
  const double dt = scene.scenario.dt;
  EXPECT_NEAR(held.x(), force.x() / k, 1e-6);
  EXPECT_NEAR(held.z(), force.z() / k, 1e-6);
  // Along y the whole body goes as its mass says.
  EXPECT_NEAR(many.part(0).velocity_W.y(), n * dt * force.y() / many.part(0).mass, 1e-3 * n * dt * force.y() / many.part(0).mass);
}

TEST(Holds, aTurnAboutAnAxisThatIsLeftFreeIsThatOfAHinge) {
  // Held at the origin of W in every direction and free to turn about z there: I + m d² about the hinge.
  scenes::LadderScene scene = twoBodies();
  scene.scenario.dt = 1e-3;
  scene.scenario.holds = {{"bone", 1e7, 500, 0.01, {}, {true, true, false}}};
  scene.scenario.loads = {{"bone", Vec3::Zero(), Vec3(0, 0, 0.01), {}}};
  const Steps many(scene, 100);
  const PartReading start = readPart(*many.model, many.model->start, 0), bone = many.part(0);
  const double inertia = start.inertia_W(2, 2) + start.mass * start.centre_W.head<2>().squaredNorm();
  EXPECT_NEAR(bone.angularVelocity_W.z(), 0.1 * 0.01 / inertia, 0.01 * 0.1 * 0.01 / inertia);
  EXPECT_LT(bone.angularVelocity_W.head<2>().norm(), 0.01 * bone.angularVelocity_W.z());
}

TEST(Pressures, onARegionOfARigidPartTheForceIsPressureTimesArea) {
  scenes::LadderScene scene = twoBodies();
  const double pressure = 800, area = 0.04 * 0.03;
  scene.scenario.pressures = {{"bone", "top", pressure}};
  const Steps one(scene, 1);
  const PartReading bone = one.part(0);
  EXPECT_LT((bone.velocity_W - scene.scenario.dt / bone.mass * Vec3(0, -pressure * area, 0)).norm(), 1e-12);
  EXPECT_LT(bone.angularVelocity_W.norm(), 1e-8);  // the middle of the top is above the centre
  const SceneReading reading = readScene(*one.model, one.model->start, {});
  ASSERT_EQ(reading.pressures.size(), 1u);
  EXPECT_LT((reading.pressures[0].onPart.force_W - Vec3(0, -pressure * area, 0)).norm(), 1e-12);
  EXPECT_LT((reading.pressures[0].onPart.point_W - Vec3(0.12, 0.22, -0.285)).norm(), 1e-12);
  EXPECT_LT(reading.pressures[0].onPart.torque_W.norm(), 1e-12);
}

TEST(Pressures, aCoarseSurfaceLoadsFineCellsEvenly) {
  // Two triangles over a face of 6 × 6 cells: the nodes inside the face get their share, and the moments are exact.
  scenes::LadderScene scene = twoBodies();
  Part cube = scenes::boxPart("cube", 2, PartKind::Soft, Vec3::Zero(), Vec3(0.06, 0.06, 0.06), 6);
  cube.visual = cube.collision = std::make_shared<TriMesh>(scenes::boxSurface(Vec3::Zero(), Vec3(0.06, 0.06, 0.06), 1));
  cube.regions = {scenes::regionIn(cube, "top", Box3(Vec3(-1, 0.06 - 1e-6, -1), Vec3(1, 0.06 + 1e-6, 1)))};
  scene.joint.parts = {cube};
  scene.scenario.pressures = {{"cube", "top", 100}};
  const auto model = compileModel(scene.joint, scene.scenario).value();
  const BoundPressure& bound = model->inside->islands[0].pressures.at(0);
  VecX b = VecX::Zero(model->start.v.size());
  std::vector<Vec3> scratch(2 * bound.points.size());
  assemblePressure(bound, *model->inside->objects[0], 1, model->start.q, scratch, b);
  Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
  const TetMesh& mesh = *model->objects[0].volume;
  double least = 1e300;
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    const Vec3 f = b.segment<3>(3 * static_cast<int>(node)), x = mesh.nodes[node];
    sum += f;
    moment += x.cross(f);
    const bool inner = x.y() > 0.06 - 1e-9 && x.x() > 1e-9 && x.x() < 0.06 - 1e-9 && x.z() > 1e-9 && x.z() < 0.06 - 1e-9;
    if (inner) least = std::min(least, -f.y());
  }
  const double whole = 100 * 0.06 * 0.06;
  EXPECT_LT((sum + whole * Vec3::UnitY()).norm(), 1e-12 * whole);
  EXPECT_LT((moment - Vec3(0.03, 0.06, 0.03).cross(sum)).norm(), 1e-12 * whole);
  // An inner node of the bricks' faces carries four to eight triangles: two thirds to four thirds of a square.
  EXPECT_GT(least, 0.5 * whole / 36);
}

TEST(Supports, aBedBearsARigidBoxByItsStiffnessAndARollerLeavesItItsWay) {
  scenes::LadderScene scene = twoBodies();
  const double perArea = 1e7, area = 0.04 * 0.03;
  scene.scenario.supports = {{"bone", "top", {false, true, false}, perArea, 0.05}};
  const Vec3 top(0.12, 0.22, -0.285), force(0.001, -5, 0);
  scene.scenario.loads = {{"bone", force, Vec3::Zero(), top}};
  const int n = 400;
  const Steps many(scene, n);
  const PartReading bone = many.part(0);
  EXPECT_NEAR(bone.centre_W.y() - 0.21, force.y() / (perArea * area), 1e-7);
  const double dt = scene.scenario.dt;
  EXPECT_NEAR(bone.velocity_W.x(), n * dt * force.x() / bone.mass, 1e-6);
  const SceneReading reading = readScene(*many.model, many.state, {});
  ASSERT_EQ(reading.supports.size(), 1u);
  EXPECT_NEAR(reading.supports[0].onPart.force_W.y(), 5, 1e-4);
  EXPECT_EQ(reading.supports[0].onPart.force_W.x(), 0);
}

TEST(Supports, theProfilesAgree) {
  scenes::LadderScene scene = twoBodies();
  scene.joint.parts[1].regions = {scenes::regionIn(scene.joint.parts[1], "side", Box3(Vec3(-0.02 - 1e-6, -1, -1), Vec3(-0.02 + 1e-6, 1, 1)))};
  scene.scenario.supports = {{"cube", "side", {true, false, true}, 1e6}, {"bone", "top", {}, 1e6}};
  scene.scenario.pressures = {{"cube", "side", -200}};
  scene.scenario.loads = {{"bone", Vec3(1, 2, 3), Vec3::Zero(), Vec3::Zero()}};
  StepperOptions reference, paper;
  reference.profile = Profile::Reference;
  paper.profile = Profile::Paper;
  const Steps a(scene, 50), b(scene, 50, reference), c(scene, 50, paper);
  EXPECT_LT((a.state.q - b.state.q).norm(), 1e-9);
  EXPECT_LT((a.state.q - c.state.q).norm(), 1e-5);  // conjugate gradients to 1e-6 in every step
}

TEST(Regions, oneWithoutAreaIsRefused) {
  scenes::LadderScene scene = twoBodies();
  scene.joint.parts[0].regions.push_back({"none", "none", "other", SurfaceKind::Visual, {}});
  scene.scenario.pressures = {{"bone", "none", 1}};
  const auto empty = compileModel(scene.joint, scene.scenario);
  ASSERT_FALSE(empty.ok());
  EXPECT_EQ(empty.error().fault, Fault::Unusable);
  scene.scenario.pressures = {};
  scene.scenario.supports = {{"bone", "elsewhere", {}, 1e6}};
  const auto unknown = compileModel(scene.joint, scene.scenario);
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(unknown.error().fault, Fault::UnknownId);
  EXPECT_EQ(unknown.error().place.pointer, "/supports/0");
}

}  // namespace
}  // namespace glenoid
