// SPDX-License-Identifier: GPL-3.0-or-later
// A joint from a template, in the window.
#include <QDir>
#include <QMenu>
#include <QTemporaryDir>

#include "app/StudioScene.h"
#include "simcore/starter/Starter.h"
#include "tests/editor/ui/GuiTest.h"

namespace glenoid {
namespace {

class NewJointTest : public GuiTest {
 protected:
  void SetUp() override {
    GuiTest::SetUp();
    if (HasFatalFailure()) return;
    window = std::make_unique<MainWindow>(MainWindow::Parts{document, link, display, selection}, probeGraphics(), loadScene, saveScene, startScene);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
  }
};

TEST_F(NewJointTest, isMadeBuiltAndOpened) {
  QTemporaryDir folder;
  const QString mine = folder.filePath(QStringLiteral("my-knee"));
  window->startJointIn(mine, "knee");
  ASSERT_TRUE(until([this] { return document.joint().id == "knee"; }, 120000)) << child<QLabel>("problem")->text().toStdString();
  EXPECT_EQ(document.joint().parts.size(), 4u);
  EXPECT_TRUE(child<QLabel>("problem")->text().isEmpty());
  for (const char* file : {"recipe.json", "README.md", "knee.scenario.json", "knee.joint/joint.json", "meshes/femur.stl"})
    EXPECT_TRUE(QFile::exists(mine + u'/' + QLatin1String(file))) << file;
  ASSERT_TRUE(until([this] { return link.snapshot().model != nullptr; }));
  link.play();
  EXPECT_TRUE(until([this] { return snapshot().step > 20; }));
  link.pause();

  // What lies there is not written over, and the scene stays.
  window->startJointIn(mine, "elbow");
  ASSERT_TRUE(until([this] { return !child<QLabel>("problem")->text().isEmpty(); }));
  EXPECT_EQ(document.joint().id, "knee");
  EXPECT_FALSE(QFile::exists(mine + QStringLiteral("/elbow.scenario.json")));
}

TEST_F(NewJointTest, eachTemplateIsInTheMenuByItsName) {
  for (const StarterKind& kind : starterKinds()) {
    QAction* const entry = action((std::string("starter.") + kind.name).c_str());
    ASSERT_NE(entry, nullptr) << kind.name;
    EXPECT_NE(entry->text(), QLatin1String(kind.name)) << "a name for people";
    EXPECT_FALSE(entry->associatedObjects().isEmpty()) << kind.name;
  }
}

}  // namespace
}  // namespace glenoid
