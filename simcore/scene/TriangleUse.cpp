// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/TriangleUse.h"

#include "simcore/scene/Joint.h"

namespace glenoid {

std::vector<int> useOfTriangles(const Part& part) {
  std::vector<int> use(part.visual->triangles.size(), 0);
  for (std::size_t u = 1; u < part.materials.size(); ++u)
    if (const Region* region = findRegion(part, part.materials[u].region); region && region->surface == SurfaceKind::Visual)
      for (const int triangle : trianglesOf(*region)) use[triangle] = static_cast<int>(u);
  return use;
}

}  // namespace glenoid
