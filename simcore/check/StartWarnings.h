// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/check/Problem.h"
#include "simcore/scene/Joint.h"

namespace glenoid {

/// A start below this is suspect: what a cage squeezes so far pushes back as soon as the run begins.
inline constexpr double kSqueezedRatio = 0.6;

/// What is suspect about how a part starts, with its nodes at `start_W` (m, as many as its volume has): CageMovesFar, where
/// a vertex of its collision surface is farther from rest than the part is thick (2 volume / area of that surface: a sheet's
/// thickness, two thirds of a ball's radius), for it may have come out on the wrong side of a neighbour; CageSqueezes, where
/// a tetrahedron has less than kSqueezedRatio of its volume, down to kLeastVolumeRatio, below which it is crushed.
std::vector<Problem> startWarnings(const Part& part, const std::vector<Vec3>& start_W);

/// The same of every part with a cage. Fails as startNodes does.
Result<std::vector<Problem>> startWarnings(const Joint& joint);

}  // namespace glenoid
