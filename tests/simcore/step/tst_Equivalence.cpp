// SPDX-License-Identifier: GPL-3.0-or-later
// The same step taken in different ways: islands apart or as one system, parts in another order, another
// solver, another instruction set, another number of threads.
#include <gtest/gtest.h>

#include "simcore/linear/BlockCholesky.h"
#include "simcore/linear/ConjugateGradients.h"
#include "simcore/linear/ReferenceCholesky.h"
#include "tests/scenes/LadderScenes.h"
#include "tests/simcore/step/Measures.h"

namespace glenoid {
namespace {

/// Chain and loose block, just before a step of their impact in which they touch, moving and deformed
/// already.
struct Touching {
  explicit Touching(const scenes::LadderScene& scene)
      : model(compileModel(scene.joint, scene.scenario).value()), start(model->start) {
    test::setInMotion(*model, findObject("loose"), Vec3(0.05, -0.4, 0.02), Vec3(0, 0, 1), start);
    Stepper stepper(model, {});
    State now = start;
    for (int i = 0; i < 40; ++i) {
      const State before = now;
      if (stepper.step({}, now).active > 0) state = before;
    }
    EXPECT_GT(state.step, 1) << "touches after it has begun to";
  }
  int findObject(const std::string& id) const {
    for (std::size_t i = 0; i < model->objects.size(); ++i)
      if (model->objects[i].id == id) return static_cast<int>(i);
    return -1;
  }
  std::shared_ptr<const Model> model;
  State start, state;
};

State stepped(const std::shared_ptr<const Model>& model, State state, const StepperOptions& options,
              int steps = 1) {
  Stepper stepper(model, options);
  for (int i = 0; i < steps; ++i) EXPECT_TRUE(stepper.step({}, state).taken);
  return state;
}

/// Largest difference of any velocity of any part, by the parts' ids, over the largest velocity.
double difference(const Model& a, const State& x, const Model& b, const State& y) {
  double worst = 0;
  for (std::size_t i = 0; i < a.objects.size(); ++i)
    for (std::size_t j = 0; j < b.objects.size(); ++j)
      if (a.objects[i].id == b.objects[j].id && a.objects[i].layout.vSize > 0)
        worst = std::max(worst,
                         (test::velocitiesOf(a, i, x) - test::velocitiesOf(b, j, y)).cwiseAbs().maxCoeff());
  return worst / x.v.cwiseAbs().maxCoeff();
}

TEST(Equivalence, islandsApartEqualOneWholeSystem) {
  // A coupling without stiffness between the loose block's top and the chain's far end makes one coupling
  // island of the two: one factorization instead of two, one set of rows inside it instead of a row in each.
  scenes::LadderScene apart = scenes::chainAndLooseBlock(), whole = apart;
  Part& loose = whole.joint.parts[3];
  loose.regions.push_back(scenes::regionIn(loose, "top", Box3(Vec3(-1, 0.0399, -1), Vec3(1, 0.0401, 1))));
  whole.joint.couplings.push_back({"nothing", "loose", "right", "top", 0, 0});
  const Touching touching(apart);
  const auto one = compileModel(whole.joint, whole.scenario).value();
  ASSERT_EQ(touching.model->couplingIslandCount, 2);
  ASSERT_EQ(one->couplingIslandCount, 1);
  for (const Profile profile : {Profile::Direct, Profile::Reference}) {
    const State a = stepped(touching.model, touching.state, {profile}),
                b = stepped(one, touching.state, {profile});
    // Round-off: the stiff springs that make A's condition 1e6 hardly move, so their digits are not lost to
    // the rest.
    EXPECT_LT(difference(*touching.model, a, *one, b), 1e-12) << static_cast<int>(profile);
  }
}

TEST(Equivalence, orderOfPartsDoesNotMatter) {
  // The chain's parts and the loose block in three other orders, through the whole impact. State, pattern,
  // pairs and keys all change their order. What is left is round-off, which an impact that is not chaotic
  // multiplies by little.
  const scenes::LadderScene scene = scenes::chainAndLooseBlock();
  const Touching first(scene);
  for (const std::array<int, 4>& order :
       {std::array{3, 2, 1, 0}, std::array{1, 3, 0, 2}, std::array{2, 0, 3, 1}}) {
    scenes::LadderScene other = scene;
    for (int i = 0; i < 4; ++i) other.joint.parts[i] = scene.joint.parts[order[i]];
    std::reverse(other.joint.couplings.begin(), other.joint.couplings.end());
    const Touching second(other);
    State a = first.start, b = second.start;
    Stepper stepperA(first.model, {}), stepperB(second.model, {});
    int active = 0;
    for (int i = 0; i < 200; ++i) {
      const StepReport& reportA = stepperA.step({}, a);
      const StepReport& reportB = stepperB.step({}, b);
      active += reportA.active > 0;
      ASSERT_EQ(reportA.contacts, reportB.contacts) << i;
      ASSERT_LT(difference(*first.model, a, *second.model, b), 1e-10) << "step " << i;
    }
    EXPECT_GT(active, 3);
  }
}

TEST(Equivalence, directAgreesWithTheReference) {
  const Touching touching(scenes::chainAndLooseBlock());
  const State direct = stepped(touching.model, touching.state, {Profile::Direct});
  const State reference = stepped(touching.model, touching.state, {Profile::Reference});
  EXPECT_LT((direct.v - reference.v).norm(), 1e-12 * reference.v.norm());
}

TEST(Equivalence, portableKernelsAgreeWithTheFastOnes) {
  // Fused multiply-adds round once where the portable path rounds twice: round-off times the condition of A.
  const Touching touching(scenes::chainAndLooseBlock());
  const State fast = stepped(touching.model, touching.state, {Profile::Direct, 1, false});
  const State portable = stepped(touching.model, touching.state, {Profile::Direct, 1, true});
  EXPECT_LT((fast.v - portable.v).norm(), 1e-12 * fast.v.norm());
}

TEST(Equivalence, oneThreadAndTwoGiveTheSameBits) {
  const Touching touching(scenes::chainAndLooseBlock());
  for (const Profile profile : {Profile::Direct, Profile::Reference, Profile::Paper})
    EXPECT_EQ(toHex(stateHash(stepped(touching.model, touching.start, {profile, 1}, 40))),
              toHex(stateHash(stepped(touching.model, touching.start, {profile, 2}, 40))));
}

TEST(Equivalence, threeSolversGiveOneAnswerForEveryIsland) {
  const Touching touching(scenes::chainAndLooseBlock());
  const StepModel& inside = *touching.model->inside;
  for (const CouplingIslandModel& island : inside.islands) {
    const auto [A, b] = test::systemOf(inside, island, touching.state);
    BlockCholesky cholesky(island.symbolic);
    ReferenceCholesky cholmod(island.symbolic);
    ASSERT_TRUE(cholesky.factor(A) && cholmod.factor(A));
    VecX x = b, y = b, z;
    cholesky.solve(x);
    cholmod.solve(y);
    CgWork work;
    const CgReport report = solveConjugateGradients(A, b, z, {1e-14, 5000}, work, true);
    ASSERT_TRUE(report.finite);
    // CHOLMOD's is refined to round-off. Ours could be off by cond(A) · 1e-16 with cond(A) near 1e6, and is
    // by a hundredth of that; conjugate gradients by their residual of 1e-14 times what the preconditioner
    // leaves of the condition.
    EXPECT_LT((x - y).norm(), 1e-12 * y.norm());
    EXPECT_LT((z - y).norm(), 1e-11 * y.norm()) << report.iterations << " iterations to " << report.residual;
  }
}

}  // namespace
}  // namespace glenoid
