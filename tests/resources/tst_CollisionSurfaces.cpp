// SPDX-License-Identifier: GPL-3.0-or-later
// How far the coarse surfaces that touch stand from the fine ones that are seen, part by part.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "simcore/spatial/TriangleTree.h"
#include "tests/resources/Measures.h"
#include "tests/resources/ShoulderSizes.h"

namespace glenoid::test {
namespace {

struct Deviation {
  double mean = 0, most = 0;
};

/// From the fine surface to the coarse one, mm, over points of the fine triangles; weighted by area.
Deviation deviation(const TriMesh& fine, const TriangleTree& coarse) {
  Deviation d;
  double area = 0;
  for (const auto& t : fine.triangles) {
    const Vec3 &a = fine.vertices[t[0]], &b = fine.vertices[t[1]], &c = fine.vertices[t[2]];
    const double w = 0.5 * (b - a).cross(c - a).norm(), off = coarse.closest((a + b + c) / 3).distance;
    d.mean += w * off;
    d.most = std::max(d.most, off);
    area += w;
  }
  if (area > 0) d.mean /= area;
  return d;
}

/// Judged is the mean: with the triangles of the paper's table single points stand off farther, at most as
/// printed (the socket's rim and the roof's edges are sharper than a few triangles can be).
TEST(CollisionSurfaces, lieWithinAMillimetreWhereContactHappens) {
  const Joint& joint = shippedShoulder();
  std::printf("| collision surface | mean, mm | most, mm |\n|---|---|---|\n");
  for (const Part& part : joint.parts) {
    const Deviation d = deviation(inMillimetres(*part.visual), TriangleTree(inMillimetres(*part.collision)));
    std::printf("| %s, all of it | %.2f | %.2f |\n", part.id.c_str(), d.mean, d.most);
  }
  const std::pair<const char*, const char*> places[] = {{"humerus", "head-cartilage"},
                                                        {"humerus", "bicipital-groove"},
                                                        {"scapula", "glenoid-cartilage"},
                                                        {"scapula", "acromion"}};
  for (const auto& [id, region] : places) {
    const Part& part = partOf(joint, id);
    const Deviation d = deviation(surfaceOf(part, region), TriangleTree(inMillimetres(*part.collision)));
    std::printf("| %s, %s | %.2f | %.2f |\n", id, region, d.mean, d.most);
    EXPECT_LT(d.mean, 1.0) << region;
  }
}

}  // namespace
}  // namespace glenoid::test
