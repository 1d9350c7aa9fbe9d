// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/ProposeExclusions.h"

#include <gtest/gtest.h>

#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

TEST(ProposeExclusions, bondedFacesShouldNotCollide) {
  const Joint joint = scenes::figure4Joint();
  const auto proposals = proposeExclusions(joint);
  ASSERT_EQ(proposals.size(), 2u);
  EXPECT_EQ(proposals[0].partA, "left");
  EXPECT_EQ(proposals[0].partB, "middle");
  EXPECT_NEAR(proposals[0].bonded, 4e-4, 1e-12) << "20 × 20 mm";
  // The smaller part is the 30 × 20 × 20 mm box: 3200 mm².
  EXPECT_NEAR(proposals[0].ofPart, 400.0 / 3200, 1e-9);
  EXPECT_GT(proposals[0].ofNear, 0.6);
}

TEST(ProposeExclusions, notForWhatIsExcludedNorForAFewTriangles) {
  Joint joint = scenes::figure4Joint();
  joint.exclusions.push_back({"middle", "left", "bonded"});
  ASSERT_EQ(proposeExclusions(joint).size(), 1u) << "either order counts";
  Region& region = joint.parts[1].regions[1];
  region.triangles = {{region.triangles[0].first, 2}};
  EXPECT_TRUE(proposeExclusions(joint).empty());
}

TEST(ProposeExclusions, severalCouplingsCountTogetherAndOnce) {
  Joint joint = scenes::figure4Joint();
  joint.couplings.push_back(joint.couplings[0]);
  joint.couplings.back().id = "again";
  const auto proposals = proposeExclusions(joint);
  ASSERT_EQ(proposals.size(), 2u);
  EXPECT_NEAR(proposals[0].bonded, 4e-4, 1e-12);
  joint.couplings.clear();
  EXPECT_TRUE(proposeExclusions(joint).empty());
}

TEST(ProposeExclusions, aCouplingThatRefersToNothingIsPassedOver) {
  Joint joint = scenes::figure4Joint();
  joint.couplings[0].regionA = "missing";
  joint.couplings[1].partB = "missing";
  EXPECT_TRUE(proposeExclusions(joint).empty());
}

}  // namespace
}  // namespace glenoid
