// SPDX-License-Identifier: GPL-3.0-or-later
// The joints that newcomers begin with, as they would: made, built, checked, run, edited.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "simcore/scene/JointFile.h"
#include "simcore/spatial/Intersect.h"
#include "simcore/starter/Starter.h"
#include "tests/MachineSpeed.h"
#include "tests/app/Program.h"

namespace glenoid::testing {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

/// Made and built once for each kind.
struct Started {
  std::string kind;
  fs::path folder;
  Outcome made, built;

  fs::path joint() const { return folder / (kind + ".joint"); }
  fs::path scenario() const { return folder / (kind + ".scenario.json"); }

  static const Started& of(const std::string& kind) {
    static std::map<std::string, Started> all;
    if (const auto found = all.find(kind); found != all.end()) return found->second;
    Started started{kind, freshFolder() / "my", {}, {}};
    started.made = glenoidProgram("joint new " + quoted(started.folder) + " --kind " + kind);
    started.built = glenoidProgram("joint build " + quoted(started.folder / "recipe.json") + " --out " + quoted(started.joint()));
    return all[kind] = started;
  }
};

class JointStarters : public ::testing::TestWithParam<std::string> {};

TEST_P(JointStarters, areMadeBuiltAndHold) {
  const Started& started = Started::of(GetParam());
  ASSERT_EQ(started.made.status, 0) << started.made.err;
  ASSERT_EQ(started.built.status, 0) << started.built.err << started.built.out;
  const std::string readme = readText(started.folder / "README.md");
  EXPECT_EQ(readme.find('@'), std::string::npos) << "every mark is filled";
  EXPECT_NE(readme.find("X points forward, Y up, Z to the right"), std::string::npos);
  EXPECT_NE(readme.find("| Muscle, relaxed | 1.06e+03 | 2.5e+04 | 0.45 |"), std::string::npos) << readme;
  const Outcome check = glenoidProgram("joint check " + quoted(started.scenario()) + " --json");
  ASSERT_EQ(check.status, 0) << check.err << check.out;
  const Json figures = Json::parse(check.out);
  EXPECT_EQ(figures["errors"], 0);
  EXPECT_EQ(figures["warnings"], 0) << check.out;
  EXPECT_TRUE(figures["startIntersections"].empty());
  EXPECT_EQ(figures["couplings"], 4);

  const auto joint = loadJoint(started.joint().string());
  ASSERT_TRUE(joint.ok()) << toLogLine(joint.error());
  EXPECT_EQ(joint->parts.size(), 4u);
  EXPECT_EQ(joint->side, JointSide::Right) << "as its name says, so that letters and cameras know it";
  for (std::size_t a = 0; a < joint->parts.size(); ++a)
    for (std::size_t b = a + 1; b < joint->parts.size(); ++b)
      if (joint->parts[a].kind == PartKind::Rigid && joint->parts[b].kind == PartKind::Rigid) {
        EXPECT_TRUE(intersectingTriangles(*joint->parts[a].visual, *joint->parts[b].visual).empty()) << a << " " << b;
      }
}

TEST_P(JointStarters, runFasterThanRealTimeAndStayOutOfEachOther) {
  const Started& started = Started::of(GetParam());
  ASSERT_EQ(started.built.status, 0) << started.built.err;
  const fs::path report = started.folder / "report.json";
  const test::SlownessAround machine;
  const Outcome run = glenoidProgram("run " + quoted(started.scenario()) + " --seconds 4 --report " + quoted(report) + " --state " + quoted(started.folder / "state.json"));
  ASSERT_EQ(run.status, 0) << run.err << run.out;
  std::fputs(run.out.c_str(), stdout);
  const Json figures = Json::parse(readText(report));
  EXPECT_TRUE(figures["finite"].get<bool>());
  EXPECT_EQ(figures["rejectedSteps"], 0);
  EXPECT_EQ(figures["steps"], 800);
  EXPECT_GT(figures["stepsPerCpuSecond"].get<double>(), 200 / machine.worst()) << "steps of 5 ms";
  // A quarter of the contact distance; the bones are pressed together with 20 and 40 N.
  EXPECT_LT(figures["penetrationMax"].get<double>(), 3e-4);
  EXPECT_GT(figures["contacts"]["max"].get<int>(), 0) << "the bones do touch";
  for (const Json& notice : figures["notices"]) ADD_FAILURE() << notice.dump();
}

TEST_P(JointStarters, areTheSameEachTime) {
  const Started& started = Started::of(GetParam());
  const fs::path again = freshFolder() / "again";
  ASSERT_EQ(glenoidProgram("joint new " + quoted(again) + " --kind " + GetParam()).status, 0);
  for (const auto& mesh : fs::directory_iterator(started.folder / "meshes"))
    EXPECT_EQ(readText(mesh.path()), readText(again / "meshes" / mesh.path().filename())) << mesh.path();
}

std::vector<std::string> kinds() {
  std::vector<std::string> names;
  for (const StarterKind& kind : starterKinds()) names.push_back(kind.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(Each, JointStarters, ::testing::ValuesIn(kinds()), [](const auto& info) { return info.param; });

TEST(JointNew, anEditedRecipeGivesAnotherJoint) {
  const Started& started = Started::of("knee");
  Json recipe = Json::parse(readText(started.folder / "recipe.json"));
  recipe["materials"][1]["youngsModulus"] = 8e6;
  recipe["parts"][0]["collisionTriangles"] = 400;
  const fs::path edited = started.folder / "edited.json", joint = started.folder / "edited.joint";
  writeText(edited, recipe.dump());
  const Outcome built = glenoidProgram("joint build " + quoted(edited) + " --meshes " + quoted(started.folder / "meshes") + " --out " + quoted(joint));
  ASSERT_EQ(built.status, 0) << built.err << built.out;
  const auto loaded = loadJoint(joint.string());
  ASSERT_TRUE(loaded.ok());
  EXPECT_EQ(loaded->materials[1].youngsModulus, 8e6);
  EXPECT_LE(loaded->parts[0].collision->triangles.size(), 400u);
}

TEST(JointNew, nothingIsWrittenOverAndWrongWordsAreNamed) {
  const fs::path folder = freshFolder();
  writeText(folder / "mine.txt", "mine");
  const Outcome full = glenoidProgram("joint new " + quoted(folder));
  EXPECT_EQ(full.status, 2);
  EXPECT_EQ(lineCount(full.err), 1) << full.err;
  EXPECT_FALSE(fs::exists(folder / "recipe.json"));
  const Outcome kind = glenoidProgram("joint new " + quoted(folder / "new") + " --kind wing");
  EXPECT_EQ(kind.status, 2);
  EXPECT_NE(kind.err.find("elbow, knee"), std::string::npos) << kind.err;
  EXPECT_FALSE(fs::exists(folder / "new"));
  EXPECT_EQ(glenoidProgram("joint new " + quoted(folder / "no" / "such")).status, 2);
}

}  // namespace
}  // namespace glenoid::testing
