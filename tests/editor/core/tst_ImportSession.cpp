// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/ImportSession.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTest>
#include <cstdlib>

#include "editor/core/ImportWords.h"
#include "simcore/file/Ply.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/step/Stepper.h"
#include "tests/scenes/BlockScenes.h"
#include "tests/simcore/file/TemporaryFolder.h"
#include "tests/simcore/mesh/Shapes.h"

namespace glenoid {
namespace {

class ImportSessionTest : public ::testing::Test {
 protected:
  void SetUp() override {
    static int argc = 1;
    static char name[] = "tst_ImportSession";
    static char* argv[] = {name, nullptr};
    m_application = std::make_unique<QCoreApplication>(argc, argv);  // the event loop of the answers
  }
  void TearDown() override { ::unsetenv("GLENOID_IMPORT_TEST"); }
  QString put(const std::string& name, const TriMesh& mesh) {
    EXPECT_TRUE(writePly(m_folder.path(name), mesh).ok());
    return QString::fromStdString(m_folder.path(name));
  }
  static bool settled(const ImportSession& session) {
    return QTest::qWaitFor([&] { return !session.busy(); }, 20000);
  }
  /// A ball of 48 mm, inside out, one triangle missing.
  static TriMesh wrongBall() {
    TriMesh ball = shapes::sphere(24);
    for (auto& t : ball.triangles) std::swap(t[0], t[1]);
    ball.triangles.pop_back();
    return ball;
  }
  std::unique_ptr<QCoreApplication> m_application;
  TemporaryFolder m_folder;
};

TEST_F(ImportSessionTest, filesBecomeRowsWithTheirRepairs) {
  ImportSession session;
  session.add({put("humerus.ply", wrongBall()), QString::fromStdString(m_folder.put("broken.stl", "solid no")), put("two.ply", shapes::sphere(30))});
  EXPECT_EQ(session.rows().size(), 3u);
  EXPECT_TRUE(session.busy());
  ASSERT_TRUE(settled(session));
  ASSERT_EQ(session.rows().size(), 3u);
  const ImportSession::Row& row = session.rows()[0];
  EXPECT_EQ(row.state, ImportSession::State::Ready) << row.problem.toStdString();
  EXPECT_EQ(row.name, QStringLiteral("humerus"));
  EXPECT_TRUE(row.wanted);
  EXPECT_EQ(row.repairs, (std::set<FindingKind>{FindingKind::InsideOut, FindingKind::Holes}));
  EXPECT_FALSE(row.found.healthy());
  EXPECT_TRUE(row.after.healthy());
  EXPECT_EQ(row.changes.size(), repairsFor(row.found, row.repairs).size());
  EXPECT_EQ(session.rows()[1].state, ImportSession::State::Failed);
  EXPECT_FALSE(session.rows()[1].wanted);
  EXPECT_TRUE(session.rows()[1].problem.contains(QStringLiteral("broken.stl")));
  EXPECT_EQ(session.ready(), 2);
}

TEST_F(ImportSessionTest, decisionsMakeTheResultAnew) {
  ImportSession session;
  session.add({put("a.ply", wrongBall())});
  ASSERT_TRUE(settled(session));
  const auto sizeOf = [&] { return boundsOf(*session.rows()[0].result).sizes().maxCoeff(); };
  session.setUnit(0, 1e-3);
  ASSERT_TRUE(settled(session));
  EXPECT_NEAR(sizeOf(), 0.048, 1e-9);
  session.setUnit(0, 1e-2);
  EXPECT_EQ(session.rows()[0].state, ImportSession::State::Working);
  EXPECT_EQ(session.ready(), 0);
  session.setUnit(0, 0.0254);  // the earlier answer is out of date and must not come through
  ASSERT_TRUE(settled(session));
  EXPECT_NEAR(sizeOf(), 48 * 0.0254, 1e-9);
  session.setRepair(0, FindingKind::Holes, false);
  ASSERT_TRUE(settled(session));
  EXPECT_FALSE(session.rows()[0].after.healthy());
  EXPECT_EQ(healthOf(*session.rows()[0].result).openEdges, 3);
  session.setAxes(0, *axisMapFrom({"-y", "z", "-x"}));
  ASSERT_TRUE(settled(session));
  EXPECT_EQ(healthOf(*session.rows()[0].result).misorientedEdges, 0);
}

TEST_F(ImportSessionTest, partsArriveAsOneUndoStep) {
  Document document;
  document.open({scenes::blockOnPlateJoint(), scenes::blockOnPlateScenario(), nullptr}, QStringLiteral("block"));
  const Scene before = document.scene();
  ImportSession session;
  session.add({put("block.ply", shapes::sphere(24)), put("Häupt 1.ply", shapes::sphere(20))});
  ASSERT_TRUE(settled(session));
  for (int row : {0, 1}) session.setUnit(row, 1e-3);
  ASSERT_TRUE(settled(session));
  session.setShift({0.5, 0, 0});
  const auto ids = session.apply(document);
  ASSERT_EQ(ids, (std::vector<std::string>{"block-2", "haupt-1"}));  // "block" was taken
  EXPECT_EQ(document.undoStack().count(), 1);
  const Joint& joint = document.joint();
  ASSERT_EQ(joint.parts.size(), before.joint.parts.size() + 2);
  const Part& part = joint.parts.back();
  EXPECT_EQ(part.kind, PartKind::Rigid);
  EXPECT_EQ(part.visual, part.collision);
  EXPECT_NEAR(boundsOf(*part.visual).center().x(), 0.5, 1e-9);
  EXPECT_EQ(part.number, joint.parts[joint.parts.size() - 2].number + 1);
  EXPECT_GE(findMaterial(joint, part.materials[0].material), 0);
  EXPECT_TRUE(compileModel(joint, document.scenario()).ok());
  document.undoStack().undo();
  EXPECT_EQ(document.joint().parts.size(), before.joint.parts.size());
  EXPECT_EQ(document.joint().materials, before.joint.materials);
  EXPECT_EQ(document.scenario().fixedParts, before.scenario.fixedParts);
  document.undoStack().redo();
  EXPECT_EQ(document.joint().parts.back().visual, part.visual);
}

TEST_F(ImportSessionTest, anEmptyDocumentGetsAJoint) {
  Document document;
  ImportSession session;
  session.add({put("a.ply", shapes::sphere(24))});
  ASSERT_TRUE(settled(session));
  session.setUnit(0, 1e-3);
  ASSERT_TRUE(settled(session));
  ASSERT_EQ(session.apply(document).size(), 1u);
  EXPECT_FALSE(document.joint().id.empty());
  EXPECT_TRUE(compileModel(document.joint(), document.scenario()).ok());
}

TEST_F(ImportSessionTest, cancelAndLeavingAreAtOnce) {
  ::setenv("GLENOID_IMPORT_TEST", "hang", 1);
  const QString file = put("a.ply", shapes::sphere(24));
  QElapsedTimer clock;
  {
    ImportSession session;
    session.add({file});
    QTest::qWait(100);
    clock.start();
    session.cancel();
    EXPECT_FALSE(session.busy());
    EXPECT_EQ(session.rows()[0].state, ImportSession::State::Failed);
    EXPECT_LT(clock.elapsed(), 200);
    ::unsetenv("GLENOID_IMPORT_TEST");
    session.add({file});  // and it can go on
    ASSERT_TRUE(settled(session));
    EXPECT_EQ(session.rows()[1].state, ImportSession::State::Ready);
    ::setenv("GLENOID_IMPORT_TEST", "hang", 1);
    session.add({file});
    QTest::qWait(50);
    clock.restart();
  }
  EXPECT_LT(clock.elapsed(), 200);  // the session is gone, its reader too
}

TEST(ImportWords, everyFindingAndNoteHasASentence) {
  for (int kind = 0; kind < kFindingKindCount; ++kind) {
    const Finding finding{static_cast<FindingKind>(kind), FindingSeverity::Warning, 2, 0.01, {}, {{RepairKind::FillHoles}}, false};
    EXPECT_TRUE(findingSentence(finding, 1).endsWith(QLatin1Char('.'))) << kind;
    EXPECT_FALSE(findingSentence(finding, 1).contains(QLatin1Char('%'))) << kind;
  }
  for (int note = 0; note < kImportNoteCount; ++note) EXPECT_TRUE(noteSentence({static_cast<ImportNote>(note), 3}).endsWith(QLatin1Char('.'))) << note;
}

}  // namespace
}  // namespace glenoid
