// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Math.h"

namespace glenoid {

/// Barycentric weights of the point of triangle abc that is nearest to p; weights of corners that do not
/// carry it are exactly zero. A triangle without area gives a point on its longest reach, never NaN. Source:
/// Ericson, "Real-Time Collision Detection", 2005, section 5.1.5 (Voronoi regions).
Vec3 nearestBarycentric(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace glenoid
