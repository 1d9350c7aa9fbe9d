// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>

#include "simcore/base/Error.h"
#include "simcore/check/Problem.h"
#include "simcore/scene/Joint.h"

namespace glenoid {

/// How far a remedy is, 0…1. False stops it.
using FixProgress = std::function<bool(double done)>;

/// Whether something can be done about a problem without asking its author a question.
bool canFix(const Problem& problem);

/// The joint with the problem gone, everything else as it was. A pure function: the same joint and problem give the same
/// answer. Fails with Unusable (arguments: what) when the joint is no longer the one that had the problem, or when the
/// remedy does not help it, or with Cancelled. Separating parts that overlap takes seconds, the rest does not.
Result<Joint> fixProblem(const Joint& joint, const Problem& problem, const FixProgress& progress = {});

}  // namespace glenoid
