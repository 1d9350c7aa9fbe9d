// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>

#include "simcore/step/Model.h"

namespace glenoid {

/// What a haptic bench presses on: a slab of 60 × 20 × 60 mm with its top at y = 0, glued to bone below.
enum class HapticSurface { Soft, Stiff, Bone };
inline constexpr HapticSurface kHapticSurfaces[] = {HapticSurface::Soft, HapticSurface::Stiff, HapticSurface::Bone};
/// "soft" (20 kPa, relaxed muscle), "stiff" (1 MPa, cartilage), "bone" (rigid).
const char* hapticSurfaceName(HapticSurface surface);

/// The slab and one ball of 6 mm radius that a hand holds from above with a coupling of this stiffness, N/m, its tip at `start`.
/// Without gravity and friction. Fails as compileModel does.
Result<std::shared_ptr<const Model>> makeHapticScene(HapticSurface surface, double stiffness, double dt, const Vec3& start);

}  // namespace glenoid
