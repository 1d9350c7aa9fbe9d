// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/repair/Edges.h"

namespace glenoid {

/// A crack: a rim whose lips lie nearer to each other than a share of its edges, however long it is. A body with one still
/// encloses what it did; nothing is missing that a lid or a second wall would have to stand for.

/// Triangles over a rim, made by cutting off the ear of least area again and again, and their area together: at most a little
/// more than the least there is where lips lie on each other.
struct RimLid {
  Triangles triangles;
  double area = 0;
};
RimLid lidOfEars(const TriMesh& mesh, const std::vector<int>& loop);

/// Twice the lid's area over the rim's length, the mean distance of its lips, is less than a fifth of its mean edge, and the lid
/// is less than a twentieth of the shell's `area`: the rim of a narrow strip is none.
bool isCrack(const TriMesh& mesh, const std::vector<int>& loop, double area);

/// Vertices that face each other across a crack of a shell that is no sheet, each the other's nearest, become one half way between; triangles that lose a
/// corner go. What has no partner stays open, for a lid. `changed`: vertices that went.
TriMesh zipped(const TriMesh& mesh, long& changed);

}  // namespace glenoid
