// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/scene/Joint.h"

namespace glenoid {

/// A motion that keeps distances, a mirror image included: x ↦ R x + t, R orthogonal.
struct Isometry {
  Mat3 R = Mat3::Identity();
  Vec3 t = Vec3::Zero();  ///< m

  /// Nothing is added where R or t is zero: a mirror in a plane of W so changes nothing but a sign, that of a zero too.
  Vec3 operator*(const Vec3& x) const;
  bool mirrors() const { return R.determinant() < 0; }
  Isometry inverse() const { return {R.transpose(), -(R.transpose() * t)}; }
};

/// Everything of a joint that has a place or a direction, elsewhere: meshes, landmarks, cages, the places of dents, its axes. Where the motion mirrors,
/// triangles are wound the other way round and tetrahedra numbered so, that surfaces look outwards and volumes are positive;
/// vertices, triangles and tetrahedra keep their order, so regions hold. Meshes that parts share stay shared. What was
/// counted or computed on the joint (the proof of its start, its dents) stays with it where it held.
Joint movedJoint(const Joint& joint, const Isometry& motion);

/// Of one mesh the same.
TriMesh movedMesh(const TriMesh& mesh, const Isometry& motion);
TetMesh movedMesh(const TetMesh& mesh, const Isometry& motion);

}  // namespace glenoid
