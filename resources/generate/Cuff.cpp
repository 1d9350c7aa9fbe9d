// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "resources/generate/Bones.h"
#include "resources/generate/Flesh.h"
#include "resources/generate/Parts.h"

/// The cuff muscles: a belly that fills its fossa, a flattened tendon over the head to its footprint.
/// Lengths and thicknesses: supraspinatus 140 × 29 × 20, infraspinatus 174 × 72 × 22, subscapularis 160 × 90
/// × 22 mm; tendons 5 to 6 mm thick; footprints 23 × 16, 29 × 19 and 40 × 20 mm (Curtis et al. 2006). Teres minor: 142 × 33 × 27 mm in the reference body
/// (anatomy.json), times 1.0975; footprint 29 × 21 mm.
namespace glenoid::generate {

namespace {

using scapula::onBlade;

constexpr double kSink = -1.3;  ///< mm: how deep the swept belly settles into bone before bone is taken away
constexpr double kSunk = -1.6;  ///< mm: the same under a footprint
constexpr double kBonded = 0.05;  ///< mm between a bonded surface and bone

Vec3 inBlade(double x, double y, double z) {
  return scapula::blade().axes * Vec3(x, y, z);
}

Surfaces both(const std::vector<Station>& stations, const Bones& bones, const Field& roof, int triangles,
              double roundness, int coarseAround, const std::vector<double>& coarseRings, const Obstacle* beside = nullptr) {
  Flesh flesh;
  flesh.tube.stations = stations;
  flesh.tube.roundness = roundness;
  flesh.tube.endLength = 0.025;
  flesh.evenings = 40;
  flesh.evenTo = 0.66;
  flesh.tube.bone = unionOf(bones.scapulaShape, humerus::filledField());  // tendons do not sag into the groove
  flesh.tube.roof = roof;
  flesh.obstacles = {{bones.scapulaShape, kBonded}, {bones.humerusShape, kBonded}, {roof, 1.2}};
  if (beside) flesh.obstacles.push_back(*beside);
  Surfaces s;
  s.visual = surfaceOf(flesh, triangles);

  Tube tube = flesh.tube;
  tube.bone = unionOf(bones.scapulaShape, bones.humerusCoarse);
  tube.phase = 0.5;
  tube.endLength = 0.02;
  tube.roundness = 0.4;
  tube.places = coarseRings;  // most of them where the tendon lies on the head
  tube.stations.pop_back();  // the tendon's thin border is too thin to be touched
  for (Station& station : tube.stations) {
    const bool bonded = station.clearance < 0;
    station.reach = std::min(station.reach, 6.0);
    station.clearance = std::max(station.clearance, 0.1);
    if (station.radial < 0.6) continue;
    // Where the tendon is bonded it need not touch: there it stays out of the contacts' reach.
    if (bonded) station.halfWidth -= 2.5;
    station.clearance = bonded ? 1.6 : 0.7;
    station.thickness = std::max(station.thickness, 5.0);  // room for the near side to give way
    station.seat = 0;
  }
  s.collision = sweep(tube, coarseAround, int(coarseRings.size()));
  keepClear(s.collision, bones.humerusCoarse, 0.55);
  return s;
}

}  // namespace

std::vector<Station> supraspinatusPath() {
  const Vec3 up = inBlade(0, 0.25, 0.97);
  return {
      {onBlade(16, 13.8, 4), up, 9, 6, kSink, 8, 0, 1},
      {onBlade(23, 15.5, 5), up, 14, 12, kSink, 12, 0, 1},
      {onBlade(44, 17, 6), up, 18.6, 21, kSink, 14, 0, 1},
      {onBlade(69, 14, 7), up, 18, 25, kSink, 14, 0, 1},
      {onBlade(92, 13, 9), inBlade(0, 0.5, 0.85), 15, 21, 0.3, 4, 0, 0.6},
      {{-14, 21, -21}, {-0.3, 0.85, -0.4}, 13, 13, 0.8, 0, 0.5},
      {{-5, 26, -6}, {-0.15, 0.98, -0.1}, 11.5, 6.8, 0.9, 4, 1},
      {{-0.5, 26, 7}, {0, 0.93, 0.3}, 11.2, 6.8, 0.8, 5, 1},
      {{1.2, 22, 16.5}, {0.05, 0.75, 0.66}, 12, 6.2, -0.3, 5, 1, 0.6},
      {{1.8, 18, 23}, {0.05, 0.6, 0.8}, 13.6, 6.6, kSunk, 10, 1, 1},
      {{2.2, 13.5, 27.5}, {0.05, 0.5, 0.85}, 13.6, 6.2, kSunk, 10, 1, 1},
      {{2.3, 11.3, 29.1}, {0.05, 0.35, 0.93}, 13.2, 5.4, kSunk, 10, 1, 0.5},
  };
}

std::vector<Station> infraspinatusPath() {
  const Vec3 up = inBlade(0, 0, 1);
  return {
      {onBlade(-5, -48, 4), up, 30, 5, kSink, 8, 0, 1},
      {onBlade(0, -47.5, 4.5), up, 41, 8.5, kSink, 9, 0, 1},
      {onBlade(11, -46.5, 5), up, 48, 13.5, kSink, 10, 0, 1},
      {onBlade(38, -39.5, 5), up, 42.5, 22.8, kSink, 10, 0, 1},
      {onBlade(68, -26, 6), up, 29.5, 29, kSink, 12, 0, 1},
      {onBlade(94, -15.5, 9), inBlade(0.05, 0.1, 1), 18.5, 23, 0.3, 6, 0, 0.8},
      {{-35, -4, -13}, {-0.95, 0.1, -0.2}, 16.5, 12, 0.8, 0, 0.5, 0.3},
      {{-26.5, 2.5, 6}, {-0.95, 0.1, 0.25}, 14.5, 7.3, 0.9, 4, 1},
      {{-20.5, 5, 15}, {-0.75, 0.2, 0.65}, 14.6, 6.7, 0.7, 5, 1},
      {{-14, 5.5, 22.3}, {-0.55, 0.22, 0.8}, 15.2, 6.2, -0.3, 7, 1, 0.6},
      {{-7.5, 5.5, 27.5}, {-0.3, 0.25, 0.92}, 16.4, 6.6, kSunk, 9, 1, 1},
      {{-2, 5, 29.8}, {-0.1, 0.25, 0.97}, 16.4, 6.2, kSunk, 9, 1, 1},
      {{0, 4.9, 30.2}, {0, 0.25, 0.97}, 15.4, 5.4, kSunk, 9, 1, 0.5},
  };
}

std::vector<Station> subscapularisPath() {
  const Vec3 up = inBlade(0, 0, -1);
  return {
      {onBlade(-2, -42, -4), up, 37, 4, kSink, 8, 0, 1},
      {onBlade(2, -42, -4.5), up, 50, 6, kSink, 9, 0, 1},
      {onBlade(11, -41, -5), up, 57, 9, kSink, 10, 0, 1},
      {onBlade(36, -34, -5), up, 51.5, 15.4, kSink, 10, 0, 1},
      {onBlade(68, -24, -6), up, 35, 25.5, kSink, 12, 0, 1},
      {onBlade(95, -17.5, -10), inBlade(0.2, 0, -1), 23, 19.5, 0.3, 4, 0, 0.7},
      {{10, -11, -26.5}, {0.75, -0.2, -0.6}, 19.5, 11, 0.8, 0, 0.5},
      {{19.5, -8, -16.5}, {0.75, -0.15, -0.6}, 19.5, 7, 0.9, 6, 1},
      {{24, -6.5, -11}, {0.9, -0.1, -0.4}, 22, 6.3, -0.6, 10, 1, 0.8},
      {{26.5, -6.3, -6}, {1, 0, -0.2}, 24, 6.4, kSunk, 14, 0.6, 1},
      {{27.8, -5.8, -0.5}, {1, 0, 0.0}, 25, 6.4, kSunk, 14, 0.3, 0.8},
      {{27.8, -5.5, 3.8}, {1, 0, 0.2}, 25, 7.6, kSunk, 14, 0.2, 0.55},
      {{26.6, -5.5, 11}, {1, 0, 0.35}, 22, 7.6, kSunk, 14, 0.2, 0.5},
  };
}

/// From the outer two thirds of the blade's lateral border, behind, to the lowest facet of the greater tubercle and the neck below it.
std::vector<Station> teresMinorPath() {
  const Vec3 up = inBlade(0, -0.25, 0.95);
  return {
      {onBlade(24, -106, 4), up, 6, 5, kSink, 8, 0, 1},
      {onBlade(32, -100, 4.5), up, 9, 9, kSink, 9, 0, 1},
      {onBlade(46, -88, 5), up, 12, 16, kSink, 10, 0, 1},
      {onBlade(66, -69, 5), up, 13.5, 20, kSink, 10, 0, 1},
      {onBlade(84, -53, 6), inBlade(0.1, -0.3, 0.95), 13, 19, 0.3, 5, 0, 0.8},
      {{-33, -37, -16}, {-0.9, -0.2, 0.1}, 12, 14, 0.8, 0, 0.3, 0.3},
      {{-26.5, -24, 2}, {-0.92, -0.15, 0.25}, 11, 9, 0.9, 0, 0.6},
      {{-22.5, -18.5, 10}, {-0.85, -0.1, 0.5}, 10.5, 7, 0.7, 4, 1},
      {{-17.5, -15.5, 16.5}, {-0.7, -0.1, 0.7}, 10.5, 6.2, -0.3, 7, 0.6, 0.6},
      {{-12.5, -14.2, 21}, {-0.5, -0.1, 0.85}, 10.5, 6.2, kSunk, 9, 0.5, 1},
      {{-7.5, -14, 24}, {-0.3, -0.05, 0.95}, 10.5, 5.8, kSunk, 9, 0.5, 1},
      {{-5, -14, 25}, {-0.2, -0.05, 0.97}, 10, 5.2, kSunk, 9, 0.5, 0.5},
  };
}

Surfaces supraspinatus(const Bones& bones) {
  return both(supraspinatusPath(), bones, scapula::acromionField(), 1716, 0.7, 6,
              {0.05, 0.24, 0.46, 0.66, 0.77, 0.87, 0.985});
}

Surfaces infraspinatus(const Bones& bones) {
  return both(infraspinatusPath(), bones, scapula::acromionField(), 2136, 0.6, 8,
              {0.06, 0.30, 0.58, 0.74, 0.85, 0.97});
}

Surfaces subscapularis(const Bones& bones) {
  return both(subscapularisPath(), bones, scapula::coracoidField(), 2424, 0.85, 8,
              {0.06, 0.30, 0.62, 0.80, 0.89, 0.985});
}

Surfaces teresMinor(const Bones& bones, const TriMesh& infraspinatus) {
  const Obstacle beside{fieldOf(infraspinatus), 0.8};
  return both(teresMinorPath(), bones, scapula::acromionField(), 1800, 0.75, 8, {0.06, 0.30, 0.58, 0.76, 0.88, 0.97}, &beside);
}

}  // namespace glenoid::generate
