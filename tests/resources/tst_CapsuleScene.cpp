// SPDX-License-Identifier: GPL-3.0-or-later
// What the arthroscopy with capsule and ligaments promises, on whole runs of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "simcore/live/Run.h"
#include "simcore/reading/Readings.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecordingFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "tests/MachineSpeed.h"

namespace glenoid {
namespace {

const std::string kResources = GLENOID_SOURCE_DIR "/resources";

const Joint& joint() {
  static const Joint loaded = loadJoint(kResources + "/joints/shoulder-capsule.joint").value();
  return loaded;
}

Scenario scenario() {
  return loadScenario(kResources + "/scenarios/arthroscopy-full.scenario.json").value();
}

const Recording& input() {
  static const Recording recording = loadRecording(kResources + "/recordings/arthroscopy.recording").value();
  return recording;
}

RunResult runFor(const Scenario& scene, double seconds, int threads = 1) {
  RunOptions options;
  options.seconds = seconds;
  options.stepper = {Profile::Direct, threads, false};
  options.input = &input();
  return runScenario(compileModel(joint(), scene).value(), options).value();
}

const RunReport& wholeRun() {
  static const RunReport report = runFor(scenario(), 10).report;
  return report;
}

TEST(CapsuleScene, staysFiniteAndNothingSinksIntoAnything) {
  const RunReport& run = wholeRun();
  EXPECT_TRUE(run.finite);
  EXPECT_EQ(run.rejectedSteps, 0);
  EXPECT_LT(run.penetrationMax, 1e-3);
  EXPECT_LT(run.residual, 1e-10);
  std::printf("%.2f ms a step (median), %.2f (99 %%), %.0f contacts at most, %.3f mm deep\n", run.step.median,
              run.step.p99, double(run.contacts.max), 1e3 * run.penetrationMax);
}

TEST(CapsuleScene, nothingIsToldOfTheWholeRun) {
  for (const Notice& notice : wholeRun().notices)
    ADD_FAILURE() << noticeName(notice.kind) << " " << notice.subject << " " << notice.figure;
}

TEST(CapsuleScene, isFasterThanTheClock) {
#ifdef NDEBUG
  EXPECT_LT(wholeRun().step.median, 5 * test::slowness());  // ms of thread CPU time for a step of 5 ms
#else
  GTEST_LOG_(INFO) << "assertions are on: no time is asserted, " << wholeRun().step.median << " ms";
#endif
}

TEST(CapsuleScene, theRecordingPressesWhatItSays) {
  ASSERT_FALSE(wholeRun().marks.empty());
  for (const MarkReport& mark : wholeRun().marks) {
    EXPECT_GE(mark.forceMax, 1.0) << mark.name;
    EXPECT_LT(mark.forceMax, 8.5) << mark.name;
  }
}

TEST(CapsuleScene, twoThreadsGiveTheSameBits) {
  EXPECT_EQ(runFor(scenario(), 2.2, 1).report.stateHash, runFor(scenario(), 2.2, 2).report.stateHash);
}

/// Turn of the humerus about the vertical after a couple of so much has acted for some seconds, degrees;
/// positive outwards.
double turnedBy(double torque) {
  Scenario scene = scenario();
  scene.holds[0].angularStiffness = 1e-3;
  Load twist;
  twist.part = "humerus";
  twist.torque_W = Vec3(0, torque, 0);
  scene.loads.push_back(twist);
  const RunResult run = runFor(scene, 2.5);
  EXPECT_TRUE(run.report.finite);
  EXPECT_LT(run.report.penetrationMax, 1.5e-3);
  for (const Notice& notice : run.report.notices)
    EXPECT_FALSE(isGrave(notice.kind)) << noticeName(notice.kind) << " " << notice.subject;
  const auto model = compileModel(joint(), scene).value();
  for (const PartReading& part : readScene(*model, run.state, run.contacts).parts)
    if (part.id == "humerus") return 2 * std::atan2(part.q_WB.y(), part.q_WB.w()) * 180 / 3.14159265;
  return 0;
}

TEST(CapsuleScene, theHeadStillTurns) {
  // A healthy shoulder turns by tens of degrees either way before its capsule is taut.
  const double still = turnedBy(0), one = turnedBy(1.0), other = turnedBy(-1.0);
  std::printf("the humerus turns by %.1f and %.1f degrees under 1 N m\n", one - still, other - still);
  EXPECT_GT(std::abs(one - still), 5);
  EXPECT_GT(std::abs(other - still), 5);
  EXPECT_LT((one - still) * (other - still), 0);
}

}  // namespace
}  // namespace glenoid
