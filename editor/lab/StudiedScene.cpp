// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/lab/StudiedScene.h"

#include <QCoreApplication>
#include <algorithm>
#include <filesystem>

#include "editor/core/SameScene.h"
#include "editor/lab/SettingWords.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecordingFile.h"
#include "simcore/scene/ScenarioFile.h"

namespace glenoid {
namespace {

struct StudiedSceneTexts {
  Q_DECLARE_TR_FUNCTIONS(glenoid::StudiedScene)
};

bool isBuiltin(const std::string& reference) { return reference.rfind("builtin:", 0) == 0; }

bool sameSettings(const Scenario& a, const Scenario& b) {
  return a.profile == b.profile && a.dt == b.dt && a.elements == b.elements && a.contactDistance == b.contactDistance && a.recoverySpeedMax == b.recoverySpeedMax;
}

}  // namespace

Result<std::shared_ptr<const StudiedScene>> StudiedScene::make(Scene scene) {
  const auto model = compileModel(scene.joint, scene.scenario);
  if (!model) return model.error();
  auto studied = std::make_shared<StudiedScene>();
  studied->m_settings = accuracySettings(**model, false);
  studied->m_scene = std::move(scene);
  return std::shared_ptr<const StudiedScene>(std::move(studied));
}

Result<Scene> StudiedScene::with(const std::string& setting) const {
  const auto found = std::find_if(m_settings.begin(), m_settings.end(), [&](const AccuracySetting& one) { return one.id == setting; });
  if (found == m_settings.end() || !fitsScenario(*found)) return Error{Fault::UnknownId, {}, {setting, "setting"}, "study"};
  Scene made = m_scene;
  made.scenario = scenarioWith(*found, m_scene.scenario);
  if (found->cells == 1 && !found->visualContact) return made;
  Result<Joint> joint = jointWith(*found, m_scene.joint);
  if (!joint) return joint.error();
  made.joint = std::move(*joint);
  return made;
}

Result<std::string> saveStudied(const Scene& scene, const std::string& folder, const std::string& stem) {
  namespace fs = std::filesystem;
  const auto at = [&](const char* ending) { return (fs::path(folder) / (stem + ending)).string(); };
  Scenario scenario = scene.scenario;
  if (const auto saved = saveJoint(scene.joint, at(".joint")); !saved) return saved.error();
  scenario.joint = stem + ".joint";
  if (!isBuiltin(scenario.input)) scenario.input.clear();
  if (scene.input && scenario.input.empty()) {
    if (const auto saved = saveRecording(*scene.input, at(".recording")); !saved) return saved.error();
    scenario.input = stem + ".recording";
  }
  if (const auto saved = saveScenario(scenario, at(".scenario.json")); !saved) return saved.error();
  return at(".scenario.json");
}

SettingApplied applySetting(Document& document, const Scene& studied, const Scene& made, const std::optional<Joint>& lastMade, const QString& words) {
  Scene after = document.scene();
  after.scenario.profile = made.scenario.profile;
  after.scenario.dt = made.scenario.dt;
  after.scenario.elements = made.scenario.elements;
  after.scenario.contactDistance = made.scenario.contactDistance;
  after.scenario.recoverySpeedMax = made.scenario.recoverySpeedMax;
  const bool ours = sameJoint(document.joint(), studied.joint) || (lastMade && sameJoint(document.joint(), *lastMade));
  const bool wantsJoint = !sameJoint(made.joint, studied.joint);
  if (wantsJoint && !ours)
    return {true, StudiedSceneTexts::tr("The joint was edited since it was studied, and this setting would put other cells or surfaces in its place. Study it again first.")};
  if (ours) after.joint = made.joint;
  const QString sentence = changedSentence(document.scene(), after);
  ChangeSet changes = changesBetween(document.joint(), after.joint);
  if (sameJoint(document.joint(), after.joint) && sameSettings(document.scenario(), after.scenario)) return {};
  changes.model = changes.settings = true;
  document.edit(StudiedSceneTexts::tr("Use the setting: %1").arg(words), changes, [&](Scene& scene) { scene = after; });
  return {false, sentence};
}

}  // namespace glenoid
