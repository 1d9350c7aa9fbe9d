// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "simcore/base/Error.h"
#include "simcore/scene/Joint.h"
#include "simcore/scene/Recording.h"
#include "simcore/scene/Scenario.h"
#include "simcore/step/Model.h"
#include "simcore/step/PaperSettings.h"

namespace glenoid {

/// A scenario with what it refers to, read from files and not yet compiled.
struct OpenScene {
  Joint joint;
  Scenario scenario;
};

/// SCENARIO of the command line: a file or "builtin:NAME". Fails as loading does, with BadUsage for a joint.
Result<OpenScene> openScenario(const std::string& word);

/// JOINT of the command line: a folder or "builtin:NAME".
Result<Joint> openJoint(const std::string& word);

/// A joint for looking at: no tools, nothing held, no contact.
OpenScene sceneAround(Joint joint);

/// SCENARIO or JOINT.
Result<OpenScene> openSceneOrJoint(const std::string& word);

/// A recording file or "builtin:NAME".
Result<Recording> openRecording(const std::string& word);

/// The recording that the scenario ships with; nothing when it names none. `word`: how the scenario was named.
Result<std::optional<Recording>> openShippedInput(const std::string& word, const Scenario& scenario);

/// The recording that `named` says, as openRecording; where it is empty the one that the scenario ships with.
Result<std::optional<Recording>> openInput(const std::string& named, const std::string& word, const Scenario& scenario);

/// Sets effects from "friction=off,bursa=on" (also "auto"). Fails with BadUsage naming the word.
Result<Done> applyEffects(const std::string& list, Effects& effects);

/// Sets what the `paper` profile adds from "tension=on,parts=off". Fails with BadUsage naming the word.
Result<Done> applyPaper(const std::string& list, PaperSettings& settings);

/// A length, m: "0.001", "0.001m" or "1mm"; "none" is infinite. Fails with BadUsage naming the option.
Result<double> lengthNamed(const std::string& option, const std::string& word);

/// "600s", "600", "10min", "2h" in seconds, > 0. Fails with BadUsage.
Result<double> durationNamed(const std::string& option, const std::string& word);

}  // namespace glenoid
