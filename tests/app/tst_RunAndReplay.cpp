// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "simcore/file/Schema.h"
#include "tests/app/Program.h"

namespace glenoid::testing {
namespace {

using Json = nlohmann::json;

/// Runs the built-in arthroscopy for some steps and answers its report.
Json reportOf(const std::string& arguments, const std::filesystem::path& folder, const std::string& scenario = "builtin:arthroscopy") {
  const auto path = folder / "report.json";
  std::filesystem::remove(path);
  const Outcome outcome = glenoidProgram("run " + scenario + " " + arguments + " --report '" + path.string() + "'");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const auto document = readDocument(path.string(), Schema::RunReport);  // as its schema says
  EXPECT_TRUE(document.ok()) << (document ? "" : toLogLine(document.error()));
  return Json::parse(readText(path), nullptr, false);
}

TEST(RunCommand, theReportHoldsWhatItPromises) {
  const Json report = reportOf("--steps 40", freshFolder());
  ASSERT_TRUE(report.is_object());
  for (const char* field : {"profile", "dt", "steps", "build", "isa", "seed", "finite", "diverged", "rejectedSteps",
                            "stepsPerSecond", "residual", "stateHash", "parts", "islands", "contacts", "ms", "penetrationMax",
                            "visualPenetrationMax", "effects", "marks", "jointHash"})
    EXPECT_TRUE(report.contains(field)) << field;
  EXPECT_EQ(report["steps"], 40);
  EXPECT_EQ(report["profile"], "direct");
  EXPECT_EQ(report["solver"], "block-cholesky");
  EXPECT_EQ(report["finite"], true);
  EXPECT_EQ(report["rejectedSteps"], 0);
  EXPECT_EQ(report["parts"].size(), 11u);
  EXPECT_EQ(report["stateHash"].get<std::string>().size(), 32u);
  // Too short for its loads to rise: no figure, and the reason.
  EXPECT_TRUE(report["contacts"]["rest"].is_null());
  EXPECT_EQ(report["contacts"]["restReason"], "loads-still-rise");
  EXPECT_FALSE(report.contains("haptic"));
  const Json& step = report["ms"]["step"];
  EXPECT_GT(step["median"], 0.0);
  EXPECT_LE(step["median"], step["p95"]);
  EXPECT_LE(step["p95"], step["p99"]);
  EXPECT_LE(step["p99"], step["p999"]);
  EXPECT_LE(step["p999"], step["max"]);
}

TEST(RunCommand, aTimeLimitStopsItWithTheReport) {
  const auto folder = freshFolder();
  const std::string run = "run builtin:arthroscopy --seconds 600 --report '" + (folder / "report.json").string() + "' --time-limit ";
  const Outcome stopped = glenoidProgram(run + "0.5s");
  EXPECT_EQ(stopped.status, 1);
  EXPECT_NE(stopped.err.find("took longer than 0.5 s"), std::string::npos) << stopped.err;
  const auto document = readDocument((folder / "report.json").string(), Schema::RunReport);
  EXPECT_TRUE(document.ok()) << (document ? "" : toLogLine(document.error()));
  const Json report = Json::parse(readText(folder / "report.json"));
  EXPECT_GT(report["steps"], 0);
  EXPECT_LT(report["steps"], 120000);
  EXPECT_TRUE(report["finite"]);
  bool said = false;
  for (const Json& notice : report["notices"]) said = said || notice["kind"] == "time-up";
  EXPECT_TRUE(said);
  for (const char* wrong : {"0", "-1s", "soon", "5 apples", "1e400", "nan", "inf"}) {
    const Outcome refused = glenoidProgram(run + "'" + wrong + "'");
    EXPECT_EQ(refused.status, 2) << wrong;
    EXPECT_EQ(lineCount(refused.err), 1) << refused.err;
  }
  EXPECT_EQ(glenoidProgram("run builtin:arthroscopy --steps 3 --time-limit 2min").status, 0);
}

TEST(RunCommand, sameInputGivesSameBitsForAnyNumberOfThreads) {
  const auto folder = freshFolder();
  const std::string first = reportOf("--steps 60", folder)["stateHash"];
  EXPECT_EQ(reportOf("--steps 60", folder)["stateHash"], first);
  EXPECT_EQ(reportOf("--steps 60 --threads 2", folder)["stateHash"], first);
  EXPECT_NE(reportOf("--steps 61", folder)["stateHash"], first);  // the hash sees the state
}

TEST(RunCommand, theReportSaysWhatTheTerminalSays) {
  const auto folder = freshFolder();
  Json scenario = Json::parse(readText(GLENOID_SOURCE_DIR "/resources/scenarios/arthroscopy.scenario.json"));
  scenario["loads"] = Json::array();  // nothing is left to rise
  scenario["seed"] = 7;
  scenario["effects"]["haptics"] = "on";
  writeText(folder / "idle.scenario.json", scenario.dump(2));
  const std::string quoted = "'" + (folder / "idle.scenario.json").string() + "'";
  const Json report = reportOf("--steps 5", folder, quoted);
  ASSERT_EQ(report["notices"].size(), 3u);
  const std::string said = glenoidProgram("run " + quoted + " --steps 5").out;
  std::set<std::string> why;
  for (const Json& notice : report["notices"]) {
    EXPECT_EQ(notice["kind"], "unused-setting");
    why.insert(notice["why"].get<std::string>());
    EXPECT_NE(said.find("notice:      " + notice["sentence"].get<std::string>() + "\n"), std::string::npos) << notice["sentence"];
  }
  EXPECT_EQ(why, (std::set<std::string>{"load-rise", "not-built", "seed"}));
}

TEST(RunCommand, optionsReachTheRun) {
  const Json report = reportOf("--seconds 0.05 --dt 0.0025 --seed 7 --profile reference --effects gravity=off --portable", freshFolder());
  EXPECT_EQ(report["steps"], 20);
  EXPECT_EQ(report["dt"], 0.0025);
  EXPECT_EQ(report["seed"], 7);
  EXPECT_EQ(report["profile"], "reference");
  EXPECT_EQ(report["isa"], "portable");
  bool found = false;
  for (const Json& effect : report["effects"])
    if (effect["name"] == "gravity") {
      found = true;
      EXPECT_EQ(effect["state"], "off");
      EXPECT_EQ(effect["reason"], "asked-off");
    }
  EXPECT_TRUE(found);
}

TEST(RunCommand, theProfileOfThePaperReportsItsSplitting) {
  const Json report = reportOf("--steps 4 --profile paper", freshFolder());
  ASSERT_TRUE(report.contains("paper"));
  EXPECT_EQ(report["finite"], true);
  EXPECT_EQ(report["paper"]["dNodeSteps"].get<int>() + report["paper"]["dObjectSteps"].get<int>(), 4);  // contacts from the start
  EXPECT_GT(report["paper"]["cgIterationsMax"], 0);
  EXPECT_GT(report["paper"]["outerIterationsMax"], 0);
}

TEST(RunCommand, realTimeKeepsTheClockAndIsFelt) {
  const Json report = reportOf("--seconds 0.4 --realtime --haptic-compare 0.05", freshFolder());
  EXPECT_EQ(report["realtime"], true);
  EXPECT_GE(report["pace"]["wallSeconds"], 0.39);  // 80 steps of 5 ms; the last begins after 79
  const Json& haptic = report["haptic"];
  ASSERT_TRUE(haptic.is_object());
  for (const char* field : {"rateHz", "latenessP99Ms", "missed", "forceMaxN", "energyMaxJ", "forceErrorRms"}) EXPECT_TRUE(haptic[field].is_number()) << field;
  EXPECT_EQ(haptic["device"], "reference");
  EXPECT_EQ(haptic["comparedSeconds"], 0.05);
  EXPECT_EQ(haptic["tools"].size(), 2u);
  EXPECT_GT(haptic["ticks"], 100);
}

TEST(RunCommand, aDeviceThatNobodyKnowsOrIsNotForThisRunIsBadInput) {
  const Outcome unknown = glenoidProgram("run builtin:arthroscopy --seconds 0.1 --realtime --device omni");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("omni"), std::string::npos) << unknown.err;
  const Outcome unpaced = glenoidProgram("run builtin:arthroscopy --seconds 0.1 --device unknown");
  EXPECT_EQ(unpaced.status, 2);
  EXPECT_NE(unpaced.err.find("--realtime"), std::string::npos) << unpaced.err;
}

// Nobody speaks at the bridge: the tool stays at home, and the summary says why.
TEST(RunCommand, aToolIsHeldByADeviceOrASentenceSaysWhyNot) {
  const Outcome held = glenoidProgram("run builtin:arthroscopy --seconds 0.1 --realtime --haptic-compare 0 --device probe=bridge:29310");
  EXPECT_EQ(held.status, 0) << held.out;
  EXPECT_NE(held.out.find("never said where its hand is"), std::string::npos) << held.out;
  for (const char* bad : {"--device haply:127.0.0.1:1", "--device bridge:lab", "--device tibia=bridge", "--device probe=bridge --device probe=bridge:9311",
                          "--device unknown --device reference"}) {
    const Outcome refused = glenoidProgram(std::string("run builtin:arthroscopy --seconds 0.1 --realtime ") + bad);
    EXPECT_EQ(refused.status, 2) << bad << refused.out;
  }
}

TEST(DevicesCommand, listsWhatMayHoldATool) {
  const Outcome outcome = glenoidProgram("devices --json --seconds 0.01 bridge:29311 haply:127.0.0.1:1");
  ASSERT_EQ(outcome.status, 0) << outcome.out;
  const Json list = Json::parse(outcome.out);
  ASSERT_EQ(list["devices"].size(), 2u);
  EXPECT_EQ(list["devices"][0]["state"], "waits for a program");
  EXPECT_EQ(list["devices"][1]["state"], "not there");
  EXPECT_GE(list["profiles"].size(), 3u);
}

TEST(ReplayCommand, aRecordingRepeatsBitByBitAndATamperedOneIsCaught) {
  const auto folder = freshFolder();
  const auto recording = folder / "r.recording";
  reportOf("--steps 60 --record '" + recording.string() + "'", folder);
  const Outcome same = glenoidProgram("replay '" + recording.string() + "' --check");
  EXPECT_EQ(same.status, 0) << same.err;
  EXPECT_EQ(same.err, "");

  std::string text = readText(recording);
  const auto at = text.find("\"stateHash\"");
  ASSERT_NE(at, std::string::npos);
  const auto digit = text.find('"', text.find(':', at)) + 1;
  text[digit] = text[digit] == '0' ? '1' : '0';
  writeText(recording, text);
  const Outcome other = glenoidProgram("replay '" + recording.string() + "' --check");
  EXPECT_EQ(other.status, 1);
  EXPECT_EQ(lineCount(other.err), 1) << other.err;
}

TEST(ReplayCommand, anInputWithoutExpectedStateCannotBeChecked) {
  const Outcome outcome = glenoidProgram("replay builtin:arthroscopy --check");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(lineCount(outcome.err), 1) << outcome.err;
}

TEST(JointCommand, theShoulderStandsBesideThePublishedTable) {
  const Outcome outcome = glenoidProgram("joint info builtin:shoulder --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json info = Json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(info.is_object());
  ASSERT_EQ(info["parts"].size(), 11u);
  for (const Json& part : info["parts"]) EXPECT_EQ(part["within"]["all"], true) << part.dump(2);
  EXPECT_EQ(info["couplings"].size(), 16u);
  for (const Json& coupling : info["couplings"]) {
    EXPECT_GE(coupling["springs"], 4) << coupling.dump();
    EXPECT_GT(coupling["stiffness"], 0.0) << coupling.dump();
  }
}

TEST(JointCommand, theTableIsReadable) {
  const Outcome outcome = glenoidProgram("joint info builtin:shoulder");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("11 of 11 parts within the tolerances"), std::string::npos) << outcome.out;
}

TEST(JointCommand, theShoulderPassesItsChecks) {
  const Outcome outcome = glenoidProgram("joint check builtin:shoulder");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("All checks hold."), std::string::npos) << outcome.out;
}

/// A sphere of rings × 2·rings quads in text: closed, wound outwards, metres.
std::string spherePly(double radius, int rings) {
  std::string vertices, faces;
  const int around = 2 * rings;
  int count = 0, triangles = 0;
  const auto vertex = [&](double x, double y, double z) {
    vertices += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
    ++count;
  };
  const auto face = [&](int a, int b, int c) {
    faces += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
    ++triangles;
  };
  vertex(0, 0, radius);
  for (int r = 1; r < rings; ++r)
    for (int k = 0; k < around; ++k) {
      const double theta = M_PI * r / rings, phi = 2 * M_PI * k / around;
      vertex(radius * std::sin(theta) * std::cos(phi), radius * std::sin(theta) * std::sin(phi), radius * std::cos(theta));
    }
  vertex(0, 0, -radius);
  const auto at = [&](int r, int k) { return 1 + (r - 1) * around + k % around; };
  for (int k = 0; k < around; ++k) {
    face(0, at(1, k), at(1, k + 1));
    for (int r = 1; r + 1 < rings; ++r) {
      face(at(r, k), at(r + 1, k), at(r + 1, k + 1));
      face(at(r, k), at(r + 1, k + 1), at(r, k + 1));
    }
    face(count - 1, at(rings - 1, k + 1), at(rings - 1, k));
  }
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " + std::to_string(triangles) +
         "\nproperty list uchar int vertex_indices\nend_header\n" + vertices + faces;
}

TEST(JointCommand, aRecipeBecomesAJointThatPassesItsChecks) {
  const auto folder = freshFolder();
  writeText(folder / "ball.ply", spherePly(0.02, 12));
  const Json material = {{"id", "tissue"}, {"name", "Tissue"}, {"density", 1000}, {"youngsModulus", 50000}, {"poissonRatio", 0.4}};
  const Json part = {{"id", "ball"}, {"number", 1}, {"kind", "soft"}, {"visual", "ball.ply"},
                     {"collisionTriangles", 120}, {"tetrahedra", 100}, {"materials", {{{"material", "tissue"}}}}};
  const Json recipe = {{"schemaVersion", 1}, {"id", "small"}, {"name", "Small"}, {"materials", {material}}, {"parts", {part}}};
  writeText(folder / "recipe.json", recipe.dump(2));
  const std::string quoted = "'" + folder.string() + "'", joint = "'" + (folder / "small.joint").string() + "'";
  const Outcome built = glenoidProgram("joint build " + quoted + "/recipe.json --meshes " + quoted + " --out " + joint);
  ASSERT_EQ(built.status, 0) << built.err;
  EXPECT_EQ(glenoidProgram("joint check " + joint).status, 0);
  const Json info = Json::parse(glenoidProgram("joint info " + joint + " --json").out, nullptr, false);
  ASSERT_TRUE(info.is_object());
  ASSERT_EQ(info["parts"].size(), 1u);
  EXPECT_EQ(info["parts"][0]["renderTriangles"], 2 * 24 * 11);
  EXPECT_NEAR(info["parts"][0]["tetrahedra"].get<double>(), 100, 15);
  EXPECT_FALSE(info["parts"][0].contains("published"));  // not the paper's shoulder
  // A ball of 24 × 12 facets: 4/3 π r³ less some two per cent, at 1000 kg/m³.
  EXPECT_NEAR(info["parts"][0]["volume"].get<double>(), 4.0 / 3 * M_PI * 8e-6, 0.03 * 3.35e-5);
  EXPECT_NEAR(info["parts"][0]["mass"].get<double>() / info["parts"][0]["volume"].get<double>(), 1000, 1e-3);
  for (const Json& side : info["parts"][0]["size"]) EXPECT_NEAR(side.get<double>(), 0.04, 1e-3);
  const std::string words = glenoidProgram("joint info " + joint).out;
  EXPECT_NE(words.find("mass g"), std::string::npos) << words;
  EXPECT_NE(words.find("1   ball"), std::string::npos) << "by its id where it has no name: " << words;

  std::filesystem::remove(folder / "ball.ply");
  const Outcome missing = glenoidProgram("joint build " + quoted + "/recipe.json --meshes " + quoted + " --out " + joint);
  EXPECT_EQ(missing.status, 2);
  EXPECT_EQ(lineCount(missing.err), 1) << missing.err;
  EXPECT_NE(missing.err.find("ball.ply"), std::string::npos) << missing.err;
}

TEST(JointCommand, theMirroredShoulderIsALeftOneAndMirroredTwiceTheSame) {
  const auto folder = freshFolder();
  const std::string left = "'" + (folder / "left.joint").string() + "'", back = "'" + (folder / "back.joint").string() + "'";
  const Outcome mirrored = glenoidProgram("joint mirror builtin:shoulder --out " + left);
  ASSERT_EQ(mirrored.status, 0) << mirrored.err;
  EXPECT_NE(mirrored.out.find("side left"), std::string::npos) << mirrored.out;
  EXPECT_NE(mirrored.out.find("“Right shoulder”"), std::string::npos) << "names that it changes: " << mirrored.out;
  const Json info = Json::parse(glenoidProgram("joint info " + left + " --json").out, nullptr, false);
  EXPECT_EQ(info["side"], "left");
  EXPECT_EQ(info["name"], "Left shoulder");
  EXPECT_EQ(info["license"], "GPL-3.0-or-later");
  EXPECT_NE(glenoidProgram("joint info " + left).out.find("side:        left"), std::string::npos);
  EXPECT_EQ(glenoidProgram("joint check " + left).status, 0);
  ASSERT_EQ(glenoidProgram("joint mirror " + left + " --out " + back).status, 0);
  const Json one = Json::parse(glenoidProgram("joint info builtin:shoulder --json").out, nullptr, false),
             two = Json::parse(glenoidProgram("joint info " + back + " --json").out, nullptr, false);
  EXPECT_EQ(one["hash"], two["hash"]);
  EXPECT_NE(one["hash"], info["hash"]);
  EXPECT_EQ(one["couplings"], two["couplings"]);
}

TEST(JointCommand, aScenarioIsMirroredWithJointAndHandsAndRunsAlike) {
  const auto folder = freshFolder();
  const std::string left = (folder / "left.scenario.json").string();
  ASSERT_EQ(glenoidProgram("joint mirror builtin:arthroscopy --out '" + left + "'").status, 0);
  for (const char* name : {"left.joint", "left.recording"}) EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  const auto reported = [&](const std::string& scenario, const char* name) {
    const std::string report = (folder / name).string();
    const Outcome run = glenoidProgram("run " + scenario + " --steps 60 --report '" + report + "'");
    EXPECT_EQ(run.status, 0) << run.err;
    return Json::parse(readText(report), nullptr, false);
  };
  const Json one = reported("builtin:arthroscopy", "right.json"), two = reported("'" + left + "'", "left.json");
  EXPECT_NEAR(one["penetrationMax"].get<double>(), two["penetrationMax"].get<double>(), 1e-6);
  EXPECT_NEAR(one["contacts"]["mean"].get<double>(), two["contacts"]["mean"].get<double>(), 0.5);
}

TEST(JointCommand, aRecipeIsNotMirroredAndSaysWhy) {
  const auto folder = freshFolder();
  writeText(folder / "r.json", R"({"schemaVersion": 1, "id": "r", "name": "R", "materials": [], "parts": []})");
  const Outcome outcome = glenoidProgram("joint mirror '" + (folder / "r.json").string() + "' --out '" + (folder / "x.joint").string() + "'");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(lineCount(outcome.err), 1) << outcome.err;
  EXPECT_NE(outcome.err.find("recipe"), std::string::npos) << outcome.err;
}

TEST(RenderCommand, writesAPictureOfTheAskedSizeWithoutADisplay) {
  const auto path = freshFolder() / "p.png";
  const Outcome outcome = glenoidProgram("render builtin:arthroscopy --size 96x64 --out '" + path.string() + "'");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string png = readText(path);
  ASSERT_GT(png.size(), 24u);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  const auto number = [&](std::size_t at) {  // big endian, as IHDR holds it
    unsigned value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(png[i]);
    return value;
  };
  EXPECT_EQ(number(16), 96u);
  EXPECT_EQ(number(20), 64u);
}

}  // namespace
}  // namespace glenoid::testing
