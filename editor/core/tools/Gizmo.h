// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "editor/core/tools/ScreenMap.h"
#include "editor/render/Layers.h"

namespace glenoid {

/// Arrows and squares by which a point is moved with the mouse: along an axis of the world, in a plane of two
/// of them, or, by the middle, in the plane that faces the viewer. Always as large on the screen, whatever
/// the distance. A value: made anew where the point is. Frame W, metres; pixels from the top left.
class Gizmo {
 public:
  enum class Grip { None, X, Y, Z, YZ, ZX, XY, Screen };

  Gizmo(const Viewport& viewport, const Vec3& centre_W);

  /// What lies under the mouse.
  Grip at(const Vec2& pixel) const;
  /// How far the point goes when this grip is dragged from one pixel to another, m. Zero where the view does
  /// not tell: an axis or a plane that is seen from its end.
  Vec3 shift(Grip grip, const Vec2& from, const Vec2& to) const;
  /// The lines and dots of it; what is `hot` is brighter.
  Strokes strokes(Grip hot) const;

 private:
  Viewport m_viewport;
  Vec3 m_centre;
  double m_length;  ///< of the arrows, m
};

}  // namespace glenoid
