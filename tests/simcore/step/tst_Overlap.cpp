// SPDX-License-Identifier: GPL-3.0-or-later
// What lies deep in each other when a run begins comes apart, at a bounded cost a step.
#include <gtest/gtest.h>

#include <cmath>

#include "simcore/collide/Penetration.h"
#include "simcore/step/StepModel.h"
#include "simcore/step/Stepper.h"
#include "simcore/study/truth/TruthBlocks.h"
#include "tests/simcore/spatial/Shapes.h"

namespace glenoid {
namespace {

constexpr double kRadius = 0.015, kRecovery = 0.1;  // m, m/s

Part ball(const std::string& id, int number, const Vec3& centre, int fineness) {
  Part part;
  part.id = part.name = id;
  part.number = number;
  part.kind = PartKind::Rigid;
  part.visual = part.collision = std::make_shared<TriMesh>(shapes::sphere(centre, kRadius, fineness));
  part.materials = {{"bone", ""}};
  return part;
}

struct Parting {
  double depth = 0;      ///< m, at the end
  double apart = 0;      ///< s, when nothing was inside any more
  double workMost = 0;   ///< StepReport::contactWork
  double fastest = 0;    ///< m/s, of any surface point
  int partsMost = 1, deepSteps = 0, unsettled = 0, bounded = 0;
};

class Scene {
 public:
  explicit Scene(const truth::TruthScene& scene)
      : m_model(compileModel(scene.joint, scene.scenario).value()), m_stepper(m_model, {}), m_check(m_model->collisionSurfaces, m_model->collisionPairs) {
    state = m_model->start;
    for (const SceneObject& object : m_model->objects) {
      m_positions.emplace_back(object.collision.vertices.size());
      m_velocities.emplace_back(object.collision.vertices.size(), Vec3::Zero());
    }
    m_spans.assign(m_positions.begin(), m_positions.end());
  }
  double depth() {
    for (std::size_t i = 0; i < m_positions.size(); ++i)
      surfacePositions(m_model->objects[i].collision, m_model->objects[i].layout, state.q, m_positions[i]);
    return m_check.deepest(m_spans).depth;
  }
  double fastest() {
    double most = 0;
    for (std::size_t i = 0; i < m_positions.size(); ++i) {
      const SceneObject& object = m_model->objects[i];
      if (!object.layout.free) continue;
      surfaceVelocities(object.collision, object.layout, state.q, state.v, m_velocities[i]);
      for (const Vec3& v : m_velocities[i]) most = std::max(most, v.norm());
    }
    return most;
  }
  const StepReport& step() { return m_stepper.step({}, state); }
  Parting part(double seconds) {
    Parting result;
    const double dt = m_model->scenario.dt;
    for (int i = 0; i < std::lround(seconds / dt); ++i) {
      const StepReport& report = step();
      EXPECT_TRUE(report.taken);
      result.workMost = std::max(result.workMost, report.contactWork);
      result.partsMost = std::max(result.partsMost, report.parts);
      result.deepSteps += report.deepOverlaps > 0;
      result.unsettled += report.pivotsExhausted;
      result.bounded += report.bounded.any();
      result.fastest = std::max(result.fastest, fastest());
      result.depth = depth();
      if (result.depth > 0) result.apart = state.time;
    }
    return result;
  }
  const Model& model() const { return *m_model; }
  State state;

 private:
  std::shared_ptr<const Model> m_model;
  Stepper m_stepper;
  PenetrationCheck m_check;
  std::vector<std::vector<Vec3>> m_positions, m_velocities;
  std::vector<std::span<const Vec3>> m_spans;
};

truth::TruthScene emptyScene() {
  truth::TruthScene scene = truth::namedScene("overlap");
  scene.scenario.effects.gravity = Wish::Off;
  scene.scenario.recoverySpeedMax = kRecovery;
  return scene;
}

TEST(Overlap, ballsPastEachOthersMiddleLeaveAtTheRecoverySpeedAlongTheLineOfTheirCentres) {
  truth::TruthScene scene = emptyScene();
  const Vec3 way = Vec3(2, -1, 0.5).normalized();
  const double distance = 0.5 * kRadius;
  scene.joint.parts = {ball("one", 1, Vec3::Zero(), 3), ball("two", 2, distance * way, 3)};
  Scene run(scene);
  const ObjectLayout &one = run.model().objects[0].layout, &two = run.model().objects[1].layout;
  const Vec3 before = run.state.q.segment<3>(two.qOffset) - run.state.q.segment<3>(one.qOffset);
  for (int i = 0; i < 6; ++i) EXPECT_GT(run.step().deepOverlaps, 0);
  const Vec3 moved = run.state.q.segment<3>(two.qOffset) - run.state.q.segment<3>(one.qOffset) - before;
  // One against the other, which is as fast as their distance grows.
  EXPECT_NEAR(moved.norm(), kRecovery * run.state.time, 0.02 * kRecovery * run.state.time);
  EXPECT_GT(moved.normalized().dot(way), std::cos(0.03));
  // As heavy as each other: each goes half the way.
  EXPECT_LT((run.state.v.segment<3>(one.vOffset) + run.state.v.segment<3>(two.vOffset)).norm(), 1e-9);
  const Parting rest = run.part((2 * kRadius - distance) / kRecovery + 0.1);
  EXPECT_EQ(rest.depth, 0);
  EXPECT_EQ(rest.unsettled + rest.bounded, 0);
}

TEST(Overlap, bonesAndTissueComeApartWhateverTheirTriangles) {
  for (const double friction : {0.0, 0.4})
    for (const bool soft : {false, true})
      for (const int fine : {3, 7}) {
        if (friction > 0 && fine > 3) continue;
        truth::TruthScene scene = emptyScene();
        for (Material& material : scene.joint.materials) material.friction = friction;
        // Two bars of 20 × 60 × 20 mm side by side, 14 mm of their 20 in each other.
        scene.joint.parts = {truth::boxPart("bone", 1, PartKind::Rigid, {0, 0, 0}, {0.02, 0.06, 0.02}),
                             truth::boxPart("other", 2, soft ? PartKind::Soft : PartKind::Rigid, {0.006, 0.004, 0.003}, {0.026, 0.064, 0.023}, 3)};
        for (Part& part : scene.joint.parts) {
          const Box3 box = boundsOf(*part.visual);
          part.collision = std::make_shared<TriMesh>(truth::boxSurface(box.min(), box.max(), fine));
        }
        scene.scenario.fixedParts = {"bone"};
        Scene run(scene);
        EXPECT_GT(run.depth(), 0.005);
        const Parting parting = run.part(0.4);
        SCOPED_TRACE(std::string(soft ? "soft" : "rigid") + ", " + std::to_string(fine) + ", friction " + std::to_string(friction));
        std::printf("overlap: %s fine %d friction %.1f: apart after %.3f s, deep in %d steps, parts %d, work %.1e, fastest %.2f m/s, unsettled %d\n",
                    soft ? "soft" : "rigid", fine, friction, parting.apart, parting.deepSteps, parting.partsMost, parting.workMost, parting.fastest, parting.unsettled);
        EXPECT_EQ(parting.depth, 0);
        EXPECT_LT(parting.apart, 0.3);
        EXPECT_EQ(parting.bounded, 0);
        // A fiftieth of what a step may cost.
        EXPECT_LT(parting.workMost, 2e6);
        EXPECT_LT(parting.fastest, 10 * kRecovery);
      }
}

TEST(Overlap, aStepEndsWhateverShapeTissueIsIn) {
  // Three blocks in each other's place, every node anywhere: hundreds of rows that contradict each other.
  truth::TruthScene scene = emptyScene();
  for (int i = 0; i < 3; ++i) {
    const Vec3 low(0.004 * i, 0.003 * (i % 2), 0.005 * (i / 2));
    scene.joint.parts.push_back(truth::boxPart("block" + std::to_string(i), 1 + i, PartKind::Soft, low, low + Vec3::Constant(0.03), 4));
    Part& part = scene.joint.parts.back();
    part.collision = std::make_shared<TriMesh>(truth::boxSurface(low, low + Vec3::Constant(0.03), 5));
  }
  Scene run(scene);
  shapes::Numbers numbers(7);
  for (Eigen::Index i = 0; i < run.state.q.size(); ++i) run.state.q[i] = numbers.in(0, 0.04);
  const StepReport& report = run.step();
  std::printf("scattered: rows %d, work %.1e, left out %d, rounds %d, searches %d, parts %d\n", report.contactSolver.rowsMax, report.contactWork,
              report.bounded.rows, report.bounded.rounds, report.bounded.searches, report.bounded.parts);
  EXPECT_TRUE(run.state.q.allFinite());
  EXPECT_TRUE(report.bounded.any()) << "the scene is worth the test";
  EXPECT_LT(report.contactWork, 6e8);
}

}  // namespace
}  // namespace glenoid
