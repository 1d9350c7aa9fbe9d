// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

#include "simcore/base/Error.h"
#include "simcore/mesh/TetMesh.h"

namespace glenoid {

/// Legacy VTK unstructured grids of linear tetrahedra, versions 1 to 4 (cells with counts) and 5 (offsets and
/// connectivity), ascii and binary (big endian). Data attached to points or cells is skipped. Units and frame are
/// the file's. Source: "VTK File Formats", The VTK User's Guide, 11th edition, 2010.

enum class VtkEncoding { Ascii, Binary };

/// A tetrahedron is without volume when volume ≤ this times the cube of its longest edge: round-off of flat
/// elements in double coordinates is about 1e-14, useful elements are above 1e-5.
inline constexpr double kFlatTetrahedron = 1e-10;

/// Fails as readWholeFile does and with UnknownFormat (no legacy VTK, or no unstructured grid), BadMesh (other cells,
/// a header that makes no sense), FileTruncated, NotFinite (element: node), BadIndex (arguments: index, size; element:
/// tetrahedron) or BadElement (argument: volume in m³; element: tetrahedron).
Result<TetMesh> readVtk(const std::string& path);
Result<TetMesh> parseVtk(std::string_view bytes, const std::string& file);

/// Version 3.0; doubles come back bit for bit in either encoding. Atomic. Fails with NotFinite, BadIndex or BadElement
/// (nothing is written that readVtk would refuse) and as writeWholeFile does.
Result<Done> writeVtk(const std::string& path, const TetMesh& mesh, VtkEncoding encoding = VtkEncoding::Binary);

/// The checks that both share: finite nodes, indices in range, positive volume.
Result<Done> checkTetMesh(const TetMesh& mesh, const std::string& file);

}  // namespace glenoid
