// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

Hash128 contentHash(const TriMesh& mesh) {
  static_assert(sizeof(Vec3) == 24 && sizeof(mesh.triangles[0]) == 12);
  const Hash128 points = hashBytes(mesh.vertices.data(), mesh.vertices.size() * sizeof(Vec3), 1);
  return hashBytes(mesh.triangles.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]), points.low ^ points.high);
}

Box3 boundsOf(const TriMesh& mesh) {
  Box3 box;
  for (const Vec3& x : mesh.vertices) box.extend(x);
  return box;
}

double enclosedVolume(const TriMesh& mesh) {
  if (mesh.vertices.empty()) return 0;
  const Vec3 origin = mesh.vertices[0];  // near the mesh: keeps digits when it stands far from the world's origin
  double six = 0;
  for (const auto& t : mesh.triangles)
    six += (mesh.vertices[t[0]] - origin).dot((mesh.vertices[t[1]] - origin).cross(mesh.vertices[t[2]] - origin));
  return six / 6;
}

}  // namespace glenoid
