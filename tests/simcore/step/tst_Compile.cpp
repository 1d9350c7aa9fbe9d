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
    if (effect.name == "gravity") EXPECT_EQ(effect.reason, "asked-off");
    if (effect.name == "friction") EXPECT_EQ(effect.reason, "nothing-to-act-on") << "all surfaces are smooth";
    if (effect.name == "couplings") EXPECT_EQ(effect.reason, "auto-present");
  }
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
