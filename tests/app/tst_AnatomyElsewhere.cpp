// SPDX-License-Identifier: GPL-3.0-or-later
// The start of a joint of scanned parts does not depend on where the scan lies: shifted, mirrored, turned, the same moves,
// volume ratios and depth in the run.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "simcore/file/Ply.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecipeFile.h"
#include "simcore/scene/Start.h"
#include "tests/app/Program.h"
#include "tests/resources/ReferenceMesh.h"
#include "tests/simcore/author/Elsewhere.h"

namespace glenoid {
namespace {

using namespace glenoid::testing;
using Json = nlohmann::json;
namespace fs = std::filesystem;

Json fromVec3(const Vec3& v) { return Json::array({v.x(), v.y(), v.z()}); }
Vec3 toVec3(const Json& json) { return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()}; }

struct Figures {
  std::map<std::string, double> moves;  ///< mm, of each part with a cage
  double leastRatio = 0, penetration = 0;  ///< −, mm
  std::string out;
};

/// Writes the recipe's surfaces where `motion` takes them, builds the joint by the command and runs it for three seconds.
Figures madeAt(const JointRecipe& recipe, const Isometry& motion, const fs::path& folder) {
  fs::create_directories(folder / "meshes");
  Json json = Json::parse(readText(GLENOID_SOURCE_DIR "/tests/recipes/anatomy.json"));
  json.erase("source");
  const JointRecipe moved = test::movedRecipe(recipe, motion);
  for (std::size_t i = 0; i < moved.parts.size(); ++i) {
    const std::string name = moved.parts[i].id + ".ply";
    EXPECT_TRUE(writePly((folder / "meshes" / name).string(), *moved.parts[i].visual).ok());
    json["parts"][i]["visual"] = name;
    json["parts"][i].erase("source");
  }
  for (Json& coupling : json["couplings"])
    if (coupling.contains("ball")) coupling["ball"]["centre"] = fromVec3(motion * toVec3(coupling["ball"]["centre"]));
  writeText(folder / "recipe.json", json.dump());
  Json scenario = Json::parse(readText(GLENOID_SOURCE_DIR "/tests/recipes/anatomy.scenario.json"));
  scenario["gravity"] = fromVec3(motion.R * toVec3(scenario["gravity"]));
  writeText(folder / "anatomy.scenario.json", scenario.dump());

  Figures figures;
  const std::string joint = (folder / "anatomy.joint").string(), report = (folder / "report.json").string();
  const Outcome build = glenoidProgram("joint build '" + (folder / "recipe.json").string() + "' --meshes '" + (folder / "meshes").string() +
                                       "' --out '" + joint + "'");
  EXPECT_EQ(build.status, 0) << build.err << build.out;
  figures.out = build.out;
  const auto loaded = loadJoint(joint);
  if (!loaded.ok() || !loaded->startProof) return figures;
  figures.leastRatio = loaded->startProof->minVolumeRatio;
  for (const Part& part : loaded->parts) {
    if (!findCage(*loaded, part.id)) continue;
    const auto start = startSurface(*loaded, part, SurfaceKind::Collision);
    double& most = figures.moves[part.id];
    for (std::size_t v = 0; v < start->vertices.size(); ++v)
      most = std::max(most, 1e3 * (start->vertices[v] - part.collision->vertices[v]).norm());
  }
  const Outcome run = glenoidProgram("run '" + (folder / "anatomy.scenario.json").string() + "' --seconds 3 --report '" + report + "'");
  EXPECT_EQ(run.status, 0) << run.err;
  figures.penetration = 1e3 * Json::parse(readText(report))["penetrationMax"].get<double>();
  return figures;
}

TEST(AnatomyElsewhere, theSameStartAndTheSameRun) {
  const auto meshes = test::referenceFolder();
  if (!meshes) GTEST_SKIP() << "the third-party surfaces are not here; GLENOID_ANATOMY may name their folder";
  const auto recipe = loadRecipe(GLENOID_SOURCE_DIR "/tests/recipes/anatomy.json", *meshes);
  ASSERT_TRUE(recipe.ok()) << toLogLine(recipe.error());
  const fs::path folder = freshFolder();
  const Figures here = madeAt(*recipe, {}, folder / "here");
  std::fputs(here.out.c_str(), stdout);
  int number = 0;
  std::vector<test::Place> places = test::elsewhere();
  if (!std::getenv("GLENOID_LONG")) places.erase(places.begin(), places.end() - 1);  // all of it at once; each by itself takes minutes
  for (const test::Place& place : places) {
    SCOPED_TRACE(place.name);
    const Figures there = madeAt(*recipe, place.motion, folder / std::to_string(number++));
    std::printf("%s: least ratio %.4f and %.4f, penetration %.4f and %.4f mm\n", place.name, here.leastRatio, there.leastRatio,
                here.penetration, there.penetration);
    EXPECT_NEAR(there.leastRatio, here.leastRatio, 0.01 * here.leastRatio);
    EXPECT_NEAR(there.penetration, here.penetration, 0.01 * here.penetration);
    ASSERT_EQ(there.moves.size(), here.moves.size());
    for (const auto& [part, move] : here.moves) {
      std::printf("  %-24s %.4f and %.4f mm\n", part.c_str(), move, there.moves.at(part));
      EXPECT_NEAR(there.moves.at(part), move, 0.01 * move) << part;
    }
  }
}

}  // namespace
}  // namespace glenoid
