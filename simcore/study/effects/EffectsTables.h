// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/study/StudyTable.h"
#include "simcore/study/effects/EffectsStudy.h"

namespace glenoid {

/// "effects": a row for each effect. "windows": the states from which all start. Lengths in mm, forces in N,
/// times in ms; a row has no figure where there was nothing to measure.
std::vector<StudyTable> effectsTables(const EffectsResult& result);

/// "on" or "off": what `auto` makes of it.
const char* stateWord(bool on);

}  // namespace glenoid
