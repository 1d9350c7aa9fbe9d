// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QSpinBox>

#include "editor/ui/AuthorDocks.h"
#include "tests/editor/ui/GuiTest.h"
#include "tests/simcore/mesh/Shapes.h"

namespace glenoid {
namespace {

/// The plate with a ball of 3480 triangles above it in place of the block; the ball is rigid and collides as it looks.
class BodyPanelWindow : public GuiTest {
 protected:
  void SetUp() override {
    GuiTest::SetUp();
    if (HasFatalFailure()) return;
    Scene scene = blockScene();
    Part& ball = scene.joint.parts[1];
    TriMesh mesh = shapes::sphere(0.02, 60, 30);
    for (Vec3& v : mesh.vertices) v.y() += 0.03;
    ball.id = "ball";
    ball.kind = PartKind::Rigid;
    ball.visual = ball.collision = std::make_shared<TriMesh>(mesh);
    ball.volume = nullptr;
    ball.cellSize = 0;
    scene.joint.id = "with-ball";
    document.open(scene, {});
    ASSERT_TRUE(until([this] { return snapshot().model && snapshot().model->joint.id == "with-ball"; }));
    selection.select("ball");
    QTest::keyClick(window.get(), Qt::Key_M);
    ASSERT_TRUE(child<QDockWidget>("dock.bodies")->isVisible());
    settle();
  }
  const Part& ball() const { return document.joint().parts[1]; }
  void press(const char* button) {
    auto* found = child<QPushButton>(button);
    ASSERT_TRUE(until([&] { return found->isEnabled(); })) << button;
    auto* controls = child<QScrollArea>("bodies.controls");
    if (controls->isAncestorOf(found)) controls->ensureWidgetVisible(found);
    QTest::mouseClick(found, Qt::LeftButton);
  }
  QImage picture(const char* name) { return child<QLabel>(name)->pixmap().toImage(); }
  static bool sameBody(const Part& a, const Part& b) {
    return a.kind == b.kind && a.collision == b.collision && a.volume == b.volume && a.cellSize == b.cellSize &&
           a.materials == b.materials;
  }
};

TEST_F(BodyPanelWindow, simplifiesEmbedsAndComesBack) {
  const Part before = ball();
  ASSERT_TRUE(until([this] { return !picture("bodies.visual").isNull(); }));
  EXPECT_TRUE(picture("bodies.volume").isNull()) << "rigid";
  child<QSpinBox>("bodies.triangles")->setValue(300);
  child<QComboBox>("bodies.kind")->setCurrentIndex(1);
  child<QDoubleSpinBox>("bodies.cell")->setValue(7);
  ASSERT_TRUE(until([this] { return !picture("bodies.volume").isNull(); })) << "three meshes side by side";
  ASSERT_TRUE(until([this] { return child<QPushButton>("bodies.apply")->isEnabled(); }));
  EXPECT_TRUE(child<QLabel>("bodies.figures")->text().contains(QStringLiteral("at most"))) << "the deviation in mm";
  EXPECT_TRUE(sameBody(ball(), before)) << "nothing before Apply";
  press("bodies.apply");
  ASSERT_EQ(ball().kind, PartKind::Soft);
  const Part after = ball();
  EXPECT_NEAR(static_cast<double>(after.collision->triangles.size()), 300, 15);
  EXPECT_GT(after.volume->tets.size(), 100u);
  EXPECT_DOUBLE_EQ(after.cellSize, 7e-3);
  ASSERT_TRUE(until([&] { return snapshot().model->joint.parts[1].volume == after.volume; })) << "and it runs";
  EXPECT_EQ(document.undoStack().count(), 1);
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(sameBody(ball(), before));
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(sameBody(ball(), after));
  link.play();
  EXPECT_TRUE(until([this] { return snapshot().step > 20; }));
  EXPECT_EQ(snapshot().rejectedSteps, 0);
  link.pause();
}

TEST_F(BodyPanelWindow, theLatestOfManyWishesWins) {
  auto* slider = child<QSlider>("bodies.triangleSlider");
  child<QComboBox>("bodies.kind")->setCurrentIndex(1);
  for (int step = 100; step < 300; step += 5) {
    slider->setValue(step);
    QTest::qWait(2);
  }
  const int wanted = child<QSpinBox>("bodies.triangles")->value();
  press("bodies.apply");
  EXPECT_NEAR(static_cast<double>(ball().collision->triangles.size()), wanted, 0.06 * wanted);
}

TEST_F(BodyPanelWindow, paintedTrianglesAreFiner) {
  const auto upper = [this] {
    double count = 0;
    for (const auto& t : ball().collision->triangles) count += ball().collision->vertices[t[0]].z() > 0;
    return count / static_cast<double>(ball().collision->triangles.size());
  };
  child<QSpinBox>("bodies.triangles")->setValue(200);
  press("bodies.apply");
  EXPECT_NEAR(upper(), 0.5, 0.12);
  // The half that faces the viewer, with a broad brush.
  QTest::keyClick(window.get(), Qt::Key_B);
  const QPoint a = window->view()->toScreen(Vec3(-0.03, 0.06, 0))->toPoint(), b = window->view()->toScreen(Vec3(0.03, 0.0, 0))->toPoint();
  QTest::mousePress(window->view(), Qt::LeftButton, {}, a);
  QTest::mouseMove(window->view(), (a + b) / 2);
  QTest::mouseMove(window->view(), b);
  QTest::mouseRelease(window->view(), Qt::LeftButton, {}, b);
  ASSERT_GT(window->author().authoring().selected().size(), 500u);
  child<QSpinBox>("bodies.factor")->setValue(200);
  press("bodies.mark");
  press("bodies.apply");
  EXPECT_GT(upper(), 0.66);
}

TEST_F(BodyPanelWindow, aMaterialOfTheLibraryJoinsTheJoint) {
  auto* combo = child<QComboBox>("bodies.material");
  const int index = combo->findData(QStringLiteral("muscle-relaxed"));
  ASSERT_GE(index, 0);
  combo->setCurrentIndex(index);
  emit combo->activated(index);
  EXPECT_EQ(ball().materials[0].material, "muscle-relaxed");
  const int material = findMaterial(document.joint(), "muscle-relaxed");
  ASSERT_GE(material, 0);
  EXPECT_DOUBLE_EQ(document.joint().materials[material].youngsModulus, 25e3);
  EXPECT_FALSE(document.joint().materials[material].source.empty());
  press("bodies.ownMaterial");
  EXPECT_NE(ball().materials[0].material, "muscle-relaxed");
  EXPECT_EQ(document.joint().materials.size(), 4u);
  action("undo")->trigger();
  action("undo")->trigger();
  EXPECT_EQ(document.joint().materials.size(), 2u);
}

TEST_F(BodyPanelWindow, anOpenSurfaceIsASentence) {
  ChangeSet changes;
  changes.parts = {"ball"};
  document.edit(QStringLiteral("a hole"), changes, [](Scene& scene) {
    TriMesh open = *scene.joint.parts[1].visual;
    open.triangles.pop_back();
    scene.joint.parts[1].visual = std::make_shared<TriMesh>(open);
  });
  child<QSpinBox>("bodies.triangles")->setValue(200);
  auto* outcome = child<QLabel>("bodies.outcome");
  ASSERT_TRUE(until([&] { return outcome->isVisible(); }));
  EXPECT_FALSE(outcome->text().isEmpty());
  EXPECT_FALSE(child<QPushButton>("bodies.apply")->isEnabled());
  action("undo")->trigger();
  child<QSpinBox>("bodies.triangles")->setValue(220);
  EXPECT_TRUE(until([this] { return child<QPushButton>("bodies.apply")->isEnabled(); }));
  EXPECT_FALSE(outcome->isVisible());
}

}  // namespace
}  // namespace glenoid
