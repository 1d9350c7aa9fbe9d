// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>

#include "editor/core/ImportSession.h"

namespace glenoid {

/// What a finding is and how much of it there is, as a sentence; lengths in millimetres by `metres` per unit.
QString findingSentence(const Finding& finding, double metres);
/// What its repair would do; empty when none is offered.
QString repairSentence(const Finding& finding, double metres);
/// What reading a file lost or changed.
QString noteSentence(const NoteCount& note);
/// Why a unit is thought to be the one.
QString unitReason(const UnitGuess& guess, bool named);
QString unitName(double metres);
QString sideSentence(BodySide side);
/// "109 × 110 × 159 mm" of a box in metres.
QString sizeSentence(const Box3& box_W);
/// Where a row stands, in a few words.
QString stateSentence(const ImportSession::Row& row);

}  // namespace glenoid
