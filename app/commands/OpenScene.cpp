// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/OpenScene.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>

#include "app/Resources.h"
#include "app/commands/Console.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecordingFile.h"
#include "simcore/scene/ResourcePaths.h"
#include "simcore/scene/ScenarioFile.h"

namespace glenoid {
namespace {

Wish* wishNamed(Effects& effects, const std::string& name) {
  if (name == "gravity") return &effects.gravity;
  if (name == "couplings") return &effects.couplings;
  if (name == "contact") return &effects.contact;
  if (name == "selfContact") return &effects.selfContact;
  if (name == "bursa") return &effects.bursa;
  if (name == "dent") return &effects.dent;
  if (name == "friction") return &effects.friction;
  if (name == "damping") return &effects.damping;
  if (name == "haptics") return &effects.haptics;
  return nullptr;
}

}  // namespace

Result<OpenScene> openScenario(const std::string& word) {
  if (namesJoint(word)) return usageError("“" + word + "” is a joint, and a scenario is wanted, which says who stays and what pulls");
  const Result<std::string> path = resolveScenario(word, "", resourceRoot());
  if (!path) return path.error();
  Result<Scenario> scenario = loadScenario(*path);
  if (!scenario) return scenario.error();
  const Result<std::string> folder = resolveJoint(scenario->joint, folderOf(*path), resourceRoot());
  if (!folder) {  // the reference stands in this file
    Error error = folder.error();
    error.place = {*path, "/joint", "", {}};
    return error;
  }
  Result<Joint> joint = loadJoint(*folder);
  if (!joint) return joint.error();
  if (const auto fits = checkScenario(*scenario, *joint, Place{*path, "", "", {}}); !fits) return fits.error();
  return OpenScene{std::move(*joint), std::move(*scenario)};
}

Result<Joint> openJoint(const std::string& word) {
  const Result<std::string> folder = resolveJoint(word, "", resourceRoot());
  if (!folder) return folder.error();
  return loadJoint(*folder);
}

OpenScene sceneAround(Joint joint) {
  OpenScene scene;
  scene.scenario.id = joint.id;
  scene.scenario.name = joint.name;
  scene.joint = std::move(joint);
  return scene;
}

Result<OpenScene> openSceneOrJoint(const std::string& word) {
  if (!namesJoint(word)) return openScenario(word);
  Result<Joint> joint = openJoint(word);
  if (!joint) return joint.error();
  return sceneAround(std::move(*joint));
}

Result<Recording> openRecording(const std::string& word) {
  const Result<std::string> path = resolveRecording(word, "", resourceRoot());
  if (!path) return path.error();
  return loadRecording(*path);
}

Result<std::optional<Recording>> openShippedInput(const std::string& word, const Scenario& scenario) {
  if (scenario.input.empty()) return std::optional<Recording>();
  const Result<std::string> file = resolveScenario(word, "", resourceRoot());
  if (!file) return file.error();
  const Result<std::string> path = resolveRecording(scenario.input, folderOf(*file), resourceRoot());
  if (!path) {
    Error error = path.error();
    error.place = {*file, "/input", "", {}};
    return error;
  }
  Result<Recording> recording = loadRecording(*path);
  if (!recording) return recording.error();
  return std::optional<Recording>(std::move(*recording));
}

Result<std::optional<Recording>> openInput(const std::string& named, const std::string& word, const Scenario& scenario) {
  if (named.empty()) return openShippedInput(word, scenario);
  Result<Recording> recording = openRecording(named);
  if (!recording) return recording.error();
  return std::optional<Recording>(std::move(*recording));
}

Result<Done> applyEffects(const std::string& list, Effects& effects) {
  std::istringstream words(list);
  std::string word;
  while (std::getline(words, word, ',')) {
    const auto equals = word.find('=');
    if (equals == std::string::npos) return usageError("--effects wants EFFECT=on, off or auto, not “" + word + "”");
    const std::string name = word.substr(0, equals), value = word.substr(equals + 1);
    Wish* wish = wishNamed(effects, name);
    if (!wish) return usageError("there is no effect “" + name + "”");
    if (value == "on") *wish = Wish::On;
    else if (value == "off") *wish = Wish::Off;
    else if (value == "auto") *wish = Wish::Auto;
    else return usageError("an effect is on, off or auto, not “" + value + "”");
  }
  return Done{};
}

Result<Done> applyPaper(const std::string& list, PaperSettings& settings) {
  std::istringstream words(list);
  std::string word;
  while (std::getline(words, word, ',')) {
    const auto equals = word.find('=');
    const std::string value = equals == std::string::npos ? "" : word.substr(equals + 1);
    if (value != "on" && value != "off") return usageError("--paper wants ADDITION=on or off, not “" + word + "”");
    bool* setting = paperSetting(settings, word.substr(0, equals));
    if (!setting) return usageError("the paper profile has no addition “" + word.substr(0, equals) + "”: tension, recovery-cap, parts, search-again or stretch-law");
    *setting = value == "on";
  }
  return Done{};
}

Result<double> lengthNamed(const std::string& option, const std::string& word) {
  if (word == "none") return std::numeric_limits<double>::infinity();
  double value = 0;
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
  const std::string unit(end, word.data() + word.size());
  if (fault != std::errc() || !(value > 0) || !(unit.empty() || unit == "m" || unit == "mm") || !std::isfinite(value))
    return usageError(option + " wants a length above zero, such as 0.5mm or 0.0005, or none, not “" + word + "”");
  return unit == "mm" ? 1e-3 * value : value;
}

Result<double> durationNamed(const std::string& option, const std::string& word) {
  double value = 0;
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
  const std::string unit(end, word.data() + word.size());
  const double seconds = unit.empty() || unit == "s" ? 1 : unit == "ms" ? 1e-3 : unit == "min" ? 60 : unit == "h" ? 3600 : 0;
  if (fault != std::errc() || !(value * seconds > 0) || !std::isfinite(value * seconds))
    return usageError(option + " wants a time above zero, such as 600s, 10min or 2h, not “" + word + "”");
  return value * seconds;
}

}  // namespace glenoid
