// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/app/Program.h"

namespace glenoid::testing {
namespace {

/// Status 2, nothing on stdout, one line on stderr that names what is meant.
void expectOneSentence(const std::string& arguments, const std::string& named) {
  const Outcome outcome = glenoidProgram(arguments);
  EXPECT_EQ(outcome.status, 2) << arguments;
  EXPECT_EQ(outcome.out, "") << arguments;
  EXPECT_EQ(lineCount(outcome.err), 1) << arguments << "\n" << outcome.err;
  EXPECT_NE(outcome.err.find(named), std::string::npos) << arguments << "\n" << outcome.err;
  EXPECT_EQ(outcome.err.find('%'), std::string::npos) << outcome.err;  // no place left unfilled
}

TEST(CommandLine, helpListsTheCommandsAndNeedsNoDisplay) {
  const Outcome outcome = glenoidProgram("--help");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  for (const char* command : {"run", "render", "joint", "replay", "export", "bench"})
    EXPECT_NE(outcome.out.find(std::string("\n  ") + command), std::string::npos) << outcome.out;
}

TEST(CommandLine, everyCommandHasHelp) {
  for (const char* command : {"run", "render", "joint", "joint new", "joint info", "joint check", "joint build", "joint dents", "joint mirror", "joint pack", "joint unpack", "replay", "bench"}) {
    const Outcome outcome = glenoidProgram(std::string(command) + " --help");
    EXPECT_EQ(outcome.status, 0) << command;
    EXPECT_GT(lineCount(outcome.out), 5) << command;
    EXPECT_EQ(outcome.err, "") << command;
  }
}

TEST(CommandLine, versionNamesVersionAndBuild) {
  const Outcome outcome = glenoidProgram("--version");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out.rfind("glenoid " GLENOID_VERSION " (build " GLENOID_VERSION, 0), 0u) << outcome.out;
  EXPECT_EQ(lineCount(outcome.out), 1);
}

TEST(CommandLine, badUsageGetsOneSentence) {
  expectOneSentence("frobnicate", "frobnicate");
  expectOneSentence("--frobnicate", "--frobnicate");
  expectOneSentence("run", "SCENARIO");
  expectOneSentence("run builtin:arthroscopy --seconds soon", "soon");
  expectOneSentence("run builtin:arthroscopy --seconds -1", "--seconds");
  expectOneSentence("run builtin:arthroscopy --seconds 1 --steps 3", "--steps");
  expectOneSentence("run builtin:arthroscopy --steps 0", "--steps");
  expectOneSentence("run builtin:arthroscopy --dt 0.5", "--dt");
  expectOneSentence("run builtin:arthroscopy --profile fast", "fast");
  expectOneSentence("run builtin:arthroscopy --threads 0", "--threads");
  expectOneSentence("run builtin:arthroscopy extra words", "extra");
  expectOneSentence("run builtin:arthroscopy --steps 1 --effects friction", "friction");
  expectOneSentence("run builtin:arthroscopy --steps 1 --effects wobble=on", "wobble");
  expectOneSentence("run builtin:arthroscopy --steps 1 --effects gravity=maybe", "maybe");
  expectOneSentence("render builtin:shoulder", "--out");
  expectOneSentence("render builtin:shoulder --out x.png --size 12by9", "1280x960");
  expectOneSentence("render builtin:shoulder --out x.png --size 0x9", "0");
  expectOneSentence("render builtin:shoulder --out x.png --layers colour", "colour");
  expectOneSentence("render builtin:shoulder --out x.png --camera nowhere", "nowhere");
  expectOneSentence("render builtin:shoulder --out x.png --sheet upwards", "upwards");
  expectOneSentence("render builtin:shoulder --out x.png --part elbow", "elbow");
  expectOneSentence("joint", "subcommand");
  expectOneSentence("joint polish builtin:shoulder", "polish");
  expectOneSentence("joint mirror builtin:shoulder", "--out");
  expectOneSentence("joint mirror builtin:shoulder --out x.scenario.json", ".joint");
  expectOneSentence("joint mirror builtin:arthroscopy --out x.joint", ".scenario.json");
  expectOneSentence("replay", "RECORDING");
  expectOneSentence("bench --sections growth,speed", "speed");
}

TEST(CommandLine, whatIsNotThereGetsOneSentence) {
  expectOneSentence("run builtin:elbow", "elbow");
  expectOneSentence("run nowhere/x.scenario.json", "nowhere/x.scenario.json");
  expectOneSentence("run builtin:arthroscopy --steps 1 --input nowhere.recording", "nowhere.recording");
  expectOneSentence("joint info nowhere.joint", "nowhere.joint");
  expectOneSentence("joint pack builtin:shoulder shoulder.zip", "NAME.jointz");
  expectOneSentence("joint unpack nowhere.jointz somewhere.joint", "nowhere.jointz");
  expectOneSentence("joint new /nowhere/at/all", "/nowhere/at/all");
  expectOneSentence("joint new x --kind wing", "elbow, knee");
  expectOneSentence("run builtin:shoulder", "is a joint, and a scenario is wanted");
  expectOneSentence("joint check builtin:elbow", "elbow");
  expectOneSentence("joint mirror nowhere.joint --out x.joint", "nowhere.joint");
  expectOneSentence("replay nowhere.recording", "nowhere.recording");
  expectOneSentence("render nowhere.joint --out x.png", "nowhere.joint");
  expectOneSentence("nowhere.scenario.json", "nowhere.scenario.json");
}

TEST(CommandLine, whatCannotBeWrittenGetsOneSentence) {
  expectOneSentence("run builtin:arthroscopy --steps 1 --report /nonexistent/r.json", "/nonexistent/r.json");
  expectOneSentence("run builtin:arthroscopy --steps 1 --record /nonexistent/r.recording", "/nonexistent/r.recording");
  expectOneSentence("render builtin:shoulder --size 8x8 --out /nonexistent/p.png", "/nonexistent/p.png");
}

/// One way to spoil a scenario file, and what the sentence must name.
struct Spoiled {
  const char* name;
  std::string (*spoil)(std::string);
  const char* named;
};

/// The text with the first `from` exchanged; fails the test when it is not there.
std::string exchanged(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

class SpoiledScenario : public ::testing::TestWithParam<Spoiled> {};

TEST_P(SpoiledScenario, getsOneSentenceThatNamesFileAndPlace) {
  const std::string good = readText(GLENOID_SOURCE_DIR "/resources/scenarios/arthroscopy.scenario.json");
  ASSERT_FALSE(good.empty());
  const auto path = freshFolder() / "spoiled.scenario.json";
  writeText(path, GetParam().spoil(good));
  expectOneSentence("run '" + path.string() + "' --steps 1", "spoiled.scenario.json");
  expectOneSentence("run '" + path.string() + "' --steps 1", GetParam().named);
}

INSTANTIATE_TEST_SUITE_P(Files, SpoiledScenario, ::testing::Values(
  Spoiled{"empty", [](std::string) { return std::string(); }, "empty"},
  Spoiled{"truncated", [](std::string s) { return s.substr(0, s.size() / 2); }, "ends before"},
  Spoiled{"noJson", [](std::string) { return std::string("solid cube\n"); }, "line 1"},
  Spoiled{"deep", [](std::string) { return std::string(100000, '['); }, "nested"},
  Spoiled{"newer", [](std::string s) { return exchanged(s, "\"schemaVersion\": 2", "\"schemaVersion\": 999"); }, "999"},
  Spoiled{"notFinite", [](std::string s) { return exchanged(s, "\"dt\": 0.005", "\"dt\": NaN"); }, "/dt"},
  Spoiled{"outOfRange", [](std::string s) { return exchanged(s, "\"dt\": 0.005", "\"dt\": -1"); }, "/dt"},
  Spoiled{"unknownPart", [](std::string s) { return exchanged(s, "\"scapula\"", "\"shinbone\""); }, "shinbone"},
  Spoiled{"noJoint", [](std::string s) { return exchanged(s, "builtin:shoulder", "builtin:ankle"); }, "ankle"}),
  [](const auto& spoiled) { return spoiled.param.name; });

}  // namespace
}  // namespace glenoid::testing
