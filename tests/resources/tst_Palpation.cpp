// SPDX-License-Identifier: GPL-3.0-or-later
// The palpation scene: a finger on the skin, a second one on the muscle below, pressed and dragged.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "resources/generate/StrokePlan.h"
#include "simcore/live/PenetrationProbe.h"
#include "simcore/live/Run.h"
#include "simcore/reading/Readings.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecordingFile.h"
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

const Recording& input() {
  static const Recording recording = loadRecording(kResources + "/recordings/palpation.recording").value();
  return recording;
}

TEST(Palpation, layersHoldUnderAFingerDraggedAtHalfAMetreASecond) {
  const auto model = palpation();
  Stepper stepper(model, {});
  State state = model->start;
  PenetrationProbe probe(*model, SurfaceKind::Collision);
  const double dt = model->scenario.dt;
  std::vector<double> cpu, skinForce, muscleForce;
  double fastest = 0;
  Vec3 last = model->scenario.tools[0].home.p_WB;
  Inputs inputs;
  for (int i = 0; i < std::lround(inputSeconds(input()) / dt); ++i) {
    const double t = (i + 1) * dt;
    handsAt(model->scenario, &input(), t, inputs.hands);
    const StepReport& report = stepper.step(inputs, state);
    ASSERT_TRUE(report.taken) << t;
    cpu.push_back(report.stepCpuMs);
    for (const RecordingMark& mark : input().marks) {
      if (t < mark.begin || t >= mark.end) continue;
      skinForce.push_back(report.toolForces[0].norm());
      muscleForce.push_back(report.toolForces[1].norm());
      fastest = std::max(fastest, (inputs.hands[0].p_WB - last).norm() / dt);
    }
    last = inputs.hands[0].p_WB;
    probe.look(state.q, report.dents);
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

TEST(Palpation, theRecordingIsTheOneThatIsPlanned) {
  const Recording again = generate::planStrokes(palpation()->scenario, "finger", "skin");
  ASSERT_EQ(again.tracks.size(), 1u);
  ASSERT_EQ(again.tracks[0].keys.size(), input().tracks[0].keys.size());
  for (std::size_t i = 0; i < again.tracks[0].keys.size(); ++i)
    EXPECT_LT((again.tracks[0].keys[i].hand.p_WB - input().tracks[0].keys[i].hand.p_WB).norm(), 1e-9) << i;
}

TEST(Palpation, comesToRestWithHandsAtHomeAndOnceTheFingerHasLetGo) {
  // The finger is on the skin before the loads are whole, so that the recorded run rests only at its end.
  const auto contactsOf = [](const Recording* hands, double seconds) {
    RunOptions options;
    options.seconds = seconds;
    options.input = hands;
    options.checks = false;
    return runScenario(palpation(), options)->report.contacts;
  };
  EXPECT_EQ(contactsOf(nullptr, 0.3).restReason, "loads-still-rise");
  EXPECT_EQ(contactsOf(nullptr, 0.55).restReason, "parts-still-move");
  EXPECT_EQ(contactsOf(&input(), 2.4).restReason, "tools-touch") << "the finger holds still on the skin";
  const ContactCounts home = contactsOf(nullptr, 2), after = contactsOf(&input(), 8);
  ASSERT_TRUE(home.rest && after.rest);
  std::printf("at rest: %.1f rows (%.1f press) with hands at home, %.1f (%.1f) after the strokes\n", *home.rest, *home.pressingRest, *after.rest, *after.pressingRest);
  // The same scene, but friction and what it has slid over may leave some contacts elsewhere.
  EXPECT_NEAR(*after.rest, *home.rest, 0.1 * *home.rest);
  EXPECT_NEAR(*after.pressingRest, *home.pressingRest, 0.2 * *home.pressingRest);
}

TEST(Palpation, pressingTheSkinPressesTheMuscleBelow) {
  // The deltoid feels the skin that is pressed onto it and the finger inside, which stands for what the skin's stiffness
  // passes on at the very spot; the muscle gives way under both, so the finger inside has but a small share. Below some 18 mm it
  // has slid down the flank between two parts of the deltoid, with dents and without, and has none.
  const auto model = palpation();
  const Vec3 out = model->scenario.tools[0].home.q_WB * Vec3::UnitZ();
  double last = 0, before = 0;  // N, at the depth before
  for (const double depth : {0.0, 8e-3, 14e-3, 20e-3}) {
    Stepper stepper(model, {});
    State state = model->start;
    StepReport report;
    for (int i = 0; i < 300; ++i) {
      const Vec3 hand = model->scenario.tools[0].home.p_WB - std::min(1.0, i / 100.0) * depth * out;
      report = stepper.step({{{hand, model->scenario.tools[0].home.q_WB}}}, state);
    }
    double below = 0, inside = 0;  // N into the shoulder, on the three parts of the deltoid
    for (const ContactReading& contact : readContacts(*model, report.contactViews)) {
      const bool onA = contact.a.starts_with("deltoid"), onB = contact.b.starts_with("deltoid");
      const std::string& other = onA ? contact.b : contact.a;
      if (onA == onB || (other != "skin" && other != "finger-inside")) continue;
      const double force = (contact.force * contact.normal_W + contact.friction_W).dot(onA ? Vec3(-out) : out);
      below += force;
      if (other == "finger-inside") inside += force;
    }
    const double skin = report.toolForces[0].dot(out);
    std::printf("%4.0f mm: %.2f N on the skin; on the muscle %.2f N, %.2f N of it by the finger inside\n", 1e3 * depth, skin, below, inside);
    EXPECT_GE(inside, depth > 0.01 && depth < 0.018 ? 0.03 : 0.0);
    EXPECT_GT(below, depth > 0 ? before + 0.05 : -1e-9) << "the deeper, the more arrives below the skin";
    if (depth > 0) EXPECT_GT(skin, last);
    before = below;
    last = skin;
  }
}

}  // namespace
}  // namespace glenoid
