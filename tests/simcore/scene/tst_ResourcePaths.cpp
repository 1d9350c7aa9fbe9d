// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/ResourcePaths.h"

#include <gtest/gtest.h>

#include "tests/simcore/file/TemporaryFolder.h"

namespace glenoid {
namespace {

TEST(ResourcePaths, builtInNamesAreLookedUp) {
  const TemporaryFolder folder;
  folder.put("joints/shoulder.joint/joint.json", "{}");
  folder.put("scenarios/palpation.scenario.json", "{}");
  folder.put("scenarios/arthroscopy.scenario.json", "{}");
  folder.put("scenarios/README.md", "");
  folder.put("recordings/a.recording", "{}");
  EXPECT_EQ(*resolveJoint("builtin:shoulder", "elsewhere", folder.path()),
            folder.path("joints/shoulder.joint"));
  EXPECT_EQ(*resolveScenario("builtin:palpation", "", folder.path()),
            folder.path("scenarios/palpation.scenario.json"));
  EXPECT_EQ(*resolveRecording("builtin:a", "", folder.path()), folder.path("recordings/a.recording"));
  const auto unknown = resolveScenario("builtin:knee", "", folder.path());
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(unknown.error().fault, Fault::UnknownId);
  EXPECT_EQ(unknown.error().arguments, (Arguments{"knee", "scenario", "arthroscopy", "palpation"}));
  for (const char* outside : {"builtin:../joints/shoulder", "builtin:", "builtin:/etc"})
    EXPECT_FALSE(resolveJoint(outside, "", folder.path()).ok()) << outside;
  EXPECT_FALSE(resolveJoint("builtin:shoulder", "", folder.path("none")).ok());
}

TEST(ResourcePaths, otherReferencesArePaths) {
  EXPECT_EQ(*resolveJoint("x.joint", "", "r"), "x.joint");
  EXPECT_EQ(*resolveJoint("../x.joint", "a/b", "r"), "a/x.joint");
  EXPECT_EQ(*resolveJoint("/x.joint", "a/b", "r"), "/x.joint");
  EXPECT_EQ(resolveJoint("", "a", "r").error().fault, Fault::BadReference);
  EXPECT_EQ(folderOf("a/b.json"), "a");
  EXPECT_EQ(folderOf("b.json"), "");
}

}  // namespace
}  // namespace glenoid
