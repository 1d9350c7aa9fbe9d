// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/mesh/MeshHealth.h"
#include "simcore/mesh/TetTools.h"
#include "simcore/study/RefineJoint.h"
#include "tests/scenes/NodeScenes.h"
#include "tests/simcore/study/ShippedScene.h"

namespace glenoid::test {
namespace {

TEST(RefineJoint, cellsGrowByTheFactorAndSurfacesByItsPower) {
  const Joint coarse = shippedScene().joint;
  const Joint fine = refineJoint(coarse, 4).value();
  ASSERT_EQ(fine.parts.size(), coarse.parts.size());
  for (std::size_t i = 0; i < fine.parts.size(); ++i) {
    const Part &a = coarse.parts[i], &b = fine.parts[i];
    EXPECT_EQ(b.visual, a.visual) << a.id;  // the very same mesh
    EXPECT_EQ(b.regions, a.regions) << a.id;
    EXPECT_TRUE(healthOf(*b.collision).healthy()) << a.id;
    // 4^(2/3) = 2.52. Simplifying stops within a few triangles where the shape forbids another collapse.
    EXPECT_NEAR(static_cast<double>(b.collision->triangles.size()) / static_cast<double>(a.collision->triangles.size()), 2.52, 0.13) << a.id;
    ASSERT_EQ(!a.volume, !b.volume);
    if (!a.volume) continue;
    // chooseCells promises 15 %.
    EXPECT_NEAR(static_cast<double>(b.volume->tets.size()) / static_cast<double>(a.volume->tets.size()), 4, 0.6) << a.id;
    EXPECT_LT(b.cellSize, a.cellSize);
    EXPECT_TRUE(healthOf(*b.volume).healthy()) << a.id;
  }
  Joint measured = fine;
  EXPECT_TRUE(separateCollision(measured, 0.3e-3, 0).value().left.empty());  // apart by what was asked for, nearly
}

TEST(RefineJoint, factorOneIsTheJointItselfAndLessIsRefused) {
  const Joint joint = shippedScene().joint;
  const Joint same = refineJoint(joint, 1).value();
  for (std::size_t i = 0; i < joint.parts.size(); ++i) EXPECT_EQ(same.parts[i].volume, joint.parts[i].volume);
  EXPECT_EQ(refineJoint(joint, 0.5).error().fault, Fault::OutOfRange);
  EXPECT_EQ(refineJoint(joint, std::nan("")).error().fault, Fault::OutOfRange);
  EXPECT_EQ(refineJoint(joint, 2, 0.4e-3, [](const std::string&, double) { return false; }).error().fault, Fault::Cancelled);
}

TEST(RefineJoint, cellsAloneLeaveSurfacesAsTheyAre) {
  const Joint coarse = shippedScene().joint;
  const Joint fine = refineCells(coarse, 3).value();
  for (std::size_t i = 0; i < fine.parts.size(); ++i) {
    EXPECT_EQ(fine.parts[i].visual, coarse.parts[i].visual);
    EXPECT_EQ(fine.parts[i].collision, coarse.parts[i].collision);
    if (!coarse.parts[i].volume) continue;
    EXPECT_NEAR(static_cast<double>(fine.parts[i].volume->tets.size()) / static_cast<double>(coarse.parts[i].volume->tets.size()), 3, 0.45) << fine.parts[i].id;
    EXPECT_TRUE(healthOf(*fine.parts[i].volume).healthy());
  }
  EXPECT_EQ(refineCells(coarse, 0.5).error().fault, Fault::OutOfRange);
  EXPECT_EQ(refineCells(coarse, 2, [](const std::string&, double) { return false; }).error().fault, Fault::Cancelled);
}

TEST(RefineJoint, pickedNodesBecomeTheNearestOfTheFinerCells) {
  const Joint coarse = scenes::figure4AtNodes();
  const Joint fine = refineCells(coarse, 6).value();
  const double half = 0.5 * std::sqrt(3.0) * coarse.parts[1].cellSize;
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(fine.couplings[c].nodesA.size(), coarse.couplings[c].nodesA.size());
    EXPECT_NEAR(fine.couplings[c].stiffnessPerNode * static_cast<double>(fine.couplings[c].nodesA.size()), 4e4, 1e-8);
    for (const int node : fine.couplings[c].nodesA) {
      double nearest = 1;
      for (const int old : coarse.couplings[c].nodesA) nearest = std::min(nearest, (fine.parts[1].volume->nodes[node] - coarse.parts[1].volume->nodes[old]).norm());
      EXPECT_LT(nearest, half);
    }
  }
  EXPECT_TRUE(compileModel(fine, scenes::figure4Scenario()).ok());
  Joint elsewhere = coarse;
  TriMesh moved = *coarse.parts[1].visual;
  for (Vec3& v : moved.vertices) v.y() += 0.1;
  elsewhere.parts[1].visual = elsewhere.parts[1].collision = std::make_shared<const TriMesh>(moved);
  const auto refused = refineCells(elsewhere, 6);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().fault, Fault::BadNodes);
  EXPECT_EQ(refused.error().place.part, "c12");
}

TEST(RefineJoint, aCarriedStateMovesLikeTheCoarseOne) {
  const StudyScene scene = shippedScene();
  const auto coarse = compileModel(scene.joint, scene.scenario).value();
  const auto fine = compileModel(refineJoint(scene.joint, 3).value(), scene.scenario).value();
  // An affine motion of every node is carried exactly, whatever the cells.
  Mat3 F;
  F << 1.02, 0.01, 0, -0.03, 0.99, 0.02, 0, 0.01, 1.01;
  const auto moved = [&](const Vec3& x) -> Vec3 { return F * x + Vec3(0.01, -0.02, 0.03); };
  State state = coarse->start;
  for (const SceneObject& object : coarse->objects)
    for (int node = 0; node < object.layout.nodeCount; ++node) {
      auto x = state.q.segment<3>(object.layout.qOffset + 3 * node);
      state.v.segment<3>(object.layout.vOffset + 3 * node) = F * x;
      x = moved(x);
    }
  const State carried = carryToRefined(*coarse, state, *fine);
  for (const SceneObject& object : fine->objects)
    for (int node = 0; node < object.layout.nodeCount; ++node) {
      const Vec3 rest = fine->start.q.segment<3>(object.layout.qOffset + 3 * node);
      // Round-off of weights that extrapolate by a few cells at most, on lengths of 0.1 m.
      EXPECT_LT((carried.q.segment<3>(object.layout.qOffset + 3 * node) - moved(rest)).norm(), 1e-13);
      EXPECT_LT((carried.v.segment<3>(object.layout.vOffset + 3 * node) - F * rest).norm(), 1e-13);
    }
}

TEST(ContactState, aPressedStateHasAboutTheWantedContacts) {
  StudyScene scene = shippedScene();
  // The first pressing alone: the search then takes a second.
  ASSERT_FALSE(scene.input.marks.empty());
  scene.input.marks.resize(1);
  const double end = scene.input.marks[0].end;
  for (HandTrack& track : scene.input.tracks)
    std::erase_if(track.keys, [&](const HandKey& key) { return key.time > end; });
  const auto states = findContactStates(scene, {{65, 0, 1}, {65, 25, 1.5}}).value();
  ASSERT_EQ(states.size(), 2u);
  for (const ContactState& found : states) {
    EXPECT_NEAR(found.contacts, found.wanted, 0.03 * found.wanted);
    EXPECT_GE(found.pressing, found.loadFactor > 1 ? 18 : 12);
    // The state gives what it says, and is the same state twice.
    const auto model = compileModel(scene.joint, scenarioOf(scene, found)).value();
    Stepper stepper(model, {});
    State state = found.state;
    EXPECT_EQ(stepper.step(found.inputs, state).contacts, found.contacts);
  }
}

}  // namespace
}  // namespace glenoid::test
