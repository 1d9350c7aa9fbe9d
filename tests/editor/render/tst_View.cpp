// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/View.h"

#include <gtest/gtest.h>

#include "editor/render/Layers.h"
#include "editor/render/Marker.h"

namespace glenoid {
namespace {

const Box3 kBox(Vec3(-0.1, -0.05, 0.0), Vec3(0.1, 0.15, 0.2));

TEST(View, namedSidesStandWhereTheySay) {
  const struct {
    Side side;
    Vec3 back, right;
  } expected[] = {
      {Side::Anterior, Vec3::UnitX(), -Vec3::UnitZ()},  // lateral of a right shoulder on the left
      {Side::Posterior, -Vec3::UnitX(), Vec3::UnitZ()}, {Side::Lateral, Vec3::UnitZ(), Vec3::UnitX()},
      {Side::Medial, -Vec3::UnitZ(), -Vec3::UnitX()},   {Side::Superior, Vec3::UnitY(), Vec3::UnitZ()},
      {Side::Inferior, -Vec3::UnitY(), -Vec3::UnitZ()}};
  for (const auto& e : expected) {
    const ViewAxes axes = axesOf(viewFrom(e.side, kBox, 1.5));
    EXPECT_LT((axes.back_W - e.back).norm(), 1e-12) << sideName(e.side);
    EXPECT_LT((axes.right_W - e.right).norm(), 1e-12) << sideName(e.side);
    EXPECT_EQ(sideNamed(sideName(e.side)), e.side);
  }
  EXPECT_FALSE(sideNamed("leftish").has_value());
}

TEST(View, lateralAndMedialFollowTheSideOfTheJoint) {
  const auto from = [](Side side, JointSide joint) { return axesOf(viewFrom(side, kBox, 1.5, 0.5, joint)).back_W; };
  for (const JointSide joint : {JointSide::Unsaid, JointSide::Right, JointSide::Left}) {
    const double outwards = joint == JointSide::Left ? -1 : 1;
    EXPECT_LT((from(Side::Lateral, joint) - outwards * Vec3::UnitZ()).norm(), 1e-12);
    EXPECT_LT((from(Side::Medial, joint) + outwards * Vec3::UnitZ()).norm(), 1e-12);
    EXPECT_LT((from(Side::Anterior, joint) - Vec3::UnitX()).norm(), 1e-12);
    EXPECT_LT((from(Side::Superior, joint) - Vec3::UnitY()).norm(), 1e-12);
  }
}

TEST(Marker, theLettersOfALeftJointAreThoseOfARightOneSeenInAMirror) {
  // From the front: what is drawn on the left for a right joint stands on the right for a left one, the letters not mirrored.
  const View front = viewFrom(Side::Anterior, kBox, 1);
  const MarkerLines right = markerLines(front, 100, false, JointSide::Right), left = markerLines(front, 100, false, JointSide::Left);
  ASSERT_EQ(right.letters.size(), left.letters.size());
  ASSERT_EQ(right.axes.size(), left.axes.size());
  EXPECT_EQ(markerLines(front, 100, false).letters.size(), right.letters.size());
  const auto centreX = [](const MarkerLines& lines, bool strokesOfL) {
    // L has two strokes, M four; both are blue.
    std::vector<double> xs;
    for (const ColoredPoint& p : lines.letters)
      if (p.color[2] > p.color[0] && p.color[2] > p.color[1]) xs.push_back(p.position[0]);
    std::sort(xs.begin(), xs.end());
    EXPECT_EQ(xs.size(), 12u);
    // The four ends of L lie together at one end of the row, the eight of M at the other.
    const bool lowIsL = xs[3] - xs[0] < xs[4] - xs[3];
    const bool low = strokesOfL == lowIsL;
    return low ? xs.front() : xs.back();
  };
  EXPECT_LT(centreX(right, true), centreX(right, false)) << "lateral of a right joint is on the viewer's left";
  EXPECT_GT(centreX(left, true), centreX(left, false));
}

TEST(View, framedBoxIsInSightAndFillsIt) {
  for (const double aspect : {0.5, 1.0, 2.0})
    for (const Side side : kSides) {
      const View view = orbited(viewFrom(side, kBox, aspect), 0.4, -0.2);
      const View close = framed(view, kBox, aspect);
      const int height = 400, width = static_cast<int>(aspect * height);
      double reach = 0;
      for (int corner = 0; corner < 8; ++corner) {
        const auto p = projected(close, kBox.corner(static_cast<Box3::CornerType>(corner)), width, height);
        ASSERT_TRUE(p.has_value());
        reach = std::max({reach, std::abs(p->x() / width - 0.5) * 2, std::abs(p->y() / height - 0.5) * 2});
      }
      EXPECT_NEAR(reach, 1 / 1.08, 1e-9) << sideName(side);
    }
  const View same = framed({}, Box3(), 1);
  EXPECT_EQ(same.eye_W, View{}.eye_W);
}

TEST(View, orbitKeepsDistanceAndStopsAtThePoles) {
  View view = viewFrom(Side::Anterior, kBox, 1);
  const double distance = (view.eye_W - view.target_W).norm();
  for (int i = 0; i < 40; ++i) view = orbited(view, 0.3, 0.2);
  EXPECT_NEAR((view.eye_W - view.target_W).norm(), distance, 1e-9);
  const ViewAxes top = axesOf(view);
  EXPECT_NEAR(top.back_W.y(), 1, 1e-9);  // over the pole, not beyond
  EXPECT_GE(top.up_W.y(), -1e-9);
  EXPECT_NEAR(axesOf(orbited(view, 0, -0.5)).back_W.y(), std::cos(0.5), 1e-9);  // and back down
  EXPECT_NEAR(axesOf(orbited(viewFrom(Side::Anterior, kBox, 1), 1.0, 0)).right_W.y(), 0,
              1e-12);  // yaw does not roll
}

TEST(View, theScenePointFollowsTheCursor) {
  const View view = orbited(viewFrom(Side::Lateral, kBox, 1.5), 0.3, 0.3);
  const ViewAxes axes = axesOf(view);
  const Vec3 grasped = view.target_W + 0.03 * axes.right_W - 0.02 * axes.up_W;
  const Vec2 before = *projected(view, grasped, 600, 400);
  const Vec2 panned1 = *projected(panned(view, 25, -10, 400), grasped, 600, 400);
  EXPECT_NEAR(panned1.x(), before.x() + 25, 1e-9);
  EXPECT_NEAR(panned1.y(), before.y() - 10, 1e-9);
  const Vec2 zoomed = *projected(zoomedAt(view, 0.5, before.x(), before.y(), 600, 400), grasped, 600, 400);
  EXPECT_NEAR((zoomed - before).norm(), 0, 1e-9);
  const View nearest = zoomedAt(view, 1e-9, 300, 200, 600, 400);
  EXPECT_NEAR((nearest.eye_W - nearest.target_W).norm(), 2e-3, 1e-12);
}

TEST(View, rayAndProjectionAreInverse) {
  const View view = orbited(viewFrom(Side::Posterior, kBox, 1.5), -0.7, 0.4);
  for (const auto& [x, y] : {std::pair(10.0, 20.0), std::pair(300.0, 200.0), std::pair(599.0, 3.0)}) {
    const Ray ray = rayThrough(view, x, y, 600, 400);
    const auto p = projected(view, ray.origin_W + 0.37 * ray.direction_W, 600, 400);
    ASSERT_TRUE(p.has_value());
    EXPECT_NEAR(p->x(), x, 1e-9);
    EXPECT_NEAR(p->y(), y, 1e-9);
    // The matrices say the same.
    const Vec4 clip = projectionMatrix(view, 1.5, 0.01, 2) * viewMatrix(view) *
                      (ray.origin_W + ray.direction_W).homogeneous();
    EXPECT_NEAR((clip.x() / clip.w() + 1) * 300, x, 1e-6);
    EXPECT_NEAR((1 - clip.y() / clip.w()) * 200, y, 1e-6);
  }
  EXPECT_FALSE(projected(view, view.eye_W + axesOf(view).back_W, 600, 400).has_value());
}

TEST(Layers, wordsChooseWhatIsShown) {
  const Layers layers = *layersFromWords("collision,contacts");
  EXPECT_FALSE(layers.visual);
  EXPECT_TRUE(layers.collision && layers.contacts && layers.tools && layers.marker);
  EXPECT_FALSE(layers.couplings || layers.dynamics || layers.regions);
  EXPECT_TRUE(layersFromWords("all")->dynamics);
  EXPECT_FALSE(layersFromWords("all,none")->tools);
  const auto refused = layersFromWords("visual,bones");
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().fault, Fault::BadUsage);
  EXPECT_EQ(refused.error().arguments.at(0), "bones");
}

}  // namespace
}  // namespace glenoid
