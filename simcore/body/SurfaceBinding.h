// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "simcore/embed/Binding.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// A surface that an object carries: topology and, for each vertex, how it follows the object.
struct SurfaceBinding {
  std::shared_ptr<const TriMesh> mesh;   ///< rest shape in the joint's frame; never null in a model
  std::vector<VertexBinding> vertices;   ///< as many as mesh->vertices
};

/// Where an object's numbers lie in the state.
struct ObjectLayout {
  bool rigid = true;
  bool free = true;    ///< false: fixed, moved by nothing; has q but takes no part in any solve
  int qOffset = 0, qSize = 7;
  int vOffset = 0, vSize = 6;  ///< vSize is 0 for a fixed object
  int nodeCount = 0;   ///< soft only
};

/// Positions of all vertices of a surface, W, from the whole state vector q. `out` has one entry per vertex.
void surfacePositions(const SurfaceBinding& surface, const ObjectLayout& layout, const VecX& q, std::span<Vec3> out);

/// Velocities of all vertices, m/s, W; zero for a fixed object.
void surfaceVelocities(const SurfaceBinding& surface, const ObjectLayout& layout, const VecX& q, const VecX& v,
                       std::span<Vec3> out);

}  // namespace glenoid
