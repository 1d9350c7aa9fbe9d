// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

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

/// A value for each vertex of the ball: its height over the ball's middle, m, from −0.04 to 0.04.
FieldLook heights(const Model& model) {
  auto values = std::make_shared<std::vector<std::vector<float>>>(model.objects.size());
  for (const Vec3& x : model.objects[kBall].visual.mesh->vertices) (*values)[kBall].push_back(static_cast<float>(x.y()));
  FieldLook field;
  field.values = values;
  field.low = -0.04;
  field.high = 0.04;
  field.title = "Height (mm)";
  field.ticks = {{-0.04, "−40"}, {-0.02, "−20"}, {0, "0"}, {0.02, "20"}, {0.04, "40"}};
  return field;
}

TEST_F(Pictures, valuesAreColoursWithAScale) {
  Layers layers;
  layers.field = heights(m_model);
  expectPicture(draw(layers), "small-field");
  layers.field->low = 0;  // one way only, and nothing is no colour
  layers.field->zeroIsNone = true;
  layers.field->ticks = {{0, "0"}, {0.02, "20"}, {0.04, "≥ 40"}};
  Look dark;
  dark.dark = true;
  expectPicture(draw(layers, dark), "small-field-dark");
}

TEST_F(Pictures, whatFacesTheViewerHasTheColourOfTheScale) {
  Layers layers;
  layers.field = heights(m_model);
  layers.marker = false;
  layers.field->title.clear();
  Look look;
  look.ambientOcclusion = false;
  const View facing = viewFrom(Side::Lateral, sceneBounds(m_model, m_model.start.q), 4.0 / 3);  // the ball is foremost
  look.samples = 1;
  const auto colourAt = [&](double height) {
    const auto image = m_renderer->picture(facing, m_model.start.q, layers, {}, look, 320, 240);
    const auto pixel = projected(facing, Vec3(0, height, 0.05 + std::sqrt(0.04 * 0.04 - height * height)), 320, 240);
    return image->at(static_cast<int>(pixel->x()), static_cast<int>(pixel->y()));
  };
  for (const auto& [low, high] : {std::pair(-0.04, 0.04), {-0.01, 0.04}, {0.0, 0.02}, {-0.02, -0.001}}) {
    layers.field->low = low;
    layers.field->high = high;
    for (const double height : {-0.012, -0.004, 0.0, 0.008, 0.013}) {
      const auto seen = colourAt(height);
      const auto wanted = colorOf(*layers.field, height);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], 255 * wanted[c], 14) << low << " " << high << " at " << height << ", channel " << c;
    }
  }
  // A part without values is the neutral grey, in another colour of its own too; the tool keeps its look.
  layers.objects.resize(4);
  layers.objects[kBall].visible = false;
  layers.objects[kBox].color = {0.1f, 0.9f, 0.1f};
  const View front = viewFrom(Side::Lateral, sceneBounds(m_model, m_model.start.q), 4.0 / 3);
  const auto image = m_renderer->picture(front, m_model.start.q, layers, {}, look, 320, 240);
  const auto pixel = projected(front, Vec3(0, -0.03, -0.025), 320, 240);
  const auto box = image->at(static_cast<int>(pixel->x()), static_cast<int>(pixel->y()));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(box[c], 255 * kNeutralColor[c], 8);
}

TEST_F(Pictures, valuesThatDoNotFitAreNoneAndOthersReplaceThem) {
  Layers layers;
  layers.field = heights(m_model);
  const Image first = draw(layers);
  auto other = std::make_shared<std::vector<std::vector<float>>>(*layers.field->values);
  for (float& value : (*other)[kBall]) value = -value;
  layers.field->values = other;
  EXPECT_FALSE(alike(compareImages(first, draw(layers)))) << "other values, other colours";
  other = std::make_shared<std::vector<std::vector<float>>>(*layers.field->values);
  (*other)[kBall].pop_back();
  layers.field->values = other;
  const Image grey = draw(layers);
  layers.field->values.reset();
  EXPECT_TRUE(alike(compareImages(grey, draw(layers))));
  layers.field = heights(m_model);
  EXPECT_TRUE(alike(compareImages(first, draw(layers))));
  ASSERT_TRUE(m_renderer->setScene(m_model).ok());  // the same scene again wants its values again
  EXPECT_TRUE(alike(compareImages(first, draw(layers))));
  EXPECT_TRUE(alike(compareImages(draw(), draw({}, {})))) << "and without a field nothing is left of it";
}

TEST_F(Pictures, namesKeepClearOfTheLegend) {
  Layers layers = words("visual,labels");
  layers.field = heights(m_model);
  expectPicture(draw(layers), "small-field-labels");
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
