// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/collide/FeatureOwners.h"

namespace glenoid {

FeatureOwners assignOwners(const CollisionSurface& surface, const std::vector<char>& skip) {
  FeatureOwners owners;
  owners.ofTriangle.assign(surface.triangles.size(), 0);
  owners.vertexTakesPart.assign(surface.vertexCount, 0);
  owners.edgeTakesPart.assign(surface.edges.size(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if ((t < skip.size() && skip[t]) || surface.empty[t]) {
      owners.ofTriangle[t] = FeatureOwners::kSkipped;
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      const int v = surface.triangles[t][k], e = surface.triangleEdges[t][k];
      if (!owners.vertexTakesPart[v]) owners.ofTriangle[t] |= std::uint8_t(1 << k);
      if (!owners.edgeTakesPart[e]) owners.ofTriangle[t] |= std::uint8_t(8 << k);
      owners.vertexTakesPart[v] = owners.edgeTakesPart[e] = 1;
      if (owners.anyVertex < 0) owners.anyVertex = v;
    }
  }
  return owners;
}

}  // namespace glenoid
