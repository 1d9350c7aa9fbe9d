// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/mesh/TriMesh.h"
#include "simcore/scene/Scenario.h"

namespace glenoid {

/// Closed surface of a tool in its own frame (origin at the tip, +Z along the shaft to the handle), m:
/// rings swept along a path in the XZ plane. A probe ends in a 4 mm hook toward +X whose outermost point of
/// the elbow is the origin; an arthroscope in a straight rounded end; a finger is a tapered capsule. A ball is
/// a sphere with twice as many corners, since all of it meets tissue, on a shaft of a quarter of its radius; a
/// bar is a box of twelve triangles.
/// `segments`: corners of a ring; the collision surface takes few, the visual one many. Rings lie closer near
/// the tip, where the tool meets tissue.
TriMesh makeToolSurface(const Tool& tool, int segments);

inline constexpr int kToolCollisionSegments = 8;
inline constexpr int kToolVisualSegments = 24;

}  // namespace glenoid
