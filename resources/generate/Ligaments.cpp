// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "resources/generate/Bones.h"
#include "resources/generate/Parts.h"

/// The three ligaments as bands. Sizes: coracoacromial 35 long, 22 wide at the acromion, 13 at the
/// coracoid, 1.3 thick (doi 10.1155/2019/3024769: 29.8 ± 9.5, 12.6 ± 4, 1.3 and 0.9); coracohumeral 42 × 15 ×
/// 3; transverse humeral 20 × 16 × 1.5 (doi 10.5603/FM.a2019.0075).
namespace glenoid::generate {

namespace {

Field raised(Field field, double by) {
  return [=](const Vec3& p) { return field(p) - by; };
}

}  // namespace

Surfaces coracoacromialLigament(const Bones&) {
  const Field acromion = scapula::acromionField(), coracoid = scapula::coracoidField();
  // Ends lie 0.4 mm in the bone: under the acromion, on top of the coracoid.
  const auto under = [&](double x, double z) {
    return Vec3(settle(acromion, Vec3(x, 24, z), -Vec3::UnitY(), 0, 20) - 0.9 * Vec3::UnitY());
  };
  const auto onTop = [&](double x, double z) {
    return Vec3(settle(coracoid, Vec3(x, 40, z), Vec3::UnitY(), 0, 35) - 0.4 * Vec3::UnitY());
  };
  Tube tube;
  tube.roundness = 0.35;
  tube.endLength = 0.015;
  tube.stations = {
      {under(-7, 0), {-0.25, 1, 0.05}, 11, 1.3, 0, 0, 0},
      {under(-2.5, -6), {-0.1, 1, -0.1}, 11, 1.3, 0, 0, 0},
      {{3.5, 31.8, -15.5}, {0.35, 0.9, -0.25}, 9.5, 1.3, 0, 0, 0},
      {{9.5, 28.2, -25}, {0.4, 0.85, -0.3}, 7.4, 1.3, 0, 0, 0},
      {onTop(14.5, -34), {0.35, 0.85, -0.3}, 6.0, 1.3, 0, 0, 0},
      {onTop(16.5, -37.5), {0.3, 0.85, -0.3}, 5.5, 1.3, 0, 0, 0},
  };
  Surfaces s;
  s.visual = sweep(tube, 24, 34);
  tube.phase = 0.5;
  s.collision = sweep(tube, 6, 12);
  return s;
}

Surfaces coracohumeralLigament(const Bones& bones, const TriMesh& biceps) {
  Tube tube;
  tube.roundness = 0.5;
  tube.endLength = 0.03;
  tube.stations = {
      {{25.0, 13.5, -32}, {0.75, 0.65, 0.1}, 4.5, 3, 0, 0, 0},
      {{25.0, 16.2, -25}, {0.65, 0.75, 0}, 6.0, 3, 0, 0, 0},
      {{24.0, 21.5, -14}, {0.65, 0.75, -0.1}, 7.2, 3, 0.8, 0, 0.3},
      {{22.4, 23.2, -3}, {0.68, 0.72, 0}, 7.4, 2.8, 0.8, 1.5, 1},
      {{19.6, 23.6, 5}, {0.66, 0.74, 0.15}, 7.0, 2.4, 0.5, 4, 1},
      {{15.8, 21.8, 11.5}, {0.62, 0.74, 0.3}, 6.4, 2.2, 0.1, 6, 1},
      {{12.8, 19.0, 16.0}, {0.55, 0.7, 0.45}, 5.6, 1.8, 0.0, 6, 1},
  };
  const Field cord = raised(fieldOf(biceps), 0.8);
  tube.bone = unionOf(bones.humerusShape, raised(fieldOf(biceps), 1.6));
  Surfaces s;
  s.visual = sweep(tube, 20, 13);
  tube.bone = unionOf(bones.humerusCoarse, cord);
  for (Station& st : tube.stations)
    if (st.radial > 0) st.clearance = std::max(st.clearance, 1.2);
  tube.phase = 0.5;
  s.collision = sweep(tube, 6, 5);
  return s;
}

Surfaces transverseHumeralLigament(const Bones& bones, const TriMesh& biceps) {
  // From the lesser to the greater tubercle, arching over the tendon in the groove; only its ends come down
  // to bone.
  Tube tube;
  tube.roundness = 0.4;
  tube.endLength = 0.02;
  const std::vector<Vec3> path{
      {27.5, 1.5, 3.0}, {26.8, 1.8, 8.0}, {23.0, 2.0, 15.6}, {19.2, 2.2, 21.8}, {13.5, 2.4, 26.5}};
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool atEnd = i != 2;
    const Vec3 up = path[i] - humerus::canalAt(path[i].y());
    tube.stations.push_back({path[i], up, 7.5, 1.5, atEnd ? 0.0 : 0.3, atEnd ? 5.0 : 0.0, 0});
  }
  const Field cord = raised(fieldOf(biceps), 0.7);
  tube.bone = unionOf(bones.humerusShape, cord);
  Surfaces s;
  s.visual = sweep(tube, 12, 11);
  tube.bone = unionOf(bones.humerusCoarse, cord);
  tube.phase = 0.5;
  tube.flatEnds = true;
  s.collision = sweep(tube, 4, 4);
  keepClear(s.collision, fieldOf(biceps), 0.8);
  return s;
}

}  // namespace glenoid::generate
