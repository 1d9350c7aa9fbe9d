// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "resources/generate/Bones.h"
#include "resources/generate/Parts.h"

/// The three cuff muscles: a belly that fills its fossa, a flattened tendon over the head to its footprint.
/// Lengths and thicknesses: supraspinatus 140 × 29 × 20, infraspinatus 174 × 72 × 22, subscapularis 160 × 90
/// × 22 mm; footprints after Curtis et al. 2006, narrowed at their common borders.
namespace glenoid::generate {

namespace {

using scapula::onBlade;

Surfaces both(Tube tube, const Bones& bones, const Field& roof, int around, int along, int coarseAround,
              const std::vector<double>& coarseRings) {
  tube.bone = unionOf(bones.scapulaShape, bones.humerusShape);
  tube.roof = roof;
  Surfaces s;
  s.visual = sweep(tube, around, along);
  tube.bone = unionOf(bones.scapulaShape, bones.humerusCoarse);
  tube.phase = 0.5;
  tube.endLength = 0.02;
  tube.roundness = 0.4;
  tube.places = coarseRings;  // most of them where the tendon lies on the head
  for (Station& station : tube.stations)
    if (station.radial > 0.5) {
      station.clearance = 0.7;
      station.thickness = std::max(station.thickness, 4.5);  // room for the near side to give way
    }
  s.collision = sweep(tube, coarseAround, int(coarseRings.size()));
  keepClear(s.collision, bones.humerusCoarse, 0.55);
  return s;
}

Vec3 inBlade(double x, double y, double z) {
  return scapula::blade().axes * Vec3(x, y, z);
}

}  // namespace

Surfaces supraspinatus(const Bones& bones) {
  const Vec3 up = inBlade(0, 0.35, 0.93);
  Tube tube;
  tube.stations = {
      {onBlade(9, 13, 4), up, 6, 5, 0.1, 8, 0},
      {onBlade(22, 18, 4), up, 11, 12, 0.1, 10, 0},
      {onBlade(46, 19, 5), up, 13.5, 19, 0.1, 12, 0},
      {onBlade(70, 14, 6), up, 11.5, 19, 0.1, 12, 0},
      {onBlade(92, 13, 9), inBlade(0, 0.6, 0.8), 10.5, 15, 0.3, 4, 0},
      {{-13, 21.5, -21}, {-0.3, 0.85, -0.4}, 10.5, 7.4, 0.8, 0, 0.5},
      {{-5, 26, -6}, {-0.15, 0.98, -0.1}, 10.5, 5.0, 0.9, 4, 1},
      {{-1, 26, 8}, {0, 0.93, 0.3}, 9.6, 5.2, 0.8, 5, 1},
      {{0.5, 21.5, 19.5}, {0.05, 0.75, 0.66}, 9.2, 4.8, 0.2, 6, 1},
      {{1.5, 15.5, 26}, {0.05, 0.5, 0.85}, 8.2, 2.6, 0.0, 6, 1},
  };
  return both(tube, bones, scapula::acromionField(), 26, 33, 6, {0.05, 0.24, 0.46, 0.66, 0.77, 0.87, 0.985});
}

Surfaces infraspinatus(const Bones& bones) {
  const Vec3 up = inBlade(0, 0, 1);
  Tube tube;
  tube.stations = {
      {onBlade(4, -50, 4), up, 30, 6, 0.1, 8, 0},
      {onBlade(16, -51, 5), up, 42, 14, 0.1, 10, 0},
      {onBlade(42, -44, 5), up, 33, 21, 0.1, 10, 0},
      {onBlade(70, -33, 6), up, 24, 22, 0.1, 10, 0},
      {onBlade(93, -22, 9), inBlade(0.2, 0.1, 1), 15, 16, 0.3, 4, 0},
      {{-31.5, -5, -12}, {-0.95, 0.1, -0.2}, 14, 10, 0.8, 0, 0.5},
      {{-26, 3, 6}, {-0.95, 0.1, 0.25}, 12.5, 6.2, 0.9, 4, 1},
      {{-19, 6, 17}, {-0.75, 0.2, 0.65}, 11, 5.4, 0.6, 5, 1},
      {{-10.5, 6.5, 25.5}, {-0.4, 0.25, 0.87}, 10.5, 4.4, 0.1, 6, 1},
      {{-5, 6.5, 29}, {-0.2, 0.25, 0.95}, 9.0, 2.6, 0.0, 6, 1},
  };
  return both(tube, bones, scapula::acromionField(), 33, 32, 8, {0.06, 0.30, 0.58, 0.74, 0.85, 0.985});
}

Surfaces subscapularis(const Bones& bones) {
  const Vec3 up = inBlade(0, 0, -1);
  Tube tube;
  tube.stations = {
      {onBlade(3, -50, -4), up, 36, 6, 0.1, 8, 0},
      {onBlade(15, -49, -5), up, 50, 14, 0.1, 10, 0},
      {onBlade(42, -42, -5), up, 39, 22, 0.1, 10, 0},
      {onBlade(70, -32, -6), up, 27, 22, 0.1, 10, 0},
      {onBlade(95, -23, -10), inBlade(0.3, 0, -1), 19, 16, 0.3, 4, 0},
      {{10, -11.5, -26.5}, {0.75, -0.2, -0.6}, 16.5, 9.5, 0.8, 0, 0.5},
      {{19, -7.5, -17}, {0.75, -0.2, -0.6}, 15.5, 7, 0.9, 6, 1},
      {{24.5, -5, -9.5}, {0.95, -0.1, -0.35}, 14.5, 5.6, 0.6, 5, 1},
      {{26.8, -5, -5}, {1, 0, -0.15}, 12.5, 4.4, 0.0, 6, 1},
      {{27.5, -5.5, -0.8}, {1, 0, 0.0}, 10.5, 2.6, 0.0, 6, 1},
  };
  return both(tube, bones, scapula::coracoidField(), 36, 34, 8, {0.06, 0.30, 0.62, 0.80, 0.89, 0.985});
}

}  // namespace glenoid::generate
