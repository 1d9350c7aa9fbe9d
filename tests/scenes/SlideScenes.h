// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/study/truth/TruthMotions.h"

/// The block on an incline is one of the problems with known answers.
namespace glenoid::scenes {

using truth::kSlideGravity;
using truth::Slide;
using truth::slideJoint;
using truth::slideScenario;
using truth::slideSpeed;

}  // namespace glenoid::scenes
