// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/scene/RegionNear.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

Vec3 centreOf(const TriMesh& mesh, int t) {
  Vec3 sum = Vec3::Zero();
  for (const int v : mesh.triangles[t]) sum += mesh.vertices[v] / 3;
  return sum;
}

TEST(RegionNear, findsTheFaceThatLooksAtTheOther) {
  // A gap of 1 mm between x = 20 mm and x = 21 mm.
  const TriMesh a = scenes::boxSurface(Vec3(0, 0, 0), Vec3(0.02, 0.02, 0.02), 4);
  const TriMesh b = scenes::boxSurface(Vec3(0.021, 0, 0), Vec3(0.04, 0.02, 0.02), 4);
  EXPECT_TRUE(trianglesNear(a, b, 0.9e-3).empty());
  const std::vector<int> near = trianglesNear(a, b, 1.1e-3);
  EXPECT_EQ(near.size(), 32u) << "4 × 4 squares of two triangles";
  for (const int t : near) EXPECT_NEAR(centreOf(a, t).x(), 0.02, 1e-12);
  EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
}

TEST(RegionNear, countsWhatLiesInsideHoweverDeep) {
  const TriMesh a = scenes::boxSurface(Vec3(0, 0, 0), Vec3(0.02, 0.02, 0.02), 4);
  const TriMesh b = scenes::boxSurface(Vec3(0.005, -0.01, -0.01), Vec3(0.03, 0.03, 0.03), 2);
  for (const double distance : {0.0, 1e-4}) {
    const std::vector<int> near = trianglesNear(a, b, distance);
    std::vector<int> wanted;
    for (int t = 0; t < static_cast<int>(a.triangles.size()); ++t)
      if (centreOf(a, t).x() > 0.005 - distance) wanted.push_back(t);
    EXPECT_EQ(near, wanted);
  }
  const Box3 ofA(Vec3(0, 0, 0), Vec3(0.02, 0.02, 0.02));
  std::vector<int> wanted;
  for (int t = 0; t < static_cast<int>(b.triangles.size()); ++t)
    if (ofA.contains(centreOf(b, t))) wanted.push_back(t);
  EXPECT_EQ(wanted.size(), 2u) << "of the face that cuts through the first box";
  EXPECT_EQ(trianglesNear(b, a, 0), wanted);
}

TEST(RegionNear, nothingIsNearToNothing) {
  EXPECT_TRUE(trianglesNear(scenes::boxSurface(Vec3::Zero(), Vec3::Ones()), TriMesh{}, 1).empty());
  EXPECT_TRUE(trianglesNear(TriMesh{}, scenes::boxSurface(Vec3::Zero(), Vec3::Ones()), 1).empty());
}

}  // namespace
}  // namespace glenoid
