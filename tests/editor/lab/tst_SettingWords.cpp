// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/lab/SettingWords.h"

#include <gtest/gtest.h>

#include "simcore/study/accuracy/AccuracySetting.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

/// No part of an id that a study may sweep is left as it stands.
TEST(SettingWords, everySettingOfAStudyHasWords) {
  const auto model = compileModel(scenes::blockOnPlateJoint(), scenes::blockOnPlateScenario()).value();
  const std::vector<AccuracySetting> settings = accuracySettings(*model, false);
  ASSERT_GT(settings.size(), 20u);
  for (const AccuracySetting& setting : settings) {
    const QString words = settingWords(setting.id);
    EXPECT_FALSE(words.contains(u'=')) << words.toStdString();
    EXPECT_FALSE(words.contains(u'%')) << words.toStdString();
  }
  EXPECT_EQ(settingWords("cells=2,dt=2.5ms").toStdString(), "twice as many tetrahedra; steps of 2.5 ms");
}

TEST(SettingWords, whatFailedSaysHowOften) {
  EXPECT_EQ(failureWords("not-finite", "3 of 40 steps").toStdString(), "3 of 40 steps were not finite");
  EXPECT_EQ(failureWords("diverged", "40 of 40 steps").toStdString(), "40 of 40 steps diverged");
}

TEST(SettingWords, aChangeIsSaidWithWhatWas) {
  Scene before{scenes::blockOnPlateJoint(), scenes::blockOnPlateScenario(), nullptr};
  Scene after = before;
  after.scenario.dt = 0.5 * before.scenario.dt;
  after.scenario.profile = Profile::Paper;
  EXPECT_EQ(changedSentence(before, after).toStdString(), "Steps of 2.5 ms in place of 5 ms; solved as published in place of solved directly.");
  EXPECT_EQ(changedSentence(before, before).toStdString(), "");
}

}  // namespace
}  // namespace glenoid
