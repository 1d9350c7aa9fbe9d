// SPDX-License-Identifier: GPL-3.0-or-later
// J of a surface point by formula and by differences of its position along q̇ = G v, for every kind of point.
#include <gtest/gtest.h>

#include <random>

#include "simcore/body/RigidObject.h"
#include "simcore/embed/Bind.h"
#include "tests/scenes/BlockScenes.h"
#include "tests/simcore/body/SoftSystem.h"

namespace glenoid {
namespace {

const Vec3 kDirection = Vec3(0.3, -0.5, 0.8).normalized();

/// The row dᵀ J, dense, from rowTerms with blocks counted from `base`.
VecX rowByFormula(const ContactObject& object, const MaterialPoint& point, const State& state, int base) {
  RowTerm terms[kMaxPointTerms];
  const int count = object.rowTerms(point, kDirection, state.q, base, terms);
  VecX row = VecX::Zero(object.layout().vSize);
  for (int i = 0; i < count; ++i) {
    EXPECT_TRUE(i == 0 || terms[i - 1].block < terms[i].block) << "ascending, each block once";
    row.segment<3>(3 * (terms[i].block - base)) = terms[i].coefficient;
  }
  return row;
}

/// The same by moving the object a little along each velocity, forth and back.
VecX rowByDifferences(const ContactObject& object, const MaterialPoint& point, const State& state) {
  const double h = 1e-5;
  VecX row(object.layout().vSize);
  for (Eigen::Index j = 0; j < row.size(); ++j) {
    State plus = state;
    plus.v.setZero();
    plus.v[object.layout().vOffset + j] = 1;
    State minus = plus;
    minus.v = -plus.v;
    object.advance(h, plus);
    object.advance(h, minus);
    row[j] = kDirection.dot(object.position(point, plus.q) - object.position(point, minus.q)) / (2 * h);
  }
  return row;
}

/// Truncation of a turning arm of 0.1 m is h²/6 · 0.1, below round-off of 0.3 m positions over 2e-5: 1e-11.
void expectSameRow(const ContactObject& object, const MaterialPoint& point, const State& state) {
  const VecX formula = rowByFormula(object, point, state, 5);
  EXPECT_LT((formula - rowByDifferences(object, point, state)).norm(), 1e-10);
  EXPECT_GT(formula.norm(), 0.1);
  // ṗ = J v.
  EXPECT_NEAR(formula.dot(state.v.segment(object.layout().vOffset, object.layout().vSize)),
              kDirection.dot(object.velocity(point, state.q, state.v)), 1e-14 * (1 + state.v.norm()));
}

TEST(PointJacobian, ofARigidPointInATriangle) {
  const TriMesh box = scenes::boxSurface(Vec3(-0.06, -0.1, -0.02), Vec3(0.06, 0.1, 0.02), 2);
  const MassProperties properties = massPropertiesOf(box, 1500).value();
  const RigidObject body({true, true, 4, 7, 3, 6, 0}, properties, 0, true);
  State state;
  state.q.setZero(11);
  setPoseAt(state.q, 4, {Vec3(0.2, -0.1, 0.2), Quat(Eigen::AngleAxisd(2.0, Vec3(-1, 2, 1).normalized()))});
  state.v = VecX::LinSpaced(9, -1, 2);
  SurfaceBinding surface{std::make_shared<TriMesh>(box), bindToRigid(box.vertices, properties.centre)};
  const double weights[] = {0.2, 0.5, 0.3};
  for (const auto& triangle : box.triangles)
    expectSameRow(body, pointAt(surface, true, triangle, weights), state);
}

/// A block of several elements, stirred, with the surface vertices that are asked for bound to it.
struct Embedded {
  Embedded()
      : system(std::make_shared<TetMesh>(scenes::boxVolume(Vec3::Zero(), Vec3(0.03, 0.03, 0.03), 2, 2, 2)),
               {lameFrom(5e4, 0.4)}) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (Eigen::Index i = 0; i < system.state.q.size(); ++i) {
      system.state.q[i] += 5e-3 * uniform(random);
      system.state.v[i] = uniform(random);
    }
  }
  SurfaceBinding bind(const std::vector<Vec3>& points) const {
    auto mesh = std::make_shared<TriMesh>();
    mesh->vertices = points;
    return {mesh, bindToTets(*system.mesh, points)};
  }
  test::SoftSystem system;
};

TEST(PointJacobian, ofANode) {
  const Embedded block;
  for (const int node : {0, 13, 26}) {
    VertexBinding binding;
    binding.node.fill(node);
    binding.weight = {1, 0, 0, 0};
    const MaterialPoint point = pointAt(binding, false);
    EXPECT_EQ(point.count, 1);
    expectSameRow(*block.system.soft, point, block.system.state);
  }
}

TEST(PointJacobian, ofAnEmbeddedVertex) {
  const Embedded block;
  const SurfaceBinding surface =
      block.bind({Vec3(0.004, 0.003, 0.006), Vec3(0.021, 0.025, 0.011), Vec3(0.034, 0.01, 0.01)});
  for (const VertexBinding& binding : surface.vertices) {  // the last lies outside and extrapolates
    const MaterialPoint point = pointAt(binding, false);
    EXPECT_EQ(point.count, 4);
    expectSameRow(*block.system.soft, point, block.system.state);
  }
}

TEST(PointJacobian, ofATriangleOverThreeTetrahedra) {
  // Corners in three tetrahedra that share no node give twelve; neighbours share some, which are merged.
  const Embedded block;
  const SurfaceBinding far =
      block.bind({Vec3(0.002, 0.001, 0.003), Vec3(0.028, 0.029, 0.002), Vec3(0.001, 0.028, 0.029)});
  const SurfaceBinding near =
      block.bind({Vec3(0.012, 0.013, 0.011), Vec3(0.018, 0.013, 0.012), Vec3(0.013, 0.018, 0.017)});
  const int vertices[] = {0, 1, 2};
  const double weights[] = {0.25, 0.35, 0.4};
  const MaterialPoint twelve = pointAt(far, false, vertices, weights);
  EXPECT_EQ(twelve.count, 12);
  expectSameRow(*block.system.soft, twelve, block.system.state);
  const MaterialPoint merged = pointAt(near, false, vertices, weights);
  EXPECT_LT(merged.count, 12);
  expectSameRow(*block.system.soft, merged, block.system.state);
}

}  // namespace
}  // namespace glenoid
