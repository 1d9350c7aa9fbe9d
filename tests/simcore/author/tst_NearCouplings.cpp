// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/NearCouplings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <iterator>

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

TEST(NearCouplings, aRegionLimitsItAndARecipeMayMirrorAll) {
  JointRecipe recipe = test::overlappingParts();
  recipe.nearCouplings = {bandToBall(1e-3)};
  const Joint all = *buildJoint(recipe);
  const std::vector<int> near = trianglesOf(*findRegion(all.parts[1], "band-ball"));
  std::vector<int> half;  // what an author drew: one side of the band
  const TriMesh& band = *recipe.parts[1].visual;
  for (int t = 0; t < static_cast<int>(band.triangles.size()); ++t)
    if (band.vertices[band.triangles[t][0]].x() > 0) half.push_back(t);
  recipe.parts[1].regions.push_back({"drawn", {}, "other", SurfaceKind::Visual, runsOf(half)});
  recipe.nearCouplings[0].coupling.regionA = "drawn";
  const auto joint = buildJoint(recipe);
  ASSERT_TRUE(joint.ok()) << toLogLine(joint.error());
  std::vector<int> expected;
  std::set_intersection(near.begin(), near.end(), half.begin(), half.end(), std::back_inserter(expected));
  ASSERT_FALSE(expected.empty());
  ASSERT_LT(expected.size(), near.size());
  EXPECT_EQ(joint->couplings[0].regionA, "band-ball");
  EXPECT_EQ(trianglesOf(*findRegion(joint->parts[1], "band-ball")), expected);
  recipe.nearCouplings[0].coupling.regionA = "nowhere";
  EXPECT_EQ(buildJoint(recipe).error().fault, Fault::UnknownId);
  recipe.nearCouplings[0].coupling.regionA = "drawn";
  recipe.side = JointSide::Right;
  recipe.mirrored = true;
  const auto mirrored = buildJoint(recipe);
  ASSERT_TRUE(mirrored.ok());
  EXPECT_EQ(mirrored->side, JointSide::Left);
  for (std::size_t i = 0; i < band.vertices.size(); ++i) EXPECT_EQ(mirrored->parts[1].visual->vertices[i], Vec3(joint->parts[1].visual->vertices[i].cwiseProduct(Vec3(1, 1, -1))));
  EXPECT_EQ(trianglesOf(*findRegion(mirrored->parts[1], "band-ball")), expected);
}

TEST(NearCouplings, whatCannotHoldIsRefusedByName) {
  Joint joint = *buildJoint(test::overlappingParts());
  joint.parts[0].visual = std::make_shared<const TriMesh>(shapes::moved(*joint.parts[0].visual, test::shiftedBy(1, 0, 0)));
  const auto far = addNearCoupling(joint, bandToBall(1e-3));
  ASSERT_FALSE(far.ok());
  EXPECT_EQ(far.error().fault, Fault::NothingNear);
  EXPECT_EQ(far.error().place.part, "band-ball");
  NearCoupling wrong = bandToBall(1e-3);
  wrong.coupling.partB = "moon";
  EXPECT_EQ(addNearCoupling(joint, wrong).error().fault, Fault::UnknownId);
}

TEST(NearCouplings, allThatFindNothingAreNamedBeforeAnythingIsBuilt) {
  JointRecipe recipe = test::overlappingParts();
  PartRecipe& ball = recipe.parts[0].id == "ball" ? recipe.parts[0] : recipe.parts[1];
  // 0.1 m along x: band and ball, which overlapped, lie apart by what their boxes say or more.
  ball.visual = std::make_shared<const TriMesh>(shapes::moved(*ball.visual, test::shiftedBy(0.1, 0, 0)));
  NearCoupling other = bandToBall(2e-3), empty = bandToBall(2e-3), wide = bandToBall(0.2);
  other.coupling.id = "second";
  empty.coupling.id = "third";
  empty.centre_W = Vec3(5, 5, 5);
  empty.radius = 0.01;
  wide.coupling.id = "fourth";
  recipe.nearCouplings = {bandToBall(1e-3), other, empty, wide};
  int pieces = 0;
  const auto joint = buildJoint(recipe, [&](const std::string&, double) { return ++pieces > 0; });
  ASSERT_FALSE(joint.ok());
  EXPECT_EQ(pieces, 0);
  EXPECT_EQ(joint.error().fault, Fault::NothingNear);
  const std::string& words = joint.error().arguments.at(0);
  for (const char* part : {"“band-ball” of band to ball (nearest ", "within 1 mm)", "“second”", "within 2 mm)", "“third” of band to ball (nothing of band lies in its ball)"})
    EXPECT_NE(words.find(part), std::string::npos) << part << " in " << words;
  EXPECT_EQ(words.find("fourth"), std::string::npos) << words;
  // The distance that is named is right: with a little more there is something, with a little less there is not.
  double nearest = 0;
  ASSERT_EQ(std::sscanf(words.c_str() + words.find("nearest ") + 8, "%lf", &nearest), 1);
  EXPECT_GT(nearest, 20);
  recipe.nearCouplings = {bandToBall(1.01e-3 * nearest)};
  EXPECT_TRUE(checkNearCouplings(recipe.parts, recipe.nearCouplings).ok());
  recipe.nearCouplings = {bandToBall(0.99e-3 * nearest)};
  EXPECT_EQ(checkNearCouplings(recipe.parts, recipe.nearCouplings).error().fault, Fault::NothingNear);
}

}  // namespace
}  // namespace glenoid
