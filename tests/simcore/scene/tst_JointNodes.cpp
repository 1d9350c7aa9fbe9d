// SPDX-License-Identifier: GPL-3.0-or-later
// Couplings at picked nodes in joint.json and in recipes.
#include <gtest/gtest.h>

#include "simcore/file/Ply.h"
#include "simcore/scene/DraftFile.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecipeFile.h"
#include "tests/simcore/file/TemporaryFolder.h"
#include "tests/simcore/scene/SampleJoint.h"

namespace glenoid {
namespace {

/// The sample with its tendon held at three of its four nodes.
Joint atNodes() {
  Joint joint = sampleJoint();
  Coupling& coupling = joint.couplings[0];
  coupling.regionA.clear();
  coupling.stiffnessPerArea = 0;
  coupling.nodesA = {3, 0, 2};
  coupling.stiffnessPerNode = 1250.0 / 3;
  return joint;
}

TEST(JointNodes, areSavedReadAndSavedAgain) {
  const TemporaryFolder folder;
  const std::string path = folder.path("s.joint");
  ASSERT_TRUE(saveJoint(atNodes(), path).ok());
  const auto back = loadJoint(path);
  ASSERT_TRUE(back.ok()) << toLogLine(back.error());
  expectSame(*back, atNodes());
  EXPECT_EQ(back->couplings[0].nodesA, (std::vector<int>{3, 0, 2})) << "in their order";
  EXPECT_EQ(jointHash(*back), jointHash(atNodes()));
  EXPECT_NE(jointHash(*back), jointHash(sampleJoint()));
  const std::string text = folder.get("s.joint/joint.json");
  EXPECT_EQ(text.find("regionA"), std::string::npos);
  EXPECT_EQ(text.find("stiffnessPerArea"), std::string::npos);
  ASSERT_TRUE(saveJoint(*back, path).ok());
  EXPECT_EQ(folder.get("s.joint/joint.json"), text);
  // One over a region is written as ever.
  ASSERT_TRUE(saveJoint(sampleJoint(), path).ok());
  EXPECT_EQ(folder.get("s.joint/joint.json").find("nodesA"), std::string::npos);
  EXPECT_EQ(folder.get("s.joint/joint.json").find("stiffnessPerNode"), std::string::npos);
}

TEST(JointNodes, aDraftKeepsWhatIsBroken) {
  const TemporaryFolder folder;
  Joint joint = atNodes();
  joint.couplings[0].nodesA = {0, 0, 99};
  joint.couplings[0].regionA = "insertion";
  EXPECT_FALSE(checkJoint(joint, {}).ok());
  std::filesystem::create_directory(folder.path("1"));
  ASSERT_TRUE(saveDraft({joint, {}}, folder.path("1"), folder.path("blobs")).ok());
  EXPECT_EQ(loadDraft(folder.path("1"))->joint.couplings, joint.couplings);
}

TEST(JointNodes, everySlipIsNamedWithItsPlace) {
  struct Slip {
    const char *what, *by;
    Fault fault;
    const char *pointer, *part;
    Arguments arguments;
  };
  const std::string nodes = "\"nodesA\": [3, 0, 2]";
  const std::vector<Slip> slips = {
      {"\"nodesA\": [3, 0, 2]", "\"nodesA\": [3, 0, 2], \"regionA\": \"insertion\"", Fault::BadNodes, "/couplings/0/nodesA", "cuff-humerus", {"both"}},
      {"\"nodesA\": [3, 0, 2],", "", Fault::BadNodes, "/couplings/0", "cuff-humerus", {"neither"}},
      {"\"nodesA\": [3, 0, 2]", "\"nodesA\": []", Fault::BadNodes, "/couplings/0", "cuff-humerus", {"neither"}},
      {"\"nodesA\": [3, 0, 2]", "\"nodesA\": [3, 0, 3]", Fault::BadNodes, "/couplings/0/nodesA/2", "cuff-humerus", {"twice", "3"}},
      {"\"nodesA\": [3, 0, 2]", "\"nodesA\": [3, 4, 2]", Fault::BadNodes, "/couplings/0/nodesA/1", "cuff-humerus", {"outside", "4", "3"}},
      {"\"nodesA\": [3, 0, 2]", "\"nodesA\": [3, -1, 2]", Fault::OutOfRange, "/couplings/0/nodesA/1", "", {"-1", "0", "2147483647"}},
      {"\"nodesA\": [3, 0, 2]", "\"nodesA\": [3, 1.5, 2]", Fault::SchemaMismatch, "/couplings/0/nodesA/1", "", {}},
      {"\"stiffnessPerNode\"", "\"stiffnessPerArea\"", Fault::BadNodes, "/couplings/0/stiffnessPerArea", "cuff-humerus", {"unit"}},
      {"\"stiffnessPerNode\": 416.6666666666667,", "", Fault::SchemaMismatch, "/couplings/0", "cuff-humerus", {"member \"stiffnessPerNode\" is missing"}},
      {"\"stiffnessPerNode\"", "\"stiffnessPerArea\": 1, \"stiffnessPerNode\"", Fault::BadNodes, "/couplings/0/stiffnessPerArea", "cuff-humerus", {"unit"}},
  };
  for (const Slip& slip : slips) {
    const TemporaryFolder folder;
    ASSERT_TRUE(saveJoint(atNodes(), folder.path("s.joint")).ok());
    std::string text = folder.get("s.joint/joint.json");
    // Lists of numbers stand on lines of their own: bring this one to one line first.
    const std::size_t list = text.find("\"nodesA\""), end = text.find(']', list);
    text.replace(list, end + 1 - list, nodes);
    const std::size_t at = text.find(slip.what, text.find("\"couplings\""));
    ASSERT_NE(at, std::string::npos) << slip.what;
    text.replace(at, std::string(slip.what).size(), slip.by);
    folder.put("s.joint/joint.json", text);
    const auto loaded = loadJoint(folder.path("s.joint"));
    ASSERT_FALSE(loaded.ok()) << slip.by;
    const Error& error = loaded.error();
    EXPECT_EQ(error.fault, slip.fault) << slip.by << " " << toLogLine(error);
    EXPECT_EQ(error.place.pointer, slip.pointer) << slip.by;
    EXPECT_EQ(error.place.part, slip.part) << slip.by;
    if (!slip.arguments.empty()) { EXPECT_EQ(error.arguments, slip.arguments) << slip.by; }
  }
}

TEST(JointNodes, aRigidPartHasNone) {
  Joint joint = atNodes();
  std::swap(joint.couplings[0].partA, joint.couplings[0].partB);
  const auto checked = checkJoint(joint, "j");
  ASSERT_FALSE(checked.ok());
  EXPECT_EQ(checked.error().fault, Fault::BadNodes);
  EXPECT_EQ(checked.error().arguments, (Arguments{"rigid", "humerus"}));
  joint = atNodes();
  joint.couplings[0].stiffnessPerNode = 0;
  EXPECT_EQ(checkJoint(joint, "j").error().fault, Fault::OutOfRange);
  joint = sampleJoint();
  joint.couplings[0].stiffnessPerNode = 5;
  EXPECT_EQ(checkJoint(joint, "j").error().arguments, (Arguments{"unit"}));
}

TEST(JointNodes, dentsAreOfTheCellsTheNodesBelongTo) {
  Joint joint = atNodes();
  const std::string before = dentBasis(joint, joint.parts[1]);
  TetMesh moved = *joint.parts[1].volume;
  moved.nodes[1].x() += 1e-3;
  joint.parts[1].volume = std::make_shared<const TetMesh>(moved);
  EXPECT_NE(dentBasis(joint, joint.parts[1]), before) << "the numbers are the same, the places are not";
  joint = atNodes();
  joint.couplings[0].damping = 1;
  EXPECT_EQ(dentBasis(joint, joint.parts[1]), before);
  joint.couplings[0].nodesA = {3, 0, 1};
  EXPECT_NE(dentBasis(joint, joint.parts[1]), before);
  Joint region = sampleJoint();
  const std::string free = dentBasis(region, region.parts[1]);
  region.parts[1].volume = std::make_shared<const TetMesh>(moved);
  EXPECT_EQ(dentBasis(region, region.parts[1]), free) << "over a region cells do not count";
}

// ---- Recipes

/// A recipe with one coupling; `hold` is what it says of where and how stiff.
Result<JointRecipe> recipeWith(const std::string& hold, const std::string& kind = "soft") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path("meshes"));
  EXPECT_TRUE(writePly(folder.path("meshes/m.ply"), *sampleJoint().parts[0].visual).ok());
  const std::string cells = kind == "soft" ? R"(, "cellSize": 0.01)" : "";
  return loadRecipe(folder.put("r.json", R"({"schemaVersion": 1, "id": "r", "name": "R",
    "materials": [{"id": "bone", "density": 1800, "youngsModulus": 1e9, "poissonRatio": 0.3}],
    "parts": [{"id": "humerus", "number": 1, "kind": "rigid", "visual": "m.ply", "materials": [{"material": "bone"}]},
              {"id": "cuff", "number": 2, "kind": ")" + kind + R"(", "visual": "m.ply", "materials": [{"material": "bone"}],
               "regions": [{"id": "foot", "triangles": [[0, 1]]}])" + cells + R"(}],
    "couplings": [{"id": "c", "partA": "cuff", "partB": "humerus", )" + hold + "}]}"), folder.path("meshes"));
}

TEST(RecipeNodes, areFoundByDistanceBallOrPoints) {
  auto recipe = recipeWith(R"("nodes": {"within": 0.003}, "stiffnessPerNode": 200, "damping": 0.002)");
  ASSERT_TRUE(recipe.ok()) << toLogLine(recipe.error());
  EXPECT_TRUE(recipe->couplings.empty());
  ASSERT_EQ(recipe->nodeCouplings.size(), 1u);
  const NodeCoupling& near = recipe->nodeCouplings[0];
  EXPECT_EQ(near.coupling.stiffnessPerNode, 200);
  EXPECT_EQ(near.coupling.damping, 0.002);
  EXPECT_TRUE(near.coupling.nodesA.empty());
  EXPECT_EQ(near.within, 0.003);
  EXPECT_EQ(near.radius, 0);
  EXPECT_TRUE(near.points_W.empty());
  recipe = recipeWith(R"("nodes": {"ball": {"centre": [0.01, 0.02, 0.03], "radius": 0.004}}, "stiffnessPerNode": 200)");
  ASSERT_TRUE(recipe.ok()) << toLogLine(recipe.error());
  EXPECT_FALSE(recipe->nodeCouplings[0].within);
  EXPECT_EQ(recipe->nodeCouplings[0].centre_W, Vec3(0.01, 0.02, 0.03));
  EXPECT_EQ(recipe->nodeCouplings[0].radius, 0.004);
  recipe = recipeWith(R"("nodes": [[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0.2]], "stiffnessPerNode": 200)");
  ASSERT_TRUE(recipe.ok()) << toLogLine(recipe.error());
  ASSERT_EQ(recipe->nodeCouplings[0].points_W.size(), 3u);
  EXPECT_EQ(recipe->nodeCouplings[0].points_W[2], Vec3(0, 0.1, 0.2));
}

TEST(RecipeNodes, slipsAreNamedWithTheirPlace) {
  struct Slip {
    const char* hold;
    Fault fault;
    const char* pointer;
    Arguments arguments;
  };
  for (const Slip& slip : {Slip{R"("nodes": {"within": 0.003}, "regionA": "foot", "stiffnessPerNode": 1)", Fault::BadNodes, "/couplings/0/nodes", {"both"}},
                           Slip{R"("nodes": {"within": 0.003}, "within": 0.1, "stiffnessPerNode": 1)", Fault::BadNodes, "/couplings/0/nodes", {"both"}},
                           Slip{R"("nodes": {"within": 0.003}, "stiffnessPerArea": 1e7)", Fault::BadNodes, "/couplings/0/stiffnessPerArea", {"unit"}},
                           Slip{R"("nodes": {"within": 0.003})", Fault::SchemaMismatch, "/couplings/0", {"member \"stiffnessPerNode\" is missing"}},
                           Slip{R"("regionA": "foot", "stiffnessPerNode": 1)", Fault::BadNodes, "/couplings/0/stiffnessPerNode", {"unit"}},
                           Slip{R"("regionA": "foot")", Fault::SchemaMismatch, "/couplings/0", {"member \"stiffnessPerArea\" is missing"}},
                           Slip{R"("stiffnessPerArea": 1e7)", Fault::SchemaMismatch, "/couplings/0", {}},
                           Slip{R"("nodes": [[0, 0, 0], [1, 0, 0]], "stiffnessPerNode": 1)", Fault::SchemaMismatch, "/couplings/0/nodes", {}},
                           Slip{R"("nodes": {}, "stiffnessPerNode": 1)", Fault::SchemaMismatch, "/couplings/0/nodes", {}}}) {
    const auto recipe = recipeWith(slip.hold);
    ASSERT_FALSE(recipe.ok()) << slip.hold;
    EXPECT_EQ(recipe.error().fault, slip.fault) << slip.hold << toLogLine(recipe.error());
    EXPECT_EQ(recipe.error().place.pointer, slip.pointer) << slip.hold;
    if (!slip.arguments.empty()) { EXPECT_EQ(recipe.error().arguments, slip.arguments) << slip.hold; }
  }
  const auto rigid = recipeWith(R"("nodes": {"within": 0.003}, "stiffnessPerNode": 1)", "rigid");
  ASSERT_FALSE(rigid.ok());
  EXPECT_EQ(rigid.error().arguments, (Arguments{"rigid", "cuff"}));
  EXPECT_EQ(rigid.error().place.pointer, "/couplings/0/nodes");
}

}  // namespace
}  // namespace glenoid
