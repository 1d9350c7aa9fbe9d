// SPDX-License-Identifier: GPL-3.0-or-later
// A training in a scenario's file: there and back, what is refused and where, what follows its parts.
#include <gtest/gtest.h>

#include <filesystem>

#include "simcore/author/MirrorJoint.h"
#include "simcore/scene/ScenarioFile.h"
#include "simcore/scene/training/TrainingCheck.h"
#include "simcore/train/TrainingWatch.h"
#include "tests/simcore/train/TrainingScenes.h"

namespace glenoid {
namespace {

using namespace scenes;

/// Every member away from its default.
Scenario full() {
  Scenario scenario = slabScenario();
  scenario.joint = "slab.joint";
  Task follow = taskAt("follow", TaskKind::Follow, "");
  follow.name = "Follow the right hand";
  follow.text = "Stay with it";
  follow.hint = "Slowly";
  follow.places[0] = {"slab", "", "", Vec3(0.01, 0, 0), {}};
  follow.keys = {{0, Vec3::Zero()}, {1, Vec3(0, 0, 0.01)}};
  follow.tolerance = 0.004;
  follow.hold = 2;
  follow.share = 0.6;
  follow.timeGood = 3;
  follow.timeMax = 9;
  follow.errorCost = 0.1;
  follow.weight = 2;
  Task press = taskAt("press", TaskKind::Press, "left");
  press.forceMin = 1;
  press.forceMax = 2;
  Task look = taskAt("look", TaskKind::Look, "middle");
  look.angle = 0.3;
  look.range = 0.1;
  look.hidden = true;
  Task pass = taskAt("pass", TaskKind::Pass, "");
  pass.places[0] = {"", "", "", Vec3(0, 0.03, 0.01), Vec3(0, 0, 1)};
  scenario.training = {"What to do", true, {follow, press, look, pass}, {{"gentle", "Gently", "slab", "right-half", 3}},
                       {{"tasks", 90, 1, 0}, {"gentle.tooHard", 10, 0, 3}}, 60, {{"time", 30, 5, 12, "somebody"}}, {{"time", 95, "Probing", "a trainer of plastic"}}};
  return scenario;
}

TEST(TrainingFile, comesBackAsItWas) {
  const std::string path = (std::filesystem::temp_directory_path() / "glenoid-training.scenario.json").string();
  Scenario scenario = full();
  scenario.tools[1].lensTurn = -1.25;
  scenario.tools[1].fieldOfView = 1.9;
  scenario.tools[1].inAir = true;
  const auto saved = saveScenario(scenario, path);
  ASSERT_TRUE(saved) << toLogLine(saved.error());
  const auto back = loadScenario(path);
  ASSERT_TRUE(back) << toLogLine(back.error());
  EXPECT_TRUE(back->training == scenario.training);
  const Tool &scope = scenario.tools[1], &read = back->tools[1];
  EXPECT_EQ(std::tuple(read.lens, read.lensTurn, read.fieldOfView, read.inAir), std::tuple(scope.lens, scope.lensTurn, scope.fieldOfView, scope.inAir));
  std::filesystem::remove(path);
}

TEST(TrainingFile, refusesWhatCannotBeDoneAndSaysWhere) {
  const auto refused = [](auto&& change) {
    Scenario scenario = full();
    change(scenario.training);
    const auto good = checkScenario(scenario, "x.scenario.json");
    return good ? std::string("accepted") : good.error().place.pointer;
  };
  EXPECT_EQ(refused([](Training&) {}), "accepted");
  EXPECT_EQ(refused([](Training& t) { t.tasks[1].id = "follow"; }), "/training/tasks/1/id");
  EXPECT_EQ(refused([](Training& t) { t.limits[0].id = "finger"; }), "/training/limits/0/id");  // "finger.forceMax" would be two things
  EXPECT_EQ(refused([](Training& t) { t.tasks[0].tool = "hook"; }), "/training/tasks/0/tool");
  EXPECT_EQ(refused([](Training& t) { t.tasks[0].keys[1].time = 0; }), "/training/tasks/0/keys/1");
  EXPECT_EQ(refused([](Training& t) { t.tasks[1].forceMax.reset(); }), "/training/tasks/1");
  EXPECT_EQ(refused([](Training& t) { t.tasks[1].forceMax = 0.5; }), "/training/tasks/1/forceMax");
  EXPECT_EQ(refused([](Training& t) { t.tasks[1].places.push_back(t.tasks[1].places[0]); }), "/training/tasks/1/places");
  EXPECT_EQ(refused([](Training& t) { t.tasks[1].places[0].region = "right-half"; }), "/training/tasks/1/places/0");
  EXPECT_EQ(refused([](Training& t) { t.tasks[3].places[0].normal_W.reset(); }), "/training/tasks/3/places/0");
  EXPECT_EQ(refused([](Training& t) { t.tasks[1].kind = TaskKind::Trace; }), "/training/tasks/1/places");
  EXPECT_EQ(refused([](Training& t) { t.tasks[2].places[0].landmark.clear(); }), "/training/tasks/2/places/0");  // the middle of a part is seen by nobody
  EXPECT_EQ(refused([](Training& t) {
              t.tasks[1].kind = TaskKind::Trace;
              t.tasks[1].places = {t.tasks[1].places[0], {"other", "there", "", {}, {}}};
            }),
            "/training/tasks/1/places");
  EXPECT_EQ(refused([](Training& t) { t.form[0].worst = 1; }), "/training/form/0");
  EXPECT_EQ(refused([](Training& t) { t.tasks[0].weight = -1; }), "/training/tasks/0/weight");
  EXPECT_EQ(refused([](Training& t) { t.references[0].sd = 0; }), "/training/references/0/sd");

  const Joint joint = slabJoint();
  const auto unknown = [&](auto&& change) {
    Scenario scenario = full();
    change(scenario.training);
    const auto good = checkScenario(scenario, joint, Place{"x.scenario.json", "", "", {}});
    return good ? std::string("accepted") : good.error().place.pointer;
  };
  EXPECT_EQ(unknown([](Training&) {}), "accepted");
  EXPECT_EQ(unknown([](Training& t) { t.tasks[1].places[0].landmark = "nowhere"; }), "/training/tasks/1/places/0/landmark");
  EXPECT_EQ(unknown([](Training& t) { t.tasks[1].places[0] = {"slab", "", "nowhere", {}, {}}; }), "/training/tasks/1/places/0/region");
  EXPECT_EQ(unknown([](Training& t) { t.tasks[2].places[0].part = "bone"; }), "/training/tasks/2/places/0/part");
  EXPECT_EQ(unknown([](Training& t) { t.limits[0].region = "nowhere"; }), "/training/limits/0/region");
}

TEST(TrainingFile, aFormThatNamesNoMetricIsRefusedWhenTheSceneIsRun) {
  Scenario scenario = full();
  scenario.training.form[1].metric = "probe.elegance";
  const auto model = compileModel(slabJoint(), scenario);
  ASSERT_TRUE(model);
  const auto watch = TrainingWatch::make(**model);
  ASSERT_FALSE(watch);
  EXPECT_EQ(watch.error().fault, Fault::UnknownId);
  EXPECT_EQ(watch.error().place.pointer, "/training/form/1/metric");
}

TEST(TrainingFile, whatLosesItsPartGoesAndTheRestStays) {
  Scenario scenario = full();
  dropFromTraining(scenario.training, "slab", "right-half");
  EXPECT_TRUE(scenario.training.limits.empty());
  EXPECT_EQ(scenario.training.tasks.size(), 4u);
  dropFromTraining(scenario.training, "slab");
  ASSERT_EQ(scenario.training.tasks.size(), 1u);  // the ring in the room
  EXPECT_EQ(scenario.training.tasks[0].id, "pass");
  Training training = full().training;
  Joint bare = slabJoint();
  bare.parts[0].landmarks.clear();
  keepTrainingTo(bare, training);
  ASSERT_EQ(training.tasks.size(), 2u);
  EXPECT_EQ(training.tasks[0].id, "follow");
}

TEST(TrainingFile, mirroredTwiceIsTheSame) {
  const Scenario scenario = full(), once = mirroredScenario(scenario);
  EXPECT_EQ(once.training.tasks[0].name, "Follow the left hand");
  EXPECT_EQ(mirroredScenario([&] { Scenario right = scenario; right.training.text = "Hold it right"; return right; }()).training.text, "Hold it left");
  EXPECT_EQ(once.training.tasks[0].keys[1].displacement_W, Vec3(0, 0, -0.01));
  EXPECT_EQ(*once.training.tasks[3].places[0].normal_W, Vec3(0, 0, -1));
  EXPECT_TRUE(mirroredScenario(once).training == scenario.training);
}

}  // namespace
}  // namespace glenoid
