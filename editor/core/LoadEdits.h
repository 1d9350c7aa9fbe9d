// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "editor/core/Document.h"

/// What an instructor does to the loads of a scenario: each function is one undo step on the document, or does nothing and answers
/// false: the index leads nowhere, the value is the same, or the scenario's schema and checkScenario would refuse it (a load on a
/// fixed part, a torque on tissue, numbers that are no numbers). Edits in a row of the same load are one step until
/// Document::endGesture(). SI units, W. GUI thread only.
namespace glenoid {

/// s over which loads rise; 0: whole at once.
bool setLoadRise(Document& document, double seconds);
/// All of its values.
bool setLoad(Document& document, int index, const Load& load);
/// Behind all others: a newton downwards, where a load acts without a point.
bool addLoad(Document& document, const std::string& part);
bool removeLoad(Document& document, int index);

}  // namespace glenoid
