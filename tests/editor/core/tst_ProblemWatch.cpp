// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/ProblemWatch.h"

#include "editor/core/PartEdits.h"
#include "simcore/scene/JointFile.h"
#include "tests/editor/core/EventLoop.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

class ProblemWatchTest : public EventLoopTest {
 protected:
  Document document;
  JobSystem jobs{document};
  ProblemWatch watch{document, jobs};

  void openBroken() {
    Scene scene{scenes::blockOnPlateJoint(), scenes::blockOnPlateScenario(), nullptr};
    for (Part& part : scene.joint.parts)
      if (part.id == "plate") {
        TriMesh mesh = *part.visual;
        for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
        part.visual = std::make_shared<const TriMesh>(mesh);
      }
    document.open(std::move(scene), "a");
  }
  const Problem* found(ProblemKind kind) const {
    for (const Problem& problem : watch.problems())
      if (problem.kind == kind) return &problem;
    return nullptr;
  }
  bool looked() {
    return until([this] { return !watch.isChecking(); });
  }
};

TEST_F(ProblemWatchTest, looksAfterOpeningAndAfterEdits) {
  openBroken();
  EXPECT_TRUE(watch.isChecking());
  ASSERT_TRUE(looked());
  ASSERT_NE(found(ProblemKind::SurfaceInwards), nullptr);
  EXPECT_EQ(found(ProblemKind::CageUnusable), nullptr);
  // An edit that makes another problem, and undo, which takes it away.
  const TetMesh volume = *document.joint().parts[findPart(document.joint(), "block")].volume;
  TetMesh inverted = volume;
  std::swap(inverted.tets[0][0], inverted.tets[0][1]);
  ASSERT_TRUE(setPartVolume(document, "block", std::make_shared<const TetMesh>(inverted), 0.01));
  ASSERT_TRUE(looked());
  EXPECT_NE(found(ProblemKind::InvertedTetrahedra), nullptr);
  document.undoStack().undo();
  ASSERT_TRUE(looked());
  EXPECT_EQ(found(ProblemKind::InvertedTetrahedra), nullptr);
}

TEST_F(ProblemWatchTest, aBurstOfEditsIsOneLook) {
  openBroken();
  ASSERT_TRUE(looked());
  int looks = 0;
  QObject::connect(&watch, &ProblemWatch::changed, [&] { ++looks; });
  QElapsedTimer clock;
  clock.start();
  for (int i = 0; i < 200; ++i) document.setYoungsModulus("tissue", 1000 + i);
  EXPECT_LT(clock.elapsed(), 200) << "edits wait for no look";
  ASSERT_TRUE(looked());
  EXPECT_EQ(looks, 1);
}

TEST_F(ProblemWatchTest, aFixIsOneUndoStepAndUndoBringsTheProblemBack) {
  openBroken();
  ASSERT_TRUE(looked());
  const std::string before = jointHash(document.joint());
  watch.fix(*found(ProblemKind::SurfaceInwards));
  ASSERT_TRUE(until([this] { return document.undoStack().count() == 1; }));
  EXPECT_FALSE(document.undoStack().undoText().isEmpty());
  ASSERT_TRUE(looked());
  EXPECT_EQ(found(ProblemKind::SurfaceInwards), nullptr);
  document.undoStack().undo();
  EXPECT_EQ(jointHash(document.joint()), before);
  ASSERT_TRUE(looked());
  EXPECT_NE(found(ProblemKind::SurfaceInwards), nullptr);
}

TEST_F(ProblemWatchTest, canBeDestroyedWhileLooking) {
  for (int i = 0; i < 10; ++i) {
    ProblemWatch another(document, jobs);
    openBroken();
    until([&] { return false; }, 5 * i);
  }
}

}  // namespace
}  // namespace glenoid
