// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <string>
#include <vector>

#include "simcore/mesh/TetMesh.h"
#include "simcore/mesh/TriMesh.h"

/// The blocks of PeerScene, inside to it and its tests.
namespace glenoid::peers {

/// A corner tetrahedron that is left out: its cell, and its corner counted in bits x, y, z.
struct LeftOut {
  std::array<int, 3> cell;
  int corner;
};

/// A block of regular cells of five tetrahedra each, with exactly as many of them as wanted: the last cell may be
/// missing, and a few corners are left out near the moving end, chosen such that the surface stays a manifold and
/// every node at the ends still carries a triangle there.
struct BlockShape {
  std::string name;
  std::array<int, 3> cells;  ///< along the block, up, across
  double height, width;      ///< m
  bool lastMissing;
  std::vector<LeftOut> leftOut;
  int tetrahedra;
};
const std::array<BlockShape, 7>& blockShapes();

TetMesh makeBlock(const BlockShape& shape, const Vec3& corner, double length);

/// Box of twelve triangles, wound outwards.
TriMesh boxSurface(const Vec3& low, const Vec3& high);

}  // namespace glenoid::peers
