// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>

#include "simcore/check/Problem.h"
#include "simcore/scene/Joint.h"

namespace glenoid {

/// What is wrong and what to do about it, for people; the joint gives the names. Works with no QCoreApplication.
QString sentenceOf(const Problem& problem, const Joint& joint);

/// What the quick fix would do, as the name of an undo step; empty where there is none.
QString fixTitleOf(const Problem& problem, const Joint& joint);

/// "Error", "Warning", "Note".
QString severityName(Severity severity);

}  // namespace glenoid
