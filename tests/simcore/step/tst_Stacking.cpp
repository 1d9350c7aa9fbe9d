// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes of twelve triangles on boxes of twelve triangles: corner on corner and edge on edge, where no distance says which
// way is up. What rests stays where its closed form has it.
#include <gtest/gtest.h>

#include <cstdio>

#include "simcore/step/Stepper.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

constexpr double kSide = 0.02;  ///< m

struct Stack {
  int boxes = 2;
  double apart = 2e-4;            ///< m, between neighbours at the start
  Vec3 shift = Vec3::Zero();      ///< m, of each box against the one below
  double turn = 0, shrink = 0;    ///< rad about Y; m, of each box's upper face
  double friction = 0, dt = 0.005, scale = 1;
  PartKind kind = PartKind::Rigid;
};

std::shared_ptr<const Model> modelOf(const Stack& stack) {
  Joint joint;
  joint.id = joint.name = "stack";
  scenes::addMaterials(joint);
  for (Material& material : joint.materials) material.friction = stack.friction;
  joint.materials[1].youngsModulus = 2e6 * stack.scale;
  joint.materials[1].massDamping = 5;
  Vec3 low(0, 0, 0);
  for (int i = 0; i < stack.boxes; ++i) {
    Part part = scenes::boxPart("box" + std::to_string(i), i + 1, i == 0 ? PartKind::Rigid : stack.kind, stack.scale * low,
                                stack.scale * (low + Vec3::Constant(kSide)), 2);
    TriMesh mesh = scenes::boxSurface(stack.scale * low, stack.scale * (low + Vec3::Constant(kSide)));
    const Vec3 middle = stack.scale * (low + Vec3::Constant(kSide / 2));
    const Mat3 R = Eigen::AngleAxisd(stack.turn * i, Vec3::UnitY()).toRotationMatrix();
    for (Vec3& x : mesh.vertices) {
      Vec3 r = x - middle;
      if (r.y() > 0) r -= stack.scale * stack.shrink * Vec3(r.x() > 0 ? 1 : -1, 0, r.z() > 0 ? 1 : -1);
      x = middle + R * r;
    }
    part.visual = part.collision = std::make_shared<TriMesh>(mesh);
    joint.parts.push_back(part);
    low += Vec3(0, kSide + stack.apart, 0) + stack.shift;
  }
  Scenario scenario;
  scenario.id = scenario.name = "stack";
  scenario.fixedParts = {"box0"};
  scenario.dt = stack.dt;
  scenario.gravity_W *= stack.scale;
  scenario.contactDistance *= stack.scale;
  scenario.recoverySpeedMax *= stack.scale;
  return compileModel(joint, scenario).value();
}

/// Height of box i's lowest corner over the plane where it has to stand, m (of a scene of size one).
double heightOver(const Model& model, const State& state, const Stack& stack, int box) {
  const SceneObject& object = model.objects[box];
  std::vector<Vec3> x(object.collision.vertices.size());
  surfacePositions(object.collision, object.layout, state.q, x);
  double lowest = 1e30;
  for (const Vec3& p : x) lowest = std::min(lowest, p.y());
  return lowest / stack.scale - box * kSide;
}

void expectStands(const Stack& stack, double seconds, const std::string& what, double tolerance = 1e-7) {
  SCOPED_TRACE(what);
  const auto model = modelOf(stack);
  Stepper stepper(model, {});
  State state = model->start;
  const long steps = std::lround(seconds / stack.dt);
  double worst = 0, cpu = 0;
  for (long i = 0; i < steps; ++i) {
    const StepReport& report = stepper.step({}, state);
    ASSERT_TRUE(report.taken) << i;
    cpu += report.stepCpuMs;
    if (i < steps / 4) continue;  // landed
    for (int box = 1; box < stack.boxes; ++box) worst = std::max(worst, std::abs(heightOver(*model, state, stack, box)));
    if (worst > 1e-3) {
      std::printf("step %ld\n", i);
      break;
    }
  }
  std::printf("%-40s off by %.2e m, %.3f ms a step\n", what.c_str(), worst, cpu / static_cast<double>(steps));
  EXPECT_LT(worst, tolerance);
}

TEST(Stacking, equalAlignedBoxesHold) {
  for (const double dt : {0.001, 0.005, 0.02})
    for (const double friction : {0.0, 0.5})
      expectStands({.friction = friction, .dt = dt}, 1, "friction " + std::to_string(friction) + ", " + std::to_string(dt) + " s");
}

TEST(Stacking, soDoShiftedTurnedAndTaperedOnes) {
  for (const double shift : {1e-12, 1e-9, 1e-7, 1e-6, 1e-4, 1e-3}) {
    expectStands({.shift = Vec3(shift, 0, 0)}, 1, "shifted along x by " + std::to_string(1e6 * shift) + " um");
    expectStands({.shift = Vec3(shift, 0, -0.7 * shift)}, 1, "shifted along both by " + std::to_string(1e6 * shift) + " um");
  }
  for (const double turn : {1e-9, 1e-6, 1e-4, 0.01, 0.3}) expectStands({.turn = turn}, 1, "turned by " + std::to_string(turn));
  expectStands({.shrink = 1e-5}, 1, "upper faces 0.01 mm smaller");
  expectStands({.shrink = -1e-5}, 1, "upper faces 0.01 mm larger");
}

TEST(Stacking, soDoTheyAtAnySizeAndFromAnyHeight) {
  for (const double scale : {0.02, 50.0}) expectStands({.scale = scale}, 1, "scale " + std::to_string(scale));
  for (const double apart : {0.0, 1e-9, 1e-3, 0.05}) expectStands({.apart = apart}, 1, "from " + std::to_string(1e3 * apart) + " mm");
}

TEST(Stacking, softBoxesHoldToo) {
  expectStands({.kind = PartKind::Soft}, 1, "soft on rigid", 1e-6);
  expectStands({.boxes = 3, .kind = PartKind::Soft}, 1, "soft on soft", 1e-4);  // the lower one gives under the upper
}

TEST(Stacking, tenStandForAMinute) {
  expectStands({.boxes = 10}, 60, "ten, frictionless");
  expectStands({.boxes = 10, .friction = 0.5}, 60, "ten, friction 0.5");
}

}  // namespace
}  // namespace glenoid
