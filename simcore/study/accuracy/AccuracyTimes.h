// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "simcore/live/RunReport.h"
#include "simcore/study/accuracy/AccuracyStudy.h"

namespace glenoid {

struct StepTimes {
  Timing cpu, wall;  ///< ms a step
  long count = 0;    ///< steps measured
};

/// What a step costs under each setting: in each repeat every setting in turn takes a few steps from the windows' states, so that
/// a machine that is busy for a while disturbs all alike. A setting whose steps take long gets fewer windows, spread over all, but every
/// repeat. Null players have no times. Nothing at all where `progress` cancels. `soFar`: called with the times up to then after each
/// repeat but the last; null: nobody asks.
std::vector<StepTimes> timeInterleaved(std::span<const std::unique_ptr<AccuracyPlayer>> players, std::span<const AccuracyWindow> windows,
                                       const AccuracyOptions& options, const std::function<bool(double)>& progress,
                                       const std::function<void(std::span<const StepTimes>)>& soFar = {});

}  // namespace glenoid
