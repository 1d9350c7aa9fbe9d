// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecordingFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "tests/app/Program.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid::testing {
namespace {

using Json = nlohmann::json;

/// A block that falls onto a plate, on disk.
std::string blockScene(const std::filesystem::path& folder) {
  EXPECT_TRUE(saveJoint(scenes::blockOnPlateJoint(), (folder / "block.joint").string()));
  Scenario scenario = scenes::blockOnPlateScenario();
  scenario.joint = "block.joint";
  scenario.description = "A block.";
  const std::string path = (folder / "block.scenario.json").string();
  EXPECT_TRUE(saveScenario(scenario, path));
  return path;
}

TEST(StudyAccuracy, writesTablesPlotsAndAScenarioThatRuns) {
  const auto folder = freshFolder();
  const std::string scene = blockScene(folder), out = (folder / "study").string();
  const Outcome outcome = glenoidProgram("study accuracy " + scene + " --out " + out + " --smallest --budget 1000s");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out, readText(out + "/summary.txt"));
  EXPECT_NE(outcome.out.find("Chosen:"), std::string::npos) << outcome.out;

  const Json report = Json::parse(readText(out + "/accuracy.json"), nullptr, false);
  ASSERT_TRUE(report.is_object());
  for (const char* field : {"build", "isa", "processor", "threads", "scenario", "jointHash", "dt", "repeats"}) EXPECT_TRUE(report.contains(field)) << field;
  ASSERT_EQ(report["tables"].size(), 3u);
  const Json& rows = report["tables"][0]["rows"];
  EXPECT_EQ(rows[0]["setting"], "scene");
  EXPECT_EQ(lineCount(readText(out + "/settings.csv")), static_cast<int>(rows.size()) + 1);
  for (const Json& row : rows) {
    if (row["failure"] == "") {
      EXPECT_GT(row["stepMedianMs"], 0.0) << row.dump();
      EXPECT_GE(row["stepsTimed"], 7) << row.dump();
    } else {
      EXPECT_NE(row["failureDetail"], "") << row.dump();
    }
  }
  // Between the picture's first bytes and its last there is a plot: tests of LogLogPlot look at what.
  for (const char* quantity : {"displacement", "contact-force", "penetration", "hand-force"}) {
    const std::string stem = out + "/" + quantity + "-own-cells";
    EXPECT_EQ(readText(stem + ".png").substr(1, 3), "PNG");
    EXPECT_EQ(readText(stem + ".pdf").substr(0, 5), "%PDF-");
    const std::string svg = readText(stem + ".svg");
    EXPECT_NE(svg.find("What accuracy costs"), std::string::npos) << stem;  // text, not outlines
    EXPECT_TRUE(svg.find(">scene<") != std::string::npos || svg.find(">scene (no error)<") != std::string::npos) << stem;
  }

  const Scenario chosen = loadScenario(out + "/chosen.scenario.json").value();
  EXPECT_NE(chosen.description.find("A block. Chosen by"), std::string::npos);
  EXPECT_TRUE(chosen.joint == "../block.joint" || chosen.joint == "chosen.joint") << chosen.joint;
  EXPECT_EQ(glenoidProgram("run " + out + "/chosen.scenario.json --steps 3").status, 0);
}

TEST(StudyAccuracy, refusesWhatCannotBeToldAndWhatCannotBeHeld) {
  const auto folder = freshFolder();
  const std::string scene = blockScene(folder), out = (folder / "study").string();
  const Outcome tooFine = glenoidProgram("study accuracy " + scene + " --out " + out + " --smallest --accuracy 0.000000001mm");
  EXPECT_EQ(tooFine.status, 2);
  EXPECT_EQ(lineCount(tooFine.err), 1);
  EXPECT_NE(tooFine.err.find("twice the displacement error of the study’s own reference"), std::string::npos) << tooFine.err;
  EXPECT_FALSE(std::filesystem::exists(out + "/chosen.scenario.json"));
  EXPECT_TRUE(std::filesystem::exists(out + "/settings.csv"));  // what was measured is kept
  const Outcome tooFast = glenoidProgram("study accuracy " + scene + " --out " + out + " --smallest --budget 0.000001ms");
  EXPECT_EQ(tooFast.status, 1);
  EXPECT_NE(tooFast.err.find("no setting stays within 1e-06 ms"), std::string::npos) << tooFast.err;
}

TEST(StudyAccuracy, shardsAreMeasuredOnceAndMergeIntoOneStudy) {
  const auto folder = freshFolder();
  const std::string out = (folder / "study").string(), start = "study accuracy " + blockScene(folder) + " --out " + out + " --smallest ";
  EXPECT_EQ(glenoidProgram(start + "--merge").status, 2);  // nothing there yet
  ASSERT_EQ(glenoidProgram(start + "--shard 1/2").status, 0);
  const std::string first = readText(out + "/shard-1-of-2.json");
  const Outcome missing = glenoidProgram(start + "--merge");
  EXPECT_EQ(missing.status, 2);
  EXPECT_NE(missing.err.find("settings of which"), std::string::npos) << missing.err;
  ASSERT_EQ(glenoidProgram(start + "--shard 2/2").status, 0);
  EXPECT_EQ(glenoidProgram(start + "--shard 1/2").out.find("Scene"), std::string::npos);
  EXPECT_EQ(readText(out + "/shard-1-of-2.json"), first);  // not measured again
  EXPECT_FALSE(std::filesystem::exists(out + "/settings.csv"));
  const Outcome merged = glenoidProgram(start + "--merge --budget 1000s");
  EXPECT_EQ(merged.status, 0) << merged.err;
  EXPECT_TRUE(std::filesystem::exists(out + "/displacement-own-cells.svg"));
  EXPECT_TRUE(std::filesystem::exists(out + "/chosen.scenario.json"));
  for (const char* wrong : {"--shard 0/2", "--shard 3/2", "--shard 1", "--shard 1/2x", "--shard 1/2 --merge", "--shard 1/2 --budget 1ms"})
    EXPECT_EQ(glenoidProgram(start + wrong).status, 2) << wrong;
}

/// As a shard that was killed leaves it: some rows, no times, no result.
void leavePartial(const std::string& out, const std::string& stem, std::size_t rows) {
  Json left = Json::parse(readText(out + "/" + stem + ".json"));
  ASSERT_GT(left["rows"].size(), rows);
  while (left["rows"].size() > rows) left["rows"].erase(left["rows"].size() - 1);
  left["rows"][0]["contacts"] = 12345.5;  // nothing that a step could find
  std::ofstream(out + "/" + stem + ".partial.json") << left.dump(2);
  std::filesystem::remove(out + "/" + stem + ".json");
}

TEST(StudyAccuracy, aShardThatWasStoppedGoesOnWithoutPlayingAgainWhatItFinished) {
  const auto folder = freshFolder();
  const std::string scene = blockScene(folder), out = (folder / "study").string(),
                    start = "study accuracy " + scene + " --out " + out + " --smallest --shard 1/2 ";
  ASSERT_EQ(glenoidProgram(start + "--resume").status, 0);  // nothing to go on with: it begins
  const Json whole = Json::parse(readText(out + "/shard-1-of-2.json"));
  EXPECT_FALSE(std::filesystem::exists(out + "/shard-1-of-2.partial.json"));
  leavePartial(out, "shard-1-of-2", 2);
  const Outcome resumed = glenoidProgram(start + "--resume");
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_NE(resumed.out.find("Going on after 2 settings."), std::string::npos) << resumed.out;
  EXPECT_FALSE(std::filesystem::exists(out + "/shard-1-of-2.partial.json"));
  const Json after = Json::parse(readText(out + "/shard-1-of-2.json"));
  ASSERT_EQ(after["rows"].size(), whole["rows"].size());
  EXPECT_EQ(after["rows"][0]["contacts"], 12345.5);
  for (std::size_t k = 0; k < whole["rows"].size(); ++k) {
    EXPECT_EQ(after["rows"][k]["ownCellsErrors"], whole["rows"][k]["ownCellsErrors"]) << k;
    EXPECT_EQ(after["rows"][k]["finerCellsErrors"], whole["rows"][k]["finerCellsErrors"]) << k;
    if (whole["rows"][k]["failure"] == "") EXPECT_GT(after["rows"][k]["timed"], 0) << k;
  }

  // Another scene is refused, and so is a shard of it that is done already; nothing is lost.
  leavePartial(out, "shard-1-of-2", 2);
  Scenario changed = loadScenario(scene).value();
  changed.contactDistance *= 2;
  ASSERT_TRUE(saveScenario(changed, scene));
  const Outcome refused = glenoidProgram(start + "--resume");
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(lineCount(refused.err), 1) << refused.err;
  EXPECT_NE(refused.err.find("shard-1-of-2.partial.json"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("scenario"), std::string::npos) << refused.err;
  EXPECT_TRUE(std::filesystem::exists(out + "/shard-1-of-2.partial.json"));
  std::filesystem::rename(out + "/shard-1-of-2.partial.json", out + "/shard-1-of-2.json");
  EXPECT_EQ(glenoidProgram(start).status, 2);
  EXPECT_EQ(glenoidProgram("study accuracy " + scene + " --out " + out + " --smallest --merge").status, 2);
  EXPECT_EQ(glenoidProgram("study accuracy " + scene + " --out " + out + " --merge --resume").status, 2);
}

TEST(StudyAccuracy, theStatusSaysWhichShardsAreDoneAndWhichDiedWithoutAWord) {
  const auto folder = freshFolder();
  const std::string scene = blockScene(folder), out = (folder / "study").string(),
                    start = "study accuracy " + scene + " --out " + out + " --smallest ";
  EXPECT_EQ(glenoidProgram(start + "--status").status, 2);  // nothing there
  ASSERT_EQ(glenoidProgram(start + "--shard 2/3").status, 0);
  const Outcome some = glenoidProgram(start + "--status");
  EXPECT_EQ(some.status, 1);
  EXPECT_NE(some.out.find("shard 1 of 3: not begun\nshard 2 of 3: done on "), std::string::npos) << some.out;
  // As it is left by one that was killed: no such process is there any more.
  Json status = Json::parse(readText(out + "/shard-2-of-3.status.json"));
  status["state"] = "running";
  status["pid"] = 0x3fffffff;  // more than any system gives
  std::ofstream(out + "/shard-2-of-3.status.json") << status.dump(2);
  const Outcome killed = glenoidProgram(start + "--status");
  EXPECT_EQ(killed.status, 1);
  EXPECT_NE(killed.out.find("shard 2 of 3: ended without a word after "), std::string::npos) << killed.out;
  for (const char* shard : {"--shard 1/3", "--shard 3/3"}) ASSERT_EQ(glenoidProgram(start + shard).status, 0);
  std::filesystem::remove(out + "/shard-2-of-3.json");
  ASSERT_EQ(glenoidProgram(start + "--shard 2/3 --resume").status, 0);
  const Outcome whole = glenoidProgram(start + "--status");
  EXPECT_EQ(whole.status, 0) << whole.out << whole.err;
}

TEST(StudyAccuracy, badRequestsAreRefusedAtOnce) {
  const auto folder = freshFolder();
  const std::string scene = blockScene(folder), start = "study accuracy " + scene + " --out " + (folder / "out").string() + " ";
  for (const char* wrong : {"--budget 1ms --accuracy 1mm", "--budget 0ms", "--budget much", "--accuracy none", "--accuracy -1mm", "--accuracy 1N --by displacement",
                            "--accuracy 1mm --by hand-force", "--by speed", "--against nothing"}) {
    const Outcome outcome = glenoidProgram(start + wrong);
    EXPECT_EQ(outcome.status, 2) << wrong;
    EXPECT_EQ(lineCount(outcome.err), 1) << outcome.err;
  }
  EXPECT_EQ(glenoidProgram("study accuracy " + scene).status, 2);
  EXPECT_EQ(glenoidProgram("study accuracy " + (folder / "none.scenario.json").string() + " --out " + (folder / "out").string()).status, 2);
  EXPECT_EQ(glenoidProgram("study accuracy " + scene + " --out " + (folder / "no/such/folder").string()).status, 2);
  EXPECT_EQ(glenoidProgram("study accuracy builtin:shoulder --out " + (folder / "out").string()).status, 2);
}

}  // namespace
}  // namespace glenoid::testing
