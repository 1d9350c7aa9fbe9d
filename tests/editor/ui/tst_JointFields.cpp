// SPDX-License-Identifier: GPL-3.0-or-later
// What the window says of the joint as a whole, and its mirror image.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>

#include "editor/core/EffectSentences.h"
#include "simcore/author/MirrorJoint.h"
#include "simcore/scene/JointFile.h"
#include "tests/editor/ui/GuiTest.h"

namespace glenoid {
namespace {

class JointFieldsWindow : public GuiTest {
 protected:
  void type(const char* field, const char* words) {
    auto* line = child<QLineEdit>(field);
    ASSERT_TRUE(line) << field;
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, QLatin1String(words));
    QTest::keyClick(line, Qt::Key_Return);
  }
};

TEST_F(JointFieldsWindow, nameDescriptionAuthorLicenceAndSideAreEditedWithUndo) {
  selection.clear();
  type("jointName", "Left knee");
  type("jointDescription", "Of nobody");
  type("jointAuthor", "A. Author");
  type("jointLicence", "CC0-1.0");
  auto* side = child<QComboBox>("jointSide");
  ASSERT_TRUE(side);
  EXPECT_EQ(side->currentText(), QStringLiteral("none said"));
  side->setFocus();
  QTest::keyClick(side, Qt::Key_Down);
  const Joint& joint = document.joint();
  EXPECT_EQ(joint.name, "Left knee");
  EXPECT_EQ(joint.description, "Of nobody");
  EXPECT_EQ(joint.provenance.author, "A. Author");
  EXPECT_EQ(joint.provenance.license, "CC0-1.0");
  EXPECT_EQ(joint.side, JointSide::Left);
  EXPECT_EQ(document.undoStack().count(), 5);
  ASSERT_TRUE(until([this] { return snapshot().model->joint.side == JointSide::Left; })) << "the view's marker takes it from there";
  for (int step = 0; step < 5; ++step) action("undo")->trigger();
  EXPECT_NE(document.joint().name, "Left knee");
  EXPECT_EQ(document.joint().side, JointSide::Unsaid);
  EXPECT_EQ(child<QComboBox>("jointSide")->currentText(), QStringLiteral("none said")) << "the field follows";
}

TEST_F(JointFieldsWindow, everyEffectSaysWhyItIsOnOrOff) {
  selection.clear();
  ASSERT_TRUE(until([this] { return snapshot().model && child<QLabel>("effect-gravity"); }));
  const std::vector<EffectFacts> effects = effectFacts(*snapshot().model);
  EXPECT_EQ(effects.size(), 9u);
  for (const EffectFacts& facts : effects) {
    auto* label = child<QLabel>(("effect-" + facts.name).c_str());
    ASSERT_TRUE(label) << facts.name;
    EXPECT_EQ(label->text(), effectSentence(facts)) << facts.name;
    EXPECT_TRUE(label->text().startsWith(facts.on ? QStringLiteral("on, because ") : QStringLiteral("off, because "))) << label->text().toStdString();
  }
}

TEST_F(JointFieldsWindow, theMirrorImageComesIntoTheSameView) {
  const std::string right = jointHash(document.joint());
  const View before = window->view()->view();
  const std::string wanted = jointHash(mirroredJoint(document.joint()));
  action("mirrorJoint")->trigger();
  EXPECT_EQ(jointHash(document.joint()), wanted);
  EXPECT_EQ(window->view()->view().eye_W.z(), -before.eye_W.z());
  ASSERT_TRUE(until([&] { return jointHash(snapshot().model->joint) == wanted; }));
  action("undo")->trigger();
  EXPECT_EQ(jointHash(document.joint()), right);
  ASSERT_TRUE(until([&] { return jointHash(snapshot().model->joint) == right; }));
}

}  // namespace
}  // namespace glenoid
