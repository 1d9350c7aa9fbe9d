// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/Program.h"

namespace glenoid::testing {
namespace {

using Json = nlohmann::json;

TEST(StabilityCommand, aSceneThatHoldsEndsWithStatusZeroAndItsTables) {
  const auto folder = freshFolder() / "new";
  const Outcome outcome = glenoidProgram("study stability builtin:arthroscopy --quick --no-paper --cases left-alone,wild-device --out '" + folder.string() + "'");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("wild-device"), std::string::npos);
  const Json json = Json::parse(readText(folder / "stability.json"), nullptr, false);
  ASSERT_TRUE(json.is_object());
  const Json& rows = json["tables"][0]["rows"];
  ASSERT_EQ(rows.size(), 3u);  // left alone; the probe at a bone and at a muscle
  for (const Json& row : rows) {
    EXPECT_EQ(row["verdict"], "held");
    EXPECT_EQ(row["finite"], true);
    EXPECT_LE(row["recoveryS"], 2.0);
    EXPECT_EQ(row["hash"].get<std::string>().size(), 32u);
  }
  EXPECT_GT(rows[1]["contactsMost"], 0);
  EXPECT_EQ(lineCount(readText(folder / "stability.csv")), 4);
  EXPECT_NE(readText(folder / "stability.txt").find("wild-device.probe-scapula.5ms"), std::string::npos);
}

TEST(StabilityCommand, aFailureLeavesAPictureAndARecordingThatRepeatsIt) {
  const auto folder = freshFolder();
  // The published splitting, stopped after forty iterations, does not keep the momentum of a blow.
  const Outcome outcome = glenoidProgram("study stability builtin:arthroscopy --quick --profile paper --cases impact --out '" + folder.string() + "'");
  EXPECT_EQ(outcome.status, 1) << outcome.out;
  EXPECT_NE(outcome.err.find("1 of 2 trials"), std::string::npos) << outcome.err;
  const std::string recording = (folder / "impact.probe-subscapularis.5ms.recording").string();
  EXPECT_FALSE(readText(folder / "impact.probe-subscapularis.5ms.png").empty());
  const Outcome replay = glenoidProgram("replay '" + recording + "' --check");
  EXPECT_EQ(replay.status, 0) << replay.err;
  EXPECT_NE(replay.out.find("bit by bit"), std::string::npos) << replay.out;
  EXPECT_NE(replay.out.find("more than what it had and what was done to it"), std::string::npos) << replay.out;
}

TEST(StabilityCommand, wrongWordsAreSaid) {
  const auto folder = freshFolder();
  const std::string out = " --out '" + folder.string() + "'";
  EXPECT_EQ(glenoidProgram("study").status, 2);
  EXPECT_EQ(glenoidProgram("study stability builtin:arthroscopy").status, 2);
  const Outcome unknown = glenoidProgram("study stability builtin:arthroscopy --cases storm" + out);
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("storm"), std::string::npos) << unknown.err;
  EXPECT_EQ(lineCount(unknown.err), 1);
  writeText(folder / "file", "");
  EXPECT_EQ(glenoidProgram("study stability builtin:arthroscopy --cases press --out '" + (folder / "file").string() + "'").status, 2);
}

}  // namespace
}  // namespace glenoid::testing
