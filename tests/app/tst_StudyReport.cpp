// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "simcore/scene/JointFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "tests/app/Program.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid::testing {
namespace {

using Json = nlohmann::json;

std::string blockScene(const std::filesystem::path& folder) {
  EXPECT_TRUE(saveJoint(scenes::blockOnPlateJoint(), (folder / "block.joint").string()));
  Scenario scenario = scenes::blockOnPlateScenario();
  scenario.joint = "block.joint";
  const std::string path = (folder / "block.scenario.json").string();
  EXPECT_TRUE(saveScenario(scenario, path));
  return path;
}

std::string withoutSpaces(const std::string& text) {
  std::string out;
  for (const char c : text)
    if (!std::isspace(static_cast<unsigned char>(c))) out += c;
  return out;
}

/// A study told by hand: figures are known, some are missing, one setting failed.
void writeStudy(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  Json rows = Json::array();
  const auto add = [&](const char* id, Json ms, Json p95, Json own, Json finer, bool inScenario = true) {
    rows.push_back({{"setting", id}, {"family", "time-step"}, {"failure", ""}, {"failureDetail", ""}, {"inScenario", inScenario}, {"contactSurfaces", "collision"}, {"windows", 8},
                    {"workMedianMs", ms}, {"workP95Ms", p95}, {"displacementOwnCellsMm", own}, {"displacementFinerCellsMm", finer}, {"contactForceOwnCellsN", own},
                    {"penetrationOwnCellsMm", nullptr}, {"displacementWhereOwnCells", "block"}});
  };
  add("scene", 2.0, 2.4, 0.31, 0.9);
  add("dt=2.5ms", 3.9, 4.6, 0.12, 0.8);
  add("dt=1.25ms", 7.5, 8.9, 0.05, 0.7);
  add("cells=2", 4.1, 4.9, nullptr, 0.4);
  add("profile=paper,paper=all", 1.5, 1.6, 0.02, nullptr, false);
  rows.push_back({{"setting", "dt=20ms"}, {"family", "time-step"}, {"failure", "not-finite"}, {"failureDetail", "3 of 40 steps"}, {"inScenario", true}, {"windows", 8}, {"workMedianMs", 0.6}, {"workP95Ms", 0.7}});
  const Json references = Json::array({{{"against", "own-cells"}, {"missing", ""}, {"displacementFloorMm", 0.002}, {"contactForceFloorN", 0.001}},
                                       {{"against", "finer-cells"}, {"missing", ""}, {"displacementFloorMm", 0.05}}});
  const Json study = {{"study", "accuracy"}, {"scenario", "shoulder.scenario.json"}, {"dt", 0.005}, {"quick", true}, {"build", "b-4711"}, {"isa", "avx2-fma"}, {"processor", "Coefficient 5000"}, {"threads", 1},
                      {"tables", Json::array({{{"id", "settings"}, {"facts", Json::object()}, {"columns", Json::array({"setting"})}, {"rows", rows}},
                                              {{"id", "references"}, {"facts", Json::object()}, {"columns", Json::array({"against"})}, {"rows", references}}})}};
  writeText(folder / "accuracy.json", study.dump(1));
}

TEST(StudyReport, saysWhichSettingToUseAndWhatItCosts) {
  const auto folder = freshFolder();
  writeStudy(folder / "study");
  const std::string html = (folder / "report.html").string();
  const Outcome outcome = glenoidProgram("study report '" + (folder / "study").string() + "' --out '" + html + "'");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string text = readText(html);
  EXPECT_NE(text.find("For 5 ms of computing to each 5 ms of simulated time, run shoulder.scenario.json with this setting: steps of 2.5 ms."), std::string::npos) << text.substr(0, 3000);
  EXPECT_NE(text.find("It costs 3.9 ms (median; 4.6 ms in 95 of 100 steps) and lies 0.12 mm of displacement away"), std::string::npos);
  EXPECT_NE(text.find("The scene as it is costs 2 ms and lies 0.31 mm away."), std::string::npos);
  EXPECT_NE(text.find("Nearest to finer cells within the same time is: twice as many tetrahedra"), std::string::npos);
  EXPECT_NE(text.find("Coefficient 5000"), std::string::npos) << "the machine";
  EXPECT_NE(text.find("b-4711"), std::string::npos) << "the build";
  EXPECT_NE(text.find("3 of 40 steps were not finite"), std::string::npos) << "what failed, with its reason";
  // Numbered without a gap, and nothing is fetched.
  int figures = 0, tables = 0;
  while (text.find("Figure " + std::to_string(figures + 1) + ". ") != std::string::npos) ++figures;
  while (text.find("Table " + std::to_string(tables + 1) + ". ") != std::string::npos) ++tables;
  EXPECT_EQ(figures, 3) << "displacement and contact force against the same cells, displacement against finer ones";
  EXPECT_EQ(tables, 4);
  EXPECT_EQ(text.find("src=\"http"), std::string::npos);
  EXPECT_EQ(text.find("href="), std::string::npos);
  // What has no figure is no figure.
  EXPECT_FALSE(std::regex_search(text, std::regex("[^a-z](nan|inf|null)[^a-z]", std::regex::icase)));
  EXPECT_NE(text.find("<td class=\"figure\">–</td>"), std::string::npos);

  const Outcome tight = glenoidProgram("study report '" + (folder / "study").string() + "' --budget 1ms --out '" + html + "'");
  ASSERT_EQ(tight.status, 0) << tight.err;
  EXPECT_NE(readText(html).find("no setting stays within 1 ms in 95 of 100 steps; the cheapest takes 2.4 ms"), std::string::npos);

  const Outcome spanish = glenoidProgram("study report '" + (folder / "study").string() + "' --language es --out '" + html + "'");
  ASSERT_EQ(spanish.status, 0) << spanish.err;
  EXPECT_EQ(readText(html).find("The scene as it is"), std::string::npos);
  EXPECT_NE(readText(html).find("3,9 ms"), std::string::npos);
}

TEST(StudyReport, thePdfCanBeSearched) {
  const auto folder = freshFolder();
  writeStudy(folder / "study");
  const std::string pdf = (folder / "report.pdf").string();
  const Outcome outcome = glenoidProgram("study report '" + (folder / "study").string() + "' --out '" + pdf + "'");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(readText(pdf).substr(0, 5), "%PDF-");
  ASSERT_EQ(std::system("command -v pdftotext >/dev/null 2>&1"), 0) << "poppler-utils is among packages-tests-debian12.txt";
  const std::string words = (folder / "words.txt").string();
  ASSERT_EQ(std::system(("pdftotext -layout '" + pdf + "' '" + words + "'").c_str()), 0);
  const std::string text = readText(words), close = withoutSpaces(text);
  // Letters that like to become one: coefficient, finer, finite.
  for (const char* part : {"Coefficient5000", "finercells", "werenotfinite", "runshoulder.scenario.jsonwiththissetting:stepsof2.5ms", "Figure1.", "Figure3.", "Table4.", "Computingtimeforeach5msthataresimulated"})
    EXPECT_NE(close.find(part), std::string::npos) << part << "\n" << text.substr(0, 2500);
  for (const char* ligature : {"\xEF\xAC\x80", "\xEF\xAC\x81", "\xEF\xAC\x82", "\xEF\xAC\x83", "\xEF\xAC\x84"}) EXPECT_EQ(text.find(ligature), std::string::npos);
  EXPECT_FALSE(std::regex_search(text, std::regex("[^a-z](nan|null)[^a-z]", std::regex::icase)));
}

TEST(StudyReport, gathersRealStudiesAndPicksAsTheCommandLineDoes) {
  const auto folder = freshFolder();
  const std::string scene = blockScene(folder), accuracy = (folder / "accuracy").string(), stability = (folder / "stability").string();
  const Outcome studied = glenoidProgram("study accuracy " + scene + " --out " + accuracy + " --smallest --budget 5ms");
  ASSERT_NE(studied.status, 2) << studied.err;
  // Told line by line while it ran: the rows end as the document has them.
  const std::string news = readText(accuracy + "/progress.jsonl");
  std::map<std::string, Json> told;
  std::size_t lines = 0, begin = 0;
  for (std::size_t end = news.find('\n'); end != std::string::npos; begin = end + 1, end = news.find('\n', begin), ++lines) {
    const Json line = Json::parse(news.substr(begin, end - begin), nullptr, false);
    ASSERT_TRUE(line.is_object()) << news.substr(begin, end - begin);
    if (line.contains("table") && line["table"] == "settings") told[line["row"]["setting"]] = line["row"];
  }
  EXPECT_EQ(begin, news.size()) << "ends with a whole line";
  const Json document = Json::parse(readText(accuracy + "/accuracy.json"), nullptr, false);
  EXPECT_EQ(told.size(), document["tables"][0]["rows"].size());
  for (const Json& row : document["tables"][0]["rows"]) EXPECT_EQ(told[row["setting"]]["displacementOwnCellsMm"], row["displacementOwnCellsMm"]) << row["setting"];

  glenoidProgram("study stability " + scene + " --out " + stability + " --quick --no-paper --cases left-alone,gravity-turned");
  const std::string html = (folder / "both.html").string();
  const Outcome outcome = glenoidProgram("study report " + accuracy + " " + stability + " --out " + html);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string text = readText(html);
  EXPECT_NE(text.find("What stays stable"), std::string::npos);
  EXPECT_NE(text.find("Gravity turned"), std::string::npos);
  // The command line's own choice, by its id at a point of the plots and by its cost in the answer.
  const std::size_t at = studied.out.find("Chosen:");
  if (studied.status == 0) {
    ASSERT_NE(at, std::string::npos);
    std::smatch id;
    const std::string after = studied.out.substr(at + 8);
    ASSERT_TRUE(std::regex_search(after, id, std::regex("^\\s*(\\S+)")));
    for (const Json& row : document["tables"][0]["rows"])
      if (row["setting"] == id[1].str()) {
        char cost[64];
        std::snprintf(cost, sizeof cost, "It costs %.3g ms (median; %.3g ms", row["workMedianMs"].get<double>(), row["workP95Ms"].get<double>());
        EXPECT_NE(text.find(cost), std::string::npos) << cost;
      }
  }
}

TEST(StudyReport, badRequestsAreRefused) {
  const auto folder = freshFolder();
  writeStudy(folder / "study");
  const std::string study = "study report '" + (folder / "study").string() + "' ";
  for (const std::string& wrong : {study + "--out report.txt", study + "--out '" + (folder / "a.html").string() + "' --budget soon", study + "--out '" + (folder / "no" / "a.html").string() + "'",
                                   "study report '" + folder.string() + "' --out '" + (folder / "a.html").string() + "'", study + "--language fr --out a.html", std::string("study report")}) {
    const Outcome outcome = glenoidProgram(wrong);
    EXPECT_EQ(outcome.status, 2) << wrong;
    EXPECT_EQ(lineCount(outcome.err), 1) << outcome.err;
  }
}

}  // namespace
}  // namespace glenoid::testing
