// SPDX-License-Identifier: GPL-3.0-or-later
// Free vibration of an elastic ball, which needs both its stiffness and its mass where they are.
// Source: Lamb, "On the vibrations of an elastic sphere", Proc. London Math. Soc. 13, 1882: with ν = 1/4 the lowest
// spheroidal mode has ω a / c_s = 2.640, the lowest torsional one 2.501, c_s² = µ/ρ.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cstdio>

#include "simcore/body/SoftObject.h"
#include "simcore/embed/Cells.h"
#include "simcore/embed/Fill.h"
#include "simcore/linear/BlockMatrix.h"
#include "tests/simcore/mesh/Shapes.h"

namespace glenoid {
namespace {

constexpr double kSpheroidal = 2.640;

/// ω a / c_s of the five lowest spheroidal modes, ascending, for cubes of `cell` radii.
std::vector<double> spheroidalModes(double cell) {
  const double a = 0.02, density = 1000;
  const Lame lame = lameFrom(1e5, 0.25);
  const TriMesh ball = shapes::sphere(a);
  const auto mesh = std::make_shared<TetMesh>(embedInCells(ball, ball, cell * a).value());
  const std::vector<Eigen::Matrix4d> moments = enclosedMoments(*mesh, ball);
  const std::vector<double> fill = fillFractions(*mesh, ball);
  std::vector<ElementTissue> tissue;
  for (std::size_t e = 0; e < fill.size(); ++e) tissue.push_back({lame, density, 0, 0, fill[e], moments[e]});
  const int nodes = static_cast<int>(mesh->nodes.size());
  const auto soft = SoftObject::make({false, true, 0, 3 * nodes, 0, 3 * nodes, nodes}, mesh, tissue, 0).value();
  State state;
  state.q.resize(3 * nodes);
  for (int i = 0; i < nodes; ++i) state.q.segment<3>(3 * i) = mesh->nodes[i];
  state.v.setZero(3 * nodes);
  state.rotations.setZero(4 * soft->elementCount());
  for (int i = 3; i < state.rotations.size(); i += 4) state.rotations[i] = 1;
  std::vector<std::array<int, 2>> pairs;
  soft->appendBlockPairs(0, pairs);
  const auto symbolic = std::make_shared<BlockSymbolic>(nodes, pairs);
  const std::vector<BlockEntry> entries = soft->blockEntries(*symbolic, 0);
  const auto matrix = [&](double dt) {  // M + Δt² K
    StepSettings settings;
    settings.dt = dt;
    BlockMatrix A(symbolic);
    VecX b = VecX::Zero(3 * nodes);
    soft->assemble(settings, state, entries, state.rotations, A, b);
    return A.toDense();
  };
  const MatX M = matrix(0), K = matrix(1) - M;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatX> modes(K, M);
  std::vector<double> found;
  for (int k = 6; found.size() < 5; ++k) {  // the first six are rigid
    const VecX u = modes.eigenvectors().col(k);
    double radial = 0;
    for (int i = 0; i < nodes; ++i) {
      const double r = u.segment<3>(3 * i).dot(mesh->nodes[i].normalized());
      if (mesh->nodes[i].norm() > 0.1 * a) radial += r * r;
    }
    if (std::getenv("GLENOID_TRACE")) std::printf("  %d %.3f radial %.3f\n", k, std::sqrt(modes.eigenvalues()[k] * density / lame.mu) * a, radial / u.squaredNorm());
    // A torsional mode has no radial part.
    if (radial > 0.1 * u.squaredNorm()) found.push_back(std::sqrt(modes.eigenvalues()[k] * density / lame.mu) * a);
  }
  return found;
}

TEST(LambSphere, lowestSpheroidalModeWithAFewCells) {
  for (const double cell : {1.0, 0.5}) {
    const std::vector<double> modes = spheroidalModes(cell);
    std::printf("ball with cells of %.2f radii: lowest spheroidal modes %.3f %.3f %.3f %.3f %.3f (Lamb 2.640)\n", cell, modes[0], modes[1],
                modes[2], modes[3], modes[4]);
    if (cell == 0.5) {
      EXPECT_NEAR(modes[0] / kSpheroidal, 1, 0.08);
    }
  }
}

}  // namespace
}  // namespace glenoid
