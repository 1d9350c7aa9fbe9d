// SPDX-License-Identifier: GPL-3.0-or-later
// A joint that starts overlapping comes out the same wherever its author's coordinates lie.
#include <gtest/gtest.h>

#include "simcore/author/SeparateStart.h"
#include "simcore/live/Run.h"
#include "simcore/scene/Start.h"
#include "tests/simcore/author/Elsewhere.h"
#include "tests/simcore/author/OverlappingParts.h"

namespace glenoid {
namespace {

/// A ball, a band that overlaps it, a strap within the band that lies nearer to one side: no two sides are alike.
JointRecipe recipe() {
  JointRecipe made = test::overlappingParts();
  for (Material& material : made.materials) material.stiffnessDamping = 0.02, material.massDamping = 5;
  NearCoupling near;
  near.coupling.id = "band-ball";
  near.coupling.partA = "band";
  near.coupling.partB = "ball";
  near.coupling.stiffnessPerArea = 2e6;
  near.coupling.damping = 0.01;
  near.within = 2e-3;
  near.centre_W = Vec3(0, 0, 0.022);
  near.radius = 0.012;
  made.nearCouplings = {near};
  near.coupling.id = "strap-band";
  near.coupling.partA = "strap";
  near.coupling.partB = "band";
  near.within = 1e-3;
  near.radius = 0;
  made.nearCouplings.push_back(near);
  made.start.emplace();
  made.start->clearance = 5e-4;
  return made;
}

struct Made {
  Joint joint;
  SeparationOutcome start;
};
Made madeFrom(const JointRecipe& from) {
  BuildReport report;
  auto joint = buildJoint(from, {}, &report);
  EXPECT_TRUE(joint.ok()) << toLogLine(joint.error());
  return {*joint, *report.start};
}

double depthOfRun(const Joint& joint, const Isometry& motion) {
  Scenario scenario;
  scenario.gravity_W = motion.R * scenario.gravity_W;
  scenario.fixedParts = {"ball"};
  const auto model = compileModel(joint, scenario);
  EXPECT_TRUE(model.ok()) << toLogLine(model.error());
  RunOptions options;
  options.steps = 60;
  const auto run = runScenario(*model, options);
  EXPECT_TRUE(run.ok());
  return run->report.penetrationMax;
}

TEST(StartElsewhere, theSameMovesRatiosAndDepth) {
  const Made here = madeFrom(recipe());
  ASSERT_GT(here.start.sweeps, 1);
  ASSERT_GE(here.start.movedParts.size(), 2u);
  const double depth = depthOfRun(here.joint, {});
  for (const test::Place& place : test::elsewhere()) {
    SCOPED_TRACE(place.name);
    const Made there = madeFrom(test::movedRecipe(recipe(), place.motion));
    EXPECT_EQ(there.start.sweeps, here.start.sweeps);
    EXPECT_EQ(there.start.movedParts, here.start.movedParts);
    EXPECT_EQ(there.start.overlapsBefore, here.start.overlapsBefore);
    for (std::size_t i = 0; i < here.start.shifts.size(); ++i) EXPECT_NEAR(there.start.shifts[i], here.start.shifts[i], 1e-9);
    EXPECT_NEAR(there.start.check.proof.minVolumeRatio, here.start.check.proof.minVolumeRatio, 1e-6);
    EXPECT_EQ(there.joint.startProof->cuts, 0);
    for (std::size_t p = 0; p < here.joint.parts.size(); ++p) {
      const Part &a = here.joint.parts[p], &b = there.joint.parts[p];
      EXPECT_EQ(a.regions, b.regions);
      ASSERT_EQ(a.collision->triangles.size(), b.collision->triangles.size());
      ASSERT_EQ(a.volume != nullptr, b.volume != nullptr);
      if (!a.volume) continue;
      ASSERT_EQ(a.volume->tets.size(), b.volume->tets.size());
      const auto before = startNodes(here.joint, a), after = startNodes(there.joint, b);
      for (std::size_t n = 0; n < before->size(); ++n)  // the grid of the own frame
        EXPECT_LT((place.motion * (*before)[n] - (*after)[n]).norm(), 1e-7);
    }
    EXPECT_NEAR(depthOfRun(there.joint, place.motion), depth, 0.01 * depth);
  }
}

TEST(StartElsewhere, aJointAlreadyBuiltIsFreedTheSame) {
  JointRecipe without = recipe();
  without.start.reset();
  const auto built = buildJoint(without);
  ASSERT_TRUE(built.ok());
  Joint here = *built;
  const auto one = separateStart(here, {});
  ASSERT_TRUE(one.ok());
  for (const test::Place& place : test::elsewhere()) {
    SCOPED_TRACE(place.name);
    Joint there = movedJoint(*built, place.motion);
    const auto other = separateStart(there, {});
    ASSERT_TRUE(other.ok());
    EXPECT_EQ(other->sweeps, one->sweeps);
    ASSERT_EQ(there.cages.size(), here.cages.size());
    for (std::size_t c = 0; c < here.cages.size(); ++c)
      for (std::size_t i = 0; i < here.cages[c].moved_W.size(); ++i) {
        EXPECT_LT((place.motion * here.cages[c].rest_W[i] - there.cages[c].rest_W[i]).norm(), 1e-7);
        EXPECT_LT((place.motion * here.cages[c].moved_W[i] - there.cages[c].moved_W[i]).norm(), 1e-7);
      }
  }
}

TEST(StartElsewhere, anAuthorsCageKeepsItsRestToTheBit) {
  JointRecipe without = recipe();
  without.start.reset();
  Joint joint = *buildJoint(without);
  Cage cage;
  {
    Joint freed = joint;
    ASSERT_TRUE(separateStart(freed, {}).ok());
    cage = freed.cages[0];
  }
  cage.moved_W = cage.rest_W;
  joint.cages = {cage};
  ASSERT_TRUE(separateStart(joint, {}).ok());
  const Cage* after = findCage(joint, cage.part);
  ASSERT_TRUE(after);
  EXPECT_EQ(after->rest_W, cage.rest_W);
  EXPECT_EQ(after->triangles, cage.triangles);
  EXPECT_NE(after->moved_W, cage.moved_W);
  // Once free, doing it again moves nothing, not by a bit.
  const std::vector<Cage> free = joint.cages;
  ASSERT_TRUE(separateStart(joint, {}).ok());
  EXPECT_EQ(joint.cages, free);
}

}  // namespace
}  // namespace glenoid
