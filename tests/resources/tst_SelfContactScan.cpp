// SPDX-License-Identifier: GPL-3.0-or-later
// A scanned subscapularis folded over itself, where reference meshes lie beside the repository: gripped at both ends, one end
// swung over the other. Depths are those of PenetrationCheck, which shares nothing with the search.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "simcore/author/MakeBody.h"
#include "simcore/collide/Penetration.h"
#include "simcore/repair/RepairStep.h"
#include "simcore/spatial/Intersect.h"
#include "simcore/step/Stepper.h"
#include "tests/resources/ReferenceMesh.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

/// Long, middle and short axis of a surface's vertices, as columns, right-handed.
Mat3 axesOf(const TriMesh& mesh, const Vec3& centre) {
  Mat3 spread = Mat3::Zero();
  for (const Vec3& x : mesh.vertices) spread += (x - centre) * (x - centre).transpose();
  const Mat3 vectors = Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors();
  Mat3 axes;
  axes << vectors.col(2), vectors.col(1), vectors.col(2).cross(vectors.col(1));
  return axes;
}

struct Folded {
  double deepest = 0, last = 0, force = 0, ms = 0, selfMs = 0;
  int rows = 0, refused = 0, triangles = 0;
};

Folded fold(const Part& muscle, double thickness, bool effect) {
  Vec3 centre = Vec3::Zero();
  for (const Vec3& x : muscle.visual->vertices) centre += x / static_cast<double>(muscle.visual->vertices.size());
  const Mat3 axes = axesOf(*muscle.visual, centre);
  double low = 1, high = -1;
  for (const Vec3& x : muscle.visual->vertices) {
    const double along = axes.col(0).dot(x - centre);
    low = std::min(low, along);
    high = std::max(high, along);
  }
  Joint joint;
  joint.id = joint.name = "scan";
  scenes::addMaterials(joint);
  Part part = muscle;
  const auto grip = [&](const char* id, double from, double to) {
    std::vector<int> triangles;
    for (std::size_t t = 0; t < part.visual->triangles.size(); ++t) {
      const auto [i, j, k] = part.visual->triangles[t];
      const double along = axes.col(0).dot((part.visual->vertices[i] + part.visual->vertices[j] + part.visual->vertices[k]) / 3 - centre);
      if (along >= from && along <= to) triangles.push_back(static_cast<int>(t));
    }
    part.regions.push_back({id, id, "footprint", SurfaceKind::Visual, runsOf(triangles)});
    Vec3 middle = Vec3::Zero();
    for (const int t : triangles)
      for (const int v : part.visual->triangles[t]) middle += part.visual->vertices[v] / (3.0 * static_cast<double>(triangles.size()));
    return middle;
  };
  const double span = high - low;
  const Vec3 nearEnd = grip("near", low, low + 0.12 * span);
  const Vec3 farEnd = grip("far", high - 0.12 * span, high);
  joint.parts.push_back(part);
  const Vec3 half = Vec3::Constant(0.004);
  joint.parts.push_back(scenes::boxPart("still", 2, PartKind::Rigid, centre + low * axes.col(0) - half, centre + low * axes.col(0) + half));
  joint.parts.push_back(scenes::boxPart("swung", 3, PartKind::Rigid, centre + high * axes.col(0) - half, centre + high * axes.col(0) + half));
  joint.couplings.push_back({"near", "scan", "still", "near", 1e7, 1e-2, ""});
  joint.couplings.push_back({"far", "scan", "swung", "far", 1e7, 1e-2, ""});
  for (const auto& [a, b] : {std::pair{"scan", "still"}, {"scan", "swung"}, {"still", "swung"}}) joint.exclusions.push_back({a, b, ""});

  Scenario scenario;
  scenario.id = scenario.name = "scan";
  scenario.gravity_W.setZero();
  scenario.fixedParts = {"still", "swung"};
  scenario.selfContactParts = {"scan"};
  if (!effect) scenario.effects.selfContact = Wish::Off;
  Motion motion;
  motion.part = "swung";
  motion.centre_W = centre;
  constexpr int kKeys = 16;
  // The far end comes over the near one, and down until their middles would lie a third of a thickness apart.
  const Mat3 over = Eigen::AngleAxisd(-std::numbers::pi, axes.col(1)).toRotationMatrix();
  const Vec3 meet = nearEnd - centre - over * (farEnd - centre);
  for (int i = 0; i <= kKeys; ++i) {
    const double share = double(i) / kKeys, angle = std::numbers::pi * share;
    MotionKey key;
    key.time = 1.5 * share;
    key.displacement_W = share * meet + thickness * (std::sin(angle) + 2 * share) * axes.col(2);
    key.turn_W = Quat(Eigen::AngleAxisd(-angle, axes.col(1)));
    motion.keys.push_back(key);
  }
  MotionKey down = motion.keys.back();
  down.time = 2;
  down.displacement_W = meet + thickness / 3 * axes.col(2);
  motion.keys.push_back(down);
  scenario.motions.push_back(motion);

  const auto model = compileModel(joint, scenario).value();
  Stepper stepper(model, {});
  State state = model->start;
  const SceneObject& object = model->objects[0];
  PenetrationCheck check({makeCollisionSurface(*object.collision.mesh)}, {{0, 0, {}, {}}});
  std::vector<Vec3> x(object.collision.vertices.size());
  const std::span<const Vec3> spans[] = {x};
  Folded folded;
  folded.triangles = static_cast<int>(object.collision.mesh->triangles.size());
  constexpr int kSteps = 420;
  for (int i = 0; i < kSteps; ++i) {
    const StepReport& report = stepper.step({}, state);
    folded.refused += !report.taken;
    folded.ms += report.stepCpuMs / kSteps;
    folded.selfMs += report.cpuMs[static_cast<int>(Stage::SelfContact)] / kSteps;
    folded.force = 0;
    int rows = 0;
    for (const ContactView& view : report.contactViews)
      if (view.objectA == view.objectB) {
        ++rows;
        folded.force += view.force;
      }
    folded.rows = std::max(folded.rows, rows);
    surfacePositions(object.collision, object.layout, state.q, x);
    folded.last = check.deepest(spans).depth;
    folded.deepest = std::max(folded.deepest, folded.last);
  }
  std::printf("scan, effect %s: %d triangles, deepest %.4f mm, at the end %.4f mm; at most %d rows, %.2f N on itself; a step %.2f ms, its search %.2f ms\n",
              effect ? "on" : "off", folded.triangles, 1e3 * folded.deepest, 1e3 * folded.last, folded.rows, folded.force, folded.ms, folded.selfMs);
  return folded;
}

TEST(SelfContactScan, aSubscapularisFoldsOntoItself) {
  const auto folder = test::referenceFolder();
  if (!folder) GTEST_SKIP() << "the third-party surfaces are not here; GLENOID_ANATOMY may name their folder";
  TriMesh scanned = test::referenceMesh(*folder, "bodyparts3d/subscapularis_FMA13414.stl");
  if (scanned.triangles.empty()) GTEST_SKIP() << "no scan of a subscapularis in " << *folder;
  for (Vec3& x : scanned.vertices) x *= 1e-3;
  const auto untangled = [](const TriMesh& mesh) { return repair(mesh, {{RepairKind::RemoveSelfIntersections}}).value().mesh; };
  scanned = untangled(scanned);
  Part muscle;
  muscle.id = muscle.name = "scan";
  muscle.number = 1;
  muscle.visual = std::make_shared<TriMesh>(scanned);
  muscle.materials = {{"tissue", ""}};
  BodyWish wish;
  wish.kind = PartKind::Soft;
  wish.collisionTriangles = 500;
  wish.cellSize = 0.006;
  const Result<Body> body = makeBody(muscle, wish);
  ASSERT_TRUE(body.ok()) << toLogLine(body.error());
  muscle.kind = PartKind::Soft;
  muscle.collision = std::make_shared<TriMesh>(untangled(*body->collision));
  ASSERT_TRUE(selfIntersections(*muscle.collision).empty());
  muscle.volume = body->volume;
  muscle.cellSize = wish.cellSize;
  const double thickness = makeCollisionSurface(*muscle.collision)->thickness;
  std::printf("scan: %d triangles, thickness %.1f mm, %d tetrahedra\n", static_cast<int>(scanned.triangles.size()), 1e3 * thickness,
              body->figures.tetrahedra);
  const Folded on = fold(muscle, thickness, true), off = fold(muscle, thickness, false);
  EXPECT_EQ(on.refused, 0);
  EXPECT_GT(on.force, 0.1);
  EXPECT_LT(on.deepest, 0.2e-3);
  EXPECT_GT(off.deepest, 1e-3);
}

}  // namespace
}  // namespace glenoid
