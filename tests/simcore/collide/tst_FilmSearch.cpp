// SPDX-License-Identifier: GPL-3.0-or-later
// Which vertices feel a film: those that look at the roof, near it, and not past its rim.
#include <gtest/gtest.h>

#include "simcore/collide/FilmSearch.h"

namespace glenoid {
namespace {

constexpr double kThickness = 2e-3;

/// A roof of two triangles in the plane y = 0 that looks down, 2 cm wide, and a sheet of four triangles around one
/// vertex under it, looking up, 8 mm wide.
struct Sheets {
  TriMesh roof{{{-0.01, 0, -0.01}, {0.01, 0, -0.01}, {0.01, 0, 0.01}, {-0.01, 0, 0.01}}, {{0, 1, 2}, {0, 2, 3}}};
  TriMesh floor{{{0, 0, 0}, {-0.004, 0, -0.004}, {0.004, 0, -0.004}, {0.004, 0, 0.004}, {-0.004, 0, 0.004}},
                {{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 1, 4}}};

  std::vector<FilmTouch> touches(const Vec3& shift, const Mat3& turned = Mat3::Identity()) const {
    std::vector<Vec3> moved;
    for (const Vec3& p : floor.vertices) moved.push_back(turned * p + shift);
    const std::vector<std::span<const Vec3>> positions{moved, roof.vertices};
    FilmSearch search({{{0, 0}}, {{1, 0}, {1, 1}}}, {makeCollisionSurface(floor), makeCollisionSurface(roof)}, kThickness, 7);
    return search.find(positions);
  }
};

TEST(FilmSearch, aVertexUnderTheRoofFeelsItByItsGapAndArea) {
  const auto touches = Sheets().touches({0.003, -0.001, 0.002});
  ASSERT_EQ(touches.size(), 1u);
  const Proximity& near = touches[0].near;
  EXPECT_NEAR(near.gap, 1e-3, 1e-15);
  EXPECT_LT((near.normal_W - Vec3(0, -1, 0)).norm(), 1e-12);
  EXPECT_NEAR(touches[0].area, 0.008 * 0.008 / 3, 1e-15);
  Vec3 foot = Vec3::Zero();
  for (int i = 0; i < 3; ++i) foot += near.b.weight[i] * Sheets().roof.vertices[near.b.vertex[i]];
  EXPECT_LT((foot - Vec3(0.003, 0, 0.002)).norm(), 1e-12);
  // The same vertex elsewhere under the roof, over the other triangle: its name stays.
  const auto slid = Sheets().touches({-0.003, -0.0005, 0.005});
  ASSERT_EQ(slid.size(), 1u);
  EXPECT_EQ(slid[0].near.key, near.key);
  EXPECT_NE(slid[0].near.b.vertex, near.b.vertex);
}

TEST(FilmSearch, insideTheRoofTheGapIsNegativeDownToADepth) {
  const auto inside = Sheets().touches({0, 0.002, 0});
  ASSERT_EQ(inside.size(), 1u);
  EXPECT_NEAR(inside[0].near.gap, -0.002, 1e-15);
  EXPECT_LT((inside[0].near.normal_W - Vec3(0, -1, 0)).norm(), 1e-12);
  EXPECT_TRUE(Sheets().touches({0, 1.05 * FilmSearch::kDepth, 0}).empty());
}

TEST(FilmSearch, whatIsFarOrBesideOrTurnedAwayFeelsNothing) {
  EXPECT_EQ(Sheets().touches({0, -0.99 * FilmSearch::kMargin * kThickness, 0}).size(), 1u);
  EXPECT_TRUE(Sheets().touches({0, -1.01 * FilmSearch::kMargin * kThickness, 0}).empty());
  EXPECT_TRUE(Sheets().touches({0.012, -0.001, 0}).empty()) << "beside the rim: 63 degrees off";
  EXPECT_EQ(Sheets().touches({0.0105, -0.001, 0}).size(), 1u) << "at the rim: 27 degrees off";
  Mat3 over;
  over << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  EXPECT_TRUE(Sheets().touches({0, -0.001, 0}, over).empty()) << "the under side of a tendon";
}

TEST(FilmSearch, placesThatAreNoNumbersGiveNothing) {
  EXPECT_TRUE(Sheets().touches({std::nan(""), -0.001, 0}).empty());
  Sheets broken;
  for (Vec3& v : broken.roof.vertices) v.setConstant(std::nan(""));
  EXPECT_TRUE(broken.touches({0, -0.001, 0}).empty());
}

}  // namespace
}  // namespace glenoid
