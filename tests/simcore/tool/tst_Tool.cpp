// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>

#include "simcore/linear/BlockCholesky.h"
#include "simcore/tool/FingerShape.h"
#include "simcore/tool/PoseSpring.h"
#include "simcore/tool/ToolBalls.h"
#include "simcore/tool/ToolShape.h"

namespace glenoid {
namespace {

Tool toolOf(ToolKind kind) {
  Tool tool;
  tool.kind = kind;
  tool.radius = kind == ToolKind::Finger || kind == ToolKind::Ball ? 0.008 : 0.0015;
  return tool;
}

class ToolShape : public testing::TestWithParam<ToolKind> {};

void expectClosedAndOutward(const TriMesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
  EXPECT_GT(enclosedVolume(mesh), 0);
}

TEST_P(ToolShape, isClosedAndOutward) {
  for (const int segments : {kToolCollisionSegments, kToolVisualSegments})
    expectClosedAndOutward(makeToolSurface(toolOf(GetParam()), segments));
}

TEST_P(ToolShape, ballsAreWhatTheSurfaceWraps) {
  const Tool tool = toolOf(GetParam());
  const std::vector<ToolBall> balls = makeToolBalls(tool);
  if (tool.kind == ToolKind::Bar) {
    EXPECT_TRUE(balls.empty()) << "no ball fits a square";
    return;
  }
  for (std::size_t i = 0; i + 1 < balls.size(); ++i)
    if (tool.kind != ToolKind::Ball)
      EXPECT_LE((balls[i + 1].centre_T - balls[i].centre_T).norm(), 0.51 * std::max(balls[i].radius, balls[i + 1].radius)) << i;
  // Every corner of the fine surface but those of the handle's end lies on the balls, and the tip on the first to meet the ground.
  for (const Vec3& p : makeToolSurface(tool, kToolVisualSegments).vertices) {
    if (p.z() > 0.8 * tool.length) continue;
    double off = 1e300;
    for (const ToolBall& ball : balls) off = std::min(off, (p - ball.centre_T).norm() - ball.radius);
    EXPECT_LT(std::abs(off), 0.12 * tool.radius) << p.transpose();
  }
  double lowest = 1e300;
  for (const ToolBall& ball : balls) lowest = std::min(lowest, ball.centre_T.z() - ball.radius);
  EXPECT_NEAR(lowest, 0, 1e-12);
}

TEST_P(ToolShape, tipIsTheOriginAndTheShaftGoesUp) {
  const Tool tool = toolOf(GetParam());
  const Box3 box = boundsOf(makeToolSurface(tool, kToolVisualSegments));
  EXPECT_NEAR(box.min().z(), 0, 1e-4);
  EXPECT_NEAR(box.max().z(), tool.length, 1.2 * tool.radius);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ToolShape, testing::Values(ToolKind::Probe, ToolKind::Arthroscope, ToolKind::Finger,
                                                           ToolKind::Ball, ToolKind::Bar));

TEST(ToolShapes, aFingerLooksLikeOneAndStaysOnItsCapsule) {
  for (const double length : {0.08, 0.03}) {
    Tool tool = toolOf(ToolKind::Finger);
    tool.length = length;
    const TriMesh look = makeFingerLook(tool), capsule = makeToolSurface(tool, 96);
    expectClosedAndOutward(look);
    EXPECT_GT(enclosedVolume(look), 0.8 * enclosedVolume(capsule));
    EXPECT_LT(enclosedVolume(look), 1.2 * enclosedVolume(capsule));
    EXPECT_EQ(look.vertices[0], Vec3(0, 0, 0));
    const double tip = 0.75 * tool.radius, taper = 0.4 * tool.length;
    int nail = 0, skin = 0;
    for (const Vec3& p : look.vertices) {
      ASSERT_TRUE(p.allFinite());
      if (p.z() > 0.016) continue;
      // The last phalanx of the capsule: a ball at the tip, a first ring of the cone at 1.3 of its radius.
      const double first = 1.3 * tip, cone = tip + (tool.radius - tip) * std::min(1.0, std::max(p.z(), first) / taper);
      const double radius = p.z() < first ? tip + (cone - tip) * (p.z() - tip) / (first - tip) : cone;
      const double off = p.z() < tip ? (p - Vec3(0, 0, tip)).norm() - tip : p.head<2>().norm() - radius;
      EXPECT_LT(std::abs(off), 0.5e-3) << p.transpose();
      if (insideNail(tool, p) > 0) {
        ++nail;
        EXPECT_GT(p.y(), 0) << "on the back";
      } else {
        ++skin;
      }
    }
    EXPECT_GT(nail, 150);
    EXPECT_GT(skin, 500);
  }
}

TEST(ToolShapes, ballIsASphereAtTheTip) {
  const Tool tool = toolOf(ToolKind::Ball);
  const TriMesh mesh = makeToolSurface(tool, kToolCollisionSegments);
  const Vec3 centre(0, 0, tool.radius);
  int below = 0;
  for (const Vec3& p : mesh.vertices) {
    if (p.z() > centre.z()) continue;
    EXPECT_NEAR((p - centre).norm(), tool.radius, 1e-15);
    ++below;
  }
  EXPECT_GT(below, 4 * 2 * kToolCollisionSegments) << "twice the corners of a shaft, in four rings and more";
}

TEST(ToolShapes, barIsABox) {
  const Tool tool = toolOf(ToolKind::Bar);
  const TriMesh mesh = makeToolSurface(tool, kToolCollisionSegments);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_NEAR(enclosedVolume(mesh), 4 * tool.radius * tool.radius * tool.length, 1e-15);
}

struct HeldBody {
  HeldBody() {
    properties.mass = 0.05;
    properties.inertia = 1e-4 * Mat3::Identity();
    body = std::make_unique<RigidObject>(ObjectLayout{true, true, 0, 7, 0, 6, 0}, properties, 0.0, false);
    const std::array<int, 2> pair{1, 0};
    symbolic = std::make_shared<BlockSymbolic>(2, std::span(&pair, 1));
    state.q.resize(7);
    setPoseAt(state.q, 0, {Vec3(0.1, 0, 0), Quat::Identity()});
    state.v.setZero(6);
    spring.anchor_B = Vec3(0, 0, -0.08);
    spring.stiffness = 800;
    spring.angularStiffness = 2;
    spring.damping = 2 * std::sqrt(800 * 0.05);
    spring.angularDamping = 0.1;
  }
  void step(const PoseTarget& target) {
    BlockMatrix A(symbolic);
    A.setZero();
    VecX b = VecX::Zero(6), rotations;
    body->assemble(settings, state, body->blockEntries(*symbolic, 0), rotations, A, b);
    assemblePoseSpring(spring, *body, target, settings.dt, state, {symbolic->entry(0, 0), symbolic->entry(1, 1), symbolic->entry(1, 0)}, A, b);
    BlockCholesky factor(symbolic);
    ASSERT_TRUE(factor.factor(A));
    factor.solve(b);
    state.v = b;
    body->advance(settings.dt, state);
  }
  MassProperties properties;
  std::unique_ptr<RigidObject> body;
  std::shared_ptr<const BlockSymbolic> symbolic;
  PoseSpring spring;
  StepSettings settings;
  State state;
};

TEST(PoseSpring, reachesItsTargetInPlaceAndTurn) {
  HeldBody held;
  PoseTarget target;
  target.anchor_W = Vec3(0.02, 0.03, -0.01);
  target.q_WB = Quat(Eigen::AngleAxisd(2.0, Vec3(1, 1, 0).normalized()));
  for (int i = 0; i < 2000; ++i) held.step(target);
  const Pose pose = held.body->pose(held.state.q);
  EXPECT_LT((pose * held.spring.anchor_B - target.anchor_W).norm(), 1e-6);
  EXPECT_LT(pose.q_WB.angularDistance(target.q_WB), 1e-5);
}

TEST(PoseSpring, isStableAtAnyStiffness) {
  HeldBody held;
  held.spring.stiffness = 1e9;
  held.spring.angularStiffness = 1e6;
  held.spring.damping = held.spring.angularDamping = 0;
  PoseTarget target;
  target.anchor_W = Vec3(0.1, 0.001, -0.08);
  for (int i = 0; i < 500; ++i) held.step(target);
  EXPECT_TRUE(held.state.v.allFinite());
  EXPECT_LT((held.body->pose(held.state.q) * held.spring.anchor_B - target.anchor_W).norm(), 1e-6);
}

TEST(PoseSpring, pullIsCutAtTheLargestForce) {
  HeldBody held;
  held.spring.forceMax = 3;
  PoseTarget target;
  target.anchor_W = Vec3(1, 1, 1);
  EXPECT_NEAR(driveWrench(held.spring, *held.body, target, held.state.q).head<3>().norm(), 3, 1e-12);
}

TEST(PoseSpring, aHandThatMovesEvenlyIsFollowedWithoutLag) {
  HeldBody held;
  PoseTarget target;
  target.q_WB = Quat::Identity();
  target.velocity_W = Vec3(0.05, 0, 0);
  double lag = 0;
  for (int i = 0; i < 1000; ++i) {
    target.anchor_W = Vec3(0.1, 0, -0.08) + (i + 1) * held.settings.dt * target.velocity_W;
    held.step(target);
    lag = (held.body->pose(held.state.q) * held.spring.anchor_B - target.anchor_W).norm();
  }
  EXPECT_LT(lag, 0.05 * held.settings.dt * 1.01);  // at most one step's way
}

TEST(PoseSpring, aHandThatJumpsPullsNoHarderThanTheLargestForce) {
  HeldBody held;
  held.spring.forceMax = 3;
  held.spring.torqueMax = 0.4;
  held.spring.damping = 10;
  held.spring.angularDamping = 1;
  const Pose there{Vec3(0.05, 0, 0), Quat(Eigen::AngleAxisd(3, Vec3::UnitX()))};
  const PoseTarget target = handTarget(there, {}, 1e-3);  // 50 m/s for one step
  const Vec6 drive = driveWrench(held.spring, *held.body, target, held.state.q);
  EXPECT_NEAR(drive.head<3>().norm(), 3, 1e-12);
  EXPECT_NEAR(drive.tail<3>().norm(), 0.4, 1e-12);
}

TEST(PoseSpring, knowsWhatCannotBeAHand) {
  EXPECT_TRUE(isHandPose({}));
  EXPECT_TRUE(isHandPose({Vec3(0.3, -0.2, 0.9), Quat(Eigen::AngleAxisd(2, Vec3::UnitY()))}));
  for (const double wrong : {std::nan(""), HUGE_VAL, -1e30, 1e300}) {
    EXPECT_FALSE(isHandPose({Vec3(0, wrong, 0), Quat::Identity()})) << wrong;
    EXPECT_FALSE(isHandPose({Vec3::Zero(), Quat(wrong, 0, 0, 0)})) << wrong;
  }
  EXPECT_FALSE(isHandPose({Vec3::Zero(), Quat(0, 0, 0, 0)}));
}

}  // namespace
}  // namespace glenoid
