// SPDX-License-Identifier: GPL-3.0-or-later
// `glenoid joint check` and `glenoid export` as programs use them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "simcore/scene/JointFile.h"
#include "tests/app/Program.h"
#include "tests/simcore/check/Faults.h"

namespace glenoid::testing {
namespace {

using Json = nlohmann::json;

/// The joint on disk, between quotes for the shell.
std::string saved(const Joint& joint, const std::filesystem::path& folder) {
  const std::string path = (folder / "test.joint").string();
  const auto done = saveJoint(joint, path);
  EXPECT_TRUE(done.ok()) << toLogLine(done.error());
  return "'" + path + "'";
}

Joint sunkJoint() {
  Joint joint = scenes::blockOnPlateJoint();
  Part& block = softPart(joint);
  const auto lower = [](auto& points) { for (Vec3& x : points) x.y() -= 2.5e-3; };
  changeMesh(block.visual, [&](TriMesh& m) { lower(m.vertices); });
  changeMesh(block.collision, [&](TriMesh& m) { lower(m.vertices); });
  changeMesh(block.volume, [&](TetMesh& m) { lower(m.nodes); });
  return joint;
}

TEST(JointCheckCommand, aSoundJointHoldsAndSaysWhatWasLookedAt) {
  const Outcome outcome = glenoidProgram("joint check " + saved(soundJoint(), freshFolder()) + " --json");
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const Json json = Json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << outcome.out;
  EXPECT_EQ(json["holds"], true);
  EXPECT_TRUE(json["problems"].empty());
  EXPECT_EQ(json["surfaces"].size(), 6u);
  EXPECT_EQ(json["couplings"], 2);
  EXPECT_GE(json["springsMin"], 4);
}

TEST(JointCheckCommand, anErrorGivesStatusOneASentenceAndItsFigures) {
  const std::string joint = saved(sunkJoint(), freshFolder());
  const Outcome words = glenoidProgram("joint check " + joint);
  EXPECT_EQ(words.status, 1);
  EXPECT_EQ(lineCount(words.err), 1) << words.err;
  EXPECT_NE(words.out.find("error: “"), std::string::npos) << words.out;
  EXPECT_NE(words.out.find("cut each other at the start"), std::string::npos) << words.out;
  EXPECT_NE(words.out.find("deepest 2 mm"), std::string::npos) << words.out;
  EXPECT_NE(words.out.find("fix: Separate"), std::string::npos) << words.out;
  EXPECT_EQ(words.out.find("All checks hold"), std::string::npos);
  EXPECT_EQ(words.out.find("%1"), std::string::npos) << words.out;

  const Outcome outcome = glenoidProgram("joint check " + joint + " --json");
  EXPECT_EQ(outcome.status, 1);
  const Json json = Json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << outcome.out;
  EXPECT_EQ(json["holds"], false);
  EXPECT_EQ(json["errors"], 1);
  const auto overlap = std::find_if(json["problems"].begin(), json["problems"].end(),
                                    [](const Json& problem) { return problem["kind"] == "overlap"; });
  ASSERT_NE(overlap, json["problems"].end()) << outcome.out;
  EXPECT_NEAR((*overlap)["figure"].get<double>(), 2e-3, 1e-9);
  EXPECT_EQ((*overlap)["severity"], "error");
  ASSERT_EQ(json["startIntersections"].size(), 1u);
  EXPECT_EQ(json["startIntersections"][0]["trianglePairs"], (*overlap)["count"]);
}

TEST(JointCheckCommand, warningsAndNotesDoNotFail) {
  Joint joint = soundJoint();
  joint.couplings.clear();
  const Outcome outcome = glenoidProgram("joint check " + saved(joint, freshFolder()));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("warning: Nothing holds"), std::string::npos) << outcome.out;
}

TEST(JointCheckCommand, aFolderThatCannotBeReadGivesStatusTwo) {
  const auto folder = freshFolder();
  const std::string joint = saved(soundJoint(), folder);
  writeText(folder / "test.joint" / "joint.json", "{");
  const Outcome outcome = glenoidProgram("joint check " + joint);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(lineCount(outcome.err), 1) << outcome.err;
}

TEST(ExportCommand, writesEveryFormatAndSaysWhatIsLost) {
  const auto folder = freshFolder();
  const std::string joint = saved(soundJoint(), folder);
  for (const char* format : {"msh", "vtu", "scn", "feb", "glb"}) {
    const auto file = folder / (std::string("x.") + format);
    const Outcome outcome = glenoidProgram("export " + joint + " --format " + format + " --out '" + file.string() + "'");
    EXPECT_EQ(outcome.status, 0) << format << outcome.err;
    EXPECT_NE(outcome.out.find("What the file does not hold:"), std::string::npos) << outcome.out;
    EXPECT_GT(std::filesystem::file_size(file), 1000u) << format;
  }
}

TEST(ExportCommand, badWishesGetOneSentence) {
  const auto folder = freshFolder();
  const std::string joint = saved(soundJoint(), folder), out = " --out '" + (folder / "x").string() + "'";
  for (const auto& [arguments, named] : std::vector<std::pair<std::string, std::string>>{
           {"export " + joint + " --format doc" + out, "doc"},
           {"export " + joint + " --format msh --part elbow" + out, "elbow"},
           {"export " + joint + " --format msh --part left" + out, "left"},  // rigid: no volume
           {"export " + joint + " --format msh --out /nonexistent/x.msh", "/nonexistent/x.msh"},
           {"export nowhere.joint --format msh" + out, "nowhere.joint"},
           {"export " + joint + " --format msh", "--out"}}) {
    const Outcome outcome = glenoidProgram(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_EQ(lineCount(outcome.err), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(named), std::string::npos) << outcome.err;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "x"));
}

}  // namespace
}  // namespace glenoid::testing
