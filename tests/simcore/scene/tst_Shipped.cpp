// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>

#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecordingFile.h"
#include "simcore/scene/ResourcePaths.h"
#include "simcore/scene/ScenarioFile.h"

// What ships must be readable by what ships with it, down to every reference.
namespace glenoid {
namespace {

const std::string kResources = std::string(GLENOID_SOURCE_DIR) + "/resources";

std::vector<std::string> filesOf(const char* folder, const std::string& ending) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(kResources + "/" + folder))
    if (entry.path().filename().string().ends_with(ending)) files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Shipped, scenariosFitTheirJointsAndInputs) {
  const auto files = filesOf("scenarios", ".scenario.json");
  EXPECT_FALSE(files.empty());
  for (const std::string& file : files) {
    const auto scenario = loadScenario(file);
    ASSERT_TRUE(scenario.ok()) << toLogLine(scenario.error());
    const auto folder = resolveJoint(scenario->joint, folderOf(file), kResources);
    ASSERT_TRUE(folder.ok()) << toLogLine(folder.error());
    const auto joint = loadJoint(*folder);
    ASSERT_TRUE(joint.ok()) << toLogLine(joint.error());
    const auto fits = checkScenario(*scenario, *joint, {file, {}, {}, {}});
    EXPECT_TRUE(fits.ok()) << toLogLine(fits.error());
    if (scenario->input.empty()) continue;
    const auto path = resolveRecording(scenario->input, folderOf(file), kResources);
    ASSERT_TRUE(path.ok()) << toLogLine(path.error());
    const auto input = loadRecording(*path);
    ASSERT_TRUE(input.ok()) << toLogLine(input.error());
    for (const HandTrack& track : input->tracks) EXPECT_GE(findTool(*scenario, track.tool), 0) << track.tool;
  }
}

TEST(Shipped, jointsAreAsTheyWereSaved) {
  const auto folders = filesOf("joints", ".joint");
  EXPECT_FALSE(folders.empty());
  for (const std::string& folder : folders) {
    const auto joint = loadJoint(folder);
    ASSERT_TRUE(joint.ok()) << toLogLine(joint.error());
    const auto checked = checkJoint(*joint, folder);
    EXPECT_TRUE(checked.ok()) << toLogLine(checked.error());
  }
}

TEST(Shipped, recordingsNameScenariosThatShip) {
  for (const std::string& file : filesOf("recordings", ".recording")) {
    const auto recording = loadRecording(file);
    ASSERT_TRUE(recording.ok()) << toLogLine(recording.error());
    EXPECT_TRUE(resolveScenario(recording->scenario, folderOf(file), kResources).ok()) << recording->scenario;
  }
}

}  // namespace
}  // namespace glenoid
