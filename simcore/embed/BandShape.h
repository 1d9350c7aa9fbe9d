// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>

#include "simcore/mesh/TetMesh.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// How a band lies over its own plane: the height of its middle surface, a cubic in the plane's coordinates. Moving every
/// place down by the height there makes the band flat; a grid cut round the flat band and moved up again follows it, so
/// that its cells' faces lie along the tissue. The move is a shear along one axis: it keeps volumes and has an inverse.
/// For bands that are a graph over their plane (less than a quarter turn). Frame W at rest, m.
struct BandShape {
  Vec3 origin = Vec3::Zero();
  Mat3 axes = Mat3::Identity();      ///< columns: along, across, off the plane; a rotation
  double length = 1;                 ///< m: x and y count in it
  std::array<double, 10> height{};   ///< m: of 1, x, y, x², xy, y², x³, x²y, xy², y³

  double heightOver(const Vec3& p_W) const;
  Vec3 flattened(const Vec3& p_W) const { return p_W - heightOver(p_W) * axes.col(2); }
  Vec3 bent(const Vec3& flat_W) const { return flat_W + heightOver(flat_W) * axes.col(2); }
};

/// The band that a closed surface is: its principal plane, and the cubic nearest to both of its sides (least squares over the
/// area as seen along the normal, so that the rim does not count). A function of the surface alone. Deterministic.
BandShape bandOf(const TriMesh& surface);

/// A surface with each vertex flattened. Triangles are cut where their flat image would leave that of the surface by more
/// than `tolerance` (m) so that what it encloses stays what it was.
TriMesh flattened(const BandShape& band, const TriMesh& surface, double tolerance);

}  // namespace glenoid
