// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "simcore/file/Schema.h"
#include "tests/app/Program.h"

namespace glenoid::testing {
namespace {

using Json = nlohmann::json;

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

TEST(Readings, theShippedShoulderTellsItsStateItsTraceAndItsTissue) {
  const auto folder = freshFolder();
  const auto state = folder / "state.json", trace = folder / "trace.csv", tissue = folder / "tissue.vtu";
  const Outcome outcome = glenoidProgram("run builtin:arthroscopy --steps 40 --state " + quoted(state) + " --trace " + quoted(trace) +
                                         " --every 10 --trace-parts humerus,probe --trace-pairs humerus:scapula --vtu " + quoted(tissue));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const auto document = readDocument(state.string(), Schema::RunState);
  ASSERT_TRUE(document.ok()) << toLogLine(document.error());
  const Json json = Json::parse(readText(state));
  EXPECT_EQ(json["scenario"], "builtin:arthroscopy");
  EXPECT_EQ(json["step"], 40);
  EXPECT_DOUBLE_EQ(json["time"], 0.2);
  EXPECT_EQ(json["parts"].size(), 13u);  // eleven and two tools
  EXPECT_GT(json["couplings"].size(), 5u);
  for (const Json& part : json["parts"]) {
    const std::string kind = part["kind"];
    if (kind == "soft") {
      EXPECT_TRUE(part.contains("peaks")) << part["id"];
    } else if (!part.contains("peaks") || kind == "tool") {
      EXPECT_FALSE(part.contains("peaks"));
      continue;
    } else {
      EXPECT_EQ(part["peaks"].size(), 1u) << "a bone has contact alone";
      EXPECT_GT(part["peaks"]["contact"]["value"], 0);
      continue;
    }
    const Json& peaks = part["peaks"];
    EXPECT_GT(peaks["stress"]["value"], 0) << part["id"];
    EXPECT_GT(peaks["strain"]["value"], 0) << part["id"];
    EXPECT_TRUE(peaks["pressure"]["value"].is_number());
    const double away = std::hypot(peaks["stress"]["at"][0].get<double>() - part["centre"][0].get<double>(),
                                   peaks["stress"]["at"][1].get<double>() - part["centre"][1].get<double>());
    EXPECT_LT(away, 0.2) << "on the part";
  }
  const std::string table = readText(trace);
  EXPECT_EQ(lineCount(table), 1 + 5);
  EXPECT_EQ(table.rfind("time,penetration,humerus.x,humerus.y,humerus.z,humerus.vx", 0), 0u);
  EXPECT_NE(table.find("humerus:scapula.normal,humerus:scapula.penetration\n"), std::string::npos);
  EXPECT_NE(readText(tissue).find("Name=\"vonMises\""), std::string::npos);
}

TEST(Readings, readingChangesNothing) {
  const auto folder = freshFolder();
  const auto hashOf = [&](const std::string& more) {
    const auto report = folder / "report.json";
    EXPECT_EQ(glenoidProgram("run builtin:arthroscopy --steps 20 --report " + quoted(report) + more).status, 0);
    return Json::parse(readText(report))["stateHash"].get<std::string>();
  };
  EXPECT_EQ(hashOf(""), hashOf(" --trace " + quoted(folder / "t.csv") + " --state " + quoted(folder / "s.json")));
}

TEST(Readings, whatCannotBeWrittenOrIsNotThereIsSaidBeforeTheRun) {
  const auto folder = freshFolder();
  // Ten hours of simulation would not end within the time of a test.
  const std::string run = "run builtin:arthroscopy --steps 5000000";
  for (const std::string& option :
       {" --state " + quoted(folder / "nowhere" / "s.json"), " --vtu " + quoted(folder), " --trace " + quoted(folder / "nowhere" / "t.csv"),
        " --report " + quoted(folder / "nowhere" / "r.json"), " --trace " + quoted(folder / "t.csv") + " --trace-parts spleen",
        " --trace " + quoted(folder / "t.csv") + " --trace-pairs humerus", std::string(" --every 5"),
        " --state " + quoted(folder / "same") + " --vtu " + quoted(folder / "same")}) {
    const Outcome outcome = glenoidProgram(run + option);
    EXPECT_EQ(outcome.status, 2) << option;
    EXPECT_EQ(lineCount(outcome.err), 1) << option << outcome.err;
    EXPECT_EQ(outcome.out, "") << option;
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder));  // and no attempt is left behind
}

}  // namespace
}  // namespace glenoid::testing
