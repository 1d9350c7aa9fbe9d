// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/step/Model.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

TEST(Compile, layoutCoversTheStateWithoutOverlap) {
  const auto model = compileModel(scenes::figure4Joint(), scenes::figure5Scenario()).value();
  int q = 0, v = 0;
  for (const SceneObject& object : model->objects) {
    EXPECT_EQ(object.layout.qOffset, q);
    EXPECT_EQ(object.layout.vOffset, v);
    q += object.layout.qSize;
    v += object.layout.vSize;
  }
  EXPECT_EQ(model->start.q.size(), q);
  EXPECT_EQ(model->start.v.size(), v);
  EXPECT_TRUE(isFinite(model->start));
}

TEST(Compile, startStateReproducesTheRestSurfaces) {
  const auto model = compileModel(scenes::figure4Joint(), scenes::figure5Scenario()).value();
  for (const SceneObject& object : model->objects) {
    if (object.tool) continue;
    std::vector<Vec3> points(object.visual.vertices.size());
    surfacePositions(object.visual, object.layout, model->start.q, points);
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LT((points[i] - object.visual.mesh->vertices[i]).norm(), 1e-14);
  }
}

TEST(Compile, aFixedPartHasNoVelocitiesAndJoinsNoIsland) {
  const auto model = compileModel(scenes::figure4Joint(), scenes::figure4Scenario()).value();
  EXPECT_EQ(model->objects[0].layout.vSize, 0);
  EXPECT_EQ(model->couplingIslandOfObject[0], -1);
}

TEST(Compile, triangleOfACouplingTakeNoPartInItsPair) {
  const auto model = compileModel(scenes::figure4Joint(), scenes::figure4Scenario()).value();
  ASSERT_EQ(model->collisionPairs.size(), 3u);
  const CollisionPair& pair = model->collisionPairs[0];  // left–middle
  EXPECT_GT(std::count(pair.skipTriangleA.begin(), pair.skipTriangleA.end(), 1), 7);
  EXPECT_GT(std::count(pair.skipTriangleB.begin(), pair.skipTriangleB.end(), 1), 7);
  EXPECT_GT(std::count(pair.skipTriangleB.begin(), pair.skipTriangleB.end(), 0), 0);
}

TEST(Compile, exclusionsAndPerforationsLeavePairsOut) {
  Joint joint = scenes::figure4Joint();
  joint.exclusions.push_back({"right", "middle", "bonded"});
  Scenario scenario = scenes::figure5Scenario();
  scenario.tools[0].perforates = {"middle"};
  const auto model = compileModel(joint, scenario).value();
  for (const CollisionPair& pair : model->collisionPairs) {
    EXPECT_FALSE(pair.surfaceA == 1 && pair.surfaceB == 2);
    EXPECT_FALSE(pair.surfaceA == 1 && pair.surfaceB == 3);
  }
  EXPECT_EQ(model->collisionPairs.size(), 10u - 2u);
}

TEST(Compile, effectsSayWhy) {
  Scenario scenario = scenes::figure4Scenario();
  scenario.effects.gravity = Wish::Off;
  scenario.effects.friction = Wish::On;
  const auto model = compileModel(scenes::figure4Joint(), scenario).value();
  EXPECT_FALSE(model->effectOn("gravity"));
  EXPECT_TRUE(model->effectOn("contact"));
  for (const EffectPlan& effect : model->effects) {
    if (effect.name == "gravity") {
      EXPECT_EQ(effect.reason, "asked-off");
    } else if (effect.name == "friction") {
      EXPECT_EQ(effect.reason, "nothing-to-act-on") << "all surfaces are smooth";
    } else if (effect.name == "couplings") {
      EXPECT_EQ(effect.reason, "auto-present");
    }
  }
}

TEST(Compile, frictionTakesEachVertexsOwnMaterial) {
  Joint joint = scenes::blockOnPlateJoint();
  Material rough = joint.materials[1];
  rough.id = "rough";
  rough.friction = 0.6;
  joint.materials[0].friction = joint.materials[1].friction = 0.2;
  joint.materials.push_back(rough);
  Part& block = joint.parts[1];
  block.regions.push_back(scenes::regionIn(block, "top", Box3(Vec3(-1, 0.0404, -1), Vec3(1, 0.0406, 1))));
  block.materials.push_back({"rough", "top"});
  Scenario scenario = scenes::blockOnPlateScenario();
  const auto model = compileModel(joint, scenario).value();
  EXPECT_TRUE(model->effectOn("friction"));
  const SceneObject& object = model->objects[1];
  ASSERT_EQ(object.friction.size(), object.collision.mesh->vertices.size());
  for (std::size_t v = 0; v < object.friction.size(); ++v)
    if (object.collision.mesh->vertices[v].y() < 0.03) {
      EXPECT_EQ(object.friction[v], 0.2);
    }
  EXPECT_EQ(*std::max_element(object.friction.begin(), object.friction.end()), 0.6);
  scenario.effects.friction = Wish::Off;
  const auto without = compileModel(joint, scenario).value();
  for (const SceneObject& smooth : without->objects) EXPECT_TRUE(smooth.friction.empty());
}

TEST(Compile, wrongNamesAreFaultsWithAPlace) {
  Scenario scenario = scenes::figure4Scenario();
  scenario.fixedParts = {"nobody"};
  Error error = compileModel(scenes::figure4Joint(), scenario).error();
  EXPECT_EQ(error.fault, Fault::UnknownId);
  EXPECT_EQ(error.place.pointer, "/fixedParts/0");
  scenario = scenes::figure4Scenario();
  scenario.holds.push_back({"middle", 1, 1, 1});
  EXPECT_EQ(compileModel(scenes::figure4Joint(), scenario).error().fault, Fault::Unusable);
  scenario = scenes::figure4Scenario();
  scenario.dt = 0;
  EXPECT_EQ(compileModel(scenes::figure4Joint(), scenario).error().fault, Fault::OutOfRange);
  Joint joint = scenes::figure4Joint();
  joint.parts[1].materials[0].material = "cheese";
  error = compileModel(joint, scenes::figure4Scenario()).error();
  EXPECT_EQ(error.fault, Fault::UnknownId);
  EXPECT_EQ(error.place.part, "middle");
}

}  // namespace
}  // namespace glenoid
