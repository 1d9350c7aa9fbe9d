// SPDX-License-Identifier: GPL-3.0-or-later
// The clavicle of the shoulder for palpation against published sizes. Its sternal end is judged by the bone's
// length: the landmark of the scaled reference lies 15 mm farther in than a clavicle of the published length
// reaches.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simcore/mesh/MeshHealth.h"
#include "simcore/scene/JointFile.h"
#include "tests/resources/Measures.h"
#include "tests/resources/ShoulderSizes.h"

namespace glenoid::test {
namespace {

const TriMesh& clavicle() {
  static const TriMesh mesh = [] {
    const Result<Joint> joint = loadJoint(GLENOID_SOURCE_DIR "/resources/joints/shoulder-superficial.joint");
    return joint ? inMillimetres(*partOf(*joint, "clavicle").visual) : TriMesh{};
  }();
  return mesh;
}

/// Middle of the bone's section at a share of the way from its sternal to its acromial end.
Cut sectionAt(double place) {
  double inner = 1e9, outer = -1e9;
  for (const Vec3& v : clavicle().vertices) inner = std::min(inner, v.z()), outer = std::max(outer, v.z());
  const Vec3 at(0, 0, inner + place * (outer - inner));
  return cutBy(clavicle(), at, Vec3::UnitZ());
}

TEST(Clavicle, measuresAsPublished) {
  ASSERT_FALSE(clavicle().triangles.empty());
  EXPECT_TRUE(healthOf(clavicle()).healthy());
  const Extents size = principalExtents(clavicle());
  expectMeasure("length of the clavicle", size.size[0], "mm", {152, 11, "Andermahr 2007, men"});
  // The end stands 4 mm higher, as the acromion does, for the subacromial gap of a healthy shoulder.
  expectMeasure("acromial end of the clavicle from its place",
                (sectionAt(0.985).middle - Vec3(-8.5, 38.4 + 4, -17.7)).norm(), "mm",
                {0, 4, "anatomy.json x 1.0975"});
}

TEST(Clavicle, isBentLikeAnSAndFlatAtItsAcromialEnd) {
  ASSERT_FALSE(clavicle().triangles.empty());
  const Vec3 first = sectionAt(0.06).middle, last = sectionAt(0.94).middle;
  const auto ahead = [&](double place) {
    const Vec3 p = sectionAt(place).middle;
    const double t = (p.z() - first.z()) / (last.z() - first.z());
    return p.x() - (first.x() + t * (last.x() - first.x()));
  };
  const double inner = ahead(0.35), outer = ahead(0.8);
  std::printf(
      "the clavicle's middle stands %.1f mm before the line between its ends at a third, %.1f mm at four "
      "fifths\n",
      inner, outer);
  EXPECT_GT(inner, 6) << "the inner two thirds bulge forward";
  EXPECT_LT(outer, inner - 8) << "the outer third bulges back";
  const Cut flat = sectionAt(0.9);
  const double wide = extentAlong(flat.points, Vec3(1, 0, 0)), high = extentAlong(flat.points, Vec3::UnitY());
  std::printf("section near the acromial end: %.1f x %.1f mm\n", wide, high);
  EXPECT_GT(wide, 1.3 * high);
}

}  // namespace
}  // namespace glenoid::test
