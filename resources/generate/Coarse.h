// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/shape/Field.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid::generate {

using namespace shape;

/// How much a place of a surface matters for contact, > 0.
using Importance = std::function<double(const Vec3&)>;

/// Closed surface of `triangles` triangles in place of a fine one, millimetres: most of them where it
/// matters, and there fitted to the fine surface (area-weighted least squares to and fro, the more the
/// farther off), elsewhere as far as they go. The answer has the fine surface's genus and does not cut
/// itself. Ends the program when the fine surface cannot be simplified (its shape is a constant of this
/// program).
TriMesh coarseOf(const TriMesh& fine, const Field& shape, int triangles, const Importance& importance);

/// The fine surface in fewer triangles, more of them where it matters; everything else as above but without
/// the fit.
TriMesh thinned(const TriMesh& fine, int triangles, const Importance& importance);

/// Moves the vertices of a coarse surface to fit a fine one, as coarseOf does.
void fit(TriMesh& coarse, const TriMesh& fine, const Field& shape, const Importance& importance);

}  // namespace glenoid::generate
