// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/body/PartMass.h"

#include <gtest/gtest.h>

#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

const Vec3 kLow(0.1, 0.2, -0.3), kSize(0.04, 0.02, 0.03);

/// A box of bone (2000 kg/m³) whose top may weigh as tissue (1000 kg/m³) to some depth.
Joint boneWithTop(double thickness) {
  Joint joint;
  scenes::addMaterials(joint);
  joint.parts = {scenes::boxPart("bone", 1, PartKind::Rigid, kLow, kLow + kSize)};
  Part& bone = joint.parts[0];
  const double top = kLow.y() + kSize.y();
  bone.regions = {scenes::regionIn(bone, "top", Box3(Vec3(-1, top - 1e-6, -1), Vec3(1, top + 1e-6, 1)))};
  if (thickness > 0) bone.materials.push_back({"tissue", "top", thickness});
  return joint;
}

Mat3 boxAbout(double mass, const Vec3& size, const Vec3& centre, const Vec3& about) {
  const Vec3 s = size.cwiseAbs2(), r = centre - about;
  return mass / 12 * Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y()).asDiagonal().toDenseMatrix() +
         mass * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
}

TEST(PartMass, aFlatLayerIsTheBoxUnderIt) {
  const double t = 0.003;
  const Joint joint = boneWithTop(t);
  const auto found = massPropertiesOf(joint, joint.parts[0]);
  ASSERT_TRUE(found.ok());
  const Vec3 lowerSize(kSize.x(), kSize.y() - t, kSize.z()), layerSize(kSize.x(), t, kSize.z());
  const Vec3 lower = kLow + 0.5 * lowerSize, layer = kLow + Vec3(0, kSize.y() - t, 0) + 0.5 * layerSize;
  const double m1 = 2000 * lowerSize.prod(), m2 = 1000 * layerSize.prod();
  const Vec3 centre = (m1 * lower + m2 * layer) / (m1 + m2);
  const Mat3 inertia = boxAbout(m1, lowerSize, lower, centre) + boxAbout(m2, layerSize, layer, centre);
  EXPECT_NEAR(found->mass, m1 + m2, 1e-12 * m1);
  EXPECT_LT((found->centre - centre).norm(), 1e-12);
  // Steiner's terms of a box 0.4 m off the origin cancel to a ten-thousandth: 1e-12 of what is left.
  EXPECT_LT((found->inertia - inertia).norm(), 1e-10 * inertia.norm());
}

TEST(PartMass, withoutLayersNothingChangesByABit) {
  const Joint joint = boneWithTop(0);
  const auto whole = massPropertiesOf(*joint.parts[0].visual, 2000), found = massPropertiesOf(joint, joint.parts[0]);
  EXPECT_EQ(whole->mass, found->mass);
  EXPECT_EQ(whole->inertia, found->inertia);
}

TEST(PartMass, aLayerAllAroundABallIsTheShell) {
  // A ball of 25 mm with 2 mm of cartilage: 4/3 π (ρ r³ + ρ' (R³ − r³)), as its triangles have it.
  constexpr double R = 0.025, t = 0.002;
  TriMesh ball;
  constexpr int kRings = 60, kAround = 120;
  ball.vertices.push_back(Vec3(0, 0, R));
  for (int i = 1; i < kRings; ++i)
    for (int j = 0; j < kAround; ++j) {
      const double a = M_PI * i / kRings, b = 2 * M_PI * j / kAround;
      ball.vertices.push_back(R * Vec3(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)));
    }
  ball.vertices.push_back(Vec3(0, 0, -R));
  const auto at = [&](int i, int j) { return 1 + (i - 1) * kAround + j % kAround; };
  for (int j = 0; j < kAround; ++j) {
    ball.triangles.push_back({0, at(1, j), at(1, j + 1)});
    for (int i = 1; i + 1 < kRings; ++i) {
      ball.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      ball.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    ball.triangles.push_back({static_cast<int>(ball.vertices.size()) - 1, at(kRings - 1, j + 1), at(kRings - 1, j)});
  }
  Joint joint = boneWithTop(0);
  Part& part = joint.parts[0];
  part.visual = part.collision = std::make_shared<TriMesh>(ball);
  part.regions = {{"all", "all", "cartilage", SurfaceKind::Visual, {{0, static_cast<int>(ball.triangles.size())}}}};
  part.materials.push_back({"tissue", "all", t});
  const auto found = massPropertiesOf(joint, part);
  ASSERT_TRUE(found.ok());
  const double r = R - t, third = 4.0 / 3 * M_PI;
  const double inner = third * r * r * r, outer = third * (R * R * R - r * r * r);
  // Triangles of 3° cut off (π/60)²/4 of the volume.
  EXPECT_NEAR(found->mass, 2000 * inner + 1000 * outer, 2e-3 * found->mass);
  const double inertia = 0.4 * third * (2000 * std::pow(r, 5) + 1000 * (std::pow(R, 5) - std::pow(r, 5)));
  EXPECT_LT((found->inertia - inertia * Mat3::Identity()).norm(), 5e-3 * inertia);
}

TEST(PartMass, aLayerDeeperThanItsBodyIsRefused) {
  Joint joint = boneWithTop(0.1);
  joint.materials[1].density = 1;
  const auto found = massPropertiesOf(joint, joint.parts[0]);
  ASSERT_FALSE(found.ok());
  EXPECT_EQ(found.error().fault, Fault::BadMesh);
  EXPECT_EQ(found.error().place.part, "bone");
}

}  // namespace
}  // namespace glenoid
