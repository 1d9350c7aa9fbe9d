// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/MirrorFile.h"

#include <cstdio>
#include <filesystem>

#include "app/Resources.h"
#include "app/commands/Console.h"
#include "app/commands/OpenScene.h"
#include "simcore/author/MirrorJoint.h"
#include "simcore/file/Json.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecordingFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "simcore/scene/SceneWords.h"

namespace glenoid {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view kScenarioEnding = ".scenario.json";

/// A recipe has parts and no meshes of its own: its surfaces lie in files of other programs, which are not ours to mirror.
bool isRecipe(const std::string& word) {
  std::error_code ignored;
  if (!fs::is_regular_file(word, ignored)) return false;
  const auto json = readJson(word);
  return json.ok() && json->find("parts") && json->find("materials");
}

void list(const char* what, const std::vector<std::string>& words) {
  if (words.empty()) return;
  std::printf("%s", what);
  for (std::size_t i = 0; i < words.size(); ++i) std::printf("%s “%s”", i ? "," : "", words[i].c_str());
  std::putchar('\n');
}

Result<Done> saveMirrored(const Joint& joint, const std::string& out) {
  const Joint mirrored = mirroredJoint(joint);
  if (const auto saved = saveJoint(mirrored, out); !saved) return saved;
  const std::string side = scene_words::wordOf(scene_words::kJointSides, mirrored.side);
  std::printf("%s: %s, hash %s\n", out.c_str(), side.empty() ? "of no side, since the original says none" : ("side " + side).c_str(),
              jointHash(mirrored).c_str());
  const SideWords words = sideWordsOf(joint);
  list("names that say the other side now, before:", words.names);
  list("ids that say a side and stay:", words.ids);
  list("sentences that say a side and stay:", words.sentences);
  return Done{};
}

Result<Done> mirrorScene(const std::string& word, const std::string& out) {
  if (!out.ends_with(kScenarioEnding))
    return usageError("of a scenario joint mirror writes a scenario: --out must end with .scenario.json, not “" + out + "”");
  const Result<OpenScene> scene = openScenario(word);
  if (!scene) return scene.error();
  const auto input = openShippedInput(word, scene->scenario);
  if (!input) return input.error();
  const std::string stem = out.substr(0, out.size() - kScenarioEnding.size());
  Scenario mirrored = mirroredScenario(scene->scenario);
  mirrored.joint = fs::path(stem + ".joint").filename().string();
  mirrored.input.clear();
  if (const auto saved = saveMirrored(scene->joint, stem + ".joint"); !saved) return saved;
  if (*input) {
    Recording hands = mirroredRecording(**input);
    hands.scenario = fs::path(out).filename().string();
    mirrored.input = fs::path(stem + ".recording").filename().string();
    if (const auto saved = saveRecording(hands, stem + ".recording"); !saved) return saved;
    std::printf("%s.recording: the hands\n", stem.c_str());
  }
  if (const auto saved = saveScenario(mirrored, out); !saved) return saved;
  std::printf("%s: the scenario\n", out.c_str());
  return Done{};
}

}  // namespace

Result<Done> mirrorFile(const std::string& word, const std::string& out) {
  if (isRecipe(word))
    return usageError("“" + word + "” is a recipe, and its surfaces are other programs' files: build the joint and mirror that");
  if (!namesJoint(word)) return mirrorScene(word, out);
  if (out.ends_with(".json"))
    return usageError("of a joint joint mirror writes a joint: --out wants a .joint folder, not “" + out + "”");
  const Result<Joint> joint = openJoint(word);
  if (!joint) return joint.error();
  return saveMirrored(*joint, out);
}

}  // namespace glenoid
