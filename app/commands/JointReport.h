// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/check/FindProblems.h"
#include "simcore/step/Model.h"

namespace glenoid {

/// `joint info`: the parts beside the paper's Table 1 (where the joint is its shoulder) and the couplings with
/// their springs, as text or JSON. The model is compiled from the joint alone.
std::string jointInfoText(const Model& model);
std::string jointInfoJson(const Model& model);

/// `joint check`: the problem list, the worst first, then what was looked at.
std::string jointCheckText(const Joint& joint, const CheckReport& report);
std::string jointCheckJson(const Joint& joint, const CheckReport& report);

}  // namespace glenoid
