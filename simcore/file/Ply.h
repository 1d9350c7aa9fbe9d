// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

#include "simcore/mesh/TriMesh.h"
#include "simcore/base/Error.h"

namespace glenoid {

/// Polygon file format (Stanford), version 1.0: ascii, binary little and big endian. Read are x, y, z of `vertex`
/// and `vertex_indices` (or `vertex_index`) of `face`; everything else is skipped. Units and frame are the file's.
/// Source: Greg Turk, "The PLY Polygon File Format", 1994.

/// What a reader should know about what was read.
struct PlyNotes {
  long polygonsSplit = 0;  ///< faces of more than three corners, cut into a fan at their first corner, concave ones where they can be
};

/// Fails as readWholeFile does and with UnknownFormat (no PLY), BadMesh (a header or row that makes no sense; a face
/// of fewer than three corners), FileTruncated (fewer rows than the header says), NotFinite (a coordinate) or BadIndex
/// (arguments: index, size). The place's element is the vertex or face, or the line of the header.
Result<TriMesh> readPly(const std::string& path, PlyNotes* notes = nullptr);
Result<TriMesh> parsePly(std::string_view bytes, const std::string& file, PlyNotes* notes = nullptr);

/// Binary little endian with double coordinates: reads back bit for bit. Atomic. Fails with NotFinite or BadIndex
/// (nothing is written that readPly would refuse) and as writeWholeFile does.
Result<Done> writePly(const std::string& path, const TriMesh& mesh);

}  // namespace glenoid
