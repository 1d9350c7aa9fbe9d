// SPDX-License-Identifier: GPL-3.0-or-later
// Through the arthroscope in the window: in the corner, large, off; a tool is dragged in the picture that is large.
#include <algorithm>

#include "tests/editor/ui/GuiTest.h"

namespace glenoid {
namespace {

class ScopeWindow : public GuiTest {
 protected:
  Result<Scene> load(const std::string& path) override {
    Scene scene = blockScene();
    if (path == "none") return scene;
    // Over the block, looking down and forward at it; the finger is in sight.
    Tool scope;
    scope.id = scope.name = "scope";
    scope.kind = ToolKind::Arthroscope;
    scope.radius = 0.002;
    scope.lens = 0.5;
    scope.home.p_WB = Vec3(-0.03, 0.12, 0);
    scope.home.q_WB = Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitY());
    scene.scenario.tools.push_back(scope);
    return scene;
  }
  static int black(const QImage& image, int x, int y) { return qGray(image.pixel(x, y)) < 6; }
};

TEST_F(ScopeWindow, aKeyShowsItInTheCornerAnotherMakesItLarge) {
  const QImage outside = grabView();
  const int w = outside.width(), h = outside.height(), side = static_cast<int>(0.34 * std::min(w, h));
  action("scope")->trigger();
  settle();
  EXPECT_TRUE(action("scope")->isChecked());
  const QImage corner = grabView();
  EXPECT_TRUE(black(corner, w - 12, h - 12)) << "a round field leaves the corners of its square dark";
  EXPECT_FALSE(black(corner, w - 10 - side / 2, h - 10 - side / 2)) << "tissue before the lens is lit";
  EXPECT_EQ(outside.pixel(w / 4, h / 4), corner.pixel(w / 4, h / 4)) << "the outside stays as it was";

  action("scope.swap")->trigger();
  settle();
  const QImage large = grabView();
  EXPECT_TRUE(black(large, 3, 3));
  EXPECT_TRUE(black(large, 3, h - 4));
  EXPECT_FALSE(black(large, w / 2, h / 2));
  EXPECT_FALSE(black(large, w - 10 - side / 2, h - 10 - side / 2)) << "the outside is in the corner";

  action("scope.swap")->trigger();
  settle();
  EXPECT_LT(difference(corner, grabView()), 1e-3);
  action("scope")->trigger();
  settle();
  EXPECT_LT(difference(outside, grabView()), 1e-3);
  EXPECT_FALSE(action("scope")->isChecked());
  EXPECT_TRUE(document.undoStack().isClean()) << "looking is no edit";
}

TEST_F(ScopeWindow, aToolFollowsTheMouseInTheLargePicture) {
  action("scope.swap")->trigger();
  window->view()->setChosenTool(0);
  settle();
  const Vec3 before = snapshot().hands[0].p_WB;
  const QPoint middle = window->view()->rect().center();
  QTest::mousePress(window->view(), Qt::LeftButton, Qt::NoModifier, middle);
  for (int i = 1; i <= 10; ++i) {
    QTest::mouseMove(window->view(), middle + QPoint(6 * i, 0));
    QTest::qWait(20);
  }
  const View through = scopeSight(*snapshot().model, snapshot().q, *findScope(*snapshot().model), window->view()->width(), window->view()->height()).view;
  link.play();
  EXPECT_TRUE(until([&] { return (snapshot().hands[0].p_WB - before).dot(axesOf(through).right_W) > 0.002; })) << "to the right in the scope's picture";
  QTest::mouseRelease(window->view(), Qt::LeftButton, Qt::NoModifier, middle + QPoint(60, 0));
  link.pause();
}

TEST_F(ScopeWindow, aSceneWithoutOneIsShownFromOutside) {
  window->openScene(QStringLiteral("none"));
  ASSERT_TRUE(until([this] { return snapshot().model && snapshot().model->scenario.tools.size() == 1; }));
  settle();
  const QImage outside = grabView();
  action("scope.swap")->trigger();
  settle();
  EXPECT_LT(difference(outside, grabView()), 1e-3);
}

}  // namespace
}  // namespace glenoid
