// SPDX-License-Identifier: GPL-3.0-or-later
// A ball in a cup with half a millimetre of room: coarse surfaces of both overlap where the fine ones do not.
#include "simcore/author/RigidAdvice.h"

#include <gtest/gtest.h>

#include "simcore/author/BuildJoint.h"
#include "simcore/author/Overlaps.h"
#include "simcore/author/SeparateStart.h"
#include "simcore/mesh/Isosurface.h"
#include "simcore/mesh/Simplify.h"

namespace glenoid {
namespace {

constexpr double kBall = 0.024, kRoom = 0.0005;  // m

TriMesh surfaceOf(const ScalarField& field) {
  TriMesh mesh = isosurface(field, Box3(Vec3::Constant(-0.033), Vec3::Constant(0.033)), 0.0025);
  for (Vec3& x : mesh.vertices)  // onto the shape, so that its chords keep half of the room
    for (int i = 0; i < 4; ++i) {
      Vec3 gradient;
      for (int k = 0; k < 3; ++k) gradient[k] = (field(x + 1e-6 * Vec3::Unit(k)) - field(x - 1e-6 * Vec3::Unit(k))) / 2e-6;
      if (gradient.norm() > 0.5) x -= field(x) * gradient / gradient.squaredNorm();
    }
  return mesh;
}

Part bone(const std::string& id, int number, const ScalarField& field, int triangles) {
  Part part;
  part.id = id;
  part.number = number;
  part.visual = std::make_shared<const TriMesh>(surfaceOf(field));
  part.collision = std::make_shared<const TriMesh>(*simplify(*part.visual, triangles));
  return part;
}

/// Half a shell that opens upwards, and the ball in it, raised by `up`.
Joint ballAndCup(int triangles, double up = 0) {
  Joint joint;
  joint.parts.push_back(bone("cup", 1, [](const Vec3& p) { return std::max({p.norm() - 0.03, kBall + kRoom - p.norm(), p.y() - 0.002}); }, triangles));
  joint.parts.push_back(bone("ball", 2, [up](const Vec3& p) { return (p - Vec3(0, up, 0)).norm() - kBall; }, triangles));
  return joint;
}

TEST(RigidAdvice, whatItAdvisesHolds) {
  const Joint joint = ballAndCup(200);
  ASSERT_FALSE(overlapsAtStart(joint)->empty()) << "the case itself";
  const RigidAdvice advice = adviseRigid(joint.parts[0], joint.parts[1]);
  EXPECT_FALSE(advice.surfacesOverlap);
  ASSERT_GT(advice.triangles, 200);
  EXPECT_EQ(advice.triangles % 100, 0);
  EXPECT_TRUE(overlapsAtStart(ballAndCup(advice.triangles))->empty());
  if (advice.clearance > 0) {
    Joint apart = joint;
    const auto report = separateCollision(apart, advice.clearance);
    ASSERT_TRUE(report.ok());
    EXPECT_TRUE(report->left.empty());
    EXPECT_TRUE(overlapsAtStart(apart)->empty());
  }
}

TEST(RigidAdvice, surfacesThatOverlapThemselvesAreSaidToo) {
  const Joint joint = ballAndCup(200, -0.002);
  const RigidAdvice advice = adviseRigid(joint.parts[0], joint.parts[1]);
  EXPECT_TRUE(advice.surfacesOverlap);
  EXPECT_EQ(advice.triangles, 0);
  EXPECT_EQ(advice.clearance, 0);
}

TEST(RigidAdvice, itCanBeStopped) {
  const Joint joint = ballAndCup(200);
  int asked = 0;
  const RigidAdvice advice = adviseRigid(joint.parts[0], joint.parts[1], [&] { return ++asked > 100; });
  EXPECT_EQ(advice.triangles, 0);
  EXPECT_EQ(asked, 2);
}

TEST(SeparateStart, spendsNoSweepOnPartsThatCannotMove) {
  Joint joint = ballAndCup(200);
  const auto outcome = separateStart(joint, {});
  ASSERT_TRUE(outcome.ok()) << toLogLine(outcome.error());
  EXPECT_EQ(outcome->overlapsBefore, 1);
  EXPECT_EQ(outcome->sweeps, 0);
  EXPECT_FALSE(outcome->check.holds());

  // A soft part between others that overlaps nothing needs none either, however long the two stay in each other's way.
  Part soft = joint.parts[1];
  soft.id = "soft";
  soft.number = 3;
  soft.kind = PartKind::Soft;
  TriMesh far = *soft.visual;
  for (Vec3& x : far.vertices) x.x() += 0.0555;  // 1.5 mm beside the cup's rim
  soft.visual = std::make_shared<const TriMesh>(far);
  soft.collision = std::make_shared<const TriMesh>(*simplify(far, 200));
  soft.volume = std::make_shared<const TetMesh>(chooseCells(*soft.visual, *soft.collision, 300)->mesh);
  joint.parts.push_back(soft);
  const auto again = separateStart(joint, {});
  ASSERT_TRUE(again.ok()) << toLogLine(again.error());
  EXPECT_EQ(again->sweeps, 0);
}

}  // namespace
}  // namespace glenoid
