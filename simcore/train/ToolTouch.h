// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>

#include "simcore/step/Stepper.h"

namespace glenoid {

/// What a tool and a part, or a tool and all parts, do to each other in a step.
struct ToolTouch {
  Vec3 force_W = Vec3::Zero();   ///< N on the tool, friction included
  double force = 0;              ///< N, its length
  Vec3 point_W = Vec3::Zero();   ///< m, mean of the contacts by normal force; meaningless where force is 0
};

/// `part`: object, −1: all parts. `counts`: of each contact by its point, W; nothing: all count.
ToolTouch toolTouch(const Model& model, const StepReport& step, int tool, int part, const std::function<bool(const Vec3&)>& counts = {});

}  // namespace glenoid
