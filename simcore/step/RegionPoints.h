// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/body/ContactObject.h"
#include "simcore/step/Model.h"

namespace glenoid {

/// A region as a surface of flat triangles whose corners are material points of its part. On a soft part each of the
/// region's triangles is split n² times, with one n for all so that what was joined stays joined, until the edges are no
/// longer than half an edge of the tetrahedra: then the surface follows what the tetrahedra do, and a third of a
/// triangle's integral at each corner is exact where it lies in one tetrahedron and of the second order elsewhere.
struct RegionPoints {
  std::vector<Vec3> rest_W;                   ///< m
  std::vector<MaterialPoint> points;          ///< as many
  std::vector<std::array<int, 3>> triangles;  ///< of points, wound outwards
  std::vector<double> area;                   ///< of each point at rest: a third of its triangles', m²
};

/// Of a region of the object's part; `restCentre`: body frame origin of a rigid part at rest. Fails with UnknownId
/// (arguments: region, "region") or Unusable where the region has no area.
Result<RegionPoints> regionPoints(const SceneObject& object, const Part& part, const std::string& region,
                                  const Vec3& restCentre);

}  // namespace glenoid
