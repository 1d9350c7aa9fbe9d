// SPDX-License-Identifier: GPL-3.0-or-later
// What no smaller repair makes sound, against volumes in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "simcore/mesh/MeshHealth.h"
#include "simcore/repair/Diagnose.h"
#include "simcore/repair/Wrap.h"
#include "tests/simcore/mesh/Shapes.h"

namespace glenoid {
namespace {

using shapes::box;
using shapes::joined;
using shapes::sphere;

TriMesh moved(TriMesh mesh, const Vec3& by, double factor = 1) {
  for (Vec3& v : mesh.vertices) v = factor * v + by;
  return mesh;
}

double volumeOf(const TriMesh& mesh) { return healthOf(mesh).volume; }

void expectSound(const TriMesh& mesh) {
  EXPECT_TRUE(healthOf(mesh).healthy());
  EXPECT_EQ(countSelfIntersections(mesh), 0);
}

constexpr double kRadius = 0.03;
const double kBall = 4 * std::numbers::pi / 3 * kRadius * kRadius * kRadius;

TEST(Wrap, aSoundBallKeepsItsVolumeAndItsPlace) {
  const TriMesh ball = moved(sphere(kRadius, 48, 31), Vec3(0.2, -0.1, 0.4));
  const TriMesh out = wrapped(ball, 0).value();
  expectSound(out);
  EXPECT_NEAR(volumeOf(out), volumeOf(ball), 0.01 * volumeOf(ball));
  EXPECT_LT((boundsOf(out).center() - boundsOf(ball).center()).norm(), 0.01 * kRadius);
  EXPECT_EQ(wrapped(ball, 0).value(), out) << "the same surface gives the same wrap";
}

TEST(Wrap, doesNotDependOnTheUnit) {
  const TriMesh ball = sphere(kRadius);
  constexpr double kFactor = 1 << 20;  // a power of two: rounding stays the same
  const TriMesh small = wrapped(ball, 1e-3).value(), large = wrapped(moved(ball, Vec3::Zero(), kFactor), 1e-3 * kFactor).value();
  ASSERT_EQ(small.triangles, large.triangles);
  for (std::size_t v = 0; v < small.vertices.size(); ++v) EXPECT_LT((kFactor * small.vertices[v] - large.vertices[v]).norm(), 1e-9 * kFactor * kRadius);
  EXPECT_NEAR(volumeOf(wrapped(moved(ball, Vec3::Zero(), 1000), 1).value()), 1e9 * volumeOf(small), 1e-3 * 1e9 * kBall);
}

// V = 2 ball − lens, the lens of two balls at the distance d: π (2 r − d)² (d² + 4 d r) / (12 d).
TEST(Wrap, ballsThroughEachOtherBecomeTheirUnion) {
  const double d = 1.2 * kRadius;
  const TriMesh both = joined(sphere(kRadius, 48, 31), moved(sphere(kRadius, 48, 31), Vec3(d, 0, 0)));
  ASSERT_GT(countSelfIntersections(both), 0);
  const double lens = std::numbers::pi * std::pow(2 * kRadius - d, 2) * (d * d + 4 * d * kRadius) / (12 * d);
  const TriMesh out = wrapped(both, 1e-3).value();
  expectSound(out);
  EXPECT_NEAR(volumeOf(out), 2 * kBall - lens, 0.02 * kBall);
}

TEST(Wrap, looseTrianglesTurnedAnyWayCloseOverHolesNarrowerThanItsWidth) {
  const TriMesh ball = sphere(kRadius, 48, 31);
  TriMesh soup;
  int number = 0;
  for (const auto& t : ball.triangles) {
    if (++number % 11 == 0) continue;  // a hole of one triangle, some 4 mm across
    const int base = static_cast<int>(soup.vertices.size());
    for (const int v : t) soup.vertices.push_back(ball.vertices[v]);
    soup.triangles.push_back(number % 3 ? std::array<int, 3>{base, base + 1, base + 2} : std::array<int, 3>{base, base + 2, base + 1});
  }
  const TriMesh out = wrapped(soup, 5e-3).value();
  expectSound(out);
  EXPECT_NEAR(volumeOf(out), kBall, 0.03 * kBall);
}

TEST(Wrap, piecesApartStayApartAndSheetsGetASmallThickness) {
  const TriMesh two = joined(sphere(kRadius), moved(sphere(kRadius), Vec3(3 * kRadius, 0, 0)));
  EXPECT_EQ(diagnose(wrapped(two, 2e-3).value()).shells, 2);
  TriMesh sheet;
  sheet.vertices = {{0, 0, 0}, {0.05, 0, 0}, {0.05, 0.02, 0}, {0, 0.02, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  const TriMesh out = wrapped(sheet, 1e-3).value();
  expectSound(out);
  EXPECT_GT(volumeOf(out), 0);
  EXPECT_LT(volumeOf(out), 0.05 * 0.02 * 1e-3);
}

TEST(Wrap, refusesWhatCannotBe) {
  const TriMesh ball = sphere(kRadius);
  EXPECT_EQ(wrapped(ball, 1e-5).error().fault, Fault::OutOfRange);  // millions of triangles
  EXPECT_EQ(wrapped(ball, 1.0).error().fault, Fault::OutOfRange);
  EXPECT_EQ(wrapped(TriMesh{}, 0).error().fault, Fault::BadMesh);
  TriMesh point;
  point.vertices = {Vec3::Ones(), Vec3::Ones(), Vec3::Ones()};
  point.triangles = {{0, 1, 2}};
  EXPECT_EQ(wrapped(point, 0).error().fault, Fault::BadMesh);
}

/// A body of many lobes through each other, with leaves across it and a hole: what is left of a bad segmentation.
TriMesh hopeless() {
  TriMesh mesh;
  for (int i = 0; i < 6; ++i) mesh = joined(mesh, moved(sphere(kRadius, 24, 15), Vec3(0.5 * kRadius * i, 0.3 * kRadius * (i % 2), 0)));
  mesh = joined(mesh, box({-kRadius / 2, -2e-4, -kRadius / 2}, {3 * kRadius, 2e-4, kRadius / 2}));
  mesh.triangles.resize(mesh.triangles.size() - 1);
  mesh.triangles[3] = {mesh.triangles[3][0], mesh.triangles[3][2], mesh.triangles[3][1]};
  return mesh;
}

TEST(Wrap, isWhatADiagnosisProposesWhereASurfaceCutsItselfAllOver) {
  const TriMesh mesh = hopeless();
  const SurfaceDiagnosis before = diagnose(mesh);
  const Finding* cuts = before.find(FindingKind::SelfIntersections);
  ASSERT_NE(cuts, nullptr);
  ASSERT_EQ(cuts->repairs.size(), 1u);
  EXPECT_EQ(cuts->repairs[0].kind, RepairKind::Wrap);
  std::set<FindingKind> all;
  for (const Finding& finding : before.findings) all.insert(finding.kind);
  const auto steps = repairsFor(before, all);
  const auto outcome = repair(mesh, steps);
  ASSERT_TRUE(outcome.ok()) << toLogLine(outcome.error());
  expectSound(outcome->mesh);
  EXPECT_TRUE(diagnose(outcome->mesh).healthy());
  EXPECT_LT((boundsOf(outcome->mesh).sizes() - boundsOf(mesh).sizes()).norm(), 0.02 * kRadius);
  EXPECT_GT(volumeOf(outcome->mesh), 1.9 * kBall);  // of the union; each ball beyond the first adds a slice of some 0.36
}

// An open surface with leaves lost two thirds of its volume when what cut it was cut out.
TEST(Repair, cuttingOutNeverEatsASurface) {
  for (TriMesh mesh : {hopeless(), joined(sphere(kRadius), moved(sphere(kRadius), Vec3(kRadius, 0, 0))),
                       joined(sphere(kRadius, 32, 21), moved(sphere(0.9 * kRadius, 32, 21), Vec3(0.2 * kRadius, 0, 0)))}) {
    RepairStep step;
    step.kind = RepairKind::RemoveSelfIntersections;
    const auto outcome = repair(mesh, {step});
    ASSERT_TRUE(outcome.ok());
    EXPECT_NEAR(volumeOf(outcome->mesh), volumeOf(mesh), 0.021 * std::abs(volumeOf(mesh)));
    EXPECT_GE(healthOf(outcome->mesh).area, 0.9 * healthOf(mesh).area);
    EXPECT_EQ(outcome->changes[0].changed + outcome->changes[0].left, diagnose(mesh).selfIntersections);
  }
}

}  // namespace
}  // namespace glenoid
