// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "simcore/step/Stepper.h"

namespace glenoid {

/// The stages that only one effect has. What several effects share (gravity, couplings and damping are all assembled at once) has
/// no time of its own.
struct EffectStages {
  const char* effect;
  std::vector<Stage> own;
  const char* shared;  ///< name of the stage in which the time of one without own stages goes up
};

/// Null: the step has no such effect.
const EffectStages* stagesOfEffect(const std::string& effect);

}  // namespace glenoid
