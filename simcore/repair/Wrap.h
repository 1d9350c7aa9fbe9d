// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Error.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// A new surface drawn tightly around what a surface has: closed, manifold, wound outwards, not cut by itself, one shell for each
/// piece that stands apart. For surfaces that no smaller repair makes sound (triangles through each other, leaves, holes, loose
/// triangles): nothing of the volume is lost. Openings narrower than `width` are bridged, wider ones are entered, so a large hole
/// becomes a pocket with the wall's own thickness; cavities inside are filled. The wrap keeps `width`/30 away and is drawn back by
/// that where it stays sound. Unit: the surface's; `width` 0: a hundredth of its diagonal. Same surface, same wrap.
/// Fails with OutOfRange where `width` would ask for more than `kMostWrapTriangles` triangles or is longer than the surface, and
/// with BadMesh where the surface has no extent.
/// Source: Portaneri, Rouxel-Labbé, Hemmer, Cohen-Steiner and Alliez, "Alpha wrapping with an offset", ACM TOG 41(4), 2022.
Result<TriMesh> wrapped(const TriMesh& mesh, double width);
inline constexpr long kMostWrapTriangles = 400'000;

}  // namespace glenoid
