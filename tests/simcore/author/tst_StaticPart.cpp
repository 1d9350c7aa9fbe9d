// SPDX-License-Identifier: GPL-3.0-or-later
// A block pressed at one place: the fine static solve against the half-space, and the table made of it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "simcore/author/MakeDents.h"
#include "simcore/mesh/TetTools.h"
#include "simcore/scene/JointFile.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

constexpr double kRadius = 3e-3, kSide = 0.04, kModulus = 1e5;

/// A cube, or less high, glued to the ground by its lower face, in a few coarse cells.
Joint gluedBlock(double poisson = 0.4, double height = kSide) {
  Joint joint;
  joint.id = "block";
  scenes::addMaterials(joint);
  for (Material& material : joint.materials)
    if (material.id == "tissue") material.youngsModulus = kModulus, material.poissonRatio = poisson;
  const Vec3 low(-kSide / 2, -height, -kSide / 2), high(kSide / 2, 0, kSide / 2);
  joint.parts = {scenes::boxPart("ground", 1, PartKind::Rigid, low - Vec3(0, kSide, 0), Vec3(high.x(), low.y(), high.z())),
                 scenes::boxPart("block", 2, PartKind::Soft, low, high)};
  Part& block = joint.parts[1];
  block.visual = block.collision = std::make_shared<const TriMesh>(scenes::boxSurface(low, high, 10));
  block.regions = {scenes::regionIn(block, "base", Box3(Vec3(-1, low.y() - 1e-6, -1), Vec3(1, low.y() + 1e-6, 1)))};
  Coupling glue;
  glue.id = "glue";
  glue.partA = "block";
  glue.regionA = "base";
  glue.partB = "ground";
  glue.stiffnessPerArea = 1e10;
  joint.couplings = {glue};
  return joint;
}

double fineCompliance(const Joint& joint, double finer) {
  const TipPatch patch = tipPatchAt(*joint.parts[1].visual, Vec3(1e-3, 0, 2e-3), kRadius);
  GradedCells cells = fineCells(joint.parts[1], kRadius);
  cells.finest /= finer;
  cells.coarsest /= finer;
  auto mesh = embedGraded(joint.parts[1], patch, cells).value();
  EXPECT_TRUE(healthOf(mesh).healthy());
  return StaticPart::make(joint, 1, std::make_shared<const TetMesh>(std::move(mesh)), TetFilling::Whole).value().compliance(patch);
}

TEST(StaticPart, aPatchOnABlockGivesAsOnAHalfSpace) {
  for (const double poisson : {0.2, 0.4}) {
    // Mean under an even pressure on a disk, less what a half-space still moves at the depth of the ground.
    const double a = kRadius, disk = 16 * (1 - poisson * poisson) / (3 * std::pow(std::numbers::pi, 2) * a * kModulus);
    const double ground = (1 + poisson) * (3 - 2 * poisson) / (2 * std::numbers::pi * kModulus * kSide);
    const Joint joint = gluedBlock(poisson);
    const double fine = fineCompliance(joint, 1), finer = fineCompliance(joint, 1.4);
    std::printf("ν %.1f: half-space %.4e to %.4e m/N, fine %.4e, finer %.4e\n", poisson, disk - ground, disk, fine, finer);
    EXPECT_GT(finer, fine) << "linear tetrahedra are too stiff, less so where finer";
    EXPECT_LT(finer / fine - 1, 0.15);  // 10 and 11 %; the error is of first order where elements are cut by the patch
    EXPECT_GT(finer, 0.9 * (disk - ground));
    EXPECT_LT(finer, 1.03 * disk);
  }
}

TEST(StaticPart, aPatchIsADiskOnAFlatFace) {
  const TipPatch patch = tipPatchAt(*gluedBlock().parts[1].visual, Vec3(1e-3, 5e-3, 2e-3), kRadius);
  EXPECT_LT((patch.middle_W - Vec3(1e-3, 0, 2e-3)).norm(), 1e-12);
  EXPECT_LT((patch.normal_W - Vec3::UnitY()).norm(), 1e-12);
  double sum = 0, spread = 0;
  for (std::size_t s = 0; s < patch.points_W.size(); ++s) {
    sum += patch.weights[s];
    spread += patch.weights[s] * (patch.points_W[s] - patch.middle_W).squaredNorm();
  }
  EXPECT_NEAR(sum, 1, 1e-12);
  EXPECT_NEAR(spread, kRadius * kRadius / 2, 0.05 * kRadius * kRadius);
}

TEST(StaticPart, whatNothingHoldsIsRefused) {
  Joint joint = gluedBlock();
  joint.couplings.clear();
  const auto part = StaticPart::make(joint, 1, joint.parts[1].volume, TetFilling::Partial);
  ASSERT_FALSE(part.ok());
  EXPECT_EQ(part.error().fault, Fault::Unusable);
}

TEST(MakeDents, aTableSaysWhatALayerGivesAndIsTheSameAgain) {
  Joint joint = gluedBlock(), again = joint;
  DentWishes wishes;
  wishes.radius = 1.5e-3;
  wishes.places = 3;
  ASSERT_TRUE(makeDents(joint, wishes).ok());
  ASSERT_TRUE(makeDents(again, wishes).ok());
  ASSERT_TRUE(joint.parts[1].dents);
  EXPECT_FALSE(joint.parts[0].dents) << "a rigid part has none";
  const DentTable& table = *joint.parts[1].dents;
  EXPECT_EQ(table, *again.parts[1].dents);
  EXPECT_EQ(table.basis, dentBasis(joint, joint.parts[1]));
  ASSERT_EQ(table.samples.size(), 3u);
  for (const DentSample& sample : table.samples) {
    EXPECT_NEAR(sample.modulus, kModulus / (1 - 0.4 * 0.4), 1e-6);
    EXPECT_GT(sample.depthMost, 0);
    EXPECT_LE(sample.depthMost, 0.41 * kSide);
    for (std::size_t k = 1; k < table.radii.size(); ++k) EXPECT_LT(sample.compliance[k], sample.compliance[k - 1]) << "the wider the harder";
  }
  joint.materials[1].youngsModulus *= 2;
  EXPECT_NE(table.basis, dentBasis(joint, joint.parts[1]));
  // Of another block, whose cells and height are not those that the table's correction was measured on: a half-space less what
  // that still moves at the depth of the ground, to a tenth: by so much it matters how cells lie to the surface.
  Joint coarser = gluedBlock();
  coarser.parts[1].volume = std::make_shared<const TetMesh>(scenes::boxVolume(Vec3(-kSide / 2, -kSide, -kSide / 2), Vec3(kSide / 2, 0, kSide / 2), 3, 3, 3));
  EXPECT_EQ(dentBasis(coarser, coarser.parts[1]), again.parts[1].dents->basis) << "a table does not know of the run's cells";
  DentWishes top = wishes;
  Part& block = coarser.parts[1];
  block.regions.push_back(scenes::regionIn(block, "top", Box3(Vec3(-0.004, -1e-6, -0.004), Vec3(0.004, 1e-6, 0.004))));
  block.materials.push_back({block.materials[0].material, "top"});
  top.places = 1;
  ASSERT_TRUE(makeDents(coarser, top).ok());
  const DentSample& middle = block.dents->samples.back();
  ASSERT_NEAR(middle.at_W.y(), 0, 1e-9);
  const double ground = (1 + 0.4) * (3 - 2 * 0.4) / (2 * std::numbers::pi * kModulus * kSide);
  for (std::size_t k = 0; k < block.dents->radii.size(); ++k) {
    const double disk = 16 / (3 * std::pow(std::numbers::pi, 2) * middle.modulus * block.dents->radii[k]);
    std::printf("%.1f mm: %.4e m/N, half-space %.4e to %.4e\n", 1e3 * block.dents->radii[k], middle.compliance[k], disk - ground, disk);
    EXPECT_GT(middle.compliance[k], 0.9 * (disk - ground));
    EXPECT_LT(middle.compliance[k], 1.1 * disk);
  }
}

TEST(MakeDents, tissueThinnerThanTheFineCellsHasNone) {
  for (const double height : {0.1e-3, 0.2e-3, 0.3e-3, 1e-3}) {
    Joint joint = gluedBlock(0.4, height);
    const auto made = makeDents(joint, {1.5e-3, 2, ""});
    ASSERT_TRUE(made.ok()) << height << " " << toLogLine(made.error());
    ASSERT_EQ(made->size(), 1u);
    EXPECT_EQ((*made)[0].part, 1);
    EXPECT_EQ((*made)[0].count, 2);
    if (height < 0.25e-3) EXPECT_EQ((*made)[0].tooThin, 2) << height;
    if (height >= 1e-3) EXPECT_EQ((*made)[0].tooThin, 0) << height;
    if ((*made)[0].tooThin == 2) {
      EXPECT_FALSE(joint.parts[1].dents) << height;
      continue;
    }
    ASSERT_TRUE(joint.parts[1].dents) << height;
    for (const DentSample& sample : joint.parts[1].dents->samples) {
      if (const double y = sample.at_W.y(); y > -1e-9 || y < -height + 1e-9) EXPECT_LE(sample.depthMost, 0.41 * height) << "from above, not at the rim";
    }
  }
}

TEST(MakeDents, aCancelLeavesTheJointAsItWas) {
  Joint joint = gluedBlock();
  const auto made = makeDents(joint, {kRadius, 3, ""}, [](const std::string&, double) { return false; });
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().fault, Fault::Cancelled);
  EXPECT_FALSE(joint.parts[1].dents);
}

}  // namespace
}  // namespace glenoid
