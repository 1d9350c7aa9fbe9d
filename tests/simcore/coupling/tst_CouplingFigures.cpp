// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/coupling/CouplingFigures.h"

#include <gtest/gtest.h>

#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

TEST(CouplingFigures, ofAFaceBondedToABlock) {
  const Joint joint = scenes::figure4Joint();
  const auto figures = couplingFigures(joint, 0, {"left"});
  ASSERT_TRUE(figures.ok());
  EXPECT_EQ(figures->springs, 16) << "four to each of the face's 2 × 2 cells";
  EXPECT_EQ(figures->anchors_W.size(), 16u);
  EXPECT_NEAR(figures->area, 4e-4, 1e-12);
  // The block is 40 × 20 × 20 mm: 4000 mm² around.
  EXPECT_NEAR(figures->coverage, 0.1, 1e-9);
  EXPECT_NEAR(figures->stiffness, 1e8 * 4e-4, 1e-6);
  EXPECT_NEAR(figures->maxGap, 0, 1e-9);
  EXPECT_EQ(figures->island, 0);
}

TEST(CouplingFigures, gapIsMeasuredToTheOtherSurface) {
  Joint joint = scenes::figure4Joint();
  TriMesh moved = *joint.parts[0].visual;
  for (Vec3& v : moved.vertices) v.x() -= 2e-3;
  joint.parts[0].visual = std::make_shared<TriMesh>(moved);
  const auto figures = couplingFigures(joint, 0);
  ASSERT_TRUE(figures.ok());
  EXPECT_NEAR(figures->meanGap, 2e-3, 1e-9);
  EXPECT_NEAR(figures->maxGap, 2e-3, 1e-9);
}

TEST(CouplingFigures, sayWhyThereAreNone) {
  Joint joint = scenes::figure4Joint();
  joint.couplings[0].regionA = "missing";
  EXPECT_EQ(couplingFigures(joint, 0).error().fault, Fault::UnknownId);
  joint = scenes::figure4Joint();
  joint.parts[1].volume = nullptr;
  EXPECT_EQ(couplingFigures(joint, 0).error().fault, Fault::Unusable);
}

TEST(CouplingFigures, islandsFollowTheCouplings) {
  Joint joint = scenes::figure4Joint();
  EXPECT_EQ(islandsOfParts(joint, {"left"}), (std::vector<int>{-1, 0, 0}));
  joint.couplings.pop_back();
  EXPECT_EQ(islandsOfParts(joint, {}), (std::vector<int>{0, 0, 1}));
}

TEST(SuggestedStiffness, isThatOfALayerOfTheSofterTissue) {
  const Joint joint = scenes::figure4Joint();
  EXPECT_DOUBLE_EQ(suggestedStiffness(joint, "left", "middle"), 5e4 / joint.parts[1].cellSize);
  EXPECT_DOUBLE_EQ(suggestedStiffness(joint, "left", "right"), 1e5 / 5e-3) << "bone's modulus over 5 mm";
  EXPECT_DOUBLE_EQ(suggestedStiffness(joint, "nobody", "nothing"), 5e4 / 5e-3);
}

}  // namespace
}  // namespace glenoid
