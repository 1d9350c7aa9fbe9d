// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// Surfaces for other programs, in the format that the file's ending names, capitals or not: PLY (binary, double), OBJ (text, 17
/// digits; both read back bit for bit) or STL (binary, single precision; triangles without shared corners). Units and frame are
/// the caller's.

/// "PLY", "OBJ" or "STL" by the ending; empty for another.
std::string writtenFormat(const std::string& path);
inline bool isWrittenAsSurface(const std::string& path) { return !writtenFormat(path).empty(); }

/// Atomic. Fails with UnknownFormat (another ending, or none), with BadMesh, NotFinite (in STL a coordinate beyond single
/// precision too) or BadIndex as writePly does, and as writeWholeFile does.
Result<Done> writeSurface(const std::string& path, const TriMesh& mesh);

}  // namespace glenoid
