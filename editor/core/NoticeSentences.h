// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <functional>

#include "simcore/live/Notice.h"
#include "simcore/scene/Joint.h"
#include "simcore/scene/Scenario.h"

namespace glenoid {

/// Which wish of a scenario changes nothing, and why, for people.
QString sentenceOf(const UnusedSetting& unused);

/// How people call a part or tool; without one its id stands for it.
using NameOf = std::function<QString(const std::string& id)>;

/// What must be said about a run, in one sentence, for people: the same on the command line, in a report and in the window.
/// Works with no QCoreApplication.
QString sentenceOf(const Notice& notice, const NameOf& nameOf = {});

/// Parts by their names in the joint, tools by theirs in the scenario; an unknown id as it is. Both must outlive it.
NameOf namesIn(const Joint& joint, const Scenario& scenario);

/// What a word of PaperSettings adds to the step as published or leaves out of it; an unknown word as it is.
QString paperDeparture(const std::string& word);

}  // namespace glenoid
