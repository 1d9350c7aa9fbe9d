// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>

#include "simcore/step/EffectFacts.h"

namespace glenoid {

/// Why an effect is on or off in a scene, in one clause with its figures that begins with a small letter and
/// has no full stop: "on, because 3 materials and 2 tools have a friction coefficient". Works with no
/// QCoreApplication.
QString effectSentence(const EffectFacts& facts);

}  // namespace glenoid
