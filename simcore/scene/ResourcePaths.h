// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"

namespace glenoid {

/// Folder of what ships with the program: joints/, scenarios/, recordings/.
struct ResourceFolders {
  std::string root;
};

/// What a reference inside a file or on the command line names, as a path. "builtin:NAME" (one slug) is looked up below
/// `resourcesRoot` and must exist: UnknownId otherwise (arguments: NAME, kind, then every name that exists). Anything
/// else is a path, relative ones from `baseFolder` (empty: the working folder); whether it exists is found on loading.
/// Fails with BadReference for an empty reference.
Result<std::string> resolveJoint(const std::string& reference, const std::string& baseFolder,
                                 const std::string& resourcesRoot);     ///< joints/NAME.joint
Result<std::string> resolveScenario(const std::string& reference, const std::string& baseFolder,
                                    const std::string& resourcesRoot);  ///< scenarios/NAME.scenario.json
Result<std::string> resolveRecording(const std::string& reference, const std::string& baseFolder,
                                     const std::string& resourcesRoot); ///< recordings/NAME.recording

/// Folder of a file, for `baseFolder`; "" when the path has none.
std::string folderOf(const std::string& path);

}  // namespace glenoid
