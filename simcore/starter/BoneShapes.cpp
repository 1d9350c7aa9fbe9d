// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/starter/BoneShapes.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "simcore/mesh/Isosurface.h"
#include "simcore/mesh/Simplify.h"
#include "simcore/shape/Relax.h"

namespace glenoid::starter {

shape::Field grown(shape::Field field, double by) {
  return [field = std::move(field), by](const Vec3& p) { return field(p) - by; };
}

TriMesh boneSurface(const shape::Field& field, const Box3& box, int triangles) {
  constexpr double kStep = 2;  // mm
  TriMesh fine = largestComponent(isosurface(field, box, kStep));
  shape::relax(fine, field, 2);
  Result<TriMesh> answer = simplify(fine, triangles);
  if (!answer) {
    std::fprintf(stderr, "simplify: %s\n", toLogLine(answer.error()).c_str());
    std::abort();
  }
  return std::move(*answer);
}

TriMesh bandSurface(const std::vector<BandPlace>& places, double thickness, const shape::Field& bone) {
  constexpr double kFall = 0.8;  // mm by which the edges come down to bone that turns away
  shape::Tube tube;
  for (const BandPlace& place : places) {
    const bool spans = place.over < 0;
    const Vec3 base = spans ? place.near : shape::project(bone, place.near, place.over);
    tube.stations.push_back({base, shape::gradient(bone, base), place.halfWidth, thickness, std::max(place.over, 0.3), spans ? 0 : kFall});
  }
  tube.bone = bone;
  tube.roundness = 0.55;
  tube.endLength = 0.12;
  return shape::sweep(tube, 16, 24);
}

}  // namespace glenoid::starter
