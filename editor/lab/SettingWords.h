// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <string>

#include "editor/core/Document.h"
#include "simcore/study/accuracy/AccuracyStudy.h"

namespace glenoid {

/// A setting by its id (AccuracySetting::id), in words: "dt=2.5ms,cells=2" is "steps of 2.5 ms; twice as many tetrahedra". What it
/// does not know it says as it is.
QString settingWords(const std::string& id);

/// Why a setting has no error, from its row: "not-finite" and "3 of 40 steps".
QString failureWords(const std::string& failure, const std::string& detail);

/// "displacement", "contact force", "penetration", "force on the hand".
QString quantityName(AccuracyQuantity quantity);
/// What errors are counted against, for people.
QString againstName(AccuracyAgainst against);
/// A family of settings (AccuracySetting::family).
QString familyName(const std::string& family);
/// 0.0123 → "0.0123 mm", three digits; NaN: "–".
QString errorText(AccuracyQuantity quantity, double shown);
QString msText(double ms);

/// What differs between two scenes of what a setting sets, as a sentence: "Steps of 2.5 ms in place of 5 ms." Empty: nothing.
QString changedSentence(const Scene& before, const Scene& after);

}  // namespace glenoid
