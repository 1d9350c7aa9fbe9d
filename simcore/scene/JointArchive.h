// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"
#include "simcore/scene/Joint.h"

/// One joint in one file: NAME.jointz is a zip of joint.json and the meshes it names, as they lie in a .joint folder. A folder
/// around them, as zipping one by hand makes it, is taken off. loadJoint and saveJoint take such files where they take folders.
namespace glenoid {

/// By the ending; capitals or not.
bool isJointArchive(const std::string& path);

/// Fails as loadJoint and writeZip do.
Result<Done> packJoint(const std::string& folder, const std::string& archive);

/// Makes the folder, which must not be there or be empty, with all of the joint or not at all. Fails with FileUnwritable, as
/// readZip does and, when what it holds is no joint, as loadJoint does.
Result<Done> unpackJoint(const std::string& archive, const std::string& folder);

/// The joint in an archive; errors name the archive. Fails as readZip and loadJoint do.
Result<Joint> loadJointArchive(const std::string& archive);

/// Fails as saveJoint and writeZip do; what was there before is then as it was.
Result<Done> saveJointArchive(const Joint& joint, const std::string& archive);

}  // namespace glenoid
