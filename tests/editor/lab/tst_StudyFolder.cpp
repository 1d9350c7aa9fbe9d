// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/lab/StudyFolder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/editor/lab/LabFiles.h"

namespace glenoid::labtest {
namespace {

TEST(StudyFolder, readsWhatHasComeAndWaitsForTheRestOfALine) {
  LabFolder files;
  StudyFolder study(files.path());
  EXPECT_FALSE(study.look());
  files.append(R"({"study":"accuracy","scenario":"a.scenario.json","dtMs":5})" "\n" R"({"fraction":0.25,"what":"cells=2"})" "\n" R"({"table":"settings","row":{"setting":"sce)");
  EXPECT_TRUE(study.look());
  EXPECT_EQ(study.kind(), "accuracy");
  EXPECT_DOUBLE_EQ(study.fraction(), 0.25);
  EXPECT_EQ(study.what(), "cells=2");
  EXPECT_TRUE(study.rows("settings").empty());
  EXPECT_FALSE(study.look()) << "nothing new";
  files.append(R"(ne","workMedianMs":1}})" "\n");
  EXPECT_TRUE(study.look());
  ASSERT_EQ(study.rows("settings").size(), 1u);
  files.append(settingRow("scene", "2", "3", "null"));
  study.look();
  ASSERT_EQ(study.rows("settings").size(), 1u) << "told again, not twice";
  EXPECT_DOUBLE_EQ(figureOf(study.rows("settings")[0], "workMedianMs"), 2);
  EXPECT_TRUE(std::isnan(figureOf(study.rows("settings")[0], "displacementOwnCellsMm")));
  EXPECT_TRUE(std::isnan(figureOf(study.rows("settings")[0], "noSuchColumn")));
  EXPECT_FALSE(study.hasEnded());
}

TEST(StudyFolder, aTrialUnderTwoProfilesIsTwoRows) {
  LabFolder files;
  files.append(R"({"study":"stability"})" "\n"
               R"({"table":"stability","row":{"trial":"press.5ms","profile":"direct"}})" "\n" R"({"table":"stability","row":{"trial":"press.5ms","profile":"paper"}})" "\n");
  StudyFolder study(files.path());
  study.look();
  EXPECT_EQ(study.rows("stability").size(), 2u);
}

TEST(StudyFolder, anEndBringsTheWholeDocumentOrTheReason) {
  LabFolder files;
  files.append(R"({"study":"accuracy","scenario":"b"})" "\n" R"({"ended":"failed","error":{"fault":")" + std::string(faultName(Fault::FileMissing)) +
               R"(","file":"x.ply","pointer":"/parts/1","part":"humerus","element":7,"arguments":["one","two"]}})" "\n");
  StudyFolder study(files.path());
  study.look();
  EXPECT_TRUE(study.hasEnded());
  EXPECT_FALSE(study.isWhole());
  ASSERT_TRUE(study.error());
  EXPECT_EQ(study.error()->fault, Fault::FileMissing);
  EXPECT_EQ(study.error()->place.file, "x.ply");
  EXPECT_EQ(study.error()->place.element, 7);
  EXPECT_EQ(study.error()->arguments, (Arguments{"one", "two"}));

  LabFolder again;  // where an older study lies
  again.append(R"({"build":"b0","scenario":"old","tables":[{"id":"settings","facts":{},"columns":["setting"],"rows":[{"setting":"scene"}]}]})", "accuracy.json");
  again.append(R"({"study":"accuracy","scenario":"new"})" "\n" R"({"ended":"failed","document":false,"error":{"fault":"FileMissing","arguments":[]}})" "\n");
  StudyFolder failed(again.path());
  failed.look();
  EXPECT_FALSE(failed.isWhole()) << "what lies there is not of this one";
  EXPECT_TRUE(failed.rows("settings").empty());

  LabFolder merged;  // no progress of its own
  merged.append(R"({"build":"b1","dt":0.005,"scenario":"c","tables":[{"id":"settings","facts":{},"columns":["setting"],"rows":[{"setting":"scene"}]}]})", "accuracy.json");
  const Result<StudyFolder> opened = StudyFolder::open(merged.path());
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->kind(), "accuracy");
  EXPECT_EQ(opened->head()["build"].text(), "b1");
  EXPECT_TRUE(opened->isWhole());
  EXPECT_EQ(opened->rows("settings").size(), 1u);
  EXPECT_FALSE(StudyFolder::open(LabFolder().path())) << "an empty folder holds no study";
}

}  // namespace
}  // namespace glenoid::labtest
