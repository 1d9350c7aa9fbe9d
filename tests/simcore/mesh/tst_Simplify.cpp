// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/Simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "simcore/mesh/MeshHealth.h"
#include "tests/simcore/mesh/Shapes.h"

using namespace glenoid;

namespace {

double worstShape(const TriMesh& mesh) {
  double worst = 1;
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    worst = std::min(worst, 2 * std::sqrt(3.0) * (b - a).cross(c - a).norm() / squares);
  }
  return worst;
}

/// What every answer for a smooth closed surface has to fulfil; ±5 % or 4 triangles of the target.
TriMesh checked(const TriMesh& mesh, int target) {
  const auto result = simplify(mesh, target);
  EXPECT_TRUE(result.ok());
  const TriMesh& out = result.value();
  const MeshHealth before = healthOf(mesh), after = healthOf(out);
  EXPECT_TRUE(after.healthy());
  EXPECT_EQ(after.genus, before.genus);
  EXPECT_EQ(after.components, before.components);
  EXPECT_EQ(countSelfIntersections(out), 0);
  EXPECT_NEAR(after.triangles, target, std::max(4.0, 0.05 * target));
  // The last step shifts to the volume of the original; 1e-9 is where its iteration stops.
  EXPECT_NEAR(after.volume / before.volume, 1, 2e-9);
  EXPECT_GT(worstShape(out), 0.02);
  if (std::getenv("GLENOID_PRINT"))
    std::printf("target %d got %d worst shape %.3f\n", target, after.triangles, worstShape(out));
  return out;
}

}  // namespace

TEST(Simplify, smoothShapesReachSmallTargets) {
  for (const int target : {28, 60, 105, 146, 264}) {
    SCOPED_TRACE(target);
    checked(shapes::sphere(0.024), target);
    checked(shapes::capsule(0.003, 0.08), target);
    checked(shapes::sphere(0.024, 100, 50), target);  // 10 000 triangles
  }
  for (const int target : {60, 120, 264}) {
    SCOPED_TRACE(target);
    checked(shapes::torus(0.016, 0.0025, 64, 12), target);
  }
}

TEST(Simplify, thinBentSheetsStayOpenInside) {
  for (const int target : {28, 60, 86, 146}) {
    SCOPED_TRACE(target);
    checked(shapes::sheet(0.034, 0.014, 0.0016, 0.6), target);
    checked(shapes::sheet(0.12, 0.06, 0.012, 1.2, 40, 26), target);
  }
}

TEST(Simplify, sliversOfTheInputDoNotStandInTheWay) {
  checked(shapes::sphere(0.024, 300, 7), 105);  // strips twenty times as long as wide
  checked(shapes::capsule(0.003, 0.08, 6, 400), 60);
  // Vertices of a fine sphere slid along it at random, as marching through a grid leaves them.
  TriMesh rough = shapes::sphere(0.024, 60, 39);
  unsigned seed = 1;
  for (Vec3& v : rough.vertices) {
    const double size = 0.05 * std::hypot(v.x(), v.z());  // less than half the spacing everywhere
    for (int k = 0; k < 3; ++k) v[k] += size * ((seed = seed * 1664525u + 1013904223u) / 4294967296.0 - 0.5);
  }
  for (Vec3& v : rough.vertices) v *= 0.024 / v.norm();
  ASSERT_EQ(countSelfIntersections(rough), 0);
  for (const int target : {28, 112, 500}) checked(rough, target);
}

TEST(Simplify, surfaceThatCutsItselfStillReachesTheTarget) {
  TriMesh pierced = shapes::sphere(0.024);
  for (Vec3& v : pierced.vertices)  // the lower cap pushed up through the upper one
    if (v.y() < -0.018) v.y() += 0.045;
  ASSERT_GT(countSelfIntersections(pierced), 0);
  const TriMesh out = simplify(pierced, 100).value();
  EXPECT_TRUE(healthOf(out).closed());
  EXPECT_TRUE(healthOf(out).manifold());
  EXPECT_LE(out.triangles.size(), 104u);
}

TEST(Simplify, thinPlateKeepsItsRim) {
  const TriMesh plate = shapes::sheet(0.10, 0.08, 0.003, 0.4, 60, 60);
  const TriMesh out = checked(plate, 106);
  // A rim drawn in by collapses would show in the extents; the chords of twenty-odd rim vertices cost 2 %.
  const Vec3 before = boundsOf(plate).diagonal(), after = boundsOf(out).diagonal();
  EXPECT_NEAR(after.x() / before.x(), 1, 0.05);
  EXPECT_NEAR(after.y() / before.y(), 1, 0.05);
}

TEST(Simplify, sphereStaysNearTheSphere) {
  const TriMesh out = checked(shapes::sphere(1.0, 64, 39), 112);
  // Regular facets at this number are tangent 4 % below the radius and stand out as much at their corners.
  for (const Vec3& v : out.vertices) EXPECT_NEAR(v.norm(), 1.0, 0.08);
}

TEST(Simplify, boxKeepsItsCorners) {
  // Each face subdivided: all inner vertices are redundant, the twelve triangles of the box are exact.
  TriMesh fine = shapes::box(Vec3::Zero(), Vec3(0.03, 0.02, 0.01));
  for (int level = 0; level < 3; ++level) {
    TriMesh next;
    std::map<std::pair<int, int>, int> middle;
    next.vertices = fine.vertices;
    const auto mid = [&](int a, int b) {
      const auto key = std::minmax(a, b);
      const auto [at, isNew] = middle.try_emplace(key, static_cast<int>(next.vertices.size()));
      if (isNew) next.vertices.push_back((next.vertices[a] + next.vertices[b]) / 2);
      return at->second;
    };
    for (const auto& t : fine.triangles) {
      const int a = mid(t[0], t[1]), b = mid(t[1], t[2]), c = mid(t[2], t[0]);
      for (const std::array<int, 3> s : {std::array{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}})
        next.triangles.push_back(s);
    }
    fine = next;
  }
  ASSERT_EQ(fine.triangles.size(), 768u);
  SimplifyOptions plain;
  plain.keepVolume = false;
  const TriMesh out = simplify(fine, 60, plain).value();
  EXPECT_LE(out.triangles.size(), 60u);
  EXPECT_NEAR(enclosedVolume(out) / 6e-6, 1, 0.02);
  const Box3 bounds = boundsOf(out);
  EXPECT_LT((bounds.max() - Vec3(0.03, 0.02, 0.01)).norm() + bounds.min().norm(), 5e-4);
}

TEST(Simplify, importanceDrawsTrianglesToItself) {
  const TriMesh ball = shapes::sphere(0.024, 60, 30);
  const auto above = [](const TriMesh& mesh) {
    int count = 0;
    for (const auto& t : mesh.triangles)
      count += mesh.vertices[t[0]].z() + mesh.vertices[t[1]].z() + mesh.vertices[t[2]].z() > 0;
    return count;
  };
  SimplifyOptions options;
  const TriMesh even = simplify(ball, 200, options).value();
  EXPECT_NEAR(above(even), 100, 25);
  for (const Vec3& v : ball.vertices) options.importance.push_back(v.z() > 0 ? 100 : 1);
  const auto result = simplify(ball, 200, options);
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(healthOf(*result).healthy());
  EXPECT_NEAR(static_cast<double>(result->triangles.size()), 200, 10);
  // The error of a smooth surface falls with the square of the triangles, so a hundredfold error draws about ten times
  // as many; shape rules leave some of the others.
  EXPECT_GT(above(*result), 145);
  options.importance.assign(ball.vertices.size(), 7.0);
  EXPECT_EQ(simplify(ball, 200, options).value(), even) << "the same everywhere is none";
}

TEST(Simplify, badImportanceIsRefused) {
  const TriMesh ball = shapes::sphere(0.024, 12, 6);
  SimplifyOptions options;
  options.importance = {1, 2, 3};
  EXPECT_EQ(simplify(ball, 20, options).error().fault, Fault::BadIndex);
  for (const double wrong : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    options.importance.assign(ball.vertices.size(), 1);
    options.importance[5] = wrong;
    EXPECT_EQ(simplify(ball, 20, options).error().fault, Fault::OutOfRange);
  }
}

TEST(Simplify, isRepeatable) {
  const TriMesh mesh = shapes::torus(0.016, 0.0025, 64, 12);
  EXPECT_EQ(simplify(mesh, 120).value(), simplify(mesh, 120).value());
}

TEST(Simplify, largeSurfaceGoesThroughBothStages) {
  checked(shapes::sphere(0.05, 300, 199), 200);  // 119 400 triangles
}

TEST(Simplify, smallSurfaceComesBackUnchanged) {
  const TriMesh box = shapes::box(Vec3::Zero(), Vec3::Ones());
  EXPECT_EQ(simplify(box, 12).value(), box);
  EXPECT_EQ(simplify(box, 100).value(), box);
}

TEST(Simplify, badInputIsRefused) {
  TriMesh open = shapes::sphere(0.02);
  EXPECT_EQ(simplify(open, 3).error().fault, Fault::OutOfRange);
  open.triangles.pop_back();
  EXPECT_EQ(simplify(open, 50).error().fault, Fault::MeshNotClosed);
  EXPECT_EQ(simplify(TriMesh{}, 50).error().fault, Fault::BadMesh);
}
