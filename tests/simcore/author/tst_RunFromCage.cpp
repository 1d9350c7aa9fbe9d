// SPDX-License-Identifier: GPL-3.0-or-later
// A run begins with the parts as their cages make them, and relaxes to less energy (paper §4.3).
#include <gtest/gtest.h>

#include "simcore/author/SeparateStart.h"
#include "simcore/scene/Start.h"
#include "simcore/step/Stepper.h"
#include "tests/simcore/author/OverlappingParts.h"

namespace glenoid {
namespace {

/// The band, bonded to the ball where it lies on it; the strap, bonded to the band.
Joint freedJoint() {
  JointRecipe recipe = test::overlappingParts();
  const auto bond = [&](const char* id, const char* a, const char* b, double within, const Vec3& centre, double radius) {
    NearCoupling near;
    near.coupling.id = id;
    near.coupling.partA = a;
    near.coupling.partB = b;
    near.coupling.stiffnessPerArea = 2e6;
    near.coupling.damping = 0.01;
    near.within = within;
    near.centre_W = centre;
    near.radius = radius;
    recipe.nearCouplings.push_back(near);
  };
  bond("band-ball", "band", "ball", 2e-3, Vec3(0, 0, 0.022), 0.012);
  bond("strap-band", "strap", "band", 1e-3, Vec3::Zero(), 0);
  for (Material& material : recipe.materials) material.stiffnessDamping = 0.02, material.massDamping = 5;
  StartWishes wishes;
  wishes.clearance = 5e-4;
  recipe.start = wishes;
  BuildReport report;
  auto joint = buildJoint(recipe, {}, &report);
  EXPECT_TRUE(joint.ok()) << toLogLine(joint.error());
  EXPECT_TRUE(report.start && report.start->check.holds());
  return *joint;
}

/// How far a part is from its rest shape, whatever its place: mean ‖FᵀF − I‖² over its volume.
double strainOf(const TetMesh& rest, const VecX& q, int offset) {
  double sum = 0, volume = 0;
  for (int tet = 0; tet < static_cast<int>(rest.tets.size()); ++tet) {
    Mat3 before, now;
    for (int k = 0; k < 3; ++k) {
      before.col(k) = rest.nodes[rest.tets[tet][k + 1]] - rest.nodes[rest.tets[tet][0]];
      now.col(k) = q.segment<3>(offset + 3 * rest.tets[tet][k + 1]) - q.segment<3>(offset + 3 * rest.tets[tet][0]);
    }
    const Mat3 F = now * before.inverse();
    const double v = tetVolume(rest, tet);
    sum += v * (F.transpose() * F - Mat3::Identity()).squaredNorm();
    volume += v;
  }
  return sum / volume;
}

TEST(RunFromCage, beginsDeformedAndRelaxes) {
  const Joint joint = freedJoint();
  Scenario scenario;
  scenario.fixedParts = {"ball"};
  scenario.gravity_W = Vec3::Zero();
  scenario.contactDistance = 1e-3;
  const auto model = compileModel(joint, scenario);
  ASSERT_TRUE(model.ok()) << toLogLine(model.error());
  State state = (*model)->start;
  const SceneObject& band = (*model)->objects[1];
  const auto nodes = startNodes(joint, joint.parts[1]);
  ASSERT_TRUE(nodes.ok());
  for (int i = 0; i < band.layout.nodeCount; ++i)
    EXPECT_EQ(Vec3(state.q.segment<3>(band.layout.qOffset + 3 * i)), (*nodes)[i]);
  const double before = strainOf(*band.volume, state.q, band.layout.qOffset);
  EXPECT_GT(before, 1e-4) << "the cage did deform it";
  Stepper stepper(*model, {});
  for (int step = 0; step < 400; ++step) stepper.step({}, state);
  ASSERT_TRUE(isFinite(state));
  EXPECT_LT(state.v.cwiseAbs().maxCoeff(), 2e-3) << "it has come to rest";
  EXPECT_LT(strainOf(*band.volume, state.q, band.layout.qOffset), before) << "with less strain than the cage gave it";
}

}  // namespace
}  // namespace glenoid
