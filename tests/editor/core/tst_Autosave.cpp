// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/Autosave.h"

#include <QDir>
#include <QDirIterator>
#include <QTemporaryDir>

#include "editor/core/PartEdits.h"
#include "simcore/scene/JointFile.h"
#include "tests/editor/core/EventLoop.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

QDateTime at(int seconds) { return QDateTime(QDate(2026, 1, 1), QTime(12, 0), Qt::UTC).addSecs(-seconds); }

TEST(Generations, theNewestStayAndOlderOnesAMinuteApart) {
  std::vector<QDateTime> saved;
  for (int i = 0; i < 60; ++i) saved.push_back(at(5 * i));  // five minutes, newest first
  std::vector<int> kept;
  const std::vector<int> drop = generationsToDrop(saved);
  for (int i = 0; i < 60; ++i)
    if (std::find(drop.begin(), drop.end(), i) == drop.end()) kept.push_back(i);
  EXPECT_EQ(kept, (std::vector<int>{0, 1, 2, 3, 15, 27, 39, 51}));
  EXPECT_TRUE(generationsToDrop({at(0), at(1), at(2), at(3)}).empty());
}

class AutosaveTest : public EventLoopTest {
 protected:
  AutosaveTest() {
    Scenario scenario = scenes::blockOnPlateScenario();
    scenario.joint = "block.joint";
    scenario.name = "Block on a plate";
    auto input = std::make_shared<Recording>();
    input->scenario = "block.scenario.json";
    input->profile = "direct";
    input->tracks.push_back({"finger", {{0, {Vec3(0, 0.05, 0), Quat::Identity()}}}});
    document.open({scenes::blockOnPlateJoint(), scenario, input}, "/somewhere/block.scenario.json");
  }
  QString root() const { return folder.filePath("autosave"); }
  int files() const {
    int count = 0;
    for (QDirIterator it(root(), QDir::Files, QDirIterator::Subdirectories); it.hasNext(); it.next()) ++count;
    return count;
  }
  /// As another program would find them: the lock of this one's session is still held.
  std::vector<QString> generations(const QString& session) const {
    std::vector<QString> list;
    for (const QString& each : QDir(session).entryList({"g??????"}, QDir::Dirs, QDir::Name)) list.push_back(session + "/" + each);
    return list;
  }
  QString onlySession() const {
    const QStringList names = QDir(root()).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    EXPECT_EQ(names.size(), 1);
    return names.isEmpty() ? QString() : root() + "/" + names[0];
  }

  QTemporaryDir folder;
  Document document;
};

TEST_F(AutosaveTest, nothingIsWrittenBeforeTheFirstEditAndACopyAfterIt) {
  auto autosave = std::make_unique<Autosave>(document, root());
  until([] { return false; }, 1300);
  EXPECT_EQ(files(), 0);
  QElapsedTimer clock;
  clock.start();
  ASSERT_TRUE(renamePart(document, "block", "Brick"));
  EXPECT_FALSE(autosave->isSafe());
  ASSERT_TRUE(until([&] { return autosave->isSafe(); }, 5000));
  EXPECT_LT(clock.elapsed(), 3000);
  const auto list = generations(onlySession());
  ASSERT_EQ(list.size(), 1u);
  const auto back = loadGeneration(list[0]);
  ASSERT_TRUE(back.ok()) << toLogLine(back.error());
  EXPECT_EQ(jointHash(back->joint), jointHash(document.joint()));
  EXPECT_EQ(back->scenario.name, "Block on a plate");
  ASSERT_NE(back->input, nullptr);
  EXPECT_EQ(back->input->tracks.size(), 1u);
  EXPECT_TRUE(abandonedSessions(root()).empty()) << "its program runs";
}

TEST_F(AutosaveTest, whileEditsGoOnACopyIsMadeEveryFewSecondsAndMeshesOnce) {
  auto autosave = std::make_unique<Autosave>(document, root());
  QElapsedTimer clock;
  clock.start();
  int edits = 0;
  until([&] {
    document.setYoungsModulus("tissue", 1000 + ++edits);
    return clock.elapsed() > 9500;
  });
  const auto list = generations(onlySession());
  EXPECT_GE(list.size(), 2u) << "quiet never came; every four seconds one";
  EXPECT_LE(list.size(), 3u);
  int blobs = 0;
  for (QDirIterator it(onlySession() + "/blobs", {"*.ply", "*.vtk"}, QDir::Files); it.hasNext(); it.next()) ++blobs;
  EXPECT_EQ(blobs, 5) << "two visual, two collision surfaces, one volume";
}

TEST_F(AutosaveTest, savingClearsAndClosingUnsavedKeepsWithoutOffering) {
  auto autosave = std::make_unique<Autosave>(document, root());
  renamePart(document, "block", "Brick");
  ASSERT_TRUE(until([&] { return autosave->isSafe(); }, 5000));
  document.saved("/somewhere/block.scenario.json");
  ASSERT_TRUE(until([&] { return files() == 0; }, 5000));

  renamePart(document, "block", "Loaf");
  ASSERT_TRUE(until([&] { return autosave->isSafe(); }, 5000));
  autosave.reset();  // closed, and the person said: do not save
  auto sessions = abandonedSessions(root());
  ASSERT_EQ(sessions.size(), 1u);
  EXPECT_TRUE(sessions[0].declined);
  EXPECT_EQ(sessions[0].generations[0].origin, "/somewhere/block.scenario.json");
  EXPECT_EQ(sessions[0].generations[0].name, "Block on a plate");
  EXPECT_EQ(loadGeneration(sessions[0].generations[0].folder)->joint.parts[findPart(document.joint(), "block")].name, "Loaf");
  removeSession(sessions[0].folder);
  EXPECT_TRUE(abandonedSessions(root()).empty());
}

TEST_F(AutosaveTest, closingASavedSceneLeavesNothing) {
  auto autosave = std::make_unique<Autosave>(document, root());
  renamePart(document, "block", "Brick");
  document.saved("a");
  autosave.reset();
  EXPECT_EQ(files(), 0);
}

TEST_F(AutosaveTest, anotherSceneBeginsAnotherSession) {
  auto autosave = std::make_unique<Autosave>(document, root());
  renamePart(document, "block", "Brick");
  ASSERT_TRUE(until([&] { return autosave->isSafe(); }, 5000));
  Scene other = document.scene();
  document.open(other, "b");
  renamePart(document, "block", "Loaf");
  ASSERT_TRUE(until([&] { return autosave->isSafe(); }, 5000));
  EXPECT_EQ(QDir(root()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), 2);
}

TEST_F(AutosaveTest, aSceneThatWasRecoveredIsKeptWithoutWaitingForAnEdit) {
  auto autosave = std::make_unique<Autosave>(document, root());
  document.openUnsaved(Scene(document.scene()), "/somewhere/block.scenario.json");
  EXPECT_FALSE(document.undoStack().isClean());
  ASSERT_TRUE(until([&] { return autosave->isSafe(); }, 5000));
  EXPECT_EQ(generations(onlySession()).size(), 1u);
}

TEST_F(AutosaveTest, whatIsNotReadyToBeSavedIsKeptToo) {
  auto autosave = std::make_unique<Autosave>(document, root());
  Joint broken = document.joint();
  broken.parts[0].materials.clear();
  ChangeSet changes;
  changes.model = true;
  document.edit("break", changes, [&](Scene& scene) { scene.joint = broken; });
  ASSERT_FALSE(checkJoint(document.joint(), {}).ok());
  ASSERT_TRUE(until([&] { return autosave->isSafe(); }, 5000));
  const auto back = loadGeneration(generations(onlySession()).at(0));
  ASSERT_TRUE(back.ok()) << toLogLine(back.error());
  EXPECT_TRUE(back->joint.parts[0].materials.empty());
}

TEST_F(AutosaveTest, aFolderThatCannotBeWrittenIsSaidOnceAndTriedAgain) {
  QFile blocker(root());
  ASSERT_TRUE(blocker.open(QIODevice::WriteOnly));  // a file where the folder should be
  blocker.close();
  Autosave autosave(document, root());
  int told = 0;
  QObject::connect(&autosave, &Autosave::failed, [&](const Error& error) {
    ++told;
    EXPECT_EQ(error.fault, Fault::FileUnwritable);
  });
  renamePart(document, "block", "Brick");
  ASSERT_TRUE(until([&] { return told == 1; }, 5000));
  renamePart(document, "block", "Loaf");
  until([] { return false; }, 1500);
  EXPECT_EQ(told, 1);
  blocker.remove();
  renamePart(document, "block", "Log");
  ASSERT_TRUE(until([&] { return autosave.isSafe(); }, 5000));
  EXPECT_EQ(generations(onlySession()).size(), 1u);
}

}  // namespace
}  // namespace glenoid
