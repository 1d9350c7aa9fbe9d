// SPDX-License-Identifier: GPL-3.0-or-later
// A tip that is drawn over tissue which is the same everywhere feels a force that is the same everywhere: that of a ball on an
// elastic layer (Dimitriadis et al. 2002), whatever the grid of elements underneath.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "simcore/author/MakeDents.h"
#include "simcore/embed/Cells.h"
#include "simcore/step/Stepper.h"
#include "tests/truth/Strokes.h"

namespace glenoid::truth {
namespace {

/// Force of a ball of radius R that lies δ deep in a layer of thickness h bonded to what is rigid: Biophys. J. 82 (2002) 2798, eq. 13.
double onLayer(double young, double poisson, double radius, double depth, double thickness) {
  const double pi = std::numbers::pi, chi = std::sqrt(radius * depth) / thickness;
  const double alpha = -(1.2876 - 1.4678 * poisson + 1.3442 * poisson * poisson) / (1 - poisson);
  const double beta = (0.6387 - 1.0277 * poisson + 1.5164 * poisson * poisson) / (1 - poisson);
  const double series = 1 - 2 * alpha / pi * chi + 4 * alpha * alpha / (pi * pi) * chi * chi -
                        8 / (pi * pi * pi) * (alpha * alpha * alpha + 4 * pi * pi / 15 * beta) * std::pow(chi, 3) +
                        16 * alpha / std::pow(pi, 4) * (alpha * alpha * alpha + 3 * pi * pi / 5 * beta) * std::pow(chi, 4);
  return 4.0 / 3 * young / (1 - poisson * poisson) * std::sqrt(radius) * std::pow(depth, 1.5) * series;
}

struct Tip {
  const char* name;
  ToolKind kind;
  double radius, ball, depth;
};
const Tip kFinger{"finger", ToolKind::Finger, 8e-3, 6e-3, 3e-3}, kProbe{"probe", ToolKind::Ball, 1.5e-3, 1.5e-3, 0.7e-3};

void compare(const char* what, const Slab& slab, const DentTable& table, std::initializer_list<Tip> tips, std::initializer_list<double> cells, double right = 0.15) {
  for (const Tip& tip : tips)
    for (const double cell : cells) {
      const Felt felt = stroke(slab, std::make_shared<const DentTable>(table), cell, {tip.kind, tip.radius, tip.depth});
      const double layer = onLayer(slab.young, slab.poisson, tip.ball, felt.depth, slab.thickness);
      std::printf("%-10s %-7s cells of %4.1f mm: %.4f N at %.3f mm, of the layer's %.3f; spread %.1f %%, sideways %.1f %%\n", what, tip.name, 1e3 * cell, felt.mean,
                  1e3 * felt.depth, felt.mean / layer, 100 * felt.spread, 100 * felt.sideways);
      EXPECT_LE(felt.spread, tip.kind == ToolKind::Finger ? 0.03 : 0.06) << what << " " << cell;
      EXPECT_LE(felt.sideways, 0.02) << what << " " << cell;
      EXPECT_NEAR(felt.mean / layer, 1, right) << what << " " << cell;
    }
}

TEST(Washboard, aTipFeelsOneForceOnAFlatSlab) {
  Slab slab;
  const auto table = dentsOf(slab);
  compare("flat", slab, *table, {kFinger, kProbe}, {0.010, 0.008, 0.0066, 0.005});
  slab.turn = 0.5;
  compare("turned", slab, *table, {kFinger, kProbe}, {0.008});
  slab.elements = Elements::Cells;
  compare("of cells", slab, *table, {kFinger, kProbe}, {0.010, 0.008, 0.0066, 0.005});
}

TEST(Washboard, onASlope) {
  Slab slab;
  slab.slope = 0.3;
  compare("sloping", slab, *dentsOf(slab), {kFinger, kProbe}, {0.010, 0.008, 0.0066, 0.005});
}

TEST(Washboard, onACurve) {
  Slab slab;
  slab.curvature = 1 / 0.06;
  compare("curved", slab, *dentsOf(slab), {kFinger, kProbe}, {0.010, 0.008, 0.0066, 0.005});
}

TEST(Washboard, onTwoLayers) {
  Slab slab;
  slab.upper = 0.008;
  compare("layers", slab, *dentsOf(slab), {kFinger, kProbe}, {0.010, 0.008, 0.0066, 0.005});
}

TEST(Washboard, inclusion) {
  Slab slab;
  const auto even = dentsOf(slab);
  slab.inclusion = 3;
  const auto table = dentsOf(slab, std::getenv("PLACES") ? std::atoi(std::getenv("PLACES")) : 96);
  for (const Tip& tip : {kFinger, kProbe})
    for (const double cell : {0.010, 0.005}) {
      const Felt felt = stroke(slab, table, cell, {tip.kind, tip.radius, tip.depth, 0.06});
      double least = 1e300, most = 0, sum = 0, place = 0;
      for (const auto& [x, f] : felt.trace) least = std::min(least, f), most = std::max(most, f);
      for (const auto& [x, f] : felt.trace)
        if (f > 0.5 * (least + most)) sum += f - 0.5 * (least + most), place += x * (f - 0.5 * (least + most));
      std::printf("inclusion %-7s %4.1f mm: %.4f to %.4f N, ratio %.2f, at %.2f mm\n", tip.name, 1e3 * cell, least, most, most / least, 1e3 * place / sum + 0.7);
      for (std::size_t i = 0; i < felt.trace.size(); i += 20) std::printf("  %5.1f:%.3f", 1e3 * felt.trace[i][0], felt.trace[i][1]);
      std::printf("\n");
    }
}

}  // namespace
}  // namespace glenoid::truth
