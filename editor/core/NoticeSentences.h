// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>

#include "simcore/live/Notice.h"

namespace glenoid {

/// Which wish of a scenario changes nothing, and why, for people.
QString sentenceOf(const UnusedSetting& unused);

/// What must be said about a run, in one sentence, for people. Works with no QCoreApplication.
QString sentenceOf(const Notice& notice);

/// What a word of PaperSettings adds to the step as published or leaves out of it; an unknown word as it is.
QString paperDeparture(const std::string& word);

}  // namespace glenoid
