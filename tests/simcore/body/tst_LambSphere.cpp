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
#include "simcore/embed/WholeCells.h"
#include "simcore/linear/BlockMatrix.h"
#include "tests/simcore/mesh/Shapes.h"

namespace glenoid {
namespace {

constexpr double kSpheroidal = 2.640;

struct Ball {
  std::shared_ptr<const TetMesh> mesh;
  std::unique_ptr<SoftObject> soft;
};

ObjectLayout layoutOf(const TetMesh& mesh) {
  const int nodes = static_cast<int>(mesh.nodes.size());
  return {false, true, 0, 3 * nodes, 0, 3 * nodes, nodes};
}

Ball ballOf(const TriMesh& surface, double cell, bool cells, const ElementTissue& alike) {
  Ball ball;
  TetMesh cut = embedInCells(surface, surface, cell).value();
  if (cells) {
    const CellMesh whole = wholeCells(cut, surface).value();
    ball.mesh = std::make_shared<TetMesh>(whole.mesh);
    ball.soft = SoftObject::makeOfCells(layoutOf(*ball.mesh), ball.mesh, whole, std::vector<ElementTissue>(ball.mesh->tets.size(), alike), 0).value();
    return ball;
  }
  const std::vector<Eigen::Matrix4d> moments = enclosedMoments(cut, surface);
  const std::vector<double> fill = fillFractions(cut, surface);
  std::vector<ElementTissue> tissue(fill.size(), alike);
  for (std::size_t e = 0; e < fill.size(); ++e) tissue[e].fill = fill[e], tissue[e].moments = moments[e];
  ball.mesh = std::make_shared<TetMesh>(std::move(cut));
  ball.soft = SoftObject::make(layoutOf(*ball.mesh), ball.mesh, tissue, 0).value();
  return ball;
}

/// ω a / c_s of the five lowest spheroidal modes, ascending, for cubes of `cell` radii.
std::vector<double> spheroidalModes(double cell, bool cells) {
  const double a = 0.02, density = 1000;
  const Lame lame = lameFrom(1e5, 0.25);
  const auto [mesh, soft] = ballOf(shapes::sphere(a), cell * a, cells, {lame, density});
  const int nodes = static_cast<int>(mesh->nodes.size());
  State state;
  state.q.resize(3 * nodes);
  for (int i = 0; i < nodes; ++i) state.q.segment<3>(3 * i) = mesh->nodes[i];
  state.v.setZero(3 * nodes);
  state.rotations.setZero(4 * soft->rotationCount());
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
  for (const auto [cells, cell] : {std::pair{false, 1.0}, {false, 0.5}, {true, 1.0}, {true, 0.5}}) {
    const std::vector<double> modes = spheroidalModes(cell, cells);
    std::printf("ball of %s, cells of %.2f radii: lowest spheroidal modes %.3f %.3f %.3f %.3f %.3f (Lamb 2.640)\n", cells ? "cells" : "tetrahedra", cell, modes[0], modes[1],
                modes[2], modes[3], modes[4]);
    if (cell == 0.5) EXPECT_NEAR(modes[0] / kSpheroidal, 1, cells ? 0.05 : 0.08);
  }
}

}  // namespace
}  // namespace glenoid
