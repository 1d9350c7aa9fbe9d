// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <vector>

#include "simcore/author/MoveJoint.h"

namespace glenoid {

/// A frame that surfaces bring with them: origin at the centroid of their area, axes along its principal axes, signs by what is
/// lopsided about them. It goes along when the surfaces are shifted or turned, and is their mirror image when they are
/// mirrored; so what is computed in it does not depend on where the author's coordinates lie. Coordinates in it are rounded to
/// a grid far finer than any scan (some 1e-8 of the size), which takes off what rounding in W left: work that goes different
/// ways at the last bit, as decimation and contact do, then begins with the same bits.
/// Not so where surfaces have no axes of their own: a shape that a turn maps to itself gets axes from W, which a turn of the
/// author's changes.
struct OwnFrame {
  Isometry own_W;   ///< x in the frame = own_W * x in W
  double grid = 0;  ///< m

  TriMesh toOwn(const TriMesh& mesh_W) const;
  TriMesh toW(const TriMesh& mesh) const { return movedMesh(mesh, own_W.inverse()); }
  TetMesh toW(const TetMesh& mesh) const { return movedMesh(mesh, own_W.inverse()); }
  /// The joint, all meshes and cages on the grid; without proof of its start and dents, which were of the other coordinates.
  Joint toOwn(const Joint& joint) const;
};

/// Of these surfaces together; they may be null. Surfaces count by their place in the list where all else is even. Of
/// nothing, or what has no area: the frame W itself.
OwnFrame ownFrameOf(const std::vector<std::shared_ptr<const TriMesh>>& surfaces);

/// Of a joint: of its parts' visual surfaces, which are what an author brought.
OwnFrame ownFrameOf(const Joint& joint);

/// The same surface in an order that follows from its shape alone: vertices by coordinates, triangles by their vertices, each
/// from its lowest vertex on. Vertices at one place stay as many as they are.
TriMesh inOwnOrder(const TriMesh& mesh);

}  // namespace glenoid
