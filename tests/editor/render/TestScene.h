// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/step/Model.h"

/// A small scene made by hand, with everything a view can show: a rigid box with creases, a rigid sphere, a
/// soft ball embedded in five tetrahedra, springs between ball and box, a named region, and a tool.
namespace glenoid::test {

enum Object { kBox, kSphere, kBall, kTool };

/// Objects in the order above; about 0.2 m across.
Model smallScene();

/// The start state with the box turned and moved and the ball squeezed and sheared.
State movedState(const Model& model);

/// One surface of the model wound the other way round.
Model withFlippedSurface(Model model, int object);

/// A sphere of `rings` × 2·rings quads; closed, wound outwards.
TriMesh sphereMesh(const Vec3& center, double radius, int rings);
TriMesh boxMesh(const Vec3& half);

/// Position of a surface vertex on the CPU, W, written from the definition of VertexBinding and ObjectLayout
/// alone.
Vec3 expectedPosition(const SceneObject& object, const VertexBinding& binding, const VecX& q);

}  // namespace glenoid::test
