// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/repair/Findings.h"

namespace glenoid {

/// What a name says of a part's size.
struct SizeHint {
  double metres = 0;     ///< usual largest extent of the whole (adults); 0 when no word of it is known
  bool partial = false;  ///< the name says that it is a part of that: “distal femur”, “tibial plateau”
};

/// By words in the name of a file or node. Sizes: Gray's Anatomy and the figures of the shoulder's own reference, rounded.
SizeHint usualSize(const std::string& name);

/// Left or right, from words ("right", "sinister") and endings ("humerus.r", "scapula_L").
BodySide sideInName(const std::string& name);

}  // namespace glenoid
