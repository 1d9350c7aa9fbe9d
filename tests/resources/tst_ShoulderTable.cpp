// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "simcore/mesh/MeshHealth.h"
#include "simcore/mesh/TetTools.h"
#include "tests/resources/ShoulderSizes.h"

namespace glenoid::test {
namespace {

/// Table 1 of the paper. An odd number of triangles cannot close a surface, hence the tolerances.
struct Row {
  int number;
  const char* id;
  bool soft;
  int visual, collision, tetrahedra;
};
constexpr Row kTable[] = {
    {1, "scapula", false, 10224, 105, 0},
    {2, "humerus", false, 5189, 112, 0},
    {3, "supraspinatus", true, 1716, 86, 87},
    {4, "infraspinatus", true, 2136, 96, 129},
    {5, "subscapularis", true, 2424, 100, 158},
    {6, "coracoacromial-ligament", true, 1632, 146, 65},
    {7, "coracohumeral-ligament", true, 522, 60, 86},
    {8, "transverse-humeral-ligament", false, 264, 28, 0},
    {9, "labrum", true, 636, 120, 96},
    {10, "labrum-tendon", true, 128, 128, 122},
    {11, "biceps-tendon", false, 264, 264, 0},
};

TEST(Shoulder, hasTheElevenPartsOfTableOne) {
  const Joint& joint = shippedShoulder();
  ASSERT_EQ(joint.parts.size(), std::size(kTable));
  for (const Row& row : kTable) {
    const Part& part = partOf(joint, row.id);
    EXPECT_EQ(part.number, row.number);
    EXPECT_EQ(part.kind == PartKind::Soft, row.soft) << row.id;
    EXPECT_NEAR(double(part.visual->triangles.size()), row.visual, 0.05 * row.visual) << row.id;
    EXPECT_NEAR(double(part.collision->triangles.size()), row.collision, std::max(0.05 * row.collision, 4.0))
        << row.id;
    if (row.soft) {
      EXPECT_NEAR(double(part.volume->tets.size()), row.tetrahedra, 0.15 * row.tetrahedra) << row.id;
    }
  }
}

TEST(Shoulder, surfacesAreClosedAndDoNotCutThemselves) {
  for (const Part& part : shippedShoulder().parts) {
    const MeshHealth visual = healthOf(*part.visual), collision = healthOf(*part.collision);
    EXPECT_TRUE(visual.healthy()) << part.id;
    EXPECT_TRUE(collision.healthy()) << part.id;
    EXPECT_EQ(collision.components, 1) << part.id;
    EXPECT_EQ(collision.genus, part.id == "labrum" ? 1 : 0) << part.id;
    EXPECT_EQ(countSelfIntersections(*part.collision), 0) << part.id;
    if (part.volume) {
      EXPECT_TRUE(healthOf(*part.volume).healthy()) << part.id;
    }
  }
}

TEST(Shoulder, hasTheCouplingsOfTableOne) {
  const Joint& joint = shippedShoulder();
  std::map<std::pair<int, int>, int> found;
  for (const Coupling& c : joint.couplings) {
    const int a = partOf(joint, c.partA).number, b = partOf(joint, c.partB).number;
    ++found[{std::min(a, b), std::max(a, b)}];
    const Region* region = findRegion(partOf(joint, c.partA), c.regionA);
    ASSERT_NE(region, nullptr) << c.id;
    const double total = c.stiffnessPerArea * areaOf(partOf(joint, c.partA), *region);
    EXPECT_GE(total, 1e4) << c.id;
    EXPECT_LE(total, 1e6) << c.id;
  }
  const std::map<std::pair<int, int>, int> wanted{
      {{1, 3}, 1}, {{1, 4}, 1}, {{1, 5}, 1}, {{1, 6}, 2}, {{1, 7}, 1},  {{1, 9}, 1},  {{2, 3}, 1},
      {{2, 4}, 1}, {{2, 5}, 1}, {{2, 7}, 1}, {{2, 8}, 2}, {{2, 11}, 1}, {{9, 10}, 1}, {{10, 11}, 1}};
  EXPECT_EQ(found, wanted);
}

TEST(Shoulder, materialsSayWhatTheyScale) {
  for (const Material& m : shippedShoulder().materials) {
    EXPECT_FALSE(m.source.empty()) << m.id;
    if (m.literatureYoungsModulus && *m.literatureYoungsModulus != m.youngsModulus) {
      EXPECT_FALSE(m.reason.empty()) << m.id;
    }
  }
}

}  // namespace
}  // namespace glenoid::test
