// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/NearCouplings.h"

#include <gtest/gtest.h>

#include "tests/simcore/author/OverlappingParts.h"

namespace glenoid {
namespace {

NearCoupling bandToBall(double within) {
  NearCoupling near;
  near.coupling.id = "band-ball";
  near.coupling.partA = "band";
  near.coupling.partB = "ball";
  near.coupling.stiffnessPerArea = 1e7;
  near.within = within;
  return near;
}

TEST(NearCouplings, theRegionIsWhatLiesWithinTheDistance) {
  JointRecipe recipe = test::overlappingParts();
  recipe.nearCouplings = {bandToBall(1e-3)};
  const auto joint = buildJoint(recipe);
  ASSERT_TRUE(joint.ok()) << toLogLine(joint.error());
  ASSERT_EQ(joint->couplings.size(), 1u);
  EXPECT_EQ(joint->couplings[0].regionA, "band-ball");
  const Region* region = findRegion(joint->parts[1], "band-ball");
  ASSERT_TRUE(region);
  const TriMesh& band = *joint->parts[1].visual;
  const std::vector<int> inRegion = trianglesOf(*region);
  std::size_t next = 0;
  for (int t = 0; t < static_cast<int>(band.triangles.size()); ++t) {
    Vec3 centre = Vec3::Zero();
    for (const int corner : band.triangles[t]) centre += band.vertices[corner] / 3;
    const bool in = next < inRegion.size() && inRegion[next] == t;
    next += in;
    // The ball is faceted by less than 0.2 mm.
    if (centre.norm() < 0.0248) {
      EXPECT_TRUE(in) << t;
    }
    if (centre.norm() > 0.0252) {
      EXPECT_FALSE(in) << t;
    }
  }
}

TEST(NearCouplings, aBallLimitsIt) {
  Joint joint = *buildJoint(test::overlappingParts());
  NearCoupling near = bandToBall(1e-3);
  near.centre_W = Vec3(0, 0.01, 0.024);
  near.radius = 0.008;
  ASSERT_TRUE(addNearCoupling(joint, near).ok());
  const TriMesh& band = *joint.parts[1].visual;
  for (const int t : trianglesOf(joint.parts[1].regions[0])) {
    Vec3 centre = Vec3::Zero();
    for (const int corner : band.triangles[t]) centre += band.vertices[corner] / 3;
    EXPECT_LE((centre - near.centre_W).norm(), near.radius + 1e-12);
  }
}

TEST(NearCouplings, whatCannotHoldIsRefusedByName) {
  Joint joint = *buildJoint(test::overlappingParts());
  joint.parts[0].visual = std::make_shared<const TriMesh>(shapes::moved(*joint.parts[0].visual, test::shiftedBy(1, 0, 0)));
  const auto far = addNearCoupling(joint, bandToBall(1e-3));
  ASSERT_FALSE(far.ok());
  EXPECT_EQ(far.error().fault, Fault::TooFewSprings);
  EXPECT_EQ(far.error().place.part, "band-ball");
  NearCoupling wrong = bandToBall(1e-3);
  wrong.coupling.partB = "moon";
  EXPECT_EQ(addNearCoupling(joint, wrong).error().fault, Fault::UnknownId);
}

}  // namespace
}  // namespace glenoid
