// SPDX-License-Identifier: GPL-3.0-or-later
// Patch test: whatever the tetrahedra look like, a constant strain on their boundary is a constant strain
// inside. Source: Bazeley, Cheung, Irons and Zienkiewicz, 1965 (the test); here with a large rotation on top.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "tests/scenes/BlockScenes.h"
#include "tests/simcore/body/SoftSystem.h"

namespace glenoid {
namespace {

constexpr double kSide = 0.03;  // m

/// 3×3×3 bricks of five tetrahedra with the inner nodes moved about by a third of a brick: no two elements
/// alike.
std::shared_ptr<TetMesh> irregularPatch() {
  auto mesh = std::make_shared<TetMesh>(scenes::boxVolume(Vec3::Zero(), kSide * Vec3::Ones(), 3, 3, 3));
  std::mt19937 random(23);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (Vec3& x : mesh->nodes)
    if ((x.array() > 1e-6).all() && (x.array() < kSide - 1e-6).all())
      x += 0.25 * kSide / 3 * Vec3(uniform(random), uniform(random), uniform(random));
  return mesh;
}

bool isInside(const Vec3& rest) {
  return (rest.array() > 1e-6).all() && (rest.array() < kSide - 1e-6).all();
}

struct Patch : test::SoftSystem {
  explicit Patch(double poissonRatio) : SoftSystem(irregularPatch(), {lameFrom(5e4, poissonRatio)}) {
    for (int node = 0; node < layout.nodeCount; ++node)
      if (isInside(mesh->nodes[node])) inner.push_back(node);
  }

  /// Boundary at F x₀; inside wherever `start` puts it.
  void deform(const Mat3& F, double scatter) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int node = 0; node < layout.nodeCount; ++node) state.q.segment<3>(3 * node) = F * mesh->nodes[node];
    for (const int node : inner)
      state.q.segment<3>(3 * node) += scatter * Vec3(uniform(random), uniform(random), uniform(random));
  }

  /// One static Newton step of the inner nodes, the boundary held; answers the force that was left on them,
  /// N.
  double relax() {
    StepSettings settings;
    settings.dt = 1;
    BlockMatrix A(symbolic);
    VecX b;
    state.v.setZero();
    assemble(settings, A, b);
    const Eigen::Index n = static_cast<Eigen::Index>(inner.size());
    MatX K(3 * n, 3 * n);
    VecX f(3 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
      f.segment<3>(3 * i) = b.segment<3>(3 * inner[i]);
      for (Eigen::Index j = 0; j < n; ++j) K.block<3, 3>(3 * i, 3 * j) = A.block(inner[i], inner[j]);
    }
    const VecX change = K.partialPivLu().solve(f);
    for (Eigen::Index i = 0; i < n; ++i) state.q.segment<3>(3 * inner[i]) += change.segment<3>(3 * i);
    return f.norm();
  }

  double worstError(const Mat3& F) const {
    double worst = 0;
    for (const int node : inner)
      worst = std::max(worst, (state.q.segment<3>(3 * node) - F * mesh->nodes[node]).norm());
    return worst;
  }

  std::vector<int> inner;
};

TEST(Patch, constantStrainIsReproducedOnAnIrregularPatch) {
  Mat3 stretch;
  stretch << 1.05, 0.02, -0.01, 0.02, 0.97, 0.03, -0.01, 0.03, 1.01;
  const Mat3 turn = Eigen::AngleAxisd(1.9, Vec3(2, -1, 1).normalized()).toRotationMatrix();
  for (const double nu : {0.0, 0.3, 0.49})
    for (const Mat3& F : {stretch, Mat3(turn * stretch)}) {
      Patch patch(nu);
      ASSERT_EQ(patch.inner.size(), 8u);
      // The affine state is in equilibrium inside: what is left is round-off of the stress times the face of
      // a cell.
      patch.deform(F, 0);
      EXPECT_LT(patch.relax(), 1e-12 * 5e4 / (1 - 2 * nu) * 0.05 * 1e-4) << nu;
      // And it is found from inner nodes a tenth of a cell off. Corotation is not linear: a few Newton steps
      // at frozen rotation, each leaving about the strain's part of the error.
      patch.deform(F, 1e-3);
      for (int i = 0; i < 30; ++i) patch.relax();
      EXPECT_LT(patch.worstError(F), 1e-13 * kSide / (1 - 2 * nu)) << nu;
    }
}

}  // namespace
}  // namespace glenoid
