// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "editor/render/Tissue.h"

/// Coordinates along, across and through the fibres of a muscle or a band, at its vertices; m. `along` falls towards
/// the end. False, with nothing changed, when start and end are one place.
namespace glenoid {

/// Fibres as a fan: they converge to a point beyond `end`, at `beyond` times the way from `from`, in the sheet in which
/// the muscle is widest. A band's are parallel: that point is then far away.
bool layFibres(const TriMesh& mesh, const Vec3& from, const Vec3& end, double beyond, Tissue& tissue);

/// Fibres that follow a muscle which bends, such as a part of the deltoid round the shoulder: along the parabola
/// through its middle, which is found from the straight line in a few rounds. Bundles narrow with the slices. Wrong for
/// a muscle that bends by more than about a right angle, or to and fro.
bool layCurvedFibres(const TriMesh& mesh, const Vec3& from, const Vec3& end, Tissue& tissue);

}  // namespace glenoid
