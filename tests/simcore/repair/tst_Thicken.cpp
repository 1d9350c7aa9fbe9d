// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/mesh/MeshHealth.h"
#include "simcore/repair/Diagnose.h"
#include "tests/simcore/mesh/Shapes.h"

namespace glenoid {
namespace {

SurfaceDiagnosis after(const TriMesh& mesh, double thickness, TriMesh* out = nullptr) {
  const auto outcome = repair(mesh, {{RepairKind::Orient}, {RepairKind::Thicken, thickness}});
  EXPECT_TRUE(outcome.ok());
  if (out) *out = outcome->mesh;
  DiagnosisOptions options;
  options.metresPerUnit = 1;
  options.thinLimit = thickness;
  return diagnose(outcome->mesh, options);
}

TEST(Thicken, aSheetGetsTwoSidesAndARim) {
  TriMesh sheet;
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 5; ++j) sheet.vertices.push_back({0.005 * i, 0.005 * j, 0.01 * std::sin(0.3 * i)});
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 4; ++j) {
      const int a = 5 * i + j;
      sheet.triangles.push_back({a, a + 5, a + 6});
      sheet.triangles.push_back({a, a + 1, a + 6});  // wound against its neighbour
    }
  TriMesh thick;
  const SurfaceDiagnosis d = after(sheet, 0.001, &thick);
  EXPECT_TRUE(d.healthy());
  EXPECT_EQ(d.genus, 0);
  EXPECT_EQ(d.selfIntersections, 0);
  EXPECT_NEAR(d.thicknessMedian, 0.001, 0.05 * 0.001);
  EXPECT_GT(d.thicknessLeast, 0.9 * 0.001);
  EXPECT_EQ(thick.vertices.size(), 2 * sheet.vertices.size());
}

TEST(Thicken, aFlatPairOfTrianglesBecomesABox) {
  const TriMesh flat{{{0, 0, 0}, {0.03, 0, 0}, {0.03, 0.02, 0}, {0, 0.02, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  TriMesh thick;
  EXPECT_TRUE(after(flat, 0.002, &thick).healthy());
  EXPECT_NEAR(enclosedVolume(thick), 0.03 * 0.02 * 0.002, 1e-15);
}

TEST(Thicken, aThinShellReachesTheWishedThickness) {
  const TriMesh thin = shapes::sheet(0.04, 0.015, 0.0005, 0.8);
  const SurfaceDiagnosis d = after(thin, 0.0015);
  EXPECT_TRUE(d.healthy());
  EXPECT_EQ(d.selfIntersections, 0);
  EXPECT_GT(d.thicknessMedian, 0.95 * 0.0015);
  // Not fatter than asked for, either: along with its rim it grows by the difference.
  EXPECT_LT(d.thicknessMedian, 1.3 * 0.0015);
}

TEST(Thicken, wallsThatAreThickEnoughStay) {
  const TriMesh ball = shapes::sphere(0.02);
  const auto outcome = repair(ball, {{RepairKind::Thicken, 0.001}});
  ASSERT_TRUE(outcome.ok());
  EXPECT_EQ(outcome->mesh, ball);
  EXPECT_EQ(outcome->changes[0].changed, 0);
}

}  // namespace
}  // namespace glenoid
