// SPDX-License-Identifier: GPL-3.0-or-later
// Stands in for a study: a shell that writes what a study would.
#include "editor/lab/StudyProcess.h"

#include <gtest/gtest.h>

#include <QFile>

#include "tests/editor/core/EventLoop.h"
#include "tests/editor/lab/LabFiles.h"

namespace glenoid::labtest {
namespace {

class StudyProcessTest : public EventLoopTest {
 protected:
  void SetUp() override {
    QObject::connect(&process, &StudyProcess::ended, &process, [this](StudyProcess::End how, const QString& words) {
      ended = true;
      end = how;
      sentence = words;
    });
  }
  void run(const QString& script) {
    process.start(QStringLiteral("/bin/sh"), {QStringLiteral("-c"), QStringLiteral("cd \"$0\" && ") + script, QString::fromStdString(files.path())}, QString::fromStdString(files.path()));
  }
  bool untilEnded() { return until([this] { return ended; }); }

  LabFolder files;
  StudyProcess process;
  bool ended = false;
  StudyProcess::End end = StudyProcess::End::Failed;
  QString sentence;
};

TEST_F(StudyProcessTest, isFollowedToItsEnd) {
  run(QStringLiteral(R"(echo '{"study":"accuracy"}' > progress.jsonl; echo '{"fraction":0.5,"what":"scene"}' >> progress.jsonl; sleep 0.6; echo '{"ended":"done"}' >> progress.jsonl)"));
  EXPECT_TRUE(process.isRunning());
  EXPECT_TRUE(until([this] { return process.study().fraction() == 0.5; }, 10000));
  ASSERT_TRUE(untilEnded());
  EXPECT_EQ(end, StudyProcess::End::Done);
  EXPECT_TRUE(sentence.isEmpty());
  EXPECT_DOUBLE_EQ(process.study().fraction(), 1);
}

TEST_F(StudyProcessTest, whatFailsSaysItsSentence) {
  run(QStringLiteral("echo 'The scene cannot be read.' >&2; exit 2"));
  ASSERT_TRUE(untilEnded());
  EXPECT_EQ(end, StudyProcess::End::Failed);
  EXPECT_EQ(sentence.toStdString(), "The scene cannot be read.");
}

TEST_F(StudyProcessTest, aProcessThatBreaksOffIsSaid) {
  run(QStringLiteral("kill -SEGV $$"));
  ASSERT_TRUE(untilEnded());
  EXPECT_EQ(end, StudyProcess::End::Failed);
  EXPECT_TRUE(sentence.contains(QStringLiteral("broke off"))) << sentence.toStdString();
}

TEST_F(StudyProcessTest, stopsWhenItIsToldTo) {
  run(QStringLiteral("echo $$ > pid; exec sleep 60"));
  ASSERT_TRUE(until([this] { return QFile::exists(QString::fromStdString(files.path()) + QStringLiteral("/pid")); }, 10000));
  process.cancel();
  ASSERT_TRUE(untilEnded());
  EXPECT_EQ(end, StudyProcess::End::Cancelled);
  EXPECT_FALSE(process.isRunning());
}

TEST_F(StudyProcessTest, aProgramThatIsNotThereIsSaid) {
  process.start(QStringLiteral("/no/such/program"), {}, QString::fromStdString(files.path()));
  ASSERT_TRUE(untilEnded());
  EXPECT_EQ(end, StudyProcess::End::Failed);
  EXPECT_TRUE(sentence.contains(QStringLiteral("/no/such/program"))) << sentence.toStdString();
}

}  // namespace
}  // namespace glenoid::labtest
