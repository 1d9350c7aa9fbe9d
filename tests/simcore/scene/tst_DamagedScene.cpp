// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecordingFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "tests/simcore/file/TemporaryFolder.h"
#include "tests/simcore/scene/SampleJoint.h"

// Every file of a joint, a scenario and a recording, cut and with bytes changed: always an answer.
namespace glenoid {
namespace {

/// splitmix64 (Steele, Lea, Flood 2014): the same damage on every machine.
std::uint64_t next(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15ull);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

/// Calls `load` on 50 cuts, each of which must be refused, and on changed bytes, which may still be valid.
template <class Load>
void damage(const TemporaryFolder& folder, const std::string& name, Load&& load) {
  const std::string whole = folder.get(name);
  for (std::size_t cut = 0; cut < 50; ++cut) {
    folder.put(name, whole.substr(0, whole.size() * cut / 50));
    const auto loaded = load();
    ASSERT_FALSE(loaded.ok()) << name << " cut " << cut;
    EXPECT_FALSE(loaded.error().place.file.empty()) << name << " cut " << cut;
    EXPECT_NE(loaded.error().fault, Fault::Internal);
  }
  std::uint64_t state = 11;
  int refused = 0;
  for (int round = 0; round < 200; ++round) {
    std::string damaged = whole;
    damaged[next(state) % damaged.size()] = static_cast<char>(next(state));
    folder.put(name, damaged);
    const auto loaded = load();
    if (loaded.ok()) continue;
    ++refused;
    EXPECT_FALSE(loaded.error().place.file.empty());
    EXPECT_NE(loaded.error().fault, Fault::Internal);
  }
  EXPECT_GT(refused, 0) << name;
  folder.put(name, whole);
  ASSERT_TRUE(load().ok());
}

TEST(DamagedScene, joint) {
  const TemporaryFolder folder;
  ASSERT_TRUE(saveJoint(sampleJoint(), folder.path("s.joint")).ok());
  std::vector<std::string> names{"s.joint/joint.json"};
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("s.joint/meshes")))
    names.push_back("s.joint/meshes/" + entry.path().filename().string());
  ASSERT_EQ(names.size(), 5u);
  for (const std::string& name : names)
    damage(folder, name, [&] { return loadJoint(folder.path("s.joint")); });
}

TEST(DamagedScene, scenario) {
  const TemporaryFolder folder;
  Scenario scenario;
  scenario.id = scenario.name = "a";
  scenario.joint = "s.joint";
  scenario.tools.resize(1);
  scenario.tools[0].id = "probe";
  scenario.holds = {{"humerus", 1, 2, 3}};
  scenario.cameras.resize(1);
  scenario.cameras[0].id = "front";
  ASSERT_TRUE(saveScenario(scenario, folder.path("a.scenario.json")).ok());
  damage(folder, "a.scenario.json", [&] { return loadScenario(folder.path("a.scenario.json")); });
}

TEST(DamagedScene, recording) {
  const TemporaryFolder folder;
  Recording recording;
  recording.scenario = "a";
  recording.tracks = {{"probe", {{0, {}}, {1.5, {{0.1, 0.2, 0.3}, Quat::Identity()}}}}};
  recording.marks = {{"m", 0, 1, "probe", "cuff"}};
  ASSERT_TRUE(saveRecording(recording, folder.path("a.recording")).ok());
  damage(folder, "a.recording", [&] { return loadRecording(folder.path("a.recording")); });
}

}  // namespace
}  // namespace glenoid
