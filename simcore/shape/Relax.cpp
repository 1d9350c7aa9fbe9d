// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/shape/Relax.h"

namespace glenoid::shape {

void relax(TriMesh& mesh, const Field& field, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Vec3> means = neighbourMeans(mesh);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      const Vec3 toMean = means[i] - mesh.vertices[i];
      const Vec3 normal = gradient(field, mesh.vertices[i]).normalized();
      mesh.vertices[i] = project(field, mesh.vertices[i] + 0.7 * (toMean - toMean.dot(normal) * normal));
    }
  }
}

}  // namespace glenoid::shape
