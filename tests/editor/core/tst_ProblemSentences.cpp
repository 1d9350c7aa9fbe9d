// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/ProblemSentences.h"

#include <gtest/gtest.h>

#include <set>

#include "editor/core/NoticeSentences.h"
#include "simcore/check/FixProblem.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

Problem sample(ProblemKind kind) {
  Problem problem;
  problem.kind = kind;
  problem.part = "block";
  problem.other = kind == ProblemKind::NoMaterial ? "tissue" : "plate";
  problem.coupling = "bond";
  problem.region = "face";
  problem.material = "cheese";
  problem.surface = SurfaceKind::Collision;
  problem.element = 7;
  problem.count = 3;
  problem.figure = 0.05;
  problem.wanted = 0.001;
  problem.parts = {"block", "plate"};
  problem.error = Error{Fault::DuplicateId, {}, {"block"}, {}};
  return problem;
}

TEST(ProblemSentences, everyKindHasItsOwnSentenceWithItsFigures) {
  const Joint joint = scenes::blockOnPlateJoint();
  std::set<QString> seen;
  for (int i = 0; i < kProblemKindCount; ++i) {
    const QString sentence = sentenceOf(sample(static_cast<ProblemKind>(i)), joint);
    const char* name = problemName(static_cast<ProblemKind>(i));
    EXPECT_GT(sentence.size(), 20) << name;
    EXPECT_EQ(sentence.back(), u'.') << name << ": " << sentence.toStdString();
    EXPECT_FALSE(sentence.contains(u"%1") || sentence.contains(u"%2") || sentence.contains(u"%3")) << sentence.toStdString();
    EXPECT_TRUE(seen.insert(sentence).second) << "the same words for two kinds: " << sentence.toStdString();
  }
}

TEST(ProblemSentences, everyFixHasATitleAndNothingElseDoes) {
  const Joint joint = scenes::blockOnPlateJoint();
  for (int i = 0; i < kProblemKindCount; ++i) {
    const Problem problem = sample(static_cast<ProblemKind>(i));
    const QString title = fixTitleOf(problem, joint);
    EXPECT_EQ(title.isEmpty(), !canFix(problem)) << problemName(problem.kind);
    EXPECT_FALSE(title.contains(u'%')) << title.toStdString();
  }
}

TEST(ProblemSentences, twoRigidPartsGetTheAdviceThatWasTried) {
  const Joint joint = scenes::blockOnPlateJoint();
  std::set<QString> seen;
  for (const RigidAdvice& advice : {RigidAdvice{true, 0, 0}, RigidAdvice{false, 800, 0.00025}, RigidAdvice{false, 800, 0}, RigidAdvice{false, 0, 0.00025}, RigidAdvice{}}) {
    Problem problem = sample(ProblemKind::Overlap);
    problem.parts.clear();
    problem.rigid = advice;
    const QString sentence = sentenceOf(problem, joint);
    EXPECT_TRUE(seen.insert(sentence).second) << sentence.toStdString();
    EXPECT_FALSE(sentence.contains(u'%')) << sentence.toStdString();
    EXPECT_FALSE(sentence.contains(u"cages")) << "cages cannot move bones: " << sentence.toStdString();
    EXPECT_EQ(sentence.contains(u"800 triangles"), advice.triangles == 800) << sentence.toStdString();
    EXPECT_EQ(sentence.contains(u"0.25 mm"), advice.clearance > 0) << sentence.toStdString();
    EXPECT_EQ(canFix(problem), advice.triangles > 0);
    EXPECT_EQ(fixTitleOf(problem, joint).contains(u"800"), advice.triangles > 0);
  }
}

TEST(ProblemSentences, namesAndLengthsAreForPeople) {
  Joint joint = scenes::blockOnPlateJoint();
  for (Part& part : joint.parts)
    if (part.id == "block") part.name = "Block with %1 in it";
  const std::string sentence = sentenceOf(sample(ProblemKind::Overlap), joint).toStdString();
  EXPECT_NE(sentence.find("“Block with %1 in it”"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("50 mm"), std::string::npos) << sentence;
}

TEST(NoticeSentences, everyKindHasItsOwnSentenceAndNoHoleInIt) {
  std::set<QString> seen;
  for (int i = 0; i < kNoticeKindCount; ++i) {
    Notice notice{static_cast<NoticeKind>(i), "a %2 thing", "plate", 0.0015, 0.001, 0.25, 50, {}};
    const QString sentence = sentenceOf(notice);
    EXPECT_GT(sentence.size(), 20) << i;
    EXPECT_EQ(sentence.back(), u'.') << sentence.toStdString();
    EXPECT_FALSE(sentence.contains(u"%1") || sentence.contains(u"%3") || sentence.contains(u"%4") || sentence.contains(u"%5")) << sentence.toStdString();
    EXPECT_TRUE(seen.insert(sentence).second) << sentence.toStdString();
  }
  const Joint joint = scenes::blockOnPlateJoint();
  Scenario scenario = scenes::blockOnPlateScenario();
  scenario.tools[0].name = "Index %1";
  const QString named = sentenceOf(Notice{NoticeKind::MarkMissed, "press", "finger / block", 0.005, 0, 0.25, 50, {}}, namesIn(joint, scenario));
  EXPECT_NE(named.indexOf(QStringLiteral("“press” (Index %1 / ") + QString::fromStdString(joint.parts[findPart(joint, "block")].name)), -1) << named.toStdString();
  EXPECT_NE(sentenceOf(Notice{NoticeKind::TooDeep, "flap", "flap", 0.0015, 0.001, 0.25, 50, {}}).indexOf(u"1.5 mm deep in itself"), -1);
  EXPECT_NE(sentenceOf(Notice{NoticeKind::TooDeep, "a %2 thing", "plate", 0.0015, 0.001, 0.25, 50, {}}).indexOf(u"1.5 mm deep"), -1);
}

}  // namespace
}  // namespace glenoid
