// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"
#include "simcore/scene/Joint.h"

/// What a joint must keep beyond its schema; shared by the files of this folder.
namespace glenoid::joint_check {

/// Ids and numbers unique, references to materials, regions and parts that exist, runs of triangles ascending. No mesh
/// is looked at. Fails with DuplicateId, UnknownId, BadReference, OutOfRange or Unusable; pointers as in joint.json.
Result<Done> checkValues(const Joint& joint, const std::string& file);

/// Meshes there and sound, volumes on soft parts only, regions inside their surface. Fails with BadMesh, BadIndex,
/// NotFinite or BadElement; the place names the part.
Result<Done> checkMeshes(const Joint& joint, const std::string& file);

}  // namespace glenoid::joint_check
