// SPDX-License-Identifier: GPL-3.0-or-later
// The bones and the cuff against surfaces of a real man, where those are at hand: distances part by part.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "simcore/spatial/TriangleTree.h"
#include "tests/resources/Measures.h"
#include "tests/resources/ReferenceMesh.h"
#include "tests/resources/ShoulderSizes.h"

namespace glenoid::test {
namespace {

struct Distances {
  double mean = 0, middle = 0, most = 0;  ///< mm; middle: the median; most: the 95th of a hundred
};

/// From points of one surface to the other.
Distances distances(const TriMesh& from, const TriMesh& to) {
  const TriangleTree tree(to);
  std::vector<std::pair<double, double>> list;
  double area = 0;
  for (const auto& t : from.triangles) {
    const Vec3 &a = from.vertices[t[0]], &b = from.vertices[t[1]], &c = from.vertices[t[2]];
    const double w = 0.5 * (b - a).cross(c - a).norm();
    list.push_back({tree.closest((a + b + c) / 3).distance, w});
    area += w;
  }
  std::sort(list.begin(), list.end());
  Distances d;
  double sum = 0;
  for (const auto& [distance, w] : list) {
    d.mean += distance * w / area;
    sum += w;
    if (sum < 0.5 * area) d.middle = distance;
    if (sum < 0.95 * area) d.most = distance;
  }
  return d;
}

TEST(ReferenceMeshes, bonesLieNearThoseOfAMan) {
  const auto folder = referenceFolder();
  if (!folder)
    GTEST_SKIP()
        << "no reference surfaces: put them in ../shared/data/anatomy or name them in GLENOID_ANATOMY";
  struct Row {
    const char *id, *file;
    bool bone;
  };
  const Row rows[] = {
      {"humerus", "bodyparts3d/humerus_FMA23130.stl", true},
      {"scapula", "zanatomy/scapula_right.stl", true},
      {"supraspinatus", "bodyparts3d/supraspinatus_FMA32544.stl", false},
      {"infraspinatus", "bodyparts3d/infraspinatus_FMA32547.stl", false},
      {"subscapularis", "bodyparts3d/subscapularis_FMA13414.stl", false},
      {"labrum", "zanatomy/glenoid_labrum_right.stl", false},
      {"coracohumeral-ligament", "zanatomy/coracohumeral_ligament_right.stl", false},
      {"transverse-humeral-ligament", "zanatomy/transverse_humeral_ligament_right.stl", false}};
  std::printf(
      "| distance to the reference | mean | median | 95 %% | as placed, mean | back, mean "
      "|\n|---|---|---|---|---|---|\n");
  for (const Row& row : rows) {
    const TriMesh theirs = referenceMesh(*folder, row.file);
    ASSERT_FALSE(theirs.triangles.empty()) << row.file;
    const TriMesh ours = inMillimetres(*partOf(shippedShoulder(), row.id).visual);
    const TriMesh fitted = aligned(ours, theirs, 30);
    const Distances there = distances(fitted, theirs), back = distances(theirs, fitted),
                    placed = distances(ours, theirs);
    std::printf("| %s | %.2f | %.2f | %.2f | %.2f | %.2f |\n", row.id, there.mean, there.middle, there.most,
                placed.mean, back.mean);
    if (row.bone) {
      EXPECT_LT(there.mean, 4) << row.id;
    }
  }
}

}  // namespace
}  // namespace glenoid::test
