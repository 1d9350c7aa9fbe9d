// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/RecipeFile.h"

#include <gtest/gtest.h>

#include "simcore/file/Ply.h"
#include "simcore/mesh/TrianglePatch.h"
#include "simcore/scene/RegionNear.h"
#include "tests/simcore/file/TemporaryFolder.h"
#include "tests/simcore/scene/SampleJoint.h"

namespace glenoid {
namespace {

const std::string kRecipe = R"({
  "schemaVersion": 1, "id": "r", "name": "R", "description": "What it is.", "side": "left", "clearance": 0.001, "separationIterations": 50,
  "materials": [{"id": "bone", "density": 1800, "youngsModulus": 1e9, "poissonRatio": 0.3}],
  "parts": [
    {"id": "humerus", "number": 1, "kind": "rigid", "visual": "h.ply", "collision": "h.ply", "materials": [{"material": "bone"}]},
    {"id": "cuff", "number": 2, "kind": "soft", "visual": "sub/c.ply", "tetrahedra": 500, "collisionTriangles": 4,
     "axes": "principal", "color": [0.25, 0.5, 1], "materials": [{"material": "bone"}],
     "regions": [{"id": "foot", "kind": "footprint", "triangles": [[0, 2], [3, 1]]}],
     "landmarks": [{"id": "l", "position": [1, 2, 3]}]}
  ],
  "couplings": [{"id": "c", "partA": "cuff", "partB": "humerus", "regionA": "foot", "stiffnessPerArea": 1e7}]
})";

struct Prepared {
  TemporaryFolder folder;
  Prepared() {
    std::filesystem::create_directories(folder.path("meshes/sub"));
    const Joint joint = sampleJoint();
    EXPECT_TRUE(writePly(folder.path("meshes/h.ply"), *joint.parts[0].visual).ok());
    EXPECT_TRUE(writePly(folder.path("meshes/sub/c.ply"), *joint.parts[1].visual).ok());
  }
  Result<JointRecipe> load(const std::string& what = {}, const std::string& by = {}) const {
    std::string text = kRecipe;
    if (!what.empty()) text.replace(text.find(what), what.size(), by);
    return loadRecipe(folder.put("r.json", text), folder.path("meshes"));
  }
};

TEST(RecipeFile, whatTheFileSaysIsRead) {
  const Prepared prepared;
  const auto recipe = prepared.load();
  ASSERT_TRUE(recipe.ok()) << toLogLine(recipe.error());
  EXPECT_EQ(recipe->id, "r");
  EXPECT_EQ(recipe->description, "What it is.");
  EXPECT_EQ(recipe->side, JointSide::Left);
  EXPECT_FALSE(recipe->parts[0].axes) << "what the recipe leaves open";
  EXPECT_EQ(recipe->clearance, 0.001);
  EXPECT_EQ(recipe->separationIterations, 50);
  ASSERT_EQ(recipe->parts.size(), 2u);
  const PartRecipe &humerus = recipe->parts[0], &cuff = recipe->parts[1];
  EXPECT_EQ(humerus.visual, humerus.collision);
  EXPECT_EQ(*humerus.visual, *sampleJoint().parts[0].visual);
  EXPECT_EQ(cuff.kind, PartKind::Soft);
  EXPECT_EQ(cuff.tetrahedra, 500);
  EXPECT_EQ(cuff.collisionTriangles, 4);
  EXPECT_EQ(cuff.axes, GridAxes::Principal);
  EXPECT_EQ(cuff.color, (std::array<float, 3>{0.25f, 0.5f, 1.0f}));
  EXPECT_FALSE(cuff.collision);
  EXPECT_EQ(cuff.regions[0].triangles, (std::vector<TriangleRun>{{0, 2}, {3, 1}}));
  EXPECT_EQ(cuff.landmarks[0].position_W, Vec3(1, 2, 3));
  EXPECT_EQ(recipe->couplings[0].stiffnessPerArea, 1e7);
}

TEST(RecipeFile, couplingsByDistanceAndTheWishesForTheStart) {
  const Prepared prepared;
  const auto recipe = prepared.load("\"regionA\": \"foot\", \"stiffnessPerArea\": 1e7}]",
                                    "\"within\": 0.002, \"ball\": {\"centre\": [0.1, 0.2, 0.3], \"radius\": 0.01}, "
                                    "\"stiffnessPerArea\": 1e7, \"reason\": \"grown together\"}, "
                                    "{\"id\": \"d\", \"partA\": \"cuff\", \"partB\": \"humerus\", \"regionA\": \"foot\", "
                                    "\"stiffnessPerArea\": 2e7}], \"start\": {\"clearance\": 0.0005, \"handles\": 40, \"parts\": [\"cuff\"]}");
  ASSERT_TRUE(recipe.ok()) << toLogLine(recipe.error());
  ASSERT_EQ(recipe->nearCouplings.size(), 1u);
  const NearCoupling& near = recipe->nearCouplings[0];
  EXPECT_EQ(near.coupling.id, "c");
  EXPECT_EQ(near.coupling.reason, "grown together");
  EXPECT_EQ(near.coupling.stiffnessPerArea, 1e7);
  EXPECT_EQ(near.within, 0.002);
  EXPECT_EQ(near.centre_W, Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(near.radius, 0.01);
  ASSERT_EQ(recipe->couplings.size(), 1u);
  EXPECT_EQ(recipe->couplings[0].id, "d");
  ASSERT_TRUE(recipe->start);
  EXPECT_EQ(recipe->start->clearance, 0.0005);
  EXPECT_EQ(recipe->start->handles, 40);
  EXPECT_EQ(recipe->start->iterations, StartWishes{}.iterations);
  EXPECT_EQ(recipe->start->parts, std::vector<std::string>{"cuff"});
  EXPECT_FALSE(prepared.load()->start);
}

TEST(RecipeFile, regionsBySetsDistanceAndBall) {
  const Prepared prepared;
  const auto recipe = prepared.load("{\"id\": \"foot\", \"kind\": \"footprint\", \"triangles\": [[0, 2], [3, 1]]}",
                                    "{\"id\": \"foot\", \"triangles\": [[0, 2], [3, 1]]}, {\"id\": \"b\", \"triangles\": [[1, 2]]}, {\"id\": \"both\", \"union\": [\"foot\", \"b\"]},"
                                    "{\"id\": \"shared\", \"intersection\": [\"foot\", \"b\"]}, {\"id\": \"less\", \"difference\": [\"both\", \"shared\"]}, {\"id\": \"rest\", \"complement\": \"shared\"},"
                                    "{\"id\": \"near\", \"near\": {\"part\": \"humerus\", \"within\": 0.5}}, {\"id\": \"limited\", \"near\": {\"part\": \"humerus\", \"within\": 0.5}, \"union\": [\"foot\"]}");
  ASSERT_TRUE(recipe.ok()) << toLogLine(recipe.error());
  const PartRecipe& cuff = recipe->parts[1];
  const auto of = [&](std::size_t region) { return trianglesOf(cuff.regions.at(region)); };
  EXPECT_EQ(of(2), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(of(3), (std::vector<int>{1}));
  EXPECT_EQ(of(4), (std::vector<int>{0, 2, 3}));
  std::vector<int> rest;
  for (int t = 0; t < static_cast<int>(cuff.visual->triangles.size()); ++t)
    if (t != 1) rest.push_back(t);
  EXPECT_EQ(of(5), rest);
  const std::vector<int> near = trianglesNear(*cuff.visual, *recipe->parts[0].visual, 0.5);
  ASSERT_FALSE(near.empty());
  EXPECT_EQ(of(6), near);
  EXPECT_EQ(of(7), common(near, of(0)));
}

TEST(RecipeFile, aPartMayBeTurnedAndTheWholeMirrored) {
  const Prepared prepared;
  const auto plain = prepared.load();
  ASSERT_TRUE(plain.ok());
  EXPECT_FALSE(plain->mirrored);
  const auto turned = prepared.load("\"number\": 2,", "\"number\": 2, \"source\": {\"unit\": \"m\", \"turn\": [0, 90, 90], \"scale\": 2, \"about\": [1, 0, 0], \"translate\": [0, 0, 5]},");
  ASSERT_TRUE(turned.ok()) << toLogLine(turned.error());
  const auto &from = plain->parts[1].visual->vertices, &to = turned->parts[1].visual->vertices;
  ASSERT_EQ(from.size(), to.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    // About Y by 90°: x → −z, z → x; then about Z: x → y, y → −x.
    const Vec3 r = from[i] - Vec3(1, 0, 0), aboutY(r.z(), r.y(), -r.x()), aboutZ(-aboutY.y(), aboutY.x(), aboutY.z());
    EXPECT_LT((to[i] - (2 * aboutZ + Vec3(1, 0, 5))).norm(), 1e-12);
  }
  EXPECT_EQ(turned->parts[0].visual->vertices, plain->parts[0].visual->vertices);
  EXPECT_TRUE(prepared.load("\"side\": \"left\"", "\"side\": \"left\", \"mirror\": true")->mirrored);
}

TEST(RecipeFile, slipsAreNamedWithTheirPlace) {
  struct Slip {
    const char *what, *by;
    Fault fault;
    const char *pointer, *part;
  };
  const Prepared prepared;
  for (const Slip& slip :
       {Slip{"\"tetrahedra\": 500", "\"tetrahedra\": 0", Fault::Unusable, "/parts/1", "cuff"},
        Slip{"\"number\": 1,", "\"number\": 1, \"cellSize\": 0.01,", Fault::Unusable, "/parts/0", "humerus"},
        Slip{"\"number\": 1,", "\"number\": 1, \"elements\": \"cells\",", Fault::Unusable, "/parts/0", "humerus"},
        Slip{"sub/c.ply", "../meshes/h.ply", Fault::BadReference, "/parts/1/visual", "cuff"},
        Slip{"[3, 1]", "[3, 2]", Fault::BadIndex, "/parts/1/regions/0/triangles", "cuff"},
        Slip{"\"number\": 2", "\"number\": 1", Fault::DuplicateId, "/parts/1/number", "cuff"},
        Slip{"\"regionA\": \"foot\"", "\"regionA\": \"hand\"", Fault::UnknownId, "/couplings/0/regionA", "c"},
        Slip{"\"regionA\": \"foot\", ", "", Fault::SchemaMismatch, "/couplings/0", ""},
        Slip{"\"regionA\": \"foot\"", "\"regionA\": \"hand\", \"within\": 0.001", Fault::UnknownId, "/couplings/0/regionA", "c"},
        Slip{"\"triangles\": [[0, 2], [3, 1]]", "\"union\": [\"hand\"]", Fault::UnknownId, "/parts/1/regions/0", "cuff"},
        Slip{"\"triangles\": [[0, 2], [3, 1]]", "\"near\": {\"part\": \"cuff\", \"within\": 1}", Fault::UnknownId, "/parts/1/regions/0", "cuff"},
        Slip{"\"triangles\": [[0, 2], [3, 1]]", "\"ball\": {\"centre\": [9, 9, 9], \"radius\": 0.1}", Fault::Unusable, "/parts/1/regions/0", "cuff"},
        Slip{"\"triangles\": [[0, 2], [3, 1]]", "\"name\": \"x\"", Fault::SchemaMismatch, "/parts/1/regions/0", ""},
        Slip{"\"partB\": \"humerus\", \"regionA\": \"foot\"", "\"partB\": \"ulna\", \"within\": 0.001", Fault::UnknownId, "/couplings/0/partB", "c"},
        Slip{"\"id\": \"humerus\"", "\"id\": \"left humerus\"", Fault::SchemaMismatch, "/parts/0/id", ""},
        Slip{"\"id\": \"foot\"", "\"id\": \"a/b\"", Fault::SchemaMismatch, "/parts/1/regions/0/id", ""},
        Slip{"\"id\": \"c\"", "\"id\": \"c\\n\"", Fault::SchemaMismatch, "/couplings/0/id", ""},
        Slip{"\"id\": \"l\"", "\"id\": \"..\"", Fault::SchemaMismatch, "/parts/1/landmarks/0/id", ""},
        Slip{"\"id\": \"r\"", "\"id\": \"say \\\"r\\\"\"", Fault::SchemaMismatch, "/id", ""},
        Slip{"\"clearance\": 0.001", "\"clearance\": -1", Fault::OutOfRange, "/clearance", ""}}) {
    const auto recipe = prepared.load(slip.what, slip.by);
    ASSERT_FALSE(recipe.ok()) << slip.by;
    EXPECT_EQ(recipe.error().fault, slip.fault) << slip.by << toLogLine(recipe.error());
    EXPECT_EQ(recipe.error().place.pointer, slip.pointer) << slip.by;
    EXPECT_EQ(recipe.error().place.part, slip.part) << slip.by;
    EXPECT_EQ(recipe.error().place.file, prepared.folder.path("r.json"));
  }
  EXPECT_TRUE(prepared.load("\"id\": \"r\"", "\"id\": \"Schulter_links-2.1-ä-肩\"").ok());
  const auto missing = prepared.load("sub/c.ply", "sub/d.ply");
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().fault, Fault::FileMissing);
  EXPECT_EQ(missing.error().place.file, prepared.folder.path("meshes/sub/d.ply"));
  EXPECT_EQ(missing.error().place.part, "cuff");
}

}  // namespace
}  // namespace glenoid
