// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>

#include "simcore/repair/Edges.h"

namespace glenoid {

/// A file with both sides of a body: shells fall into two groups that mirror each other.
struct MirrorSides {
  int axis = 0;       ///< across which they mirror
  double plane = 0;   ///< coordinate between them; no shell reaches across
};
std::optional<MirrorSides> findMirrorSides(const TriMesh& mesh, const Shells& shells);

}  // namespace glenoid
