// SPDX-License-Identifier: GPL-3.0-or-later
// Every name that the shipped joints show has a place in the table that is translated.
#include <gtest/gtest.h>

#include <set>

#include "editor/core/AnatomyNames.h"
#include "simcore/scene/JointFile.h"

namespace glenoid {
namespace {

TEST(AnatomyNames, coverTheShippedJointsAndNothingElse) {
  std::set<std::string> shipped;
  for (const char* name : {"shoulder", "shoulder-superficial"}) {
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
  const std::set<std::string> known(anatomyNames().begin(), anatomyNames().end());
  EXPECT_EQ(known, shipped);
}

TEST(AnatomyNames, anAuthorsOwnNameStays) {
  EXPECT_EQ(anatomyName("My ligament %1"), QStringLiteral("My ligament %1"));
  EXPECT_TRUE(anatomyName("").isEmpty());
}

}  // namespace
}  // namespace glenoid
