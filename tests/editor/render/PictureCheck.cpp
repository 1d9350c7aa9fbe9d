// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/editor/render/PictureCheck.h"

#include <cstring>
#include <filesystem>

namespace glenoid::test {
namespace {

bool g_update = false;  // set once by main, before any test

}  // namespace

int runPictureTests(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  for (int i = 1; i < argc; ++i) g_update = g_update || std::strcmp(argv[i], "--update") == 0;
  return RUN_ALL_TESTS();
}

bool alike(const ImageDifference& d) {
  return d.sameSize && d.mean <= kMeanLimit && d.fractionDifferent <= kFractionLimit;
}

void expectPicture(const Image& image, const std::string& name) {
  const std::string stored = std::string(GLENOID_SOURCE_DIR) + "/tests/render/" + name + ".png";
  if (g_update) {
    ASSERT_TRUE(writePng(image, stored).ok()) << stored;
    return;
  }
  const auto expected = readPng(stored);
  const std::string folder = std::string(GLENOID_BUILD_DIR) + "/pictures/";
  const auto keep = [&](const Image& kept, const std::string& ending) {
    std::filesystem::create_directories(folder);
    EXPECT_TRUE(writePng(kept, folder + name + ending + ".png").ok());
  };
  if (!expected) {
    keep(image, "");
    FAIL() << toLogLine(expected.error()) << "; drawn now: " << folder << name << ".png";
  }
  const ImageDifference d = compareImages(image, *expected);
  if (alike(d)) return;
  keep(image, "");
  keep(differenceImage(image, *expected), ".difference");
  FAIL() << name << ": mean " << d.mean << ", max " << d.max << ", different " << d.fractionDifferent
         << "; see " << folder;
}

void Drawing::SetUp() {
  auto context = HeadlessContext::create();
  if (!context)
    GTEST_SKIP() << "This machine draws nothing without a display: " << toLogLine(context.error());
  m_context = std::move(*context);
  auto renderer = SceneRenderer::create();
  ASSERT_TRUE(renderer.ok()) << toLogLine(renderer.error());
  m_renderer = std::move(*renderer);
}

void Drawing::TearDown() {
  m_renderer.reset();  // before its context
  m_context.reset();
}

}  // namespace glenoid::test
