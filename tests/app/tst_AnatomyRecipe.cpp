// SPDX-License-Identifier: GPL-3.0-or-later
// The author's pipeline on surfaces of a real shoulder, by the commands: one recipe, one joint, ten seconds of it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "simcore/author/Overlaps.h"
#include "simcore/mesh/TetTools.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/Start.h"
#include "simcore/spatial/Intersect.h"
#include "simcore/spatial/TriangleTree.h"
#include "tests/MachineSpeed.h"
#include "tests/app/Program.h"
#include "tests/resources/ReferenceMesh.h"

namespace glenoid {
namespace {

using namespace glenoid::testing;
using Json = nlohmann::json;
namespace fs = std::filesystem;

/// Built once, by the command.
struct Built {
  fs::path folder;
  Outcome outcome;

  static const Built& anatomy(const std::string& meshes) {
    static const Built built = [&] {
      Built made;
      made.folder = freshFolder();
      made.outcome = glenoidProgram("joint build '" GLENOID_SOURCE_DIR "/tests/recipes/anatomy.json' --meshes '" + meshes + "' --out '" +
                                    (made.folder / "anatomy.joint").string() + "'");
      fs::copy_file(GLENOID_SOURCE_DIR "/tests/recipes/anatomy.scenario.json", made.folder / "anatomy.scenario.json");
      return made;
    }();
    return built;
  }
};

#define NEEDS_ANATOMY(folder)                                                                                  \
  const auto folder = test::referenceFolder();                                                                 \
  if (!folder) GTEST_SKIP() << "the third-party surfaces are not here; GLENOID_ANATOMY may name their folder"

TEST(AnatomyRecipe, oneCommandMakesAJointThatStartsWithoutIntersections) {
  NEEDS_ANATOMY(meshes);
  const Built& built = Built::anatomy(*meshes);
  ASSERT_EQ(built.outcome.status, 0) << built.outcome.err << built.outcome.out;
  std::fputs(built.outcome.out.c_str(), stdout);
  const auto joint = loadJoint((built.folder / "anatomy.joint").string());
  ASSERT_TRUE(joint.ok()) << toLogLine(joint.error());
  EXPECT_EQ(joint->parts.size(), 8u);
  EXPECT_EQ(joint->couplings.size(), 11u);
  ASSERT_TRUE(joint->startProof);
  EXPECT_EQ(joint->startProof->of, startHash(*joint));
  EXPECT_EQ(joint->startProof->cuts, 0);
  EXPECT_GT(joint->startProof->minVolumeRatio, 0.1);

  // Looked at again here, on surfaces rebuilt from the nodes, and beside the rest state, where eight pairs overlap.
  Joint atRest = *joint;
  atRest.cages.clear();
  const auto before = overlapsAtStart(atRest);
  ASSERT_TRUE(before.ok());
  EXPECT_GE(before->size(), 8u);
  const auto surfaces = startSurfaces(*joint, SurfaceKind::Collision);
  ASSERT_TRUE(surfaces.ok());
  for (const auto& [a, b] : pairsThatMayCollide(*joint)) {
    EXPECT_TRUE(intersectingTriangles((*surfaces)[a], (*surfaces)[b]).empty()) << joint->parts[a].id << " " << joint->parts[b].id;
    const TriangleTree tree((*surfaces)[a]);
    for (const Vec3& p : (*surfaces)[b].vertices) ASSERT_FALSE(tree.inside(p)) << joint->parts[a].id << " " << joint->parts[b].id;
  }
  for (const Part& part : joint->parts) {
    if (!part.volume) continue;
    const auto nodes = startNodes(*joint, part);
    ASSERT_TRUE(nodes.ok());
    const TetMesh moved{*nodes, part.volume->tets};
    for (int tet = 0; tet < static_cast<int>(moved.tets.size()); ++tet)
      ASSERT_GT(tetVolume(moved, tet), 0.1 * tetVolume(*part.volume, tet)) << part.id << " " << tet;
  }
}

TEST(AnatomyRecipe, theJointRunsTenSecondsFasterThanRealTime) {
  NEEDS_ANATOMY(meshes);
  const Built& built = Built::anatomy(*meshes);
  ASSERT_EQ(built.outcome.status, 0) << built.outcome.err;
  const std::string scenario = "'" + (built.folder / "anatomy.scenario.json").string() + "'";
  const std::string report = (built.folder / "report.json").string();
  const test::SlownessAround machine;
  const Outcome run = glenoidProgram("run " + scenario + " --seconds 10 --report '" + report + "'");
  ASSERT_EQ(run.status, 0) << run.err;
  std::fputs(run.out.c_str(), stdout);
  const Json figures = Json::parse(readText(report));
  EXPECT_TRUE(figures["finite"].get<bool>());
  EXPECT_EQ(figures["rejectedSteps"], 0);
  EXPECT_EQ(figures["steps"], 2000);
  // By the clock of the thread, since tests run beside each other: 2000 steps of 5 ms.
  EXPECT_GT(figures["stepsPerCpuSecond"].get<double>(), 200 / machine.worst());
  // The start is relaxed, not thrown apart: parts that have been separated do not sink back into each other.
  EXPECT_LT(figures["penetrationMax"].get<double>(), 2e-3);
}

TEST(AnatomyRecipe, theSameRecipeGivesTheSameJoint) {
  NEEDS_ANATOMY(meshes);
  const Built& built = Built::anatomy(*meshes);
  const std::string again = (built.folder / "again.joint").string();
  ASSERT_EQ(glenoidProgram("joint build '" GLENOID_SOURCE_DIR "/tests/recipes/anatomy.json' --meshes '" + *meshes + "' --out '" + again + "'").status, 0);
  EXPECT_EQ(readText(fs::path(again) / "joint.json"), readText(built.folder / "anatomy.joint" / "joint.json"));
}

}  // namespace
}  // namespace glenoid
