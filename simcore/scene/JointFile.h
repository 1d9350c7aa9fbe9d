// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"
#include "simcore/scene/Joint.h"

namespace glenoid {

/// A joint on disk is the folder NAME.joint with joint.json and meshes/, whose files are named by content hash
/// (surfaces .ply, volumes .vtk). A mesh that several parts share is stored and loaded once. The same in one file is
/// NAME.jointz (JointArchive.h).

/// Reads and checks all of it; `path` is the folder, its joint.json, or an archive. Fails as readDocument, readPly and readVtk do and with DuplicateId, UnknownId
/// (arguments: id, kind), OutOfRange, BadReference (a mesh name that leaves the folder), HashMismatch (arguments:
/// found, named), BadMesh (a rigid part with a volume, a soft one without) or BadIndex (a region beyond its surface).
Result<Joint> loadJoint(const std::string& path);

/// Into a folder, or where the path ends in .jointz and is none, into an archive. Writes new meshes first, joint.json last, so that a save happened or it did not; then removes the mesh files that
/// only an older joint.json named. The first save over a joint.json of an older schema keeps it beside as
/// joint.v1.json, with its meshes. Other files in the folder stay. Makes the folder when its parent exists.
/// Fails as checkJoint does, before anything is written, and with FileMissing or FileUnwritable.
Result<Done> saveJoint(const Joint& joint, const std::string& folder);

/// What loadJoint asks of values and references, for a joint in memory; `file` only names it in errors. Pointers are
/// those of the joint.json it would become.
Result<Done> checkJoint(const Joint& joint, const std::string& file);

/// 32 hexadecimal digits over every value and every mesh of the joint: the same for a joint and its reloaded copy.
/// A mesh that is missing counts as such. Not for joints with numbers that are not finite.
std::string jointHash(const Joint& joint);

/// The same over what decides where the parts start and which of them may touch: meshes, cages and exclusions. A
/// joint's proof of its start holds while this is what the proof says.
std::string startHash(const Joint& joint);

/// The same over what decides how a part gives under a tip: its meshes, the elasticity of its materials, its regions
/// and its couplings. What Part::dents holds is right while this is its basis.
std::string dentBasis(const Joint& joint, const Part& part);

}  // namespace glenoid
