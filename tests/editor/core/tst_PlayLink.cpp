// SPDX-License-Identifier: GPL-3.0-or-later
// The link with a compiler and steps made here: what counts is which model runs and what is said, not physics.
#include "editor/core/PlayLink.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QThread>
#include <atomic>

#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

/// Young's modulus of "tissue" is what the fake model starts at; zero or less cannot be compiled.
Result<std::shared_ptr<const Model>> fakeCompile(const Joint& joint, const Scenario& scenario) {
  const double young = joint.materials[findMaterial(joint, "tissue")].youngsModulus;
  if (young <= 0) return Error{Fault::Unusable, {{}, {}, "block", {}}, {"no stiffness"}, {}};
  auto model = std::make_shared<Model>();
  model->joint = joint;
  model->scenario = scenario;
  SceneObject object;
  object.id = "block";
  object.layout.rigid = false;
  object.layout.qSize = object.layout.vSize = 3;
  model->objects.push_back(object);
  model->start.q = VecX::Constant(3, young);
  model->start.v = VecX::Zero(3);
  return std::shared_ptr<const Model>(model);
}

StepFunction fakeSteps(std::shared_ptr<const Model> model, const StepperOptions&) {
  auto report = std::make_shared<StepReport>();
  return [=](const Inputs& inputs, State& state) -> const StepReport& {
    state.q[0] += 1;
    state.q[1] = inputs.hands.empty() ? 0 : inputs.hands[0].p_WB.y();
    state.step += 1;
    state.time += model->scenario.dt;
    return *report;
  };
}

/// Says after the second step that the block is torn away, and at once that the seed does nothing.
struct FakeWatch : StepWatch {
  void look(const StepReport&, const State& state, bool) override {
    if (state.step != 2) return;
    auto more = *list;
    more.push_back({NoticeKind::TornAway, "block", "", 3, 0.1, state.time, state.step, {}});
    list = std::make_shared<const std::vector<Notice>>(more);
  }
  void add(const Notice&) override {}
  std::shared_ptr<const std::vector<Notice>> notices() const override { return list; }
  std::shared_ptr<const std::vector<Notice>> list =
      std::make_shared<const std::vector<Notice>>(std::vector<Notice>{{NoticeKind::UnusedSetting, "7", "", 0, 0, 0, 0, {UnusedSetting::Why::Seed, "7"}}});
};

std::unique_ptr<StepWatch> fakeWatch(std::shared_ptr<const Model>, std::shared_ptr<const Recording>, std::function<void()>) {
  return std::make_unique<FakeWatch>();
}

Scene scene(double young) {
  Scene made{scenes::blockOnPlateJoint(), scenes::blockOnPlateScenario(), nullptr};
  made.joint.materials[findMaterial(made.joint, "tissue")].youngsModulus = young;
  return made;
}

class PlayLinkTest : public testing::Test {
 protected:
  template <class Condition>
  bool until(Condition holds) {
    QElapsedTimer clock;
    clock.start();
    while (!holds()) {
      if (clock.elapsed() > 20000) return false;
      QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
      QThread::msleep(1);
    }
    return true;
  }

  PlayLinkTest() {
    QObject::connect(&link, &PlayLink::problem, [this](const Error& error) { problems.push_back(error); });
  }
  bool shows(double start) { return link.snapshot().model && link.snapshot().model->start.q[0] == start; }

  int argc = 1;
  char name[5] = "test";
  char* argv[2] = {name, nullptr};
  QCoreApplication application{argc, argv};
  Document document;
  PlayLink link{document, fakeCompile, fakeSteps, fakeWatch};
  std::vector<Error> problems;
};

TEST_F(PlayLinkTest, anOpenedSceneIsCompiledAndShownAtRest) {
  document.open(scene(10), "a");
  EXPECT_TRUE(link.isCompiling());
  ASSERT_TRUE(until([this] { return shows(10); }));
  EXPECT_FALSE(link.isCompiling());
  EXPECT_FALSE(link.snapshot().playing);
  EXPECT_EQ(link.snapshot().step, 0);
}

TEST_F(PlayLinkTest, commandsReachTheRun) {
  document.open(scene(10), "a");
  ASSERT_TRUE(until([this] { return shows(10); }));
  link.stepOnce();
  ASSERT_TRUE(until([this] { return link.snapshot().step == 1; }));
  link.togglePlay();
  ASSERT_TRUE(until([this] { return link.snapshot().playing && link.snapshot().step > 5; }));
  link.togglePlay();
  ASSERT_TRUE(until([this] { return !link.snapshot().playing; }));
  link.reset();
  ASSERT_TRUE(until([this] { return link.snapshot().step == 0; }));
}

TEST_F(PlayLinkTest, anEditKeepsTheStateAndUndoToo) {
  document.open(scene(10), "a");
  ASSERT_TRUE(until([this] { return shows(10); }));
  for (int i = 0; i < 3; ++i) link.stepOnce();
  document.setYoungsModulus("tissue", 20);
  ASSERT_TRUE(until([this] { return shows(20); }));
  EXPECT_EQ(link.snapshot().q[0], 13);
  document.undoStack().undo();
  ASSERT_TRUE(until([this] { return shows(10); }));
  EXPECT_EQ(link.snapshot().q[0], 13);
}

TEST_F(PlayLinkTest, whatCannotBeCompiledIsSaidAndTheOldModelStays) {
  document.open(scene(10), "a");
  ASSERT_TRUE(until([this] { return shows(10); }));
  document.setYoungsModulus("tissue", -1);
  ASSERT_TRUE(until([this] { return !problems.empty(); }));
  EXPECT_EQ(problems[0].fault, Fault::Unusable);
  EXPECT_EQ(problems[0].place.part, "block");
  EXPECT_TRUE(shows(10));
  link.stepOnce();
  EXPECT_TRUE(until([this] { return link.snapshot().step == 1; }));
}

TEST_F(PlayLinkTest, ofManyEditsTheLastOneCounts) {
  document.open(scene(10), "a");
  for (int i = 1; i <= 50; ++i) document.setYoungsModulus("tissue", 10 + i);
  ASSERT_TRUE(until([this] { return shows(60) && !link.isCompiling(); }));
}

TEST_F(PlayLinkTest, anotherSceneStartsOverAndRests) {
  document.open(scene(10), "a");
  ASSERT_TRUE(until([this] { return shows(10); }));
  link.play();
  ASSERT_TRUE(until([this] { return link.snapshot().step > 5; }));
  document.open(scene(30), "b");
  ASSERT_TRUE(until([this] { return shows(30); }));
  EXPECT_EQ(link.snapshot().step, 0);
  EXPECT_FALSE(link.snapshot().playing);
}

TEST_F(PlayLinkTest, aHeldToolFollowsTheHandAndAReleasedOneTheRecording) {
  Scene with = scene(10);
  auto recording = std::make_shared<Recording>();
  recording->tracks.push_back({"finger", {{0, {Vec3(0, 0.05, 0), Quat::Identity()}}}});
  with.input = recording;
  document.open(with, "a");
  ASSERT_TRUE(until([this] { return shows(10); }));
  link.stepOnce();
  ASSERT_TRUE(until([this] { return link.snapshot().step == 1; }));
  EXPECT_EQ(link.snapshot().q[1], 0.05) << "nobody holds it";
  link.play();
  link.holdTool(0, {Vec3(0, 0.03, 0), Quat::Identity()});
  EXPECT_TRUE(link.isHeld(0));
  ASSERT_TRUE(until([this] { return link.snapshot().q[1] == 0.03; }));
  link.releaseTool(0);
  ASSERT_TRUE(until([this] { return link.snapshot().q[1] == 0.05; }));
}

TEST_F(PlayLinkTest, whatMustBeSaidComesOnceAndTheGravestFirst) {
  int changes = 0;
  QObject::connect(&link, &PlayLink::noticesChanged, [&] { ++changes; });
  document.open(scene(10), "a");
  ASSERT_TRUE(until([this] { return link.notices().size() == 1; }));
  EXPECT_EQ(changes, 1);
  link.stepOnce();
  ASSERT_TRUE(until([this] { return link.snapshot().step == 1; }));
  link.stepOnce();
  ASSERT_TRUE(until([this] { return link.snapshot().step == 2; }));
  ASSERT_EQ(link.notices().size(), 2u);
  EXPECT_EQ(link.notices()[0].kind, NoticeKind::TornAway);
  EXPECT_EQ(link.notices()[1].kind, NoticeKind::UnusedSetting);
  EXPECT_EQ(changes, 2);
  link.stepOnce();
  ASSERT_TRUE(until([this] { return link.snapshot().step == 3; }));
  EXPECT_EQ(changes, 2) << "nothing new";
  link.reset();
  ASSERT_TRUE(until([this] { return link.notices().size() == 1; }));
}

TEST_F(PlayLinkTest, canBeDestroyedWhileCompiling) {
  for (int i = 0; i < 20; ++i) {
    PlayLink another(document, fakeCompile, fakeSteps, fakeWatch);
    document.open(scene(10 + i), "a");
    another.play();
  }
}

}  // namespace
}  // namespace glenoid
