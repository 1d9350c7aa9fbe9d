// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "resources/generate/Superficial.h"

namespace glenoid::generate {
namespace {

constexpr double kBursa = 1.6;   ///< mm, what lies between the deltoid and the cuff
constexpr double kSeptum = 0.9;  ///< mm between two neighbouring parts

Tube clavicular() {
  Tube tube;
  tube.stations = {
      {{13, 33, -46}, {0.75, 0.65, 0.1}, 28, 3.5, 0.4, 10, 0},
      {{21, 27, -37}, {0.85, 0.5, 0.1}, 27, 8, 0.4, 2, 0},
      {{33, 12, -8}, {0.88, 0.3, 0.35}, 27, 14, kBursa, 0, 0.2},
      {{31, -10, 13}, {0.8, 0, 0.6}, 21, 14, kBursa, 2, 0.3},
      {{23, -38, 21}, {0.75, -0.1, 0.65}, 14, 13, kBursa, 3, 0},
      {{14, -68, 26}, {0.7, -0.1, 0.7}, 8, 10, 0.8, 4, 0},
      {{11, -90, 27}, {0.7, -0.1, 0.7}, 4, 5, 0.2, 6, 0},
  };
  return tube;
}

Tube acromial() {
  Tube tube;
  tube.stations = {
      {{-14.5, 38.5, 4.5}, {-0.1, 0.85, 0.5}, 19.5, 4, 0.4, 10, 0},
      {{-14, 33, 22}, {-0.05, 0.7, 0.7}, 24, 13, kBursa, 0, 0.2},
      {{-8, 17, 37}, {0, 0.4, 0.9}, 24, 21, kBursa, 0, 0.4},
      {{-4, -8, 39}, {0, 0.05, 1}, 23, 23, kBursa, 3, 0.2},
      {{-3, -40, 33}, {0, -0.1, 1}, 15, 20, kBursa, 3, 0},
      {{-3.5, -72, 34}, {0, -0.1, 1}, 9, 12, 0.8, 4, 0},
      {{-3.7, -103, 37}, {0, -0.1, 1}, 6.5, 6.5, 0.2, 6, 0},
  };
  return tube;
}

Tube spinal() {
  Tube tube;
  tube.stations = {
      {{-62, 14, -42}, {-0.75, 0.65, 0.1}, 25, 5, 0.4, 10, 0},
      {{-67, 4, -31}, {-0.9, 0.35, 0.25}, 26, 16, 0.4, 0, 0},
      {{-60, -7, -3}, {-0.85, 0.15, 0.5}, 26, 24, kBursa, 0, 0.2},
      {{-38, -24, 24}, {-0.75, 0, 0.65}, 22, 24, kBursa, 2, 0.2},
      {{-25, -50, 27}, {-0.7, -0.1, 0.7}, 12, 17, kBursa, 3, 0},
      {{-17, -76, 29}, {-0.65, -0.1, 0.75}, 6.5, 11, 0.8, 4, 0},
      {{-13, -98, 32}, {-0.5, -0.1, 0.85}, 4, 4, 0.2, 6, 0},
  };
  return tube;
}

Surfaces laid(Tube tube, const Ground& ground, const std::vector<double>& coarseRings) {
  tube.roundness = 0.55;
  tube.endLength = 0.05;
  tube.bone = ground.visual;
  Surfaces s;
  s.visual = sweep(tube, kDeltoidAround, kDeltoidAlong);
  keepClear(s.visual, ground.visual, 0.3);
  tube.bone = ground.coarse;
  tube.places = coarseRings;
  tube.phase = 0.5;
  tube.roundness = 0.45;
  tube.endLength = 0.02;
  s.collision = sweep(tube, 8, int(coarseRings.size()));
  keepClear(s.collision, ground.coarse, 0.6);
  return s;
}

}  // namespace

Ground over(const Ground& a, const Ground& b) { return {unionOf(a.visual, b.visual), unionOf(a.coarse, b.coarse)}; }

Ground groundOf(const Surfaces& surfaces) { return {fieldOf(surfaces.visual), fieldOf(surfaces.collision)}; }

std::array<Surfaces, 3> deltoid(const Ground& ground) {
  const std::vector<double> rings{0.03, 0.16, 0.32, 0.48, 0.64, 0.8, 0.95};
  std::array<Surfaces, 3> parts;
  // The middle part first; its neighbours give way to it.
  parts[1] = laid(acromial(), ground, rings);
  const Field middle = fieldOf(parts[1].visual), middleCoarse = fieldOf(parts[1].collision);
  const auto away = [](const Field& field) -> Field { return [field](const Vec3& p) { return field(p) - kSeptum + kBursa; }; };
  const Ground beside{unionOf(ground.visual, away(middle)), unionOf(ground.coarse, away(middleCoarse))};
  parts[0] = laid(clavicular(), beside, rings);
  parts[2] = laid(spinal(), beside, rings);
  return parts;
}

}  // namespace glenoid::generate
