// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/base/Math.h"

namespace glenoid {

/// How things are picked on the screen.
enum class PickMode { Click, Box, Lasso, Brush };
inline constexpr PickMode kPickModes[] = {PickMode::Click, PickMode::Box, PickMode::Lasso, PickMode::Brush};

/// Where the mouse is and which keys are held: Shift adds, Ctrl subtracts, Alt goes through.
struct Pointer {
  Vec2 at = Vec2::Zero();  ///< pixels from the top left
  bool shift = false, ctrl = false, alt = false;
};

/// What one press, move and release marks on the screen: a point, a rectangle, a closed curve, or a broad
/// line.
class PickStroke {
 public:
  PickStroke() = default;
  PickStroke(PickMode mode, const Vec2& at, double radius) : m_mode(mode), m_radius(radius), m_path{at} {}

  void extend(const Vec2& at);
  PickMode mode() const { return m_mode; }
  const Vec2& first() const { return m_path.front(); }
  const Vec2& last() const { return m_path.back(); }
  const Vec2& previous() const { return m_path.size() > 1 ? m_path[m_path.size() - 2] : m_path.back(); }
  /// Whether a point of the screen is marked. A brush marks what lies within its radius of the path's last
  /// piece, since the pieces before have been asked for when they were the last. A click marks a square of
  /// five pixels.
  bool covers(const Vec2& p) const;
  /// Closed line around what is marked, for drawing; empty for a click.
  std::vector<Vec2> outline() const;

 private:
  PickMode m_mode = PickMode::Click;
  double m_radius = 0;
  std::vector<Vec2> m_path;
};

/// A circle as a closed line.
std::vector<Vec2> circleOutline(const Vec2& centre, double radius);

}  // namespace glenoid
