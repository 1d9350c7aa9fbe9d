// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// What simplifying made of a tangled surface, without the places where it cuts itself: those triangles are taken out
/// and the holes closed. The surface as it was where it does not cut itself, or where no sound surface remains. Any unit.
TriMesh untangled(TriMesh mesh);

}  // namespace glenoid
