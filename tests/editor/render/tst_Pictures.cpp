// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/editor/render/PictureCheck.h"
#include "tests/editor/render/TestScene.h"

namespace glenoid::test {
namespace {

class Pictures : public Drawing {
 protected:
  void SetUp() override {
    Drawing::SetUp();
    if (!m_renderer) return;  // skipped
    ASSERT_TRUE(m_renderer->setScene(m_model).ok());
  }
  View view() const {
    return orbited(viewFrom(Side::Anterior, sceneBounds(m_model, m_model.start.q), 4.0 / 3), 0.6, 0.35);
  }
  Image draw(const Layers& layers, const Look& look, const VecX& q, std::vector<ContactView> contacts = {}) {
    Look fixed = look;  // the same samples whatever draws
    fixed.samples = 1;
    fixed.supersample = 2;
    auto image = m_renderer->picture(view(), q, layers, contacts, fixed, 320, 240);
    EXPECT_TRUE(image.ok());
    return image.ok() ? *image : Image{};
  }
  Image draw(const Layers& layers = {}, const Look& look = {}) { return draw(layers, look, m_model.start.q); }
  static Layers words(const char* list) { return *layersFromWords(list); }

  const Model m_model = smallScene();
};

TEST_F(Pictures, visualSurfaces) {
  expectPicture(draw(), "small-visual");
}

TEST_F(Pictures, movedAndDeformed) {
  expectPicture(draw({}, {}, movedState(m_model).q), "small-moved");
}

TEST_F(Pictures, collisionSurfaces) {
  expectPicture(draw(words("collision")), "small-collision");
}

TEST_F(Pictures, dynamicsAndCouplings) {
  expectPicture(draw(words("dynamics,couplings")), "small-dynamics");
}

TEST_F(Pictures, strokesLieOnTheScreenOrInTheScene) {
  const auto reddish = [](const Image& image, int x, int y) {
    const auto p = image.at(x, y);
    return p[0] > 120 && p[0] > p[1] + 60 && p[0] > p[2] + 60;
  };
  Layers layers;
  Strokes screen;
  screen.onScreen = true;
  screen.dotPx = 16;
  screen.linePx = 6;
  screen.dots.push_back({Eigen::Vector3f(40, 30, 0), {1, 0, 0, 1}});
  for (const float x : {100.0f, 160.0f}) screen.lines.push_back({Eigen::Vector3f(x, 20, 0), {1, 0, 0, 1}});
  layers.strokes = {screen};
  EXPECT_FALSE(reddish(draw(), 40, 30));
  const Image onScreen = draw(layers);
  EXPECT_TRUE(reddish(onScreen, 40, 30)) << "pixels from the top left";
  EXPECT_TRUE(reddish(onScreen, 130, 20));
  EXPECT_FALSE(reddish(onScreen, 40, 240 - 30));
  EXPECT_FALSE(reddish(onScreen, 180, 20));

  // A dot in the middle of the sphere is hidden by it; one before it is not.
  Vec3 middle = Vec3::Zero();
  const TriMesh& sphere = *m_model.objects[kSphere].visual.mesh;
  for (const Vec3& v : sphere.vertices) middle += v / static_cast<double>(sphere.vertices.size());
  const Vec3 before = middle + 0.3 * (view().eye_W - middle);
  const auto seen = [&](const Vec3& at, float strength) {
    Strokes dot;
    dot.dotPx = 16;
    dot.hiddenStrength = strength;
    dot.dots.push_back({at.cast<float>(), {1, 0, 0, 1}});
    Layers with;
    with.strokes = {dot};
    const auto pixel = projected(view(), at, 320, 240);
    return reddish(draw(with), static_cast<int>(pixel->x()), static_cast<int>(pixel->y()));
  };
  EXPECT_TRUE(seen(before, 0));
  EXPECT_FALSE(seen(middle, 0));
  EXPECT_TRUE(seen(middle, 1));
}

TEST_F(Pictures, anObjectMayHaveAnotherColour) {
  Layers layers;
  layers.objects.resize(4);
  layers.objects[kSphere].color = {0.1f, 0.9f, 0.1f};
  const Image plain = draw(), green = draw(layers);
  Vec3 middle = Vec3::Zero();
  const TriMesh& sphere = *m_model.objects[kSphere].visual.mesh;
  for (const Vec3& v : sphere.vertices) middle += v / static_cast<double>(sphere.vertices.size());
  const auto pixel = projected(view(), middle, 320, 240);
  const auto p = green.at(static_cast<int>(pixel->x()), static_cast<int>(pixel->y()));
  EXPECT_GT(p[1], p[0] + 30);
  EXPECT_GT(p[1], p[2] + 30);
  EXPECT_GT(compareImages(plain, green).fractionDifferent, 0.005);
}

TEST_F(Pictures, everythingAtOnce) {
  std::vector<ContactView> contacts;
  contacts.push_back({kTool, kBall, Vec3(0.04, 0.02, 0.04), Vec3(1, 1, 0).normalized(), 0, 5});
  contacts.push_back({kTool, kSphere, Vec3(0.045, 0.05, 0.0), Vec3::UnitX(), 0.001, 0});
  expectPicture(draw(words("all"), {}, m_model.start.q, contacts), "small-all");
}

TEST_F(Pictures, selectedTransparentOnDark) {
  Layers layers;
  layers.objects.resize(4);
  layers.objects[kBall].opacity = 0.35f;
  layers.objects[kSphere].selected = true;
  layers.objects[kBox].hovered = true;
  layers.couplings = true;
  Look look;
  look.dark = true;
  expectPicture(draw(layers, look), "small-dark");
}

TEST_F(Pictures, marksOnTriangles) {
  Layers layers;
  TriangleMark mark;
  mark.object = kBox;
  mark.triangles = {10, 11, 5000, -1};  // two of them exist
  layers.marks.push_back(mark);
  const Image image = draw(layers);
  EXPECT_FALSE(alike(compareImages(image, draw())));
  expectPicture(image, "small-marks");
}

TEST_F(Pictures, aMissingPartIsNoticed) {
  const Image whole = draw();
  for (const int object : {kBox, kSphere, kBall, kTool}) {
    Layers layers;
    layers.objects.resize(4);
    layers.objects[object].visible = false;
    EXPECT_FALSE(alike(compareImages(whole, draw(layers)))) << object;
  }
}

TEST_F(Pictures, aSurfaceInsideOutIsNoticed) {
  const Image whole = draw();
  for (const int object : {kBox, kSphere, kBall}) {
    ASSERT_TRUE(m_renderer->setScene(withFlippedSurface(m_model, object)).ok());
    EXPECT_FALSE(alike(compareImages(whole, draw()))) << object;
  }
}

TEST_F(Pictures, eachLayerChangesThePicture) {
  const Image none = draw(words("none"));
  for (const char* layer : {"visual", "collision", "dynamics", "couplings", "regions,visual"})
    EXPECT_FALSE(alike(compareImages(none, draw(words(layer))))) << layer;
  EXPECT_FALSE(alike(compareImages(draw(words("visual")), draw(words("visual,regions")))));
}

TEST_F(Pictures, theSameTwice) {
  EXPECT_EQ(draw(), draw());
}

TEST_F(Pictures, withoutBackgroundOnlyTheSceneIsOpaque) {
  Look look;
  look.transparent = true;
  Layers layers;
  layers.marker = false;
  const Image image = draw(layers, look);
  EXPECT_EQ(image.at(2, 2)[3], 0);
  const Vec2 middle = *projected(view(), Vec3(0, 0, 0.05), 320, 240);
  EXPECT_EQ(image.at(static_cast<int>(middle.x()), static_cast<int>(middle.y()))[3], 255);
}

TEST_F(Pictures, anAbsurdSizeIsRefused) {
  for (const auto& [w, h] : {std::pair(0, 10), std::pair(10, -1), std::pair(1 << 20, 10)}) {
    const auto refused = m_renderer->picture(view(), m_model.start.q, {}, {}, {}, w, h);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().fault, Fault::OutOfRange);
  }
}

}  // namespace

/// The one call that command lines use; makes its own context, so it stands outside the fixture.
TEST(RenderPicture, drawsWithoutAnythingPrepared) {
  const Model model = smallScene();
  const View view = viewFrom(Side::Lateral, sceneBounds(model, model.start.q), 1);
  const auto image = renderPicture(model, model.start, view, {}, 64, 64);
  if (!image && image.error().fault == Fault::NoGraphics) GTEST_SKIP() << toLogLine(image.error());
  ASSERT_TRUE(image.ok()) << toLogLine(image.error());
  EXPECT_NE(image->at(32, 32), image->at(63, 0));  // the ball before the background
}

}  // namespace glenoid::test

int main(int argc, char** argv) {
  return glenoid::test::runPictureTests(argc, argv);
}
