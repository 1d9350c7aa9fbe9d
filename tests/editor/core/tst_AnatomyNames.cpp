// SPDX-License-Identifier: GPL-3.0-or-later
// Every name that the shipped joints show has a place in the table that is translated.
#include <gtest/gtest.h>

#include <set>

#include "editor/core/AnatomyNames.h"
#include "simcore/file/Json.h"
#include "simcore/scene/JointFile.h"

namespace glenoid {
namespace {

TEST(AnatomyNames, coverTheShippedJointsAndNothingElse) {
  std::set<std::string> shipped;
  for (const char* name : {"shoulder", "shoulder-superficial", "shoulder-capsule"}) {
    const Joint joint = loadJoint(std::string(GLENOID_SOURCE_DIR) + "/resources/joints/" + name + ".joint").value();
    shipped.insert(joint.name);
    for (const Material& material : joint.materials) shipped.insert(material.name);
    for (const Bursa& bursa : joint.bursae) shipped.insert(bursa.name);
    for (const Part& part : joint.parts) {
      shipped.insert(part.name);
      for (const Region& region : part.regions) shipped.insert(region.name);
      for (const Landmark& landmark : part.landmarks) shipped.insert(landmark.name);
    }
  }
  for (const char* name : {"elbow", "knee"}) {  // the joints to begin with
    const auto recipe = readJson(std::string(GLENOID_SOURCE_DIR) + "/resources/starters/" + name + ".recipe.json");
    ASSERT_TRUE(recipe.ok()) << toLogLine(recipe.error());
    shipped.insert((*recipe)["name"].text());
    for (const char* list : {"materials", "parts"})
      for (const JsonValue& each : (*recipe)[list].items()) shipped.insert(each["name"].text());
  }
  const std::set<std::string> known(anatomyNames().begin(), anatomyNames().end());
  EXPECT_EQ(known, shipped);
}

TEST(AnatomyNames, anAuthorsOwnNameStays) {
  EXPECT_EQ(anatomyName("My ligament %1"), QStringLiteral("My ligament %1"));
  EXPECT_TRUE(anatomyName("").isEmpty());
}

}  // namespace
}  // namespace glenoid
