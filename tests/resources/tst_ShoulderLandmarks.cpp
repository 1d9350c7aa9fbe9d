// SPDX-License-Identifier: GPL-3.0-or-later
// Named points of the bones against those of one adult man, scaled so that his head radius is 24 mm.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "simcore/spatial/TriangleTree.h"
#include "tests/resources/Measures.h"
#include "tests/resources/ShoulderSizes.h"

namespace glenoid::test {
namespace {

constexpr double kNear = 4;  // mm

/// Measured on the reference body, times 1.0975. The acromion's points stand 4 mm higher in the joint, for
/// the subacromial gap of a healthy shoulder; the distance below counts that.
struct Point {
  const char *part, *id;
  Vec3 wanted;
};
const Point kPoints[] = {
    {"humerus", "head-centre", {0, 0, 0}},
    {"humerus", "head-top", {-1.1, 24.1, 0.4}},
    {"humerus", "head-apex", {-6.8, 11.6, -19.9}},
    {"humerus", "greater-tubercle-lateral", {2.0, 16.9, 26.7}},
    {"humerus", "greater-tubercle-top", {8.3, 22.2, 9.8}},
    {"humerus", "superior-facet", {9.0, 15.7, 23.3}},
    {"humerus", "middle-facet", {-8.2, 9.7, 24.7}},
    {"humerus", "inferior-facet", {-5.5, -5.5, 26.2}},
    {"humerus", "lesser-tubercle", {27.3, -0.8, 3.9}},
    {"humerus", "lesser-tubercle-facet", {23.8, 1.4, -2.2}},
    {"humerus", "groove-top", {17.0, 12.0, 10.9}},
    {"humerus", "groove-middle", {17.7, 3.2, 13.0}},
    {"humerus", "deltoid-tuberosity", {-3.7, -99.5, 42.8}},
    {"humerus", "lateral-epicondyle", {-16.0, -286.0, 86.6}},
    {"humerus", "medial-epicondyle", {-7.8, -292.2, 17.2}},
    {"scapula", "trigonum-spinae", {-77.8, -16.0, -113.4}},
    {"scapula", "inferior-angle", {-78.4, -136.0, -78.3}},
    {"scapula", "superior-angle", {-56.2, 28.9, -93.0}},
    {"scapula", "acromial-angle", {-42.9, 19.3, 1.4}},
    {"scapula", "acromion-tip", {4.6, 34.4, -5.8}},
    {"scapula", "acromion-anterolateral", {1.1, 34.1, -0.6}},
    {"scapula", "acromion-lateral", {-19.5, 32.1, 6.6}},
    {"scapula", "coracoid-tip", {29.2, 11.1, -30.3}},
    {"scapula", "glenoid-centre", {-11.7, -5.5, -23.1}},
    {"scapula", "glenoid-superior", {-1.4, 12.6, -26.5}},
    {"scapula", "glenoid-inferior", {-10.3, -21.2, -14.3}},
    {"scapula", "glenoid-anterior", {1.9, -13.9, -25.8}},
    {"scapula", "glenoid-posterior", {-23.0, -4.7, -14.1}},
    {"scapula", "supraglenoid-tubercle", {-10.5, 14.5, -24.9}},
};

TEST(ShoulderLandmarks, lieWhereTheReferenceBodyHasThem) {
  for (const Point& point : kPoints) {
    const double off = (landmark(partOf(shippedShoulder(), point.part), point.id) - point.wanted).norm();
    expectMeasure(std::string(point.id) + " from its place", off, "mm", {0, kNear, "anatomy.json x 1.0975"});
  }
}

/// The vertex that is farthest along a direction, of those that pass.
template <class Rule>
Vec3 extreme(const Part& part, const Vec3& direction, const Rule& rule) {
  Vec3 best = Vec3::Zero();
  double most = -1e300;
  for (const Vec3& metres : part.visual->vertices) {
    const Vec3 v = 1e3 * metres;
    if (rule(v) && v.dot(direction) > most) most = v.dot(direction), best = v;
  }
  return best;
}

TEST(ShoulderLandmarks, areWhereTheBonesEnd) {
  // The stored points might lie on the surface and yet not be what their names say: look for the extremes.
  const Part &humerus = partOf(shippedShoulder(), "humerus"), &scapula = partOf(shippedShoulder(), "scapula");
  const auto judge = [](const char* what, double found, double wanted) {
    expectMeasure(what, found, "mm", {wanted, kNear, "anatomy.json x 1.0975"});
  };
  const auto all = [](const Vec3&) { return true; };
  judge("most lateral point of the upper humerus, z",
        extreme(humerus, Vec3::UnitZ(), [](const Vec3& v) { return v.y() > -5; }).z(), 26.7);
  judge("most anterior point of the upper humerus, x",
        extreme(humerus, Vec3::UnitX(), [](const Vec3& v) { return v.y() > -15; }).x(), 27.3);
  judge("lowest point of the scapula, y", extreme(scapula, -Vec3::UnitY(), all).y(), -136.0);
  judge("most anterior point of the scapula, x", extreme(scapula, Vec3::UnitX(), all).x(), 29.2 + 3);
  judge("most medial point of the scapula, z", extreme(scapula, -Vec3::UnitZ(), all).z(), -113.4);
  judge("highest point of the blade's upper corner, y",
        extreme(scapula, Vec3::UnitY(), [](const Vec3& v) { return v.z() < -75; }).y(), 28.9);
}

TEST(ShoulderLandmarks, lieOnTheBone) {
  for (const char* id : {"scapula", "humerus"}) {
    const Part& bone = partOf(shippedShoulder(), id);
    const TriangleTree tree(*bone.visual);
    for (const Landmark& l : bone.landmarks) {
      if (l.id == "head-centre") continue;
      EXPECT_LT(tree.closest(l.position_W).distance, 1e-3) << l.id;
      EXPECT_NE(l.name.find('('), std::string::npos)
          << l.id << ": the anatomist's name with the lay name beside it";
    }
  }
}

TEST(ShoulderRegions, areNamedAndNotEmpty) {
  const std::pair<const char*, std::vector<const char*>> wanted[] = {
      {"scapula",
       {"glenoid-cartilage", "acromion", "acromial-angle", "coracoid", "coracoid-tip", "biceps-anchor",
        "supraspinous-fossa", "scapular-spine"}},
      {"humerus",
       {"head-cartilage", "bicipital-groove", "greater-tubercle", "superior-facet", "middle-facet",
        "inferior-facet", "lesser-tubercle", "lesser-tubercle-facet", "bare-area", "rotator-interval"}},
      {"labrum", {"base", "biceps-anchor"}},
      {"supraspinatus", {"origin", "insertion", "tendon"}},
      {"infraspinatus", {"origin", "insertion", "tendon"}},
      {"subscapularis", {"origin", "insertion", "tendon"}}};
  for (const auto& [part, regions] : wanted)
    for (const char* id : regions) {
      const TriMesh surface = surfaceOf(partOf(shippedShoulder(), part), id);
      std::printf("region %s %s: %zu triangles, %.0f mm2\n", part, id, surface.triangles.size(),
                  areaOf(surface));
      EXPECT_GE(surface.triangles.size(), 6u) << part << ' ' << id;
    }
}

}  // namespace
}  // namespace glenoid::test
