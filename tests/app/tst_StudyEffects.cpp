// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/plot/BarPlot.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "tests/app/Program.h"
#include "tests/scenes/SlideScenes.h"

namespace glenoid::testing {
namespace {

using Json = nlohmann::json;

/// A block that friction holds on a slope, on disk.
std::string slopeScene(const std::filesystem::path& folder) {
  scenes::Slide slide;
  slide.friction = 0.5;
  EXPECT_TRUE(saveJoint(scenes::slideJoint(slide), (folder / "slope.joint").string()));
  Scenario scenario = scenes::slideScenario(slide);
  scenario.joint = "slope.joint";
  scenario.id = "slope";
  const std::string path = (folder / "slope.scenario.json").string();
  EXPECT_TRUE(saveScenario(scenario, path));
  return path;
}

TEST(StudyEffects, writesTablesAPlotPicturesAndWords) {
  const auto folder = freshFolder();
  const std::string out = (folder / "study").string();
  const Outcome outcome =
      glenoidProgram("study effects " + slopeScene(folder) + " --out " + out + " --smallest");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out, readText(out + "/summary.txt"));
  EXPECT_NE(outcome.out.find("auto: on, because a friction coefficient is given to"), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("Dents under a tip: costs nothing, not even when it is switched on"),
            std::string::npos)
      << outcome.out;
  const Json report = Json::parse(readText(out + "/effects.json"));
  for (const char* field : {"build", "isa", "processor", "scenario", "jointHash", "dt"})
    EXPECT_TRUE(report.contains(field)) << field;
  const Json& rows = report["tables"][0]["rows"];
  EXPECT_EQ(rows.size(), 9u);
  EXPECT_EQ(lineCount(readText(out + "/effects.csv")), 10);
  for (const Json& row : rows) {
    if (row["effect"] == "friction") {
      EXPECT_GT(row["displacementMostMm"], 0.5);
      EXPECT_GT(row["onMedianMs"], 0.0);
    }
    EXPECT_EQ(row["acts"], !row["onMedianMs"].is_null());
    EXPECT_FALSE(report["words"][row["effect"].get<std::string>()].get<std::string>().empty());
  }
  EXPECT_EQ(readText(out + "/price.png").substr(1, 3), "PNG");
  EXPECT_EQ(readText(out + "/price.pdf").substr(0, 5), "%PDF-");
  EXPECT_NE(readText(out + "/price.svg").find(">Friction<"), std::string::npos);
  EXPECT_EQ(readText(out + "/friction.png").substr(1, 3), "PNG");
  EXPECT_FALSE(std::filesystem::exists(out + "/dent.png"));  // nothing is lost
}

TEST(StudyEffects, badRequestsAreRefused) {
  const auto folder = freshFolder();
  const std::string scene = slopeScene(folder),
                    start = "study effects " + scene + " --out " + (folder / "out").string() + " ";
  for (const char* wrong : {"--effects magic", "--effects friction,magic --smallest", "--quick --nothing"}) {
    const Outcome outcome = glenoidProgram(start + wrong);
    EXPECT_EQ(outcome.status, 2) << wrong;
    EXPECT_EQ(lineCount(outcome.err), 1) << outcome.err;
  }
  EXPECT_EQ(glenoidProgram("study effects " + (folder / "none.scenario.json").string() + " --out " +
                           (folder / "out").string())
                .status,
            2);
}

TEST(StudyEffects, aRunSaysWhyEachEffectIsOnOrOff) {
  const auto folder = freshFolder();
  const std::string report = (folder / "report.json").string();
  const Outcome outcome = glenoidProgram("run " + slopeScene(folder) + " --steps 3 --report " + report);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("effect:      Friction on, because a friction coefficient is given to"),
            std::string::npos)
      << outcome.out;
  const Json json = Json::parse(readText(report));
  EXPECT_EQ(json["effects"].size(), 9u);
  for (const Json& effect : json["effects"]) {
    const std::string why = effect["why"];
    EXPECT_EQ(why.rfind(effect["state"].get<std::string>() + ", because ", 0), 0u) << why;
  }
}

TEST(BarPlot, ticksAreRoundAndFew) {
  for (double most = 1e-4; most < 1e4; most *= 1.37) {
    const double tick = evenTick(most);
    EXPECT_LE(most / tick, 9 + 1e-9) << most;
    EXPECT_GE(most / tick, 3) << most;
    const double mantissa = tick / std::pow(10, std::floor(std::log10(tick) + 1e-9));
    EXPECT_LT(std::min({std::abs(mantissa - 1), std::abs(mantissa - 2), std::abs(mantissa - 5)}), 1e-9)
        << tick;
  }
}

}  // namespace
}  // namespace glenoid::testing
