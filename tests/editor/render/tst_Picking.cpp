// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/editor/render/PictureCheck.h"
#include "tests/editor/render/TestScene.h"

namespace glenoid::test {
namespace {

class Picking : public Drawing {
 protected:
  void SetUp() override {
    Drawing::SetUp();
    if (!m_renderer) return;
    ASSERT_TRUE(m_renderer->setScene(m_model).ok());
    m_view = viewFrom(Side::Anterior, sceneBounds(m_model, q()), 4.0 / 3);
  }
  const VecX& q() const { return m_model.start.q; }
  std::optional<PickHit> pickAt(const Vec3& p_W, const Layers& layers = {}) {
    const Vec2 pixel = *projected(m_view, p_W, m_target.width, m_target.height);
    return m_renderer->pick(m_view, q(), layers, m_target, pixel.x(), pixel.y());
  }
  Vec3 centerOf(int object) const { return boundsOf(*m_model.objects[object].visual.mesh).center(); }

  const Model m_model = smallScene();
  const Target m_target{0, 640, 480};
  View m_view;
};

TEST_F(Picking, findsTheObjectUnderThePixel) {
  for (const int object : {kBox, kSphere, kBall, kTool}) {
    const auto hit = pickAt(centerOf(object));
    ASSERT_TRUE(hit.has_value()) << object;
    EXPECT_EQ(hit->object, object);
  }
  EXPECT_FALSE(m_renderer->pick(m_view, q(), {}, m_target, 1, 1).has_value());
  EXPECT_FALSE(m_renderer->pick(m_view, q(), {}, m_target, -5, 1).has_value());
  EXPECT_FALSE(m_renderer->pick(m_view, q(), {}, m_target, 640, 1).has_value());
}

TEST_F(Picking, answersTriangleAndPointOnIt) {
  const auto hit = pickAt(centerOf(kSphere));
  ASSERT_TRUE(hit.has_value());
  const TriMesh& mesh = *m_model.objects[kSphere].visual.mesh;
  ASSERT_LT(hit->triangle, static_cast<int>(mesh.triangles.size()));
  const auto& t = mesh.triangles[hit->triangle];
  const Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
  const Vec3 normal = (b - a).cross(c - a).normalized();
  EXPECT_LT(std::abs(normal.dot(hit->point_W - a)), 1e-6);  // in its plane, m
  EXPECT_GT(normal.dot(hit->normal_W), 0.99);
  for (const auto& [p, r] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})  // and inside its edges
    EXPECT_GT((r - p).cross(hit->point_W - p).dot(normal), -1e-8);
  // The pixel's middle is where the ray through it meets the plane.
  const Vec2 pixel = *projected(m_view, centerOf(kSphere), m_target.width, m_target.height);
  const Ray ray = rayThrough(m_view, std::floor(pixel.x()) + 0.5, std::floor(pixel.y()) + 0.5, 640, 480);
  const double s = normal.dot(a - ray.origin_W) / normal.dot(ray.direction_W);
  EXPECT_LT((ray.origin_W + s * ray.direction_W - hit->point_W).norm(), 2e-6);
}

TEST_F(Picking, seesOnlyWhatIsShown) {
  Layers layers;
  layers.objects.resize(4);
  layers.objects[kSphere].visible = false;
  const auto hit = pickAt(centerOf(kSphere), layers);
  EXPECT_TRUE(!hit || hit->object != kSphere);
  layers.objects[kSphere] = {true, 0, false, false};
  const auto clear = pickAt(centerOf(kSphere), layers);
  EXPECT_TRUE(!clear || clear->object != kSphere);
  Layers coarse;
  coarse.visual = false;
  coarse.collision = true;
  const auto collision = pickAt(centerOf(kBall), coarse);
  ASSERT_TRUE(collision.has_value());
  EXPECT_EQ(collision->surface, SurfaceKind::Collision);
  EXPECT_LT(collision->triangle, static_cast<int>(m_model.objects[kBall].collision.mesh->triangles.size()));
}

TEST_F(Picking, aRectangleHoldsEveryTriangleSeenInIt) {
  const Vec2 pixel = *projected(m_view, centerOf(kBall), 640, 480);
  const int x = static_cast<int>(pixel.x()), y = static_cast<int>(pixel.y());
  const auto hits = m_renderer->pickRectangle(m_view, q(), {}, m_target, x - 20, y - 20, x + 20, y + 20);
  ASSERT_GT(hits.size(), 4u);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    EXPECT_EQ(hits[i].object, kBall);
    EXPECT_TRUE(i == 0 || hits[i].triangle > hits[i - 1].triangle);
  }
  const auto middle = pickAt(centerOf(kBall));
  ASSERT_TRUE(middle.has_value());
  EXPECT_TRUE(std::any_of(hits.begin(), hits.end(),
                          [&](const PickHit& h) { return h.triangle == middle->triangle; }));
}

}  // namespace
}  // namespace glenoid::test

int main(int argc, char** argv) {
  return glenoid::test::runPictureTests(argc, argv);
}
