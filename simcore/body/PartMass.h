// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/body/RigidObject.h"
#include "simcore/scene/Joint.h"

namespace glenoid {

/// Mass, centre and inertia of a rigid part at rest, frame W: what its visual surface encloses at the density of its default
/// material, and for each use of another material on a region with a thickness, the difference of densities over the layer
/// under that region. A layer is the body between the region's triangles and the same triangles with each vertex moved
/// inwards by the thickness along its normal (of the region's triangles around it, by their angles), closed by walls along the
/// region's border, integrated exactly. Layers of regions that overlap both count. Right where the thickness is small
/// beside the radii of the surface; the surface must be closed.
/// Fails with UnknownId (a material, a region) or BadMesh (no positive volume or mass left), naming the part.
Result<MassProperties> massPropertiesOf(const Joint& joint, const Part& part);

}  // namespace glenoid
