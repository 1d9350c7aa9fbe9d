// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/ToolDrag.h"

#include <algorithm>
#include <cmath>

namespace glenoid {

ToolDrag::ToolDrag(const View& view, const Pose& hand, const Vec3& tip_W, double x, double y, int heightPx)
    : m_view(view), m_hand(hand), m_x(x), m_y(y) {
  const double depth = (view.eye_W - tip_W).dot(axesOf(view).back_W);
  // A tip behind the eye still has to move somehow: as if it lay one millimetre before it.
  m_metresPerPixel = 2 * std::max(depth, 1e-3) * std::tan(view.fieldOfView / 2) / std::max(heightPx, 1);
}

Pose ToolDrag::moved(double x, double y) const {
  const ViewAxes axes = axesOf(m_view);
  Pose hand = m_hand;
  hand.p_WB += axes.right_W * ((x - m_x) * m_metresPerPixel) - axes.up_W * ((y - m_y) * m_metresPerPixel) -
               axes.back_W * m_depth;
  return hand;
}

}  // namespace glenoid
