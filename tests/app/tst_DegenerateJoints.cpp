// SPDX-License-Identifier: GPL-3.0-or-later
// Every command that takes a joint, on joints that nobody should have made: it ends by itself, soon, and in a sentence.
// GLENOID_LONG=1 takes three hundred of them instead of some dozen.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>

#include "tests/app/DegenerateJoints.h"
#include "tests/app/Program.h"

namespace glenoid::testing {
namespace {

namespace fs = std::filesystem;

/// Seconds of processor time and bytes that one command may take; children inherit it. Under a sanitizer memory is not counted so.
void limitChildren() {
  const rlimit seconds{120, 130};
  setrlimit(RLIMIT_CPU, &seconds);
  const rlimit core{0, 0};
  setrlimit(RLIMIT_CORE, &core);
}

bool everything() {
  const char* wish = std::getenv("GLENOID_LONG");
  return wish && *wish && *wish != '0';
}

void tryCommand(const std::string& command, const std::string& what, unsigned seed) {
  const Outcome outcome = glenoidProgram(command);
  SCOPED_TRACE("seed " + std::to_string(seed) + " (" + what + "): glenoid " + command);
  EXPECT_TRUE(outcome.status >= 0 && outcome.status <= 2) << "status " << outcome.status << "\n" << outcome.err.substr(0, 2000);
  if (outcome.status == 0) return;
  EXPECT_EQ(lineCount(outcome.err), 1) << outcome.err.substr(0, 2000);
  EXPECT_EQ(outcome.err.find("error of ours"), std::string::npos) << outcome.err.substr(0, 2000);
  EXPECT_EQ(outcome.err.find("%1"), std::string::npos) << outcome.err.substr(0, 2000);
}

TEST(DegenerateJoints, everyCommandEndsInASentence) {
  limitChildren();
  const fs::path base = freshFolder();
  const unsigned count = everything() ? 300 : 24;
  const std::vector<std::string> formats{"msh", "vtu", "scn", "feb", "glb", "inp"};
  for (unsigned seed = 1; seed <= count; ++seed) {
    const fs::path joint = base / ("n" + std::to_string(seed) + ".joint");
    const std::string what = writeDegenerateJoint(seed, joint), word = "'" + joint.string() + "'", out = "'" + (base / "out").string();
    const fs::path scenario = base / ("n" + std::to_string(seed) + ".scenario.json");
    writeText(scenario, "{\"schemaVersion\": 2, \"id\": \"n\", \"name\": \"N\", \"joint\": \"" + joint.filename().string() + "\"}");
    const auto written = [&](const std::string& format) { return "export " + word + " --format " + format + " --out " + out + "." + format + "'"; };
    std::vector<std::string> commands{"joint check " + word, "joint info " + word, written(formats[seed % formats.size()]), "run '" + scenario.string() + "' --steps 3",
                                      "joint pack " + word + " " + out + ".jointz'", "joint mirror " + word + " --out " + out + "-other.joint'"};
    if (everything() || seed % 6 == 0) commands.push_back("render " + word + " --size 160x120 --out " + out + ".png'");
    if (everything() || seed == 12) commands.push_back("joint dents " + word + " --out " + out + ".joint'");  // takes half a minute of a sound joint
    if (everything()) {
      for (const std::string& format : formats) commands.push_back(written(format));
      commands.push_back("joint check " + word + " --json");
      commands.push_back("joint info " + word + " --json");
      for (const char* sheet : {"anatomy", "meshes", "cage"}) commands.push_back("render " + word + " --size 160x120 --sheet " + sheet + " --out " + out + ".png'");
      commands.push_back("render '" + scenario.string() + "' --size 160x120 --time 0.01 --colour stress --layers visual,dynamics,couplings,regions --out " + out + ".png'");
    }
    for (const std::string& command : commands) tryCommand(command, what, seed);
    if (::testing::Test::HasFailure()) continue;  // what failed can be looked at
    fs::remove_all(joint);
    fs::remove_all(base / "out-other.joint");
  }
}

TEST(DegenerateJoints, everyRecipeIsBuiltOrRefusedInASentence) {
  limitChildren();
  const fs::path base = freshFolder();
  const unsigned count = everything() ? 150 : 20;
  for (unsigned seed = 1; seed <= count; ++seed) {
    const fs::path folder = base / ("n" + std::to_string(seed));
    const std::string what = writeDegenerateRecipe(seed, folder);
    tryCommand("joint build '" + (folder / "recipe.json").string() + "' --out '" + (folder / "out.joint").string() + "'", what, seed);
    if (!::testing::Test::HasFailure()) fs::remove_all(folder);
  }
}

}  // namespace
}  // namespace glenoid::testing
