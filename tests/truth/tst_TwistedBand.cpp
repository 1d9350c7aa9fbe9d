// SPDX-License-Identifier: GPL-3.0-or-later
// A thin free band that twists along its way, in cells that follow it, which are twisted then: its lowest frequencies beside
// another program's, whose bricks follow its faces. Nothing holds it, so that nothing but the elements is judged.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/truth/Calculix.h"
#include "simcore/study/truth/EmbeddedBody.h"

namespace glenoid::truth {
namespace {

constexpr double kLength = 0.056, kWidth = 0.012, kThickness = 0.0015, kE = 4e6, kDensity = 1000;
constexpr int kRigid = 6, kShown = 3;

Vec2 flat(double s, double t) { return {kLength * s, kWidth * (t - 0.5)}; }
/// z = c x y: from end to end the slope across grows by `slope`.
double liftOf(double slope, const Vec2& p) { return slope / kLength * (p.x() - kLength / 2) * p.y(); }

std::vector<double> byCells(double slope, double poisson, double cell) {
  MarkedSurface surface = prism(flat, 56, 12, {0, kThickness});
  for (Vec3& x : surface.mesh.vertices) x.z() += liftOf(slope, x.head<2>());
  EmbeddedBody body(surface, Vec3::Constant(cell), Elements::Cells, kE, poisson, kDensity, GridAxes::Band);
  // A bed that is next to nothing makes rigid motions slow instead of endless.
  for (int axis = 0; axis < 3; ++axis) body.hold("+-", axis, 1e-9);
  return body.frequencies(kRigid + kShown);
}

TEST(TwistedBand, twistedCellsSwingAsBricksOfAnotherProgramDo) {
  NEEDS_CALCULIX()
  for (const double poisson : {0.0, 0.45}) {
    std::vector<double> straight;  // of flat cells of 8 mm, over the bricks'
    for (const double slope : {0.0, 0.7}) {
      const BrickProblem problem{flat, 56, 12, 2, kThickness, kE, poisson, {}, '+', 0, [&](double s, double t) { return liftOf(slope, flat(s, t)); }};
      const auto wanted = frequenciesByCalculix(problem, kDensity, kRigid + kShown);
      ASSERT_TRUE(wanted);
      EXPECT_LT((*wanted)[kRigid - 1], 0.02 * (*wanted)[kRigid]);
      const std::vector<double> coarse = byCells(slope, poisson, 0.008), fine = byCells(slope, poisson, 0.004);
      ASSERT_EQ(coarse.size(), wanted->size());
      ASSERT_EQ(fine.size(), wanted->size());
      EXPECT_LT(coarse[kRigid - 1], 0.02 * coarse[kRigid]);
      for (int k = kRigid; k < kRigid + kShown; ++k) {
        const double ratio = coarse[k] / (*wanted)[k];
        std::printf("nu %.2f, twisted by %.2f: bricks %6.2f Hz; cells along it of 8 mm %.3f, of 4 mm %.3f of it\n", poisson, slope, (*wanted)[k], ratio,
                    fine[k] / (*wanted)[k]);
        if (slope == 0) straight.push_back(ratio);
        EXPECT_NEAR(ratio / straight[k - kRigid], 1, 0.06) << "what the twist costs";
        EXPECT_NEAR(fine[k] / (*wanted)[k], 1, 0.05);
      }
      EXPECT_NEAR(coarse[kRigid] / (*wanted)[kRigid], 1, 0.12);
    }
  }
}

}  // namespace
}  // namespace glenoid::truth
