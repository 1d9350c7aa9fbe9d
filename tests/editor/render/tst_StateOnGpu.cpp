// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/body/SurfaceBinding.h"
#include "simcore/reading/UnderSkin.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "tests/editor/render/PictureCheck.h"
#include "tests/editor/render/TestScene.h"

namespace glenoid::test {
namespace {

using StateOnGpu = Drawing;

/// Float numbers of up to 0.2 m, ten operations: 10 · 2⁻²⁴ · 0.2 m.
constexpr double kFloatLength = 1.2e-7;

void expectPositions(SceneRenderer& renderer, const Model& model, const VecX& q) {
  for (int i = 0; i < static_cast<int>(model.objects.size()); ++i)
    for (const SurfaceKind kind : {SurfaceKind::Visual, SurfaceKind::Collision}) {
      const SceneObject& object = model.objects[i];
      const SurfaceBinding& surface = kind == SurfaceKind::Visual ? object.visual : object.collision;
      const auto gpu = renderer.evaluated(i, kind, q);
      ASSERT_EQ(gpu.positions_W.size(), surface.vertices.size());
      double worst = 0;
      for (std::size_t v = 0; v < surface.vertices.size(); ++v)
        worst = std::max(
            worst,
            (gpu.positions_W[v].cast<double>() - expectedPosition(object, surface.vertices[v], q)).norm());
      EXPECT_LT(worst, kFloatLength) << object.id;
    }
}

TEST_F(StateOnGpu, positionsEqualThoseOfTheCpu) {
  const Model model = smallScene();
  ASSERT_TRUE(m_renderer->setScene(model).ok());
  expectPositions(*m_renderer, model, model.start.q);
  expectPositions(*m_renderer, model, movedState(model).q);
  expectPositions(*m_renderer, model, model.start.q);  // and back again: nothing is kept that should not be
}

TEST_F(StateOnGpu, normalsAreAreaWeighted) {
  const Model model = smallScene();
  ASSERT_TRUE(m_renderer->setScene(model).ok());
  const VecX q = movedState(model).q;
  for (const int i : {kSphere, kBall}) {  // no crease: one normal for each vertex
    const SceneObject& object = model.objects[i];
    const auto gpu = m_renderer->evaluated(i, SurfaceKind::Visual, q);
    std::vector<Vec3> sums(object.visual.vertices.size(), Vec3::Zero());
    const auto at = [&](int v) { return expectedPosition(object, object.visual.vertices[v], q); };
    for (const auto& t : object.visual.mesh->triangles) {
      const Vec3 area = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
      for (const int v : t) sums[v] += area;
    }
    for (std::size_t v = 0; v < sums.size(); ++v)
      // Edges of 2 mm known to 1e-8 m: an angle of 1e-5, a few of which add up.
      EXPECT_LT((gpu.normals_W[v].cast<double>() - sums[v].normalized()).norm(), 5e-5)
          << object.id << " " << v;
  }
}

TEST_F(StateOnGpu, aTurnedBoxTakesItsNormalsAlong) {
  const Model model = smallScene();
  ASSERT_TRUE(m_renderer->setScene(model).ok());
  const VecX q = movedState(model).q;
  const auto before = m_renderer->evaluated(kBox, SurfaceKind::Visual, model.start.q);
  const auto after = m_renderer->evaluated(kBox, SurfaceKind::Visual, q);
  const int o = model.objects[kBox].layout.qOffset;
  const Quat turn(q[o + 6], q[o + 3], q[o + 4], q[o + 5]);
  for (std::size_t v = 0; v < before.normals_W.size(); ++v) {
    EXPECT_NEAR(before.normals_W[v].norm(), 1, 1e-5);
    EXPECT_LT((turn * before.normals_W[v].cast<double>() - after.normals_W[v].cast<double>()).norm(), 2e-5);
  }
}

TEST_F(StateOnGpu, aDentSinksTheSurfaceRoundItsPlaceAndGoes) {
  const Model model = smallScene();
  ASSERT_TRUE(m_renderer->setScene(model).ok());
  int soft = 0;
  while (model.objects[soft].layout.rigid) ++soft;
  const auto before = m_renderer->evaluated(soft, SurfaceKind::Visual, model.start.q);
  const auto collision = m_renderer->evaluated(soft, SurfaceKind::Collision, model.start.q);
  const Vec3 place = before.positions_W[0].cast<double>(), normal = before.normals_W[0].cast<double>().normalized();
  const double depth = 1e-3, radius = 4e-3;
  const std::vector<DentView> dents{{soft, soft, place, normal, depth, radius}};
  const auto dented = m_renderer->evaluated(soft, SurfaceKind::Visual, model.start.q, dents);
  for (std::size_t v = 0; v < before.positions_W.size(); ++v) {
    const Vec3 p = before.positions_W[v].cast<double>();
    const Vec3 expected = p - depth * std::exp(-(p - place).squaredNorm() / (2 * radius * radius)) * normal;
    EXPECT_LT((dented.positions_W[v].cast<double>() - expected).norm(), 4 * kFloatLength) << v;
  }
  EXPECT_EQ(m_renderer->evaluated(soft, SurfaceKind::Collision, model.start.q, dents).positions_W, collision.positions_W);
  EXPECT_EQ(m_renderer->evaluated(soft, SurfaceKind::Visual, model.start.q).positions_W, before.positions_W);
}

TEST_F(StateOnGpu, whatASkinCoversIsDrawnBeneathIt) {
  const std::string resources = GLENOID_SOURCE_DIR "/resources";
  const auto model = compileModel(loadJoint(resources + "/joints/shoulder-superficial.joint").value(),
                                  loadScenario(resources + "/scenarios/palpation.scenario.json").value()).value();
  ASSERT_TRUE(m_renderer->setScene(*model).ok());
  const int muscle = findPart(model->joint, "deltoid-acromial");
  const SceneObject& object = model->objects[muscle];
  VecX q = model->start.q;
  for (int n = 0; n < object.layout.nodeCount; ++n) q[object.layout.qOffset + 3 * n + 2] += 6e-3;  // out through the skin
  UnderSkin kept(*model);
  kept.look(q, {});
  const std::span<const Vec3> shifts = kept.shifts(muscle);
  ASSERT_EQ(shifts.size(), object.visual.vertices.size());
  std::vector<Vec3> at(shifts.size());
  surfacePositions(object.visual, object.layout, q, at);
  const auto drawn = m_renderer->evaluated(muscle, SurfaceKind::Visual, q);
  double most = 0;
  for (std::size_t v = 0; v < at.size(); ++v) {
    EXPECT_LT((drawn.positions_W[v].cast<double>() - at[v] - shifts[v]).norm(), 4 * kFloatLength) << v;
    most = std::max(most, shifts[v].norm());
  }
  EXPECT_GT(most, 3e-3);
  // And all as it was where nothing comes through.
  surfacePositions(object.visual, object.layout, model->start.q, at);
  const auto before = m_renderer->evaluated(muscle, SurfaceKind::Visual, model->start.q);
  for (std::size_t v = 0; v < at.size(); ++v) EXPECT_LT((before.positions_W[v].cast<double>() - at[v]).norm(), 4 * kFloatLength) << v;
}

TEST_F(StateOnGpu, aStateOfAnotherModelIsNotDrawn) {
  const Model model = smallScene();
  ASSERT_TRUE(m_renderer->setScene(model).ok());
  EXPECT_TRUE(m_renderer->evaluated(kBox, SurfaceKind::Visual, VecX::Zero(3)).positions_W.empty());
  EXPECT_TRUE(m_renderer->bounds(VecX::Zero(3), {}).isEmpty());
  EXPECT_TRUE(m_renderer->picture({}, VecX::Zero(3), {}, {}, {}, 16, 16).ok());
}

TEST_F(StateOnGpu, anotherSceneTakesThePlace) {
  Model model = smallScene();
  ASSERT_TRUE(m_renderer->setScene(model).ok());
  model.objects.pop_back();  // the tool, last in q too
  model.start.q.conservativeResize(model.start.q.size() - 7);
  ASSERT_TRUE(m_renderer->setScene(model).ok());
  expectPositions(*m_renderer, model, movedState(model).q);
  Model broken = smallScene();
  broken.objects[kBall].visual.vertices[5].node[2] = 99;
  const auto refused = m_renderer->setScene(broken);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().fault, Fault::BadIndex);
  EXPECT_EQ(refused.error().place.part, "ball");
  expectPositions(*m_renderer, model, model.start.q);  // the old scene stays
}

}  // namespace
}  // namespace glenoid::test

int main(int argc, char** argv) {
  return glenoid::test::runPictureTests(argc, argv);
}
