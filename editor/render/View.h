// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "simcore/base/Math.h"
#include "simcore/scene/JointSide.h"
#include "simcore/scene/Scenario.h"

namespace glenoid {

/// Where one looks from. Frame W: X anterior, Y superior, Z to the right of the body; metres. Near and far planes are not
/// kept: they follow from what is in the scene. A value: every motion answers a new view.
struct View {
  Vec3 eye_W = Vec3(0.4, 0.1, 0.4);
  Vec3 target_W = Vec3::Zero();
  Vec3 up_W = Vec3::UnitY();  ///< any direction that is not along the gaze
  double fieldOfView = 0.6;   ///< vertical, rad, in (0, π)
};

/// Orthonormal camera axes in W: right, up, back (from target to eye).
struct ViewAxes {
  Vec3 right_W, up_W, back_W;
};
ViewAxes axesOf(const View& view);

/// Turns about the target: `yaw` about the vertical axis Y of the world, `pitch` about the camera's right
/// axis, rad; positive moves the scene to the right and down, as if grasped. Stops over the poles instead of
/// rolling over.
View orbited(const View& view, double yaw, double pitch);

/// Moves eye and target so that what lies in the target's plane follows the cursor by (dx, dy) pixels, y
/// down.
View panned(const View& view, double dx, double dy, int heightPx);

/// Scales the distance by `factor` (< 1: nearer) and keeps what lies in the target's plane under the cursor
/// (x, y; pixels from the top left) where it is. The distance stays within 2 mm and 20 m.
View zoomedAt(const View& view, double factor, double x, double y, int widthPx, int heightPx);

/// Same direction, whole box in sight with a margin of 8 %. An empty box changes nothing.
View framed(const View& view, const Box3& box_W, double aspect);

/// Named directions of a joint. The name says where the viewer stands; lateral and medial follow the joint's side.
enum class Side { Anterior, Posterior, Lateral, Medial, Superior, Inferior };
inline constexpr Side kSides[] = {Side::Anterior, Side::Posterior, Side::Lateral,
                                  Side::Medial,   Side::Superior,  Side::Inferior};
const char* sideName(Side side);  ///< "anterior", …
std::optional<Side> sideNamed(std::string_view name);
View viewFrom(Side side, const Box3& box_W, double aspect, double fieldOfView = 0.5, JointSide of = JointSide::Unsaid);

View viewOf(const Camera& camera);

/// World → camera, and camera → clip space of OpenGL (z in [−1, 1]).
Eigen::Matrix4d viewMatrix(const View& view);
Eigen::Matrix4d projectionMatrix(const View& view, double aspect, double nearPlane, double farPlane);

/// Ray through a pixel's point (x, y from the top left), direction of length one.
struct Ray {
  Vec3 origin_W, direction_W;
};
Ray rayThrough(const View& view, double x, double y, int widthPx, int heightPx);

/// Pixel (from the top left) at which a point is seen; nothing when it lies behind the eye.
std::optional<Vec2> projected(const View& view, const Vec3& p_W, int widthPx, int heightPx);

}  // namespace glenoid
