// SPDX-License-Identifier: GPL-3.0-or-later
// The palpation scene: a finger on the skin, a second one on the muscle below, pressed and dragged.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "simcore/live/PenetrationProbe.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "simcore/step/Stepper.h"

namespace glenoid {
namespace {

const std::string kResources = GLENOID_SOURCE_DIR "/resources";

std::shared_ptr<const Model> palpation() {
  static const auto model = compileModel(loadJoint(kResources + "/joints/shoulder-superficial.joint").value(),
                                         loadScenario(kResources + "/scenarios/palpation.scenario.json").value()).value();
  return model;
}

/// Along the finger, from the joint outwards, and two directions beside it.
struct Directions {
  Vec3 out, up, front;
};
Directions directions() {
  const Quat q = palpation()->scenario.tools[0].home.q_WB;
  const Vec3 out = q * Vec3::UnitZ(), up = (Vec3::UnitY() - out.y() * out).normalized();
  return {out, up, up.cross(out)};
}

/// In within half a second to 22 mm below home, then round and round with 0.5 m/s on an oval that crosses the borders of
/// all parts of the deltoid and the edge of the acromion, out again in the last second.
Vec3 handAt(double t, double end) {
  const auto [out, up, front] = directions();
  const double in = std::clamp(2 * t, 0.0, 1.0) * std::clamp(2 * (end - 1 - t), 0.0, 1.0);
  const double radius = 0.025, omega = 0.5 / radius, angle = omega * std::max(0.0, t - 0.5);
  const double wide = std::clamp(t - 0.5, 0.0, 1.0) * radius * (t < end - 1.5 ? 1 : 0);
  return palpation()->scenario.tools[0].home.p_WB - 0.022 * in * out + wide * (std::sin(angle) * up + std::cos(angle) * front);
}

TEST(Palpation, layersHoldUnderAFingerDraggedAtHalfAMetreASecond) {
  const auto model = palpation();
  Stepper stepper(model, {});
  State state = model->start;
  PenetrationProbe probe(*model, SurfaceKind::Collision);
  const double dt = model->scenario.dt, end = 6;
  std::vector<double> cpu, skinForce, muscleForce;
  double fastest = 0;
  Vec3 last = handAt(0, end);
  for (int i = 0; i < std::lround(end / dt); ++i) {
    const double t = (i + 1) * dt;
    const Vec3 hand = handAt(t, end);
    if (t < end - 1.5) fastest = std::max(fastest, (hand - last).norm() / dt);
    last = hand;
    const StepReport& report = stepper.step({{{hand, model->scenario.tools[0].home.q_WB}}}, state);
    ASSERT_TRUE(report.taken) << t;
    cpu.push_back(report.stepCpuMs);
    if (t > 1.5 && t < end - 1.5) {
      skinForce.push_back(report.toolForces[0].norm());
      muscleForce.push_back(report.toolForces[1].norm());
    }
    probe.look(state.q);
  }
  const auto median = [](std::vector<double> list) {
    std::nth_element(list.begin(), list.begin() + list.size() / 2, list.end());
    return list[list.size() / 2];
  };
  std::printf("step %.2f ms median, dragged at up to %.2f m/s; on the skin %.2f N (median), on the muscle %.2f N at most; %.3f mm inside (%s)\n",
              median(cpu), fastest, median(skinForce), *std::max_element(muscleForce.begin(), muscleForce.end()), 1e3 * probe.deepest(), probe.where().c_str());
  EXPECT_GT(fastest, 0.45);
  EXPECT_LT(probe.deepest(), 1e-3) << probe.where();
  EXPECT_GT(median(skinForce), 0.5);
  // Over the curve of the shoulder the finger inside comes and goes; the skin alone is always pressed.
  EXPECT_GT(*std::max_element(muscleForce.begin(), muscleForce.end()), 0.1);
  // A second after the finger is gone everything rests again.
  EXPECT_LT(state.v.cwiseAbs().maxCoeff(), 5e-2);
}

TEST(Palpation, pressingTheSkinPressesTheMuscleBelow) {
  const auto model = palpation();
  const auto [out, up, front] = directions();
  double last = 0;
  for (const double depth : {8e-3, 14e-3, 20e-3}) {
    Stepper stepper(model, {});
    State state = model->start;
    StepReport report;
    for (int i = 0; i < 300; ++i) {
      const Vec3 hand = model->scenario.tools[0].home.p_WB - std::min(1.0, i / 100.0) * depth * out;
      report = stepper.step({{{hand, model->scenario.tools[0].home.q_WB}}}, state);
    }
    const double muscle = report.toolForces[1].dot(out), skin = report.toolForces[0].dot(out);
    std::printf("%4.0f mm: %.2f N on the skin, %.2f N on the muscle\n", 1e3 * depth, skin, muscle);
    EXPECT_GT(muscle, last);
    EXPECT_GT(skin, 0);
    last = muscle;
  }
}

}  // namespace
}  // namespace glenoid
