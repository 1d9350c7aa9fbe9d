// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/step/StepModel.h"

namespace glenoid {

/// What a scenario does to parts beside holds and tools: loads, pressures and supports on free ones, motions of fixed
/// ones. Private to step/.

/// That the parts are there and can take it. Fails with UnknownId or Unusable, naming the pointer.
Result<Done> checkActions(const Joint& joint, const Scenario& scenario);

/// Fixed objects with a motion; puts them where it begins in model.start. After compileObjects.
void compileMotions(Model& model, StepModel& inside);

/// Loads, pressures and supports into their islands; after every object has its island and base. `centres`: body frame
/// origin of each rigid object at rest. Fails with UnknownId (a region) or Unusable (a region without area, a point
/// outside the tetrahedra), naming the pointer and the part.
Result<Done> compileActions(const Model& model, StepModel& inside, const std::vector<Vec3>& centres);

/// Block pairs that a support fills, before the symbolic phase, and where they lie, after it.
void appendSupportPairs(const BoundSupport& support, const VecX& q, std::vector<std::array<int, 2>>& pairs);
void bindSupport(BoundSupport& support, const VecX& q, const BlockSymbolic& symbolic);

}  // namespace glenoid
