// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "editor/render/View.h"

namespace glenoid {

/// One drag of a tool with the mouse, as a pure function of where it began: left drag moves the hand in the plane
/// through the tip that faces the viewer, the wheel moves it along the gaze. The turn of the tool stays.
/// A point that was grasped stays under the cursor. Frames: W; pixels from the top left.
class ToolDrag {
 public:
  /// `tip_W`: what is grasped; `hand`: the pose the hand has now.
  ToolDrag(const View& view, const Pose& hand, const Vec3& tip_W, double x, double y, int heightPx);

  /// The hand's pose with the cursor at (x, y).
  Pose moved(double x, double y) const;
  /// Away from the viewer by `depth`, m (negative: nearer); keeps what was dragged so far.
  void push(double depth) { m_depth += depth; }

 private:
  View m_view;
  Pose m_hand;
  double m_x, m_y, m_metresPerPixel, m_depth = 0;
};

/// Metres that one notch of the wheel moves a tool in depth.
inline constexpr double kDepthPerNotch = 0.001;

}  // namespace glenoid
