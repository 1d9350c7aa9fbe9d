// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/coupling/BondLimit.h"

#include <gtest/gtest.h>

#include "simcore/scene/JointFile.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

TEST(BondLimit, isAThinLayerOfTheSofterSidesStiffestTissue) {
  Joint joint = scenes::figure4Joint();  // bone 100 kPa (by default), tissue 50 kPa, faces of 4 cm²
  BondLimit limit = bondLimitOf(joint, joint.couplings[0]);
  EXPECT_DOUBLE_EQ(limit.modulus, 5e4) << "the bone does not give";
  EXPECT_NEAR(limit.area, 4e-4, 1e-12);
  EXPECT_NEAR(limit.stiffness, 4e4, 1e-6);
  EXPECT_DOUBLE_EQ(limit.most, 5e4 / 1e-4);
  EXPECT_NEAR(limit.areaForStiffness, 4e4 / (5e4 / 1e-3), 1e-9) << "8 cm² of a layer of 1 mm are as stiff";
  EXPECT_FALSE(limit.exceeded());
  joint.couplings[0].stiffnessPerArea = 1.01 * 5e4 / 1e-4;
  EXPECT_FALSE(bondLimitOf(joint, joint.couplings[0]).exceeded()) << "as large as a cell of 2 cm: it is the cell that gives";
  const std::vector<TriangleRun> whole = joint.parts[1].regions[0].triangles;
  joint.parts[1].regions[0].triangles = {{trianglesOf(joint.parts[1].regions[0])[0], 1}};
  EXPECT_TRUE(bondLimitOf(joint, joint.couplings[0]).exceeded());
  joint.couplings[0].stiffnessPerArea = 0.99 * 5e4 / 1e-4;
  EXPECT_FALSE(bondLimitOf(joint, joint.couplings[0]).exceeded());
  joint.parts[1].regions[0].triangles = whole;

  Material tendon = joint.materials[1];
  tendon.id = "tendon";
  tendon.youngsModulus = 5e6;
  joint.materials.push_back(tendon);
  joint.parts[1].materials.push_back({"tendon", "left-end"});
  EXPECT_DOUBLE_EQ(bondLimitOf(joint, joint.couplings[0]).modulus, 5e6);
  joint.parts[0].kind = PartKind::Soft;  // softer than the tendon: it gives first
  EXPECT_DOUBLE_EQ(bondLimitOf(joint, joint.couplings[0]).modulus, joint.materials[0].youngsModulus);
}

TEST(BondLimit, ofRigidPartsIsTheSofterBones) {
  Joint joint = scenes::figure4Joint();
  Part& left = joint.parts[0];
  left.regions.push_back(scenes::regionIn(left, "side", Box3(Vec3(-1, -1, -0.001), Vec3(1, 1, 0.001))));
  joint.couplings = {{"bones", "left", "right", "side", 1e7, 0, ""}};
  EXPECT_DOUBLE_EQ(bondLimitOf(joint, joint.couplings[0]).modulus, joint.materials[0].youngsModulus);
  joint.parts[0].materials.clear();
  joint.parts[2].materials.clear();
  EXPECT_EQ(bondLimitOf(joint, joint.couplings[0]).modulus, 0);
  EXPECT_FALSE(bondLimitOf(joint, joint.couplings[0]).exceeded()) << "no material, no limit";
}

TEST(BondLimit, shippedCouplingsAreTissue) {
  for (const char* name : {"shoulder", "shoulder-superficial", "shoulder-capsule"}) {
    const auto joint = loadJoint(std::string(GLENOID_SOURCE_DIR "/resources/joints/") + name + ".joint");
    ASSERT_TRUE(joint.ok());
    for (const Coupling& coupling : joint->couplings) EXPECT_FALSE(bondLimitOf(*joint, coupling).exceeded()) << coupling.id;
  }
}

}  // namespace
}  // namespace glenoid
