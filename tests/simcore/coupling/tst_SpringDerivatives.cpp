// SPDX-License-Identifier: GPL-3.0-or-later
// What a coupling spring adds to A and b against differences of its force, at frozen lever arms, for every
// pairing of soft and rigid ends.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "simcore/body/RigidObject.h"
#include "simcore/body/SoftObject.h"
#include "simcore/coupling/SpringAssembly.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

enum class End { Rigid, Soft, Fixed };

struct Pairing {
  const char* name;
  End a, b;
};

constexpr double kStiffness = 3e4, kDamping = 20, kDt = 7e-3;

/// Two objects in one state, joined by one spring that is stretched by centimetres.
struct Joined {
  explicit Joined(const Pairing& pairing) {
    int q = 0, v = 0, block = 0;
    const auto add = [&](End end, std::unique_ptr<ContactObject>& object, MaterialPoint& point, int& base) {
      ObjectLayout layout{end != End::Soft, end != End::Fixed, q, 7, v, end == End::Fixed ? 0 : 6, 0};
      if (end == End::Soft) {
        const auto mesh =
            std::make_shared<TetMesh>(scenes::boxVolume(Vec3::Zero(), 0.02 * Vec3::Ones(), 1, 1, 1));
        layout = {false, true, q, 24, v, 24, 8};
        object =
            SoftObject::make(layout, mesh, std::vector<ElementTissue>(5, {lameFrom(5e4, 0.4)}), 0).value();
        point.count = 4;
        point.node = {0, 2, 5, 7};
        point.weight = {0.1, 0.4, 0.3, 0.2};
      } else {
        const TriMesh box = scenes::boxSurface(-0.02 * Vec3::Ones(), 0.02 * Vec3::Ones());
        object = std::make_unique<RigidObject>(layout, massPropertiesOf(box, 1000).value(), 0, true);
        point.r_B = Vec3(0.03, -0.01, 0.02);
      }
      base = layout.free ? block : -1;
      block += object->blockCount();
      q += layout.qSize;
      v += layout.vSize;
    };
    add(pairing.a, a, spring.pointA, spring.baseA);
    add(pairing.b, b, spring.pointB, spring.baseB);
    spring.a = a.get();
    spring.b = b.get();
    spring.stiffness = kStiffness;
    spring.damping = kDamping;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-0.05, 0.05);
    state.q = VecX::NullaryExpr(q, [&] { return uniform(random); });
    for (const ContactObject* object : {a.get(), b.get()})
      if (object->layout().rigid)
        state.q.segment<4>(object->layout().qOffset + 3) = Vec4(0.5, -0.3, 0.6, 0.4).normalized();
    state.v.setZero(v);
    std::vector<std::array<int, 2>> pairs;
    appendSpringPairs(spring, state.q, pairs);
    symbolic = std::make_shared<BlockSymbolic>(block, pairs);
    bindSpring(spring, state.q, *symbolic);
  }

  Vec3 stretch(const State& at) const {
    return a->position(spring.pointA, at.q) - b->position(spring.pointB, at.q);
  }

  /// Stretch with the objects moved by h along velocity j.
  Vec3 stretchAlong(Eigen::Index j, double speed, double h) const {
    State moved = state;
    moved.v[j] = speed;
    a->advance(h, moved);
    b->advance(h, moved);
    return stretch(moved);
  }

  std::unique_ptr<ContactObject> a, b;
  BoundSpring spring;
  State state;
  std::shared_ptr<const BlockSymbolic> symbolic;
};

class SpringDerivatives : public testing::TestWithParam<Pairing> {};

TEST_P(SpringDerivatives, matrixAndRightHandSideAreThoseOfTheForce) {
  const Joined joined(GetParam());
  BlockMatrix A(joined.symbolic);
  A.setZero();
  VecX b = VecX::Zero(joined.state.v.size());
  assembleSpring(joined.spring, kDt, joined.state.q, A, b);

  // Blocks follow the velocities here, so A's order is v's. J = ∂(p_a − p_b) along q̇ = G v.
  const double h = 1e-5;
  MatX J(3, joined.state.v.size());
  for (Eigen::Index j = 0; j < J.cols(); ++j)
    J.col(j) = (joined.stretchAlong(j, 1, h) - joined.stretchAlong(j, -1, h)) / (2 * h);
  // F = −Jᵀ (k s + c ṡ) with J as it is now: −∂F/∂q G = k Jᵀ J and −∂F/∂v = c Jᵀ J.
  const MatX expectedA = (kDt * kDt * kStiffness + kDt * kDamping) * J.transpose() * J;
  const VecX expectedB = -kDt * kStiffness * J.transpose() * joined.stretch(joined.state);
  ASSERT_GT(joined.stretch(joined.state).norm(), 0.01);
  // A turning arm of 0.04 m differs from its chord by h²/6; positions of 0.1 m over 2e-5 keep eleven digits.
  EXPECT_LT((A.toDense() - expectedA).norm(), 1e-10 * expectedA.norm());
  EXPECT_LT((b - expectedB).norm(), 1e-10 * expectedB.norm());
}

TEST_P(SpringDerivatives, partLeftOutIsTheTurnOfTheLever) {
  // With levers that move, F's derivative has the change of Jᵀ besides: for a rigid end at most k |r| |s|,
  // the torque of the pull by a radian. A soft end has none.
  const Pairing pairing = GetParam();
  const Joined joined(pairing);
  const double h = 1e-5;
  const auto forceAt = [&](const State& at) {
    BlockMatrix A(joined.symbolic);
    A.setZero();
    VecX b = VecX::Zero(at.v.size());
    assembleSpring(joined.spring, kDt, at.q, A, b);
    return VecX(b / kDt);
  };
  BlockMatrix A(joined.symbolic);
  A.setZero();
  VecX b = VecX::Zero(joined.state.v.size());
  assembleSpring(joined.spring, kDt, joined.state.q, A, b);
  MatX K = A.toDense() / (kDt * kDt + kDt * kDamping / kStiffness);
  MatX H(K.rows(), K.cols());
  for (Eigen::Index j = 0; j < H.cols(); ++j) {
    State plus = joined.state;
    plus.v[j] = 1;
    State minus = plus;
    minus.v = -plus.v;
    for (const ContactObject* object : {joined.a.get(), joined.b.get()}) {
      object->advance(h, plus);
      object->advance(h, minus);
    }
    H.col(j) = (forceAt(minus) - forceAt(plus)) / (2 * h);
  }
  const double lever = Vec3(0.03, -0.01, 0.02).norm(),
               torque = kStiffness * lever * joined.stretch(joined.state).norm();
  const int rigidEnds = (pairing.a == End::Rigid) + (pairing.b == End::Rigid);
  // Spectral norm of [s]ᵀ[r] is at most |s||r|; two rigid ends are two separate blocks.
  EXPECT_LE((H - K).operatorNorm(), rigidEnds ? torque * (1 + 1e-6) : 1e-9 * K.norm());
  EXPECT_TRUE(!rigidEnds || (H - K).operatorNorm() > 0.1 * torque);
}

INSTANTIATE_TEST_SUITE_P(Ends, SpringDerivatives,
                         testing::Values(Pairing{"softOnSoft", End::Soft, End::Soft},
                                         Pairing{"softOnRigid", End::Soft, End::Rigid},
                                         Pairing{"rigidOnRigid", End::Rigid, End::Rigid},
                                         Pairing{"softOnFixed", End::Soft, End::Fixed},
                                         Pairing{"fixedOnRigid", End::Fixed, End::Rigid}),
                         [](const auto& ends) { return ends.param.name; });

}  // namespace
}  // namespace glenoid
