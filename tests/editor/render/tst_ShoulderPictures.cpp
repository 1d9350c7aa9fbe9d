// SPDX-License-Identifier: GPL-3.0-or-later
// The shoulder that ships, as compiled for the arthroscopy scene, in its start state: from four sides, in its
// layers and each part alone. A part that goes missing, moves or turns inside out shows here.
#include "simcore/scene/JointFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "tests/editor/render/PictureCheck.h"

namespace glenoid::test {
namespace {

constexpr int kWidth = 240, kHeight = 180;
constexpr double kAspect = static_cast<double>(kWidth) / kHeight;

class ShoulderPictures : public Drawing {
 protected:
  static void SetUpTestSuite() {
    const std::string resources = std::string(GLENOID_SOURCE_DIR) + "/resources/";
    const auto joint = loadJoint(resources + "joints/shoulder.joint");
    ASSERT_TRUE(joint.ok()) << toLogLine(joint.error());
    const auto scenario = loadScenario(resources + "scenarios/arthroscopy.scenario.json");
    ASSERT_TRUE(scenario.ok()) << toLogLine(scenario.error());
    auto model = compileModel(*joint, *scenario);
    ASSERT_TRUE(model.ok()) << toLogLine(model.error());
    s_model = *model;
  }
  static void TearDownTestSuite() { s_model.reset(); }
  void SetUp() override {
    Drawing::SetUp();
    if (!m_renderer) return;  // skipped
    ASSERT_TRUE(s_model != nullptr);
    ASSERT_TRUE(m_renderer->setScene(*s_model).ok());
  }

  Image draw(const View& view, const Layers& layers) {
    Look look;
    look.samples = 1;  // the same samples whatever draws
    look.supersample = 2;
    auto image = m_renderer->picture(view, s_model->start.q, layers, {}, look, kWidth, kHeight);
    EXPECT_TRUE(image.ok());
    return image.ok() ? *image : Image{};
  }
  Box3 box(const Layers& layers) const { return m_renderer->bounds(s_model->start.q, layers); }
  static Layers words(const char* list) {
    Layers layers = *layersFromWords(list);
    layers.tools = false;
    return layers;
  }
  static Layers only(int object) {
    Layers layers = words("visual");
    layers.objects.resize(s_model->objects.size());
    for (int i = 0; i < static_cast<int>(layers.objects.size()); ++i) layers.objects[i].visible = i == object;
    return layers;
  }
  static inline std::shared_ptr<const Model> s_model;
};

TEST_F(ShoulderPictures, fromFourSides) {
  const Layers layers = words("visual");
  for (const Side side : {Side::Anterior, Side::Posterior, Side::Lateral, Side::Superior})
    expectPicture(draw(viewFrom(side, box(layers), kAspect), layers),
                  std::string("shoulder-") + sideName(side));
}

TEST_F(ShoulderPictures, aMissingPartIsNoticedAlone) {
  for (int i = 0; i < static_cast<int>(s_model->objects.size()); ++i) {
    if (s_model->objects[i].tool) continue;
    Layers layers = only(i);
    const View view = orbited(viewFrom(Side::Anterior, box(layers), kAspect), -0.5, 0.2);
    const Image there = draw(view, layers);
    layers.objects[i].visible = false;
    EXPECT_FALSE(alike(compareImages(there, draw(view, layers)))) << s_model->objects[i].id;
  }
}

TEST_F(ShoulderPictures, inItsLayers) {
  const Layers whole = words("visual");
  const View view = orbited(viewFrom(Side::Anterior, box(whole), kAspect), -0.6, 0.25);
  for (const char* layer : {"collision", "dynamics", "couplings"})
    expectPicture(draw(view, words(layer)), std::string("shoulder-layer-") + layer);
  expectPicture(draw(view, words("visual,regions")), "shoulder-layer-regions");
}

TEST_F(ShoulderPictures, asTheArthroscopeStandsBeforeIt) {
  ASSERT_FALSE(s_model->scenario.cameras.empty());
  Layers layers;  // with tools
  expectPicture(draw(viewOf(s_model->scenario.cameras[0]), layers), "shoulder-arthroscopy");
}

TEST_F(ShoulderPictures, eachPartAlone) {
  int parts = 0;
  for (int i = 0; i < static_cast<int>(s_model->objects.size()); ++i) {
    if (s_model->objects[i].tool) continue;
    ++parts;
    const Layers layers = only(i);
    const View view = orbited(viewFrom(Side::Anterior, box(layers), kAspect), -0.5, 0.2);
    expectPicture(draw(view, layers), "shoulder-part-" + s_model->objects[i].id);
  }
  EXPECT_EQ(parts, 11);  // Table 1 of the paper
}

}  // namespace
}  // namespace glenoid::test

int main(int argc, char** argv) {
  return glenoid::test::runPictureTests(argc, argv);
}
