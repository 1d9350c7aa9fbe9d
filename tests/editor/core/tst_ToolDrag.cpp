// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/ToolDrag.h"

#include <gtest/gtest.h>

namespace glenoid {
namespace {

constexpr int kWidth = 800, kHeight = 600;

View someView() {
  View view;
  view.eye_W = Vec3(0.3, 0.2, 0.25);
  view.target_W = Vec3(0.01, 0.02, -0.01);
  return view;
}

TEST(ToolDrag, theGraspedTipStaysUnderTheCursor) {
  const View view = someView();
  const Pose hand{Vec3(0.02, 0.03, 0.01), Quat(Eigen::AngleAxisd(0.7, Vec3::UnitX()))};
  const Vec2 start = *projected(view, hand.p_WB, kWidth, kHeight);
  const ToolDrag drag(view, hand, hand.p_WB, start.x(), start.y(), kHeight);
  for (const Vec2& by : {Vec2(0, 0), Vec2(40, 0), Vec2(-25, 60), Vec2(100, -130)}) {
    const Pose moved = drag.moved(start.x() + by.x(), start.y() + by.y());
    const Vec2 seen = *projected(view, moved.p_WB, kWidth, kHeight);
    EXPECT_LT((seen - start - by).norm(), 1e-6) << by.transpose();
    EXPECT_TRUE(moved.q_WB.isApprox(hand.q_WB));
  }
}

TEST(ToolDrag, theWheelMovesAlongTheGazeAndIsKept) {
  const View view = someView();
  const Pose hand{Vec3(0.02, 0.03, 0.01), Quat::Identity()};
  ToolDrag drag(view, hand, hand.p_WB, 100, 100, kHeight);
  drag.push(0.005);
  const Vec3 by = drag.moved(100, 100).p_WB - hand.p_WB;
  EXPECT_LT((by + 0.005 * axesOf(view).back_W).norm(), 1e-12);
  const Vec3 further = drag.moved(130, 100).p_WB - drag.moved(100, 100).p_WB;
  EXPECT_NEAR(further.dot(axesOf(view).back_W), 0, 1e-12);
}

TEST(ToolDrag, aTipBehindTheEyeGivesFinitePoses) {
  const View view = someView();
  const Pose hand{view.eye_W + axesOf(view).back_W, Quat::Identity()};
  const ToolDrag drag(view, hand, hand.p_WB, 0, 0, 0);
  EXPECT_TRUE(drag.moved(500, 500).p_WB.allFinite());
}

}  // namespace
}  // namespace glenoid
