// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/Program.h"

namespace glenoid::testing {
namespace {

using Json = nlohmann::json;

TEST(StudyTruth, writesTablesAPlotOfEachProblemAndScenesThatRun) {
  const auto folder = freshFolder() / "new's";
  const Outcome outcome =
      glenoidProgram("study truth --quick --only hanging-bar,spring-pair-step,le1 --elements cells --out \"" +
                     folder.string() + "\"");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("3 of 3 answers are within their bars"), std::string::npos) << outcome.out;
  const Json json = Json::parse(readText(folder / "truth.json"), nullptr, false);
  ASSERT_TRUE(json.is_object());
  EXPECT_EQ(json["profile"], "direct");
  ASSERT_EQ(json["tables"][1]["rows"].size(), 3u);
  for (const Json& row : json["tables"][1]["rows"]) {
    EXPECT_EQ(row["met"], true) << row["problem"];
    EXPECT_LE(row["error"].get<double>(), row["bar"].get<double>());
    for (const char* ending : {".png", ".svg", ".pdf"})
      EXPECT_FALSE(readText(folder / (row["problem"].get<std::string>() + ending)).empty())
          << row["problem"] << ending;
  }
  EXPECT_EQ(lineCount(readText(folder / "truth.csv")), 1 + 2 + 3 + 2);
  EXPECT_NE(readText(folder / "scenes" / "README.txt").find("spring-pair-step: none, since"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "scenes" / "spring-pair-step.scenario.json"));
  for (const char* scene : {"hanging-bar", "le1"}) {
    const Outcome run = glenoidProgram(
        "run \"" + (folder / "scenes" / (std::string(scene) + ".scenario.json")).string() + "\" --steps 5");
    EXPECT_EQ(run.status, 0) << run.err;
  }
}

TEST(StudyTruth, listsItsProblemsAndRefusesOthers) {
  const Outcome list = glenoidProgram("study truth --list");
  EXPECT_EQ(list.status, 0);
  EXPECT_GE(lineCount(list.out), 12);
  EXPECT_NE(list.out.find("capstan"), std::string::npos);
  EXPECT_EQ(glenoidProgram("study truth").status, 2);
  const Outcome unknown =
      glenoidProgram("study truth --only cooks --out '" + (freshFolder() / "x").string() + "'");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("cooks"), std::string::npos) << unknown.err;
}

}  // namespace
}  // namespace glenoid::testing
