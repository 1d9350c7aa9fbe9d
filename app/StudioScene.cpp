// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/StudioScene.h"

#include <filesystem>

#include "app/Resources.h"
#include "app/commands/OpenScene.h"
#include "app/commands/StabilityFiles.h"
#include "simcore/author/BuildJoint.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecipeFile.h"
#include "simcore/scene/RecordingFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "simcore/scene/training/TrainingCheck.h"
#include "simcore/live/RunReport.h"
#include "simcore/starter/Starter.h"

namespace glenoid {
namespace {

/// Takes out what a scenario says of parts that are not, of the same kind, in the joint.
void keepTo(const Joint& joint, const Joint& alsoIn, Scenario& scenario) {
  const auto there = [&](const std::string& id) {
    const int a = findPart(joint, id), b = findPart(alsoIn, id);
    return a >= 0 && b >= 0 && joint.parts[a].kind == alsoIn.parts[b].kind;
  };
  std::erase_if(scenario.fixedParts, [&](const std::string& id) { return !there(id); });
  std::erase_if(scenario.selfContactParts, [&](const std::string& id) { return !there(id); });
  const auto keep = [&](auto& actions) { std::erase_if(actions, [&](const auto& action) { return !there(action.part); }); };
  keep(scenario.holds);
  keep(scenario.loads);
  keep(scenario.motions);
  const auto keepRegions = [&](auto& actions) {
    std::erase_if(actions, [&](const auto& action) {
      return !there(action.part) || !findRegion(joint.parts[findPart(joint, action.part)], action.region) ||
             !findRegion(alsoIn.parts[findPart(alsoIn, action.part)], action.region);
    });
  };
  keepRegions(scenario.pressures);
  keepRegions(scenario.supports);
  for (const Joint* each : {&joint, &alsoIn}) keepTrainingTo(*each, scenario.training);
  for (Tool& tool : scenario.tools) std::erase_if(tool.perforates, [&](const std::string& id) { return !there(id); });
}

/// Where the scenario on disk would not fit the joint that is about to be saved beside it, puts one there that fits both
/// the old joint and the new one.
Result<Done> bridgeScenario(const Joint& joint, const Scenario& scenario, const std::string& path, const std::string& jointFolder) {
  const auto old = loadScenario(path);
  if (!old || checkScenario(*old, joint, {})) return Done{};
  const auto oldJoint = loadJoint(jointFolder);
  if (!oldJoint) return Done{};  // nothing there that would have to be kept together
  if (const auto good = checkJoint(joint, jointFolder); !good) return good;  // nothing is written where the joint is refused
  Scenario bridge = scenario;
  keepTo(joint, *oldJoint, bridge);
  return saveScenario(bridge, path);
}

}  // namespace

namespace {

/// The scene that was recorded, as it was run, with the recorded hands.
Result<Scene> loadRecorded(const std::string& word) {
  Result<Recording> recording = openRecording(word);
  if (!recording) return recording.error();
  Result<OpenScene> opened = openScenario(recording->scenario);
  if (!opened) {
    Error error = opened.error();
    if (error.place.file.empty()) error.place.file = word;
    return error;
  }
  Scene scene{std::move(opened->joint), std::move(opened->scenario), nullptr};
  scene.scenario.dt = recording->dt;
  scene.scenario.seed = recording->seed;
  if (const auto profile = profileNamed(recording->profile)) scene.scenario.profile = *profile;
  for (const HandTrack& track : recording->tracks)
    if (findTool(scene.scenario, track.tool) < 0) return Error{Fault::UnknownId, {word, "/tracks", track.tool, {}}, {track.tool, "tool"}, "recording's track"};
  scene.input = std::make_shared<const Recording>(std::move(*recording));
  return scene;
}

}  // namespace

Result<Scene> loadScene(const std::string& word) {
  if (word.ends_with(".recording")) return loadRecorded(word);
  auto opened = openSceneOrJoint(word);
  if (!opened.ok()) return opened.error();
  Scene scene{std::move(opened->joint), std::move(opened->scenario), nullptr};
  auto input = openShippedInput(word, scene.scenario);
  if (!input.ok()) return input.error();
  if (*input) scene.input = std::make_shared<const Recording>(std::move(**input));
  return scene;
}

LabServices labServices(const QString& program) {
  LabServices services;
  services.program = program;
  services.loader = loadScene;
  services.trial = [](const std::string& path) -> Result<TrialToReplay> {
    const Result<Recording> recording = loadRecording(path);
    if (!recording) return recording.error();
    Result<StabilityAgain> again = openStabilityAgain(*recording);
    if (!again) return again.error();
    return TrialToReplay{std::move(again->run), again->trial.id(), recording->steps, recording->stateHash, std::move(again->stage)};
  };
  return services;
}

Result<std::string> startScene(const std::string& kind, const std::string& folder, const std::function<bool(double)>& goOn) {
  const StarterKind* const starter = findStarter(kind);
  if (!starter) return Error{Fault::UnknownId, {}, {kind, "starter"}, "new joint"};
  constexpr double kMade = 0.4;  // of the time, for the surfaces
  const auto files = saveStarter(*starter, resourceRoot(), folder);
  if (!files) return files.error();
  const auto recipe = loadRecipe(files->recipe, files->meshes);
  if (!recipe) return recipe.error();
  const auto joint = buildJoint(*recipe, [&](const std::string&, double done) { return !goOn || goOn(kMade + (1 - kMade) * done); });
  if (!joint) return joint.error();
  if (const auto saved = saveJoint(*joint, files->joint); !saved) return saved.error();
  return files->scenario;
}

Result<Done> saveScene(const Scene& scene, const std::string& path) {
  static const std::string kEnding = ".scenario.json";
  namespace fs = std::filesystem;
  std::string stem = fs::path(path).filename().string();
  if (stem.size() > kEnding.size() && stem.ends_with(kEnding)) stem.resize(stem.size() - kEnding.size());
  const fs::path folder = fs::path(path).parent_path();
  // A scenario that is saved where it lies keeps its joint beside it, whatever that is called.
  const Result<Scenario> before = loadScenario(path);
  const bool own = before && before->joint == scene.scenario.joint && before->joint.rfind("builtin:", 0) != 0 && before->joint.ends_with(".joint") &&
                   before->joint.find('/') == std::string::npos;
  const std::string jointName = own ? before->joint : stem + ".joint";
  Scenario scenario = scene.scenario;
  scenario.joint = jointName;
  // What was relative to the old place would not be found from the new one; a built-in input is found anywhere.
  const bool stays = before && before->input == scenario.input;
  if (!stays && scenario.input.rfind("builtin:", 0) != 0) scenario.input.clear();
  const std::string jointFolder = (folder / jointName).string();
  // Two files cannot change at once. Should the program be killed between them, what lies there must still fit together.
  if (const auto bridged = bridgeScenario(scene.joint, scenario, path, jointFolder); !bridged) return bridged;
  auto joint = saveJoint(scene.joint, jointFolder);
  if (!joint.ok()) return joint.error();
  return saveScenario(scenario, path);
}

}  // namespace glenoid
