// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/tools/MeshPicture.h"

#include <gtest/gtest.h>

#include "editor/core/LatestJob.h"
#include "tests/simcore/mesh/Shapes.h"

namespace glenoid {
namespace {

TEST(MeshPicture, aBallIsARoundDiscLitFromTheViewer) {
  const TriMesh ball = shapes::sphere(0.02, 60, 30);
  Viewport viewport;
  viewport.view.eye_W = Vec3(0, 0, 0.3);
  viewport.view.target_W = Vec3::Zero();
  viewport.view.fieldOfView = 0.2;
  viewport.width = viewport.height = 200;
  const Image image = meshPicture(ball, viewport, {{0.5f, 0.5f, 0.5f}, true, false, {}});
  int covered = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) covered += image.at(x, y)[3] == 255;
  // The silhouette's radius in pixels: tan of the angle whose sine is r over the distance.
  const double radius = 0.02 / std::sqrt(0.3 * 0.3 - 0.02 * 0.02) / std::tan(0.1) * 100;
  EXPECT_NEAR(covered / (M_PI * radius * radius), 1, 0.02);
  EXPECT_EQ(image.at(2, 2)[3], 0);
  EXPECT_GT(image.at(100, 100)[0], image.at(100 + static_cast<int>(0.95 * radius), 100)[0]) << "darker at the rim";
  const Image flat = meshPicture(ball, viewport, {{0.5f, 0.5f, 0.5f}, false, true, {}});
  EXPECT_NE(flat, image);
  std::vector<int> all;
  for (int t = 0; t < static_cast<int>(ball.triangles.size()); ++t) all.push_back(t);
  const Image marked = meshPicture(ball, viewport, {{0.5f, 0.5f, 0.5f}, true, false, all});
  EXPECT_GT(marked.at(100, 100)[0], marked.at(100, 100)[2] + 60) << "orange";
  EXPECT_EQ(meshPicture({}, viewport, {}).at(100, 100)[3], 0);
}

}  // namespace
}  // namespace glenoid
