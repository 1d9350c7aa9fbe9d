// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Error.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// The collision surface of a visual one: simplified to about so many triangles, then without the places where that cuts
/// itself, as far as a sound surface remains. Any unit and frame; what comes out depends on the frame's axes in detail. Fails as simplify does.
Result<TriMesh> makeCollision(const TriMesh& visual, int triangles);

}  // namespace glenoid
