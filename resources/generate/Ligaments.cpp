// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "resources/generate/Bones.h"
#include "resources/generate/Parts.h"

/// The three ligaments as bands with rounded ends. Sizes: coracoacromial 35 long, 22 wide at the acromion, 13 at the
/// coracoid, 1.3 thick (doi 10.1155/2019/3024769: 29.8 ± 9.5, 12.6 ± 4, 1.3 and 0.9); coracohumeral 42 × 15 ×
/// 3; transverse humeral 20 × 16 × 1.5 (doi 10.5603/FM.a2019.0075).
namespace glenoid::generate {

namespace {

Field raised(Field field, double by) {
  return [=](const Vec3& p) { return field(p) - by; };
}

/// Places of so many rings that lie closer towards both ends, where the outline turns.
std::vector<double> closerAtEnds(int rings) {
  std::vector<double> places;
  for (int j = 0; j < rings; ++j) {
    const double even = (j + 0.4) / (rings - 0.2), round = 0.5 - 0.5 * std::cos(std::numbers::pi * even);
    places.push_back(0.25 * even + 0.75 * round);
  }
  return places;
}

}  // namespace

Surfaces coracoacromialLigament(const Bones&) {
  const Field acromion = scapula::acromionField(), coracoid = scapula::coracoidField();
  // A sheet whose ends stand in bone: it comes out from under the acromion and goes into the coracoid's edge.
  const Vec3 out = project(acromion, Vec3(-0.5, 33, -7.5)), in = project(coracoid, Vec3(17.0, 21.5, -33.5));
  const Vec3 way = (in - out).normalized(), up = Vec3(0.35, 0.9, -0.25);
  const auto at = [&](double share, double lift) { return Vec3(out + share * (in - out) + lift * up); };
  Tube tube;
  tube.roundness = 0.5;
  tube.endLength = 0.05;
  tube.stations = {
      {out - 7 * way + Vec3(0, -0.7, 0), {-0.1, 1, -0.1}, 11.0, 1.2, 0, 0, 0},
      {out + Vec3(0, -0.8, 0), {0.05, 1, -0.1}, 11.4, 1.2, 0, 0, 0},
      {at(0.33, 1.5), {0.35, 0.9, -0.25}, 10.0, 1.1, 0, 0, 0},
      {at(0.67, 1.3), {0.4, 0.85, -0.3}, 8.0, 1.1, 0, 0, 0},
      {in, {0.35, 0.85, -0.3}, 6.4, 1.1, 0, 0, 0},
      {in + 2.5 * way, {0.3, 0.85, -0.3}, 5.6, 1.1, 0, 0, 0},
  };
  Surfaces s;
  tube.places = closerAtEnds(34);
  tube.endLength = 0.12;
  s.visual = sweep(tube, 24, 34);
  tube.places.clear();
  tube.endLength = 0.05;
  tube.phase = 0.5;
  s.collision = sweep(tube, 6, 12);
  return s;
}

Surfaces coracohumeralLigament(const Bones& bones, const TriMesh& biceps) {
  Tube tube;
  tube.roundness = 0.6;
  tube.endLength = 0.10;
  tube.stations = {
      {{25.0, 14.0, -30.5}, {0.75, 0.65, 0.1}, 5.4, 2.8, 0, 0, 0},
      {{25.2, 17.0, -23.5}, {0.65, 0.75, 0}, 6.4, 3, 0, 0, 0},
      {{24.0, 21.5, -14}, {0.65, 0.75, -0.1}, 7.4, 3.2, 0.8, 0, 0.3},
      {{22.4, 23.4, -3}, {0.68, 0.72, 0}, 7.6, 3.1, 0.8, 0, 1},
      {{20.4, 24.0, 5}, {0.66, 0.74, 0.15}, 7.4, 2.8, 0.6, 0, 1},
      {{17.6, 22.6, 10.8}, {0.62, 0.74, 0.3}, 6.8, 2.5, 0.2, 0, 1},
      {{14.0, 19.2, 15.8}, {0.55, 0.7, 0.45}, 6.0, 1.8, -0.3, 6, 1},
  };
  const Field cord = raised(fieldOf(biceps), 2.1);
  // Bridges the groove instead of dipping into it.
  tube.bone = smoothUnion({humerus::filledField(), raised(fieldOf(biceps), 1.4)}, 8);
  Surfaces s;
  tube.endLength = 0.24;
  tube.places = closerAtEnds(13);
  s.visual = sweep(tube, 20, 13);
  tube.places.clear();
  tube.bone = unionOf(bones.humerusCoarse, cord);
  tube.endLength = 0.03;
  for (Station& st : tube.stations) {
    if (st.radial > 0) st.clearance = std::max(st.clearance, 1.2);
    if (st.radial > 0.5) st.reach = 4;
  }
  tube.phase = 0.5;
  s.collision = sweep(tube, 6, 5);
  return s;
}

Surfaces transverseHumeralLigament(const Bones& bones, const TriMesh& biceps) {
  // From the lesser to the greater tubercle, arching over the tendon in the groove; its ends thin out on
  // bone.
  Tube tube;
  tube.roundness = 0.85;
  tube.endLength = 0.38;
  const std::vector<Vec3> path{
      {26.6, 1.5, 7.0}, {25.3, 1.8, 10.6}, {22.4, 2.0, 16.2}, {19.2, 2.2, 20.8}, {15.6, 2.4, 24.0}};
  const double thickness[] = {1.0, 1.6, 1.7, 1.6, 1.0};
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool atEnd = i != 2, last = i == 0 || i + 1 == path.size();
    const Vec3 up = path[i] - humerus::canalAt(path[i].y());
    tube.stations.push_back({path[i], up, 8.2, thickness[i], last ? -0.4 : atEnd ? 0.0 : 0.3, atEnd ? 9.0 : 4.0, 0});
  }
  const Field cord = raised(fieldOf(biceps), 0.7);
  tube.bone = smoothUnion({humerus::filledField(), cord}, 3);
  Surfaces s;
  tube.places = closerAtEnds(13);
  s.visual = sweep(tube, 10, 13);
  tube.places.clear();
  tube.bone = unionOf(bones.humerusCoarse, raised(fieldOf(biceps), 1.45));
  for (Station& station : tube.stations) {
    station.thickness = 1.8;
    station.clearance = std::max(station.clearance, 0.0);
    station.reach = station.reach < 5 ? 0 : 5;
  }
  tube.phase = 0.5;
  tube.flatEnds = true;
  tube.roundness = 0.4;
  tube.endLength = 0.02;
  s.collision = sweep(tube, 4, 4);
  keepClear(s.collision, fieldOf(biceps), 0.8);
  return s;
}

}  // namespace glenoid::generate
