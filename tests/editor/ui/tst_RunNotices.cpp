// SPDX-License-Identifier: GPL-3.0-or-later
// What must be said about a run stands in the window, in the sentences of the command line.
#include <QListWidget>
#include <QPushButton>
#include <QToolButton>

#include "editor/core/NoticeSentences.h"
#include "simcore/live/Run.h"
#include "tests/editor/ui/GuiTest.h"

namespace glenoid {
namespace {

class RunNotices : public GuiTest {
 protected:
  Result<Scene> load(const std::string& path) override {
    if (path != "cubes") return blockScene();
    Scene scene{scenes::sunkenCubesJoint(), scenes::sunkenCubesScenario(), nullptr};
    scene.joint.parts[findPart(scene.joint, "deep")].name = "Deepest cube";
    scene.scenario.seed = 7;
    scene.scenario.effects.bursa = Wish::On;
    return scene;
  }
  bool opened() {
    window->openScene(QStringLiteral("cubes"));
    return until([this] { return snapshot().model && findPart(snapshot().model->joint, "slab") >= 0; });
  }
  std::vector<QString> rows() {
    std::vector<QString> texts;
    auto* list = child<QListWidget>("problemList");
    for (int row = 0; row < list->count(); ++row) texts.push_back(list->item(row)->text());
    return texts;
  }
  long rowsWith(const QString& words) {
    const auto all = rows();
    return std::count_if(all.begin(), all.end(), [&](const QString& row) { return row.contains(words); });
  }
};

TEST_F(RunNotices, aCalmRunSaysNothing) {
  EXPECT_TRUE(until([this] { return link.snapshot().notices != nullptr; }));
  EXPECT_FALSE(child<QLabel>("notice")->isVisible());
}

TEST_F(RunNotices, theWindowSaysWhatTheCommandLineSays) {
  ASSERT_TRUE(opened());
  auto* words = child<QLabel>("notice");
  ASSERT_TRUE(until([&] { return words->isVisible(); })) << "a setting that does nothing is said before any step";
  EXPECT_FALSE(words->text().contains(QStringLiteral("deep")));
  link.stepOnce();
  ASSERT_TRUE(until([this] { return link.notices().size() == 4; }));
  // The same scene without a window; names are people's here, ids there.
  RunOptions options;
  options.steps = 1;
  const auto said = runScenario(compileModel(document.joint(), document.scenario()).value(), options)->report.notices;
  ASSERT_EQ(said.size(), 4u);
  for (const Notice& notice : said) {
    const auto same = std::find_if(link.notices().begin(), link.notices().end(),
                                   [&](const Notice& n) { return sentenceOf(n) == sentenceOf(notice); });
    EXPECT_NE(same, link.notices().end()) << sentenceOf(notice).toStdString();
  }
  link.play();
  ASSERT_TRUE(until([this] { return snapshot().time > 0.2; }));
  link.pause();
  ASSERT_TRUE(until([this] { return !snapshot().playing; }));
  EXPECT_EQ(link.notices().size(), 4u) << "no flood";
  EXPECT_EQ(words->text(), sentenceOf(link.notices()[0], namesIn(document.joint(), document.scenario())));
  EXPECT_TRUE(words->text().contains(QStringLiteral("“slab” and “Deepest cube” lay 3.85 mm deep in each other at 0.005 s"))) << words->text().toStdString();
  EXPECT_EQ(child<QPushButton>("allNotices")->text(), QStringLiteral("3 more"));
  QTest::mouseClick(child<QPushButton>("allNotices"), Qt::LeftButton);
  ASSERT_TRUE(until([this] { return child<QListWidget>("problemList")->isVisible() && !window->problems().isChecking(); }));
  EXPECT_EQ(rowsWith(QStringLiteral("deep in each other")), 2) << "once a pair";
  EXPECT_EQ(rowsWith(QStringLiteral("The seed 7")), 1) << "the problem of the scene, not a second time";
  EXPECT_EQ(rowsWith(QStringLiteral("holds nothing for it to act on")), 1);
  EXPECT_TRUE(child<QLabel>("problemSummary")->text().contains(QStringLiteral("notices about the run")));
  setLanguage(QStringLiteral("es"));
  EXPECT_TRUE(until([&] { return words->text().contains(QStringLiteral("Deepest cube")) && !words->text().contains(QStringLiteral("deep in")); }));
}

TEST_F(RunNotices, theLineStaysUntilClosedAndComesBackWithNews) {
  ASSERT_TRUE(opened());
  auto* words = child<QLabel>("notice");
  ASSERT_TRUE(until([&] { return words->isVisible(); }));
  QTest::qWait(300);
  EXPECT_TRUE(words->isVisible());
  QTest::mouseClick(child<QToolButton>("closeNotice"), Qt::LeftButton);
  EXPECT_FALSE(words->isVisible());
  QTest::qWait(100);
  EXPECT_FALSE(words->isVisible()) << "nothing new was said";
  link.play();
  ASSERT_TRUE(until([&] { return words->isVisible(); }));
  EXPECT_TRUE(words->text().contains(QStringLiteral("deep in each other"))) << words->text().toStdString();
  link.pause();
  link.reset();
  EXPECT_TRUE(until([&] { return !words->text().contains(QStringLiteral("deep")); }));
  window->openScene(QStringLiteral("block"));
  EXPECT_TRUE(until([&] { return !words->isVisible(); }));
}

}  // namespace
}  // namespace glenoid
