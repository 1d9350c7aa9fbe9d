// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/StudioScene.h"

#include <filesystem>

#include "app/commands/OpenScene.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/ScenarioFile.h"

namespace glenoid {

Result<Scene> loadScene(const std::string& word) {
  auto opened = openSceneOrJoint(word);
  if (!opened.ok()) return opened.error();
  Scene scene{std::move(opened->joint), std::move(opened->scenario), nullptr};
  auto input = openShippedInput(word, scene.scenario);
  if (!input.ok()) return input.error();
  if (*input) scene.input = std::make_shared<const Recording>(std::move(**input));
  return scene;
}

Result<Done> saveScene(const Scene& scene, const std::string& path) {
  static const std::string kEnding = ".scenario.json";
  namespace fs = std::filesystem;
  std::string stem = fs::path(path).filename().string();
  if (stem.size() > kEnding.size() && stem.ends_with(kEnding)) stem.resize(stem.size() - kEnding.size());
  const fs::path folder = fs::path(path).parent_path();
  const std::string jointName = stem + ".joint";
  Scenario scenario = scene.scenario;
  scenario.joint = jointName;
  // What was relative to the old place would not be found from the new one; a built-in input is found anywhere.
  if (scenario.input.rfind("builtin:", 0) != 0) scenario.input.clear();
  auto joint = saveJoint(scene.joint, (folder / jointName).string());
  if (!joint.ok()) return joint.error();
  return saveScenario(scenario, path);
}

}  // namespace glenoid
