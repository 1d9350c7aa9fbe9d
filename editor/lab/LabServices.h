// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <functional>
#include <memory>
#include <string>

#include "editor/core/Document.h"
#include "simcore/study/StabilityRun.h"

namespace glenoid {

/// A trial of the gauntlet to be seen again, as a recording of it says.
struct TrialToReplay {
  StabilityRun run;
  std::string id;         ///< "press.probe-humerus.5ms"
  long steps = 0;         ///< it had
  std::string stateHash;  ///< at its end; empty: not known
  std::shared_ptr<const void> stage = {};  ///< what the run may look into
};

/// What the lab asks of the application, since where things lie is its business.
struct LabServices {
  QString program;     ///< glenoid itself; empty: studies cannot be run
  SceneLoader loader;  ///< the scene that a study names
  /// The trial that a recording in a study's folder is of; compiles its scene, so on a worker. Fails as loading does and with UnknownId.
  std::function<Result<TrialToReplay>(const std::string& recording)> trial;
};

}  // namespace glenoid
