// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QTest>
#include <memory>

#include "editor/core/PlayLink.h"
#include "editor/ui/Language.h"
#include "editor/ui/MainWindow.h"
#include "editor/ui/SceneView.h"
#include "editor/ui/Theme.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {

/// A block on a plate with a finger above, close enough to be pushed by a short drag.
inline Scene blockScene() {
  Scene scene{scenes::blockOnPlateJoint(), scenes::blockOnPlateScenario(), nullptr};
  scene.scenario.name = "Block on a plate";
  Camera camera;
  camera.id = camera.name = "front";
  camera.eye_W = Vec3(0.05, 0.08, 0.30);
  camera.target_W = Vec3(0, 0.03, 0);
  scene.scenario.cameras = {camera};
  return scene;
}

/// The whole window over the scene above, on a real (virtual) screen, with real steps.
class GuiTest : public testing::Test {
 protected:
  void SetUp() override {
    applyTheme(*qApp, loadTheme(true));
    setLanguage(QStringLiteral("en"));
    window = std::make_unique<MainWindow>(
        MainWindow::Parts{document, link, display, selection}, probeGraphics(),
        [this](const std::string& path) { return load(path); },
        [this](const Scene& scene, const std::string& path) { return save(scene, path); }, SceneStarter(), labServices());
    window->resize(1280, 800);
    window->show();
    window->activateWindow();  // with no window manager nothing else gives it the focus
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    ASSERT_NE(window->view(), nullptr) << "no OpenGL on this display";
    QObject::connect(window->view(), &SceneView::drawn, window.get(), [this] { ++frames; });
    window->openScene(QStringLiteral("block"));
    ASSERT_TRUE(until([this] { return link.snapshot().model != nullptr; }));
    settle();
  }
  void TearDown() override { setLanguage(QStringLiteral("en")); }

  /// Where scenes come from and go to. Loading runs on a worker.
  virtual Result<Scene> load(const std::string& path) {
    if (path == "missing") return Error{Fault::FileMissing, {path, {}, {}, {}}, {}, {}};
    return blockScene();
  }
  virtual Result<Done> save(const Scene&, const std::string&) { return Done{}; }

  /// What the lab asks of the application; nothing: studies cannot be run.
  virtual LabServices labServices() { return {}; }

  template <class Condition>
  bool until(Condition holds, int milliseconds = 20000) {
    return QTest::qWaitFor(holds, milliseconds);
  }
  /// Long enough for what was published to be drawn, and drawn finely.
  void settle() {
    do {
      framesSeen = frames;
      QTest::qWait(500);
    } while (frames != framesSeen);
  }
  template <class T>
  T* child(const char* name) {
    T* found = window->findChild<T*>(QString::fromLatin1(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  QAction* action(const char* id) { return window->actions()[QString::fromLatin1(id)]; }
  const Snapshot& snapshot() const { return link.snapshot(); }
  QImage grabView() { return window->view()->grabFramebuffer().convertToFormat(QImage::Format_RGB32); }

  /// Share of the pixels that differ visibly.
  static double difference(const QImage& a, const QImage& b) {
    if (a.size() != b.size()) return 1;
    long different = 0;
    for (int y = 0; y < a.height(); ++y) {
      for (int x = 0; x < a.width(); ++x) {
        const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
        different += std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q)) > 24;
      }
    }
    return static_cast<double>(different) / (static_cast<double>(a.width()) * a.height());
  }

  Document document;
  Selection selection;
  DisplayState display;
  PlayLink link{document};
  std::unique_ptr<MainWindow> window;
  int frames = 0, framesSeen = 0;
};

}  // namespace glenoid
