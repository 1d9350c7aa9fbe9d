// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/import/ImportedFile.h"

namespace glenoid {

/// STL and OBJ as many programs write them, brought to what the reader behind takes, and the names that it would cut or merge.
/// Numbers are not touched.
struct TextSurfaces {
  std::string bytes;               ///< for the reader; empty: the file as it is
  std::vector<std::string> names;  ///< whole, in the file's order
  bool named = false;              ///< OBJ: whether any line names an object or a group
};

/// ASCII: keywords in any case, lines or marks before the first word, names of several words. Binary: bytes behind the triangles
/// that the header counts are left out. Fails with FileTruncated where a file ends within a triangle or, binary, holds fewer than it counts, and with BadMesh
/// (argument: what) for what is no STL at all.
Result<TextSurfaces> stlForReader(std::string_view bytes, const std::string& path);

/// Every `o` line becomes a name of its own without spaces; `names` are what they were. Groups (`g`) stay.
TextSurfaces objForReader(std::string_view bytes);

/// Gives surfaces their whole names back: those the reader made of objForReader's, or of as many solids as there are surfaces.
void nameSurfaces(const TextSurfaces& text, bool objects, std::vector<ImportedSurface>& surfaces);

/// What stands in place of a surface where a download went wrong, in words; empty for anything else.
std::string notTheFile(std::string_view bytes);

}  // namespace glenoid
