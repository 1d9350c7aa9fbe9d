// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "simcore/collide/Penetration.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "simcore/step/Stepper.h"
#include "tests/resources/ShoulderSizes.h"

namespace glenoid::test {
namespace {

std::shared_ptr<const Model> modelOf(const char* scenario) {
  const std::string path =
      std::string(GLENOID_SOURCE_DIR "/resources/scenarios/") + scenario + ".scenario.json";
  const Result<Scenario> loaded = loadScenario(path);
  EXPECT_TRUE(loaded.ok()) << (loaded ? "" : toLogLine(loaded.error()));
  if (!loaded) return nullptr;
  const std::string name = loaded->joint.substr(std::string("builtin:").size());
  const Result<Joint> joint = loadJoint(GLENOID_SOURCE_DIR "/resources/joints/" + name + ".joint");
  EXPECT_TRUE(joint.ok()) << name;
  if (!joint) return nullptr;
  const auto model = compileModel(*joint, *loaded);
  EXPECT_TRUE(model.ok()) << (model ? "" : toLogLine(model.error()));
  return model ? *model : nullptr;
}

TEST(ShoulderAtRest, noTwoPartsOrToolsCutEachOther) {
  for (const char* scenario : {"arthroscopy", "palpation"}) {
    const auto model = modelOf(scenario);
    ASSERT_TRUE(model);
    std::vector<std::vector<Vec3>> positions;
    for (const SceneObject& object : model->objects) {
      positions.emplace_back(object.collision.vertices.size());
      surfacePositions(object.collision, object.layout, model->start.q, positions.back());
    }
    const std::vector<std::span<const Vec3>> views(positions.begin(), positions.end());
    for (const PairIntersections& cut :
         startIntersections(model->collisionSurfaces, model->collisionPairs, views)) {
      const CollisionPair& pair = model->collisionPairs[cut.pair];
      ADD_FAILURE() << scenario << ": " << model->objects[pair.surfaceA].id << " cuts "
                    << model->objects[pair.surfaceB].id;
    }
  }
}

TEST(ShoulderAtRest, pairsThatMatterMayCollide) {
  const std::set<std::pair<std::string, std::string>> needed{{"humerus", "supraspinatus"},
                                                             {"humerus", "infraspinatus"},
                                                             {"humerus", "subscapularis"},
                                                             {"humerus", "biceps-tendon"},
                                                             {"transverse-humeral-ligament", "biceps-tendon"},
                                                             {"supraspinatus", "coracoacromial-ligament"},
                                                             {"humerus", "labrum"}};
  for (const Exclusion& e : shippedShoulder().exclusions) {
    EXPECT_FALSE(needed.contains({e.partA, e.partB}) || needed.contains({e.partB, e.partA}))
        << e.partA << " and " << e.partB;
    EXPECT_FALSE(e.reason.empty());
  }
}

TEST(ShoulderAtRest, touchesAsMuchAsThePaperSaysAndStays) {
  // The paper speaks of some tens of contacts; at rest the parts lie a millimetre apart.
  const auto model = modelOf("arthroscopy");
  ASSERT_TRUE(model);
  Stepper stepper(model, {});
  State state = model->start;
  const Inputs hands;
  for (int i = 0; i < 100; ++i) {
    const StepReport& report = stepper.step(hands, state);
    ASSERT_TRUE(report.taken);
    EXPECT_GE(report.contacts, 30);
    EXPECT_LE(report.contacts, 80);
  }
  EXPECT_LT(state.v.cwiseAbs().maxCoeff(), 0.05) << "settled after half a second";
}

}  // namespace
}  // namespace glenoid::test
