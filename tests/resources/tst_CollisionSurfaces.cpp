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
  double mean = 0, nearlyAll = 0, most = 0;  ///< nearlyAll: 95 % of the area lie nearer
};

/// From the fine surface to the coarse one, mm, over points of the fine triangles; weighted by area.
Deviation deviation(const TriMesh& fine, const TriangleTree& coarse) {
  Deviation d;
  double area = 0, nearer = 0;
  std::vector<std::pair<double, double>> list;
  for (const auto& t : fine.triangles) {
    const Vec3 &a = fine.vertices[t[0]], &b = fine.vertices[t[1]], &c = fine.vertices[t[2]];
    const double w = 0.5 * (b - a).cross(c - a).norm(), off = coarse.closest((a + b + c) / 3).distance;
    d.mean += w * off;
    d.most = std::max(d.most, off);
    area += w;
    list.push_back({off, w});
  }
  if (area > 0) d.mean /= area;
  std::sort(list.begin(), list.end());
  for (const auto& [off, w] : list) {
    nearer += w;
    d.nearlyAll = off;
    if (nearer >= 0.95 * area) break;
  }
  return d;
}

/// The triangles that face down.
TriMesh undersideOf(const TriMesh& surface) {
  TriMesh down = surface;
  std::erase_if(down.triangles, [&](const std::array<int, 3>& t) {
    const Vec3 &a = surface.vertices[t[0]], &b = surface.vertices[t[1]], &c = surface.vertices[t[2]];
    return (b - a).cross(c - a).normalized().y() > -0.5;
  });
  return down;
}

/// Judged are 95 % of what touches: with the triangles of the paper's table single points stand off farther,
/// at most as printed (the socket's rim and the tubercles' edges are sharper than a few triangles can be).
TEST(CollisionSurfaces, lieWithinAMillimetreWhereContactHappens) {
  const Joint& joint = shippedShoulder();
  std::printf("| collision surface | mean, mm | 95 %%, mm | most, mm |\n|---|---|---|---|\n");
  const auto print = [](const std::string& what, const Deviation& d) {
    std::printf("| %s | %.2f | %.2f | %.2f |\n", what.c_str(), d.mean, d.nearlyAll, d.most);
  };
  for (const Part& part : joint.parts) {
    print(part.id + ", all of it",
          deviation(inMillimetres(*part.visual), TriangleTree(inMillimetres(*part.collision))));
  }
  const std::pair<const char*, const char*> places[] = {
      {"humerus", "head-cartilage"},  {"humerus", "bicipital-groove"},      {"humerus", "greater-tubercle"},
      {"humerus", "lesser-tubercle"}, {"humerus", "superior-facet"},        {"humerus", "middle-facet"},
      {"humerus", "inferior-facet"},  {"humerus", "lesser-tubercle-facet"}, {"scapula", "glenoid-cartilage"},
      {"scapula", "acromion"}};
  for (const auto& [id, region] : places) {
    const Part& part = partOf(joint, id);
    const bool isRoof = std::string(region) == "acromion";
    const TriMesh surface = isRoof ? undersideOf(surfaceOf(part, region)) : surfaceOf(part, region);
    ASSERT_FALSE(surface.triangles.empty()) << region;
    const Deviation d = deviation(surface, TriangleTree(inMillimetres(*part.collision)));
    print(part.id + ", " + region + (isRoof ? ", underside" : ""), d);
    EXPECT_LT(d.nearlyAll, 1.0) << region;
  }
}

}  // namespace
}  // namespace glenoid::test
