// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/scene/Joint.h"

namespace glenoid {

/// Where the nodes of a soft part start, m, W: at rest, or as its cage moves them. Fails as cageWeights does; the place
/// names the part.
Result<std::vector<Vec3>> startNodes(const Joint& joint, const Part& part);

/// One of the part's surfaces as it starts: the rest surface of a rigid part, of a soft one what its nodes make of it.
Result<TriMesh> startSurface(const Joint& joint, const Part& part, SurfaceKind kind);

}  // namespace glenoid
