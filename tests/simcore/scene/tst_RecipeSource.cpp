// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/file/Ply.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/scene/RecipeFile.h"
#include "tests/simcore/file/TemporaryFolder.h"
#include "tests/simcore/import/SampleFiles.h"
#include "tests/simcore/mesh/Shapes.h"

// Recipes whose surfaces come from other programs.
namespace glenoid {
namespace {

class RecipeSource : public ::testing::Test {
 protected:
  /// A recipe of one rigid part; `general` and `part` are entries with a comma after them.
  Result<JointRecipe> load(const std::string& file, const std::string& part = {}, const std::string& general = {}) {
    m_reports.clear();
    const std::string text = R"({"schemaVersion": 1, "id": "r", "name": "R", )" + general +
                             R"("materials": [{"id": "bone", "density": 1800, "youngsModulus": 1e9, "poissonRatio": 0.3}],
      "parts": [{"id": "box", "number": 1, "kind": "rigid", )" + part + R"("visual": ")" + file + R"(", "materials": [{"material": "bone"}]}]})";
    return loadRecipe(m_folder.put("r.json", text), m_folder.path("meshes"), &m_reports);
  }
  void put(const std::string& name, const std::string& bytes) { m_folder.put("meshes/" + name, bytes); }
  void put(const std::string& name, const TriMesh& mesh) {
    std::filesystem::create_directories(m_folder.path("meshes"));
    ASSERT_TRUE(writePly(m_folder.path("meshes/" + name), mesh).ok());
  }
  static Box3 boxOf(const Result<JointRecipe>& recipe) {
    EXPECT_TRUE(recipe.ok()) << (recipe ? "" : toLogLine(recipe.error()));
    return recipe ? boundsOf(*recipe->parts[0].visual) : Box3();
  }
  TemporaryFolder m_folder;
  std::vector<SourceReport> m_reports;
};

TEST_F(RecipeSource, aPlyWithoutSourceStaysBitForBit) {
  const TriMesh ball = shapes::sphere(0.024, 12, 7);
  put("a.ply", ball);
  const auto recipe = load("a.ply");
  ASSERT_TRUE(recipe.ok());
  EXPECT_EQ(*recipe->parts[0].visual, ball);
  EXPECT_TRUE(m_reports.empty());
}

TEST_F(RecipeSource, unitAxesAndShiftPlaceASurface) {
  put("box.stl", samples::stlBinary());  // 1 × 2 × 3
  const auto recipe = load("box.stl", R"("source": {"unit": "mm", "axes": ["-y", "z", "-x"], "translate": [0.5, 0, 0]}, )");
  const Box3 box = boxOf(recipe);
  EXPECT_LT((box.min() - Vec3(0.498, 0, -0.001)).norm(), 1e-9);
  EXPECT_LT((box.max() - Vec3(0.5, 0.003, 0)).norm(), 1e-9);
  EXPECT_TRUE(healthOf(*recipe->parts[0].visual).healthy());
  ASSERT_EQ(m_reports.size(), 1u);
  EXPECT_EQ(m_reports[0].part, "box");
  EXPECT_EQ(m_reports[0].format, "STL");
  EXPECT_EQ(m_reports[0].metresPerUnit, 1e-3);
  EXPECT_FALSE(m_reports[0].notes.empty());  // corners joined
}

TEST_F(RecipeSource, thePartComesBeforeTheRecipe) {
  put("box.obj", samples::obj());
  const std::string general = R"("source": {"unit": "cm", "translate": [1, 0, 0]}, )";
  EXPECT_NEAR(boxOf(load("box.obj", "", general)).max().x(), 1.01, 1e-7);
  EXPECT_NEAR(boxOf(load("box.obj", R"("source": {"unit": "mm"}, )", general)).max().x(), 1.001, 1e-7);
}

TEST_F(RecipeSource, theFilesOwnUnitCounts) {
  for (const samples::Sample& sample : samples::all())
    if (sample.name == "stored.3mf") put("inch.3mf", sample.bytes);
  EXPECT_NEAR(boxOf(load("inch.3mf")).max().z(), 3 * 0.0254, 1e-7);
  put("box.stl", samples::stlBinary());
  const auto unnamed = load("box.stl");
  ASSERT_FALSE(unnamed.ok());
  EXPECT_EQ(unnamed.error().fault, Fault::SchemaMismatch);
  EXPECT_EQ(unnamed.error().place.file, m_folder.path("r.json"));
  EXPECT_EQ(unnamed.error().place.pointer, "/parts/0/visual");
}

TEST_F(RecipeSource, repairsThicknessShellAndCountAreTaken) {
  TriMesh wrong = shapes::sphere(24, 48, 31);
  for (auto& t : wrong.triangles) std::swap(t[0], t[1]);
  wrong.triangles.pop_back();
  const TriMesh small = shapes::sphere(1, 8, 5);
  const int base = static_cast<int>(wrong.vertices.size());
  for (const Vec3& v : small.vertices) wrong.vertices.push_back(v + Vec3(100, 0, 0));
  for (const auto& t : small.triangles) wrong.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  put("wrong.ply", wrong);
  const auto recipe = load("wrong.ply", R"("source": {"unit": "mm", "shell": "largest", "repairs": ["fillHoles", "outwards"], "simplifyVisual": 500}, )");
  ASSERT_TRUE(recipe.ok()) << toLogLine(recipe.error());
  const MeshHealth health = healthOf(*recipe->parts[0].visual);
  EXPECT_TRUE(health.healthy());
  EXPECT_EQ(health.components, 1);
  EXPECT_LE(health.triangles, 501);
  ASSERT_EQ(m_reports.size(), 1u);
  ASSERT_EQ(m_reports[0].changes.size(), 2u);
  EXPECT_EQ(m_reports[0].changes[0].changed, 1);
  EXPECT_EQ(m_reports[0].changes[1].changed, 1);
  put("sheet.ply", TriMesh{{{0, 0, 0}, {30, 0, 0}, {30, 20, 0}, {0, 20, 0}}, {{0, 1, 2}, {0, 2, 3}}});
  const auto thick = load("sheet.ply", R"("source": {"unit": "mm", "thicken": 0.001}, )");
  ASSERT_TRUE(thick.ok()) << toLogLine(thick.error());
  EXPECT_NEAR(healthOf(*thick->parts[0].visual).volume, 600e-9, 1e-15);
  EXPECT_NEAR(boxOf(load("wrong.ply", R"("source": {"unit": "mm", "shell": 1}, )")).sizes().y(), 0.002, 1e-9);
}

TEST_F(RecipeSource, slipsAreNamedWithTheirPlace) {
  put("box.stl", samples::stlBinary());
  struct Slip {
    const char* source;
    Fault fault;
    const char* pointer;
  };
  for (const Slip& slip : {Slip{R"({"unit": "furlong"})", Fault::SchemaMismatch, "/parts/0/source/unit"},
                           Slip{R"({"unit": "mm", "axes": ["x", "x", "z"]})", Fault::SchemaMismatch, "/parts/0/source/axes"},
                           Slip{R"({"unit": "mm", "axes": ["x", "y", "w"]})", Fault::SchemaMismatch, "/parts/0/source/axes/2"},
                           Slip{R"({"unit": "mm", "repairs": ["polish"]})", Fault::SchemaMismatch, "/parts/0/source/repairs"},
                           Slip{R"({"unit": "mm", "surface": "liver"})", Fault::UnknownId, "/parts/0/visual"},
                           Slip{R"({"unit": "mm", "shell": 1})", Fault::SchemaMismatch, "/parts/0/visual"},
                           Slip{R"({"unit": "mm", "thicken": -1})", Fault::OutOfRange, "/parts/0/source/thicken"}}) {
    const auto recipe = load("box.stl", std::string(R"("source": )") + slip.source + ", ");
    ASSERT_FALSE(recipe.ok()) << slip.source;
    EXPECT_EQ(recipe.error().fault, slip.fault) << toLogLine(recipe.error());
    EXPECT_EQ(recipe.error().place.pointer, slip.pointer) << toLogLine(recipe.error());
  }
  put("broken.stl", "solid nothing\nfacet normal");
  const auto broken = load("broken.stl", R"("source": {"unit": "mm"}, )");
  ASSERT_FALSE(broken.ok());
  EXPECT_EQ(broken.error().place.file, m_folder.path("meshes/broken.stl"));
  EXPECT_EQ(broken.error().place.part, "box");
}

}  // namespace
}  // namespace glenoid
