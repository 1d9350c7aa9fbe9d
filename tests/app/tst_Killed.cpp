// SPDX-License-Identifier: GPL-3.0-or-later
// A program that edits, makes safety copies and saves is killed at a random moment: nothing older than ten seconds may be
// lost, and the project that it saves must open. Five times; GLENOID_LONG=1: a hundred.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QElapsedTimer>
#include <QProcess>
#include <QTemporaryDir>
#include <QTimer>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "app/StudioScene.h"
#include "editor/core/Autosave.h"
#include "editor/core/PartEdits.h"
#include "simcore/scene/JointFile.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

constexpr const char* kChild = "--edit-until-killed";

Scene startScene() {
  Scene scene{scenes::figure4Joint(), scenes::figure4Scenario(), nullptr};
  scene.scenario.joint = "project.joint";
  scene.scenario.id = "project";
  return scene;
}

/// Edits every few milliseconds and says on stdout which edit is in memory since when; saves now and then. Some edits take
/// a part out and put it back, so that joint and scenario change together.
int editUntilKilled(int argc, char** argv) {
  QCoreApplication application(argc, argv);
  QCoreApplication::setApplicationName("glenoid-killed");
  const QString root = argv[2];
  const std::string project = argv[3];
  std::mt19937 random(static_cast<unsigned>(std::atoi(argv[4])));
  Document document;
  document.open(startScene(), QString::fromStdString(project));
  Autosave autosave(document, root);
  const Part last = document.joint().parts.back();
  int edit = 0;
  QTimer timer;
  QElapsedTimer pause;  // a person stops to look now and then
  QObject::connect(&timer, &QTimer::timeout, [&] {
    if (pause.isValid() && pause.elapsed() < 1300) return;
    pause.invalidate();
    if (random() % 40 == 0) pause.start();
    ++edit;
    const bool there = findPart(document.joint(), last.id) >= 0;
    if (random() % 10 == 0) {
      there ? removePart(document, last.id) : addPart(document, last);
    } else if (random() % 25 == 0 && there) {
      Scene after = document.scene();
      after.scenario.fixedParts = {document.joint().parts.front().id, last.id};
      ChangeSet changes;
      changes.model = true;
      document.edit("fix", changes, [&](Scene& scene) { scene = after; });
    }
    renamePart(document, document.joint().parts.front().id, QString::number(edit));
    std::printf("%d %lld\n", edit, static_cast<long long>(QDateTime::currentMSecsSinceEpoch()));
    std::fflush(stdout);
    if (random() % 150 == 0) {
      const auto saved = saveScene(document.scene(), project);
      if (!saved.ok()) {
        std::printf("failed %s\n", toLogLine(saved.error()).c_str());
        std::fflush(stdout);
      }
      document.saved(QString::fromStdString(project));
      std::printf("saved %d\n", edit);
      std::fflush(stdout);
    }
  });
  timer.start(15);
  return application.exec();
}

int editOf(const Joint& joint) { return std::atoi(joint.parts.front().name.c_str()); }

TEST(Killed, atARandomMomentNothingOlderThanTenSecondsIsLostAndNoProjectIsDamaged) {
  const int rounds = std::getenv("GLENOID_LONG") ? 100 : 5;
  std::mt19937 random(2026);
  qint64 worst = 0;
  int recovered = 0;
  for (int round = 0; round < rounds; ++round) {
    QTemporaryDir folder;
    const QString root = folder.filePath("autosave"), project = folder.filePath("project.scenario.json");
    ASSERT_TRUE(saveScene(startScene(), project.toStdString()).ok());
    QProcess child;
    child.start(QCoreApplication::applicationFilePath(), {kChild, root, project, QString::number(round)});
    ASSERT_TRUE(child.waitForStarted());
    ASSERT_TRUE(child.waitForReadyRead(20000));
    // Half of the rounds die within the first seconds, the others later, while many copies come and go.
    const int life = std::uniform_int_distribution<int>(50, round % 2 ? 7000 : 3000)(random);
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < life) child.waitForReadyRead(std::max<int>(1, life - static_cast<int>(clock.elapsed())));
    const qint64 killed = QDateTime::currentMSecsSinceEpoch();
    ::kill(static_cast<pid_t>(child.processId()), SIGKILL);
    ASSERT_TRUE(child.waitForFinished());
    EXPECT_EQ(child.exitStatus(), QProcess::CrashExit);

    std::vector<qint64> when{0};  // of each edit
    int savedEdit = 0;
    for (const QString& line : QString::fromUtf8(child.readAllStandardOutput()).split('\n', Qt::SkipEmptyParts)) {
      const QStringList words = line.split(' ');
      ASSERT_NE(words[0], "failed") << line.toStdString();
      if (words[0] == "saved") savedEdit = words[1].toInt();
      else if (words.size() == 2 && words[1].size() == 13) when.push_back(words[1].toLongLong());
    }
    const int edits = static_cast<int>(when.size()) - 1;
    ASSERT_GT(edits, 0);

    // The project opens, whole, and holds a state that was saved.
    const auto opened = loadScene(project.toStdString());
    ASSERT_TRUE(opened.ok()) << "round " << round << ": " << toLogLine(opened.error());
    const int onDisk = editOf(opened->joint);
    EXPECT_GE(onDisk, savedEdit);

    int best = onDisk;
    for (const AbandonedSession& session : abandonedSessions(root)) {
      EXPECT_FALSE(session.declined) << "a program that was killed declines nothing";
      const auto back = loadGeneration(session.generations[0].folder);
      ASSERT_TRUE(back.ok()) << "round " << round << ": " << toLogLine(back.error());
      best = std::max(best, editOf(back->joint));
      ++recovered;
    }
    // The first edit that is lost, if any, is younger than ten seconds.
    if (best < edits) {
      const qint64 lost = killed - when[best + 1];
      worst = std::max(worst, lost);
      EXPECT_LT(lost, 10000) << "round " << round << ": edit " << best + 1 << " of " << edits;
    }
  }
  EXPECT_GT(recovered, 0);
  std::printf("%d rounds, %d with safety copies, oldest edit lost: %.1f s\n", rounds, recovered, worst * 1e-3);
}

}  // namespace
}  // namespace glenoid

int main(int argc, char** argv) {
  if (argc == 5 && std::string(argv[1]) == glenoid::kChild) return glenoid::editUntilKilled(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  QCoreApplication application(argc, argv);
  QCoreApplication::setApplicationName("glenoid-killed");
  return RUN_ALL_TESTS();
}
