// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/repair/Findings.h"

namespace glenoid {

/// What the name of a file or node says about the part: its usual largest extent in metres (adults), 0 when no word of
/// it is known. Sizes: Gray's Anatomy and the figures of the shoulder's own reference, rounded.
double usualSize(const std::string& name);

/// Left or right, from words ("right", "sinister") and endings ("humerus.r", "scapula_L").
BodySide sideInName(const std::string& name);

}  // namespace glenoid
