// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>

#include "simcore/import/ImportedFile.h"
#include "simcore/import/MeshFormat.h"

namespace glenoid {

/// What the head of a file says of its axes: SPACE=LPS or SPACE=RAS in the header of an STL, in comments of OBJ and PLY and in the
/// title or a field of legacy VTK, as 3D Slicer writes it; the axis that points up of COLLADA, FBX and glTF. VTP says it in an
/// array, which its reader looks for.
FileAxes axesSaidIn(std::string_view bytes, MeshFormat format);

/// "LPS" or "RAS" behind "SPACE=" in a text, in any case; Unsaid where there is neither.
FileAxes spaceIn(std::string_view text);
/// "LPS", "RAS" alone.
FileAxes spaceNamed(std::string_view word);

/// What BodyParts3D writes in the comments of an OBJ, whose own names are numbers: the part's English name and the unit of its
/// bounds. Empty, and nothing, for other files.
struct ObjComments {
  std::string name;
  std::optional<double> metresPerUnit;
};
ObjComments objComments(std::string_view bytes);

}  // namespace glenoid
