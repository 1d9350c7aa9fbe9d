// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/base/Math.h"

namespace glenoid {

/// What can be picked of a part, as it is seen from one place: triangles of a surface (ScreenMap) or nodes of its
/// cells (NodeMap), numbered from 0. All picking in the plane of the screen (click, box, lasso, brush) asks here.
class PickMap {
 public:
  virtual ~PickMap() = default;
  /// Pixel of the middle of each; far outside of any window for what lies behind the eye.
  virtual const std::vector<Eigen::Vector2f>& centres() const = 0;
  /// Within the window, not hidden and not turned away.
  virtual bool seen(int item) const = 0;
  /// What is under a pixel, −1: nothing. Without `through` only what is seen.
  virtual int at(const Vec2& pixel, bool through) const = 0;
  /// Whether they may reach farther than the brush, which then takes what is under its way as well.
  virtual bool haveExtent() const = 0;
};

}  // namespace glenoid
