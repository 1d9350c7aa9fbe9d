// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/TetMesh.h"

namespace glenoid {

Hash128 contentHash(const TetMesh& mesh) {
  const Hash128 points = hashBytes(mesh.nodes.data(), mesh.nodes.size() * sizeof(Vec3), 2);
  return hashBytes(mesh.tets.data(), mesh.tets.size() * sizeof(mesh.tets[0]), points.low ^ points.high);
}

double tetVolume(const TetMesh& mesh, int tet) {
  const auto& t = mesh.tets[tet];
  const Vec3& x0 = mesh.nodes[t[0]];
  return (mesh.nodes[t[1]] - x0).dot((mesh.nodes[t[2]] - x0).cross(mesh.nodes[t[3]] - x0)) / 6;
}

}  // namespace glenoid
