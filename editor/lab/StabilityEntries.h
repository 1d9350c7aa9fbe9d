// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <vector>

#include "editor/lab/StudyFolder.h"

namespace glenoid {

/// What came of one trial of the gauntlet, from a row of its table. NaN where there is no figure.
struct StabilityEntry {
  std::string id, what, subject, profile;
  double stepMs = 0;
  bool counts = true, held = true, carries = true;
  std::vector<std::string> broken;   ///< words of brokenBounds
  double energyExcess = 0;           ///< of what there was and was put in
  double depthMm = 0, depthOfBound = 0, recoveryS = 0, endSpeed = 0;  ///< endSpeed: m/s
  std::string depthPair;
  long insideOutMost = 0, insideOutEnd = 0, steps = 0, rejected = 0;
  std::string recording, picture;    ///< paths; empty: there is none
};

/// In the order of the table; those that do not count (the published method beside another) after those that do.
std::vector<StabilityEntry> stabilityEntries(const StudyFolder& study);

/// "press" → "A tool presses"; unknown words as they are.
QString trialWords(const std::string& what);
/// "held", or what was broken, in a few words.
QString verdictWords(const StabilityEntry& entry);
/// The same as a sentence with its figures.
QString verdictSentence(const StabilityEntry& entry);
/// "46 of 48 trials held."
QString verdictSummary(const std::vector<StabilityEntry>& entries);

}  // namespace glenoid
