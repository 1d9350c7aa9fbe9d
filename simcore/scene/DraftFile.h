// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"
#include "simcore/scene/Joint.h"
#include "simcore/scene/Scenario.h"

namespace glenoid {

/// A joint and its scenario as they are in memory, finished or not: what saveJoint would refuse (a part without material,
/// without volume, a reference that leads nowhere) is kept all the same. For the program's own safety copies, never for
/// an author's project.
struct Draft {
  Joint joint;
  Scenario scenario;
};

/// Writes joint.json, scenario.json and meshes/ into an existing empty folder. Each mesh is written once into `blobs`, a
/// folder on the same file system that many drafts share, and linked from there: a blob has its name only when it is
/// whole. Numbers that are not finite are lost. Fails with FileMissing or FileUnwritable.
Result<Done> saveDraft(const Draft& draft, const std::string& folder, const std::string& blobs);

/// Reads it back. Fails as readJson, readPly and readVtk do; a mesh that was missing stays missing.
Result<Draft> loadDraft(const std::string& folder);

}  // namespace glenoid
