// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/JobSystem.h"

#include <atomic>

#include "editor/core/PartEdits.h"
#include "editor/core/SameScene.h"
#include "simcore/scene/JointFile.h"
#include "tests/editor/core/EventLoop.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

class JobSystemTest : public EventLoopTest {
 protected:
  JobSystemTest() {
    document.open({scenes::blockOnPlateJoint(), scenes::blockOnPlateScenario(), nullptr}, "a");
    QObject::connect(&jobs, &JobSystem::ended, [this](int, JobSystem::End end, const QString& sentence) {
      ends.push_back(end);
      sentences.push_back(sentence);
    });
  }
  /// Renames the plate once `go` says so.
  std::function<Result<Joint>(JobContext&)> renaming() {
    return [this, joint = document.joint()](JobContext& context) -> Result<Joint> {
      while (!go && context.goesOn()) QThread::msleep(1);
      Joint named = joint;
      named.parts[findPart(named, "plate")].name = "Table";
      return named;
    };
  }
  std::string plateName() const { return document.joint().parts[findPart(document.joint(), "plate")].name; }

  Document document;
  std::atomic<bool> go{false};
  std::vector<JobSystem::End> ends;
  QStringList sentences;
  JobSystem jobs{document};
};

TEST_F(JobSystemTest, aResultIsOneUndoStep) {
  const std::string before = jointHash(document.joint());
  jobs.startJoint("Name the plate", renaming());
  EXPECT_TRUE(jobs.busy());
  EXPECT_EQ(document.undoStack().count(), 0);
  go = true;
  ASSERT_TRUE(until([this] { return !ends.empty(); }));
  EXPECT_EQ(ends[0], JobSystem::End::Applied);
  EXPECT_EQ(plateName(), "Table");
  EXPECT_EQ(document.undoStack().count(), 1);
  EXPECT_EQ(document.undoStack().undoText(), "Name the plate");
  document.undoStack().undo();
  EXPECT_EQ(jointHash(document.joint()), before);
  EXPECT_FALSE(jobs.busy());
}

TEST_F(JobSystemTest, phaseProgressAndRemainingTimeAreTold) {
  jobs.startJoint("Count", [joint = document.joint()](JobContext& context) -> Result<Joint> {
    context.phase("halves");
    for (int i = 0; i < 150 && context.progress(i / 300.0); ++i) QThread::msleep(10);
    while (context.goesOn()) QThread::msleep(1);
    return Error{Fault::Cancelled, {}, {}, {}};
  });
  ASSERT_TRUE(until([this] { return jobs.jobs()[0].done > 0.48; }));
  const JobSystem::Info info = jobs.jobs()[0];
  EXPECT_EQ(info.phase, "halves");
  EXPECT_EQ(info.title, "Count");
  // Half of the work took 1.5 s or more, so about as long is left.
  EXPECT_GT(info.remaining, 1.0);
  EXPECT_LT(info.remaining, 60.0);
  jobs.cancelAll();
}

TEST_F(JobSystemTest, cancelTakesEffectWithinAFifthOfASecondAndLeavesNothing) {
  const std::string before = jointHash(document.joint());
  // One that listens, and one that is deaf for a second, as a library may be.
  std::atomic<bool> deafEnded{false};
  for (const bool listens : {true, false}) {
    ends.clear();
    const int id = jobs.startJoint("Long", [&, listens, joint = document.joint()](JobContext& context) -> Result<Joint> {
      for (int i = 0; i < 1000 && (!listens || context.goesOn()); ++i) QThread::msleep(1);
      Joint changed = joint;
      changed.name = "changed";
      if (!listens) deafEnded = true;
      return changed;
    });
    until([] { return false; }, 100);
    QElapsedTimer clock;
    clock.start();
    jobs.cancel(id);
    ASSERT_TRUE(until([this] { return !ends.empty(); }));
    EXPECT_LT(clock.elapsed(), 200) << (listens ? "listens" : "deaf");
    EXPECT_EQ(ends[0], JobSystem::End::Cancelled);
    EXPECT_FALSE(jobs.busy());
  }
  ASSERT_TRUE(until([&] { return deafEnded.load(); }));
  until([] { return false; }, 50);
  EXPECT_EQ(ends.size(), 1u) << "what comes late is not heard";
  EXPECT_EQ(jointHash(document.joint()), before);
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(JobSystemTest, aChangeOfWhatItWorksOnDropsTheResultWithASentence) {
  jobs.startJoint("Name the plate", renaming());
  ASSERT_TRUE(renamePart(document, "block", "Brick"));
  go = true;
  ASSERT_TRUE(until([this] { return !ends.empty(); }));
  EXPECT_EQ(ends[0], JobSystem::End::Dropped);
  EXPECT_TRUE(sentences[0].contains("Name the plate")) << sentences[0].toStdString();
  EXPECT_EQ(document.undoStack().count(), 1) << "only the person's own";
}

TEST_F(JobSystemTest, aChangeThatWasUndoneOrDoesNotMatterKeepsIt) {
  jobs.startJoint("Name the plate", renaming());
  ASSERT_TRUE(renamePart(document, "block", "Brick"));
  document.undoStack().undo();
  document.setProfile(Profile::Paper);  // of the scenario
  go = true;
  ASSERT_TRUE(until([this] { return !ends.empty(); }));
  EXPECT_EQ(ends[0], JobSystem::End::Applied);
  EXPECT_EQ(plateName(), "Table");

  ends.clear();
  go = false;
  jobs.start<int>("Look at the plate", [this](JobContext&) -> Result<int> {
    while (!go) QThread::msleep(1);
    return 4;
  }, [this](int legs) { renamePart(document, "plate", QStringLiteral("Table of %1").arg(legs)); },
      JobSystem::partsAreTheSame({"plate"}));
  ASSERT_TRUE(renamePart(document, "block", "Brick"));
  go = true;
  ASSERT_TRUE(until([this] { return !ends.empty(); }));
  EXPECT_EQ(ends[0], JobSystem::End::Applied);
  EXPECT_EQ(plateName(), "Table of 4");
}

TEST_F(JobSystemTest, failuresAndExceptionsBecomeSentences) {
  jobs.startJoint("Fail", [](JobContext&) -> Result<Joint> { return Error{Fault::MeshNotClosed, {{}, {}, "plate", {}}, {"3"}, {}}; });
  ASSERT_TRUE(until([this] { return ends.size() == 1; }));
  EXPECT_EQ(ends[0], JobSystem::End::Failed);
  EXPECT_TRUE(sentences[0].contains("plate")) << sentences[0].toStdString();
  jobs.startJoint("Throw", [](JobContext&) -> Result<Joint> { throw std::bad_alloc(); });
  ASSERT_TRUE(until([this] { return ends.size() == 2; }));
  EXPECT_EQ(ends[1], JobSystem::End::Failed);
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(JobSystemTest, aResultThatChangesNothingIsNoStep) {
  jobs.startJoint("Nothing", [joint = document.joint()](JobContext&) -> Result<Joint> { return joint; });
  ASSERT_TRUE(until([this] { return !ends.empty(); }));
  EXPECT_EQ(ends[0], JobSystem::End::Applied);
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(JobSystemTest, canBeDestroyedWhileJobsRun) {
  for (int i = 0; i < 10; ++i) {
    JobSystem another(document);
    another.startJoint("Name the plate", renaming());
    another.startJoint("Name it again", renaming());
  }
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST(SameScene, namesWhatChanged) {
  const Joint before = scenes::figure4Joint();
  Joint after = before;
  EXPECT_FALSE(changesBetween(before, after).model);
  after.parts[1].name = "other";
  after.materials[0].friction += 1;
  after.couplings[0].damping += 1;
  const ChangeSet changes = changesBetween(before, after);
  EXPECT_TRUE(changes.model);
  EXPECT_EQ(changes.parts, std::set<std::string>{before.parts[1].id});
  EXPECT_EQ(changes.materials, std::set<std::string>{before.materials[0].id});
  EXPECT_EQ(changes.couplings, std::set<std::string>{before.couplings[0].id});
  after = before;
  after.parts.erase(after.parts.begin());
  EXPECT_EQ(changesBetween(before, after).parts, std::set<std::string>{before.parts[0].id});
  EXPECT_EQ(changesBetween(after, before).parts, std::set<std::string>{before.parts[0].id});
}

}  // namespace
}  // namespace glenoid
