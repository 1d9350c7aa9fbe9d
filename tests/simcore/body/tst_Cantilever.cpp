// SPDX-License-Identifier: GPL-3.0-or-later
// A bar under its own weight, clamped at one end, against beam theory while the cells shrink. Linear
// tetrahedra in bricks of five are too stiff in bending (shear locking) and, near ν = 1/2, too stiff
// altogether (volume locking): the figures stand in simcore/fem/README.md.
#include <gtest/gtest.h>

#include "simcore/linear/BlockCholesky.h"
#include "tests/scenes/BlockScenes.h"
#include "tests/simcore/body/SoftSystem.h"

namespace glenoid {
namespace {

constexpr double kLength = 0.08, kWidth = 0.01, kYoung = 5e4, kDensity = 1000, kGravity = 1e-3;

/// Timoshenko: q L⁴ / 8 E I from bending and q L² / 2 κ G A from shear, κ of a rectangle (Cowper 1966).
double beamDeflection(double nu) {
  const double area = kWidth * kWidth, inertia = area * area / 12, load = kDensity * area * kGravity;
  const double shear = kYoung / (2 * (1 + nu)), kappa = 10 * (1 + nu) / (12 + 11 * nu);
  return load * std::pow(kLength, 4) / (8 * kYoung * inertia) +
         load * kLength * kLength / (2 * kappa * shear * area);
}

/// Mean deflection of the free end with `n` bricks across, relative to beam theory.
double deflectionRatio(int n, double nu) {
  const auto mesh =
      std::make_shared<TetMesh>(scenes::boxVolume(Vec3::Zero(), Vec3(kLength, kWidth, kWidth), 8 * n, n, n));
  test::SoftSystem bar(mesh, {lameFrom(kYoung, nu), kDensity});
  StepSettings settings;
  settings.dt = 1e3;  // so long a step is the static answer
  settings.gravity_W = Vec3(0, -kGravity, 0);
  BlockMatrix A(bar.symbolic);
  VecX b;
  bar.assemble(settings, A, b);
  // Held by springs of 1e6 times the stiffness of a node; their own stretch is lost behind that.
  for (int node = 0; node < bar.layout.nodeCount; ++node)
    if (mesh->nodes[node].x() < 1e-9)
      A.add(bar.diagonal(node), 1e6 * A.block(node, node).norm() * Mat3::Identity());
  BlockCholesky factor(bar.symbolic);
  EXPECT_TRUE(factor.factor(A));
  factor.solve(b);
  double sum = 0;
  int count = 0;
  for (int node = 0; node < bar.layout.nodeCount; ++node)
    if (mesh->nodes[node].x() > kLength - 1e-9) sum -= b[3 * node + 1] * settings.dt, ++count;
  return sum / count / beamDeflection(nu);
}

TEST(Cantilever, convergesToBeamTheoryWithSecondOrder) {
  const double coarse = deflectionRatio(2, 0), middle = deflectionRatio(4, 0), fine = deflectionRatio(8, 0);
  std::printf("cantilever with 2, 4, 8 bricks across: %.3f, %.3f, %.3f of beam theory\n", coarse, middle,
              fine);
  EXPECT_LT(coarse, middle);
  EXPECT_LT(middle, fine);
  EXPECT_LT(fine, 1) << "a conforming element is never too soft";
  // The order rises toward two, that of the displacement of linear elements.
  EXPECT_NEAR(std::log2((1 - middle) / (1 - fine)), 1.9, 0.2);
  // The limit by Richardson. With ν = 0 the clamp does not hinder the cross-section, so beam theory and
  // elasticity differ by less than a per cent at this slenderness.
  EXPECT_NEAR(fine + (fine - middle) / 3, 1, 0.01);
}

TEST(Cantilever, locksByTheFiguresOfTheReadme) {
  struct Figure {
    double nu;
    int across;
    double ratio;
  };
  for (const Figure& f :
       {Figure{0.0, 1, 0.326}, Figure{0.0, 4, 0.877}, Figure{0.3, 1, 0.351}, Figure{0.3, 4, 0.880},
        Figure{0.45, 1, 0.312}, Figure{0.45, 4, 0.839}, Figure{0.49, 1, 0.287}, Figure{0.49, 4, 0.795}})
    EXPECT_NEAR(deflectionRatio(f.across, f.nu), f.ratio, 2e-3) << f.across << " across at nu " << f.nu;
}

}  // namespace
}  // namespace glenoid
