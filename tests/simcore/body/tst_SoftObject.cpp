// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/linear/BlockCholesky.h"
#include "tests/scenes/BlockScenes.h"
#include "tests/simcore/body/SoftSystem.h"

namespace glenoid {
namespace {

/// A soft bar along X, all nodes free.
struct Bar : test::SoftSystem {
  explicit Bar(int nx, double damping = 0, double fill = 1)
      : SoftSystem(std::make_shared<TetMesh>(scenes::boxVolume(Vec3::Zero(), Vec3(0.08, 0.02, 0.02), nx, 2, 2)),
                   {lameFrom(5e4, 0.3), 1000, 0, damping, fill}) {}
};

TEST(SoftObject, massIsDensityTimesFilledVolume) {
  EXPECT_NEAR(Bar(4).soft->mass(), 1000 * 0.08 * 0.02 * 0.02, 1e-12);
  EXPECT_NEAR(Bar(4, 0, 0.25).soft->mass(), 250 * 0.08 * 0.02 * 0.02, 1e-12);
}

TEST(SoftObject, rightHandSideIsTheForceOfTheEnergy) {
  Bar bar(3);
  for (Eigen::Index i = 0; i < bar.state.q.size(); ++i) bar.state.q[i] += 2e-4 * std::sin(12.9 * i);
  BlockMatrix A(bar.symbolic);
  VecX b;
  StepSettings settings;
  bar.assemble(settings, A, b);
  const double h = 1e-8;
  for (const Eigen::Index i : {0, 17, 40}) {
    State plus = bar.state, minus = bar.state;
    plus.q[i] += h;
    minus.q[i] -= h;
    const double force = -(bar.soft->elasticEnergy(plus) - bar.soft->elasticEnergy(minus)) / (2 * h);
    EXPECT_NEAR(b[i] / settings.dt, force, 1e-4 * (1 + std::abs(force)));
  }
}

TEST(SoftObject, matrixIsMassPlusStiffnessOfTheStep) {
  Bar bar(3, 2e-3);
  StepSettings settings;
  settings.dt = 1e-2;
  BlockMatrix with(bar.symbolic), without(bar.symbolic);
  VecX b;
  bar.assemble(settings, with, b);
  settings.damping = false;
  bar.assemble(settings, without, b);
  // A = M + (Δt² + Δt β) K: the two differ by Δt β K, and their ratio is (Δt + β)/Δt after M is taken off.
  const MatX K = (with.toDense() - without.toDense()) / (1e-2 * 2e-3);
  const MatX M = without.toDense() - 1e-4 * K;
  // M holds one number for each pair of nodes: rows add up to what a node would carry alone, all of it to the mass.
  const int n = bar.layout.nodeCount;
  MatX shares(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Mat3 block = M.block<3, 3>(3 * i, 3 * j);
      shares(i, j) = block(0, 0);
      EXPECT_LT((block - shares(i, j) * Mat3::Identity()).norm(), 1e-9 * M.norm() + 1e-12 * K.norm());
    }
  EXPECT_NEAR(shares.sum(), bar.soft->mass(), 1e-9 * bar.soft->mass() + 1e-12);
  // By hand: ρ V/20 (1 + δ_ij) of each tetrahedron.
  for (std::size_t e = 0; e < bar.mesh->tets.size(); ++e)
    for (const int i : bar.mesh->tets[e])
      for (const int j : bar.mesh->tets[e]) shares(i, j) -= 1000 * tetVolume(*bar.mesh, static_cast<int>(e)) / 20 * (i == j ? 2 : 1);
  EXPECT_LT(shares.norm(), 1e-9 * bar.soft->mass() + 1e-12 * K.norm());
  const VecX translation = Vec3(1, 2, 3).replicate(bar.layout.nodeCount, 1);
  EXPECT_LT((K * translation).norm(), 1e-9 * K.norm());
}

TEST(SoftObject, fourAtATimeEqualsOneAtATime) {
  // Stretched, turned by more than a radian, and with one element inside out; 5·3·2·2 elements leave no lane free, 5 do.
  for (const int nx : {1, 3}) {
    Bar bar(nx, 1e-3);
    const Mat3 turn = Eigen::AngleAxisd(1.3, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    for (int node = 0; node < bar.layout.nodeCount; ++node) {
      const Vec3 x = bar.mesh->nodes[node];
      bar.state.q.segment<3>(3 * node) = turn * (x + 2e-3 * Vec3(std::sin(300 * x.y()), x.x() * x.z() * 100, std::cos(200 * x.x()))) + Vec3(1, -2, 3);
    }
    bar.state.q.segment<3>(3 * bar.mesh->tets[2][1]) += turn * Vec3(0.05, 0.03, 0);
    BlockMatrix vectors(bar.symbolic), portable(bar.symbolic), singly(bar.symbolic);
    VecX bVectors, bPortable, bSingly;
    const VecX guess = bar.state.rotations;
    StepSettings settings;
    bar.assemble(settings, vectors, bVectors);
    const VecX found = bar.state.rotations;
    bar.state.rotations = guess;
    settings.portable = true;
    bar.assemble(settings, portable, bPortable);
    EXPECT_EQ(bVectors, bPortable) << "bits do not depend on the instruction set";
    EXPECT_EQ(found, bar.state.rotations);
    settings.rotationsBySvd = true;
    bar.assemble(settings, singly, bSingly);
    EXPECT_LT((vectors.toDense() - singly.toDense()).norm(), 1e-11 * singly.toDense().norm());
    // Three metres from the origin a coordinate keeps 4e-16 m, 1e-13 of strain in elements of a centimetre.
    EXPECT_LT((bVectors - bSingly).norm(), 1e-9 * bSingly.norm());
  }
}

TEST(SoftObject, stepOfTheWholeBodyKeepsMomentum) {
  Bar bar(4, 1e-3);
  for (int node = 0; node < bar.layout.nodeCount; ++node) bar.state.v.segment<3>(3 * node) = Vec3(0.1, 0.02 * std::sin(node), 0);
  for (Eigen::Index i = 0; i < bar.state.q.size(); ++i) bar.state.q[i] += 3e-4 * std::sin(5.1 * i);
  BlockMatrix A(bar.symbolic);
  BlockCholesky factor(bar.symbolic);
  VecX b;
  StepSettings settings;
  bar.assemble(settings, A, b);
  const auto momentum = [&](const VecX& v) {  // M v: assemble at rest gives b = M v where no force acts
    Bar rest(4);
    rest.state.v = v;
    BlockMatrix scratch(rest.symbolic);
    VecX p;
    rest.assemble(settings, scratch, p);
    return Vec3(p.reshaped(3, rest.layout.nodeCount).rowwise().sum());
  };
  const Vec3 before = momentum(bar.state.v);
  ASSERT_TRUE(factor.factor(A));
  VecX v = b;
  factor.solve(v);
  EXPECT_LT((momentum(v) - before).norm(), 1e-10 * before.norm());
}

TEST(SoftObject, flatElementIsNamed) {
  auto mesh = std::make_shared<TetMesh>(scenes::boxVolume(Vec3::Zero(), Vec3::Ones(), 1, 1, 1));
  mesh->nodes[mesh->tets[3][0]] = mesh->nodes[mesh->tets[3][1]];
  const ObjectLayout layout{false, true, 0, 24, 0, 24, 8};
  const auto soft = SoftObject::make(layout, mesh, std::vector<ElementTissue>(5, {lameFrom(1, 0.3), 1, 0, 0, 1}), 0);
  ASSERT_FALSE(soft.ok());
  EXPECT_EQ(soft.error().fault, Fault::BadElement);
  ASSERT_TRUE(soft.error().place.element.has_value());
}

TEST(SoftObject, surfacePointMergesNodesAndFollowsLinearMotion) {
  Bar bar(2);
  SurfaceBinding surface;
  for (int k = 0; k < 3; ++k) {
    VertexBinding binding;
    binding.node = bar.mesh->tets[k];
    binding.weight = {0.1, 0.2, 0.3, 0.4};
    surface.vertices.push_back(binding);
  }
  const int vertices[] = {0, 1, 2};
  const double weights[] = {0.2, 0.3, 0.5};
  const MaterialPoint point = pointAt(surface, false, vertices, weights);
  double sum = 0;
  for (int i = 0; i < point.count; ++i) {
    sum += point.weight[i];
    if (i) {
      EXPECT_LT(point.node[i - 1], point.node[i]);
    }
  }
  EXPECT_NEAR(sum, 1, 1e-14);
  std::vector<Vec3> positions(3);
  surfacePositions(surface, bar.layout, bar.state.q, positions);
  EXPECT_LT((bar.soft->position(point, bar.state.q) - (0.2 * positions[0] + 0.3 * positions[1] + 0.5 * positions[2])).norm(), 1e-15);
}

}  // namespace
}  // namespace glenoid
