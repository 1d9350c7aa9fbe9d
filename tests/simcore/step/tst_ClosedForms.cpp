// SPDX-License-Identifier: GPL-3.0-or-later
// Whole steps whose answer is known in closed form.
#include <gtest/gtest.h>

#include <complex>

#include "tests/scenes/LadderScenes.h"
#include "tests/simcore/step/Measures.h"

namespace glenoid {
namespace {

TEST(ClosedForm, freeFallOfRigidAndSoft) {
  // Backward Euler under constant weight: v_n = v₀ + n Δt g, x_n = x₀ + n Δt v₀ + n (n + 1)/2 Δt² g, for
  // every node.
  scenes::LadderScene scene = scenes::twoFallingBoxes();
  scene.scenario.dt = 5e-3;
  const auto model = compileModel(scene.joint, scene.scenario).value();
  State state = model->start;
  const Vec3 v0(0.7, 1.5, -0.3), g = scene.scenario.gravity_W;
  for (const int object : {0, 1}) test::setInMotion(*model, object, v0, Vec3::Zero(), state);
  Stepper stepper(model, {});
  const int n = 200;
  for (int i = 0; i < n; ++i) ASSERT_TRUE(stepper.step({}, state).taken);
  const double t = n * 5e-3;
  const Vec3 way = t * v0 + 0.5 * t * (t + 5e-3) * g;
  ASSERT_GT(way.norm(), 3);
  for (const int object : {0, 1}) {
    const ObjectLayout& layout = model->objects[object].layout;
    for (int node = 0; node < (layout.rigid ? 1 : layout.nodeCount); ++node) {
      const int q = layout.qOffset + 3 * node, v = layout.vOffset + 3 * node;
      // 200 sums of numbers of ten metres per second keep 1e-12; a soft part's solve adds cond(A) of 1e3 to
      // each.
      EXPECT_LT((state.q.segment<3>(q) - model->start.q.segment<3>(q) - way).norm(), 1e-11);
      EXPECT_LT((state.v.segment<3>(v) - v0 - t * g).norm(), 1e-11);
    }
  }
}

TEST(ClosedForm, twoBodiesOnASpringSwingAsBackwardEulerSays) {
  // Stretch s of a spring k between masses of reduced mass µ, ω² = k/µ: (s + i…)_n = d zⁿ with z = 1/(1 −
  // iωΔt), so s_n = d (1 + ω²Δt²)^(−n/2) cos(n atan ωΔt): the period and the damping that the implicit step
  // brings.
  const double k = 400, d = 1e-3;
  for (const double dt : {1e-3, 5e-3, 2e-2}) {
    scenes::LadderScene scene = scenes::twoBoxesOnASpring(k);
    scene.scenario.dt = dt;
    const auto model = compileModel(scene.joint, scene.scenario).value();
    State state = model->start;
    const int first = model->objects[0].layout.qOffset, second = model->objects[1].layout.qOffset;
    const double m1 = model->objects[0].mass, m2 = model->objects[1].mass,
                 omega = std::sqrt(k * (m1 + m2) / (m1 * m2));
    EXPECT_NEAR(m1, 0.032, 1e-12);
    EXPECT_NEAR(m2, 0.024, 1e-12);
    const double apart = state.q[second] - state.q[first];
    state.q[second] += d;
    const std::complex<double> z = 1.0 / std::complex<double>(1, -omega * dt);
    std::complex<double> s = d;
    Stepper stepper(model, {});
    for (int n = 0; n < 100; ++n) {
      stepper.step({}, state);
      s *= z;
      // Round-off of positions of centimetres, over 100 steps.
      ASSERT_NEAR(state.q[second] - state.q[first] - apart, s.real(), 1e-11 * d)
          << "step " << n << " of " << dt;
    }
    EXPECT_LT(std::abs(s), 0.9 * d) << "the implicit step damps";
    EXPECT_LT(state.v.segment<3>(model->objects[0].layout.vOffset + 3).norm(), 1e-10) << "nothing turns";
  }
}

TEST(ClosedForm, aSpinningBodyInAWholeStepKeepsItsEnergyAndAngularMomentum) {
  // The rigid box of the falling scene alone in space, tumbling about no principal axis.
  scenes::LadderScene scene = scenes::twoFallingBoxes();
  scene.scenario.effects.gravity = Wish::Off;
  for (const double dt : {1e-3, 5e-3, 2e-2}) {
    scene.scenario.dt = dt;
    const auto model = compileModel(scene.joint, scene.scenario).value();
    State state = model->start;
    state.v.segment<3>(model->objects[0].layout.vOffset + 3) = Vec3(8, 3, -5);
    const ContactObject& box = *model->inside->objects[0];
    const double energy = box.kineticEnergy(state), momentum = box.momentum(state).tail<3>().norm();
    Stepper stepper(model, {});
    for (int i = 0; i < 1000; ++i) stepper.step({}, state);
    // Every step rounds once, at random: 1000 of them make some 1e-14.
    EXPECT_NEAR(box.kineticEnergy(state), energy, 1e-12 * energy) << dt;
    EXPECT_NEAR(box.momentum(state).tail<3>().norm(), momentum, 1e-12 * momentum) << dt;
  }
}

/// Lengthening of the bar under its own weight, m, after the step has found its rest.
double elongation(int cells, double young, double density, double* rise = nullptr) {
  scenes::LadderScene scene = scenes::hangingBar(cells, young, density);
  scene.scenario.dt = 0.1;
  const auto model = compileModel(scene.joint, scene.scenario).value();
  State state = model->start;
  Stepper stepper(model, {});
  for (int i = 0; i < 30; ++i) stepper.step({}, state);
  EXPECT_LT(state.v.norm(), 1e-9) << "at rest";
  const ObjectLayout& bar = model->objects[1].layout;
  const TetMesh& mesh = *model->objects[1].volume;
  double top = 0, held = 0, bottom = 0;
  int bottoms = 0;
  for (int i = 0; i < bar.nodeCount; ++i) {
    const double sag = mesh.nodes[i].y() - state.q[bar.qOffset + 3 * i + 1];
    if (mesh.nodes[i].y() < -0.1 + 1e-9) bottom += sag, ++bottoms;
  }
  // The bond's own mean over its area: nodes of the end share the area unevenly, and sag unevenly for it.
  for (const SpringView& spring : model->springs) {
    double sag = 0;
    for (int k = 0; k < 4; ++k) {
      const int node = spring.a.node[k];
      sag += spring.a.weight[k] * (mesh.nodes[node].y() - state.q[bar.qOffset + 3 * node + 1]);
    }
    top += spring.stiffness * sag;
    held += spring.stiffness;
  }
  if (rise) *rise = top / held;
  return bottom / bottoms - top / held;
}

TEST(ClosedForm, aLoadMovesAHeldBodyByForceOverStiffness) {
  // Both act at the point of the body that rests at the origin, which is not its mass centre: at rest that point has
  // moved by F/k and the body has turned by τ/kθ, whatever the lever.
  scenes::LadderScene scene = scenes::twoFallingBoxes();
  scene.scenario.effects.gravity = Wish::Off;
  const double k = 2e3, kTheta = 5;
  const Vec3 force(3, -4, 1), torque(0.2, 0.1, -0.3);
  const std::string id = scene.joint.parts[0].id;
  scene.scenario.holds = {{id, k, kTheta, 0.05}};
  scene.scenario.loads = {{id, force, torque}};
  const auto model = compileModel(scene.joint, scene.scenario).value();
  ASSERT_TRUE(model->objects[0].layout.rigid);
  State state = model->start;
  const Pose start = poseAt(state.q, model->objects[0].layout.qOffset);
  ASSERT_GT(start.p_WB.norm(), 1e-2) << "there is a lever";
  Stepper stepper(model, {});
  for (int i = 0; i < 4000; ++i) ASSERT_TRUE(stepper.step({}, state).taken);
  const Pose end = poseAt(state.q, model->objects[0].layout.qOffset);
  const Vec3 anchor_B = start.q_WB.conjugate() * -start.p_WB;
  EXPECT_LT((end * anchor_B - force / k).norm(), 1e-9);
  const Eigen::AngleAxisd turn(end.q_WB * start.q_WB.conjugate());
  EXPECT_LT((turn.angle() * turn.axis() - torque / kTheta).norm(), 1e-9);
}

TEST(ClosedForm, aHangingBarGrowsByRhoGLSquaredOverTwoE) {
  const double young = 5e5, density = 1000, expected = density * 9.81 * 0.1 * 0.1 / (2 * young);
  double error[3], rise = 0;
  for (int i = 0; i < 3; ++i) error[i] = elongation(1 << i, young, density, &rise) / expected - 1;
  std::printf("hanging bar with 1, 2, 4 bricks across: off by %.1e, %.1e, %.1e\n", error[0], error[1],
              error[2]);
  // Five tetrahedra load the corners of a brick unevenly, which bends the end faces: an error of the end
  // cells alone, so it falls with their height squared.
  EXPECT_LT(std::abs(error[0]), 2e-3);
  EXPECT_NEAR(std::log2(error[0] / error[2]) / 2, 2, 0.3);
  // What holds it gives by its weight over 1e10 N/m³ × 4 cm². The weight is right to 1e-15; what is at rest has the
  // digits that positions of 10 cm keep of 1e-7 m.
  EXPECT_NEAR(rise, density * 9.81 * 0.1 / 1e10, 1e-6 * density * 9.81 * 0.1 / 1e10);
}

}  // namespace
}  // namespace glenoid
