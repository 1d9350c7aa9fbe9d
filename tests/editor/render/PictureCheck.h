// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "editor/render/GlContext.h"
#include "editor/render/SceneRenderer.h"

/// Test programs that draw have their own main: `--update` stores what they draw instead of comparing.
namespace glenoid::test {

/// Reads and removes --update; then runs the tests.
int runPictureTests(int argc, char** argv);

/// Limits between a stored picture and one drawn now. Another driver moves samples at edges and rounds shades
/// differently: llvmpipe with 128, 256 and 512 bits agree to the last bit, softpipe differs by 4e-5 in the
/// mean and in 2e-4 of the pixels; a graphics card may differ some tens of times more. A missing part or a
/// surface wound inside out exceeds the limits (tst_Pictures, tst_ShoulderPictures).
inline constexpr double kMeanLimit = 0.002, kFractionLimit = 0.005;
bool alike(const ImageDifference& difference);

/// Compares with tests/render/NAME.png. On failure picture and difference are left in BUILD/pictures.
void expectPicture(const Image& image, const std::string& name);

/// A context and a renderer for a test; skips with a sentence where there is no EGL at all.
class Drawing : public ::testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;
  std::unique_ptr<HeadlessContext> m_context;
  std::unique_ptr<SceneRenderer> m_renderer;
};

}  // namespace glenoid::test
