// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <vector>

#include "simcore/study/ContactState.h"
#include "simcore/study/HapticTrial.h"
#include "simcore/study/StudyTable.h"

namespace glenoid {

/// What haptics is held to (bench haptics); a table says of each row whether it is kept.
struct HapticBars {
  double energy = 1e-3;            ///< J made in any 10 s
  double stiffnessShare = 0.8;     ///< of the device's bound, rendered on bone
  double forceError = 0.05;        ///< N, or
  double forceErrorShare = 0.02;   ///< of the exact force's rms, whichever is more; without added delay
  double latenessP99 = 0.5, latenessP999 = 1;  ///< ms
  double rateOff = 0.001;          ///< of 1 kHz
};

/// Virtual hand on soft, stiff and bone at each added delay, in a time of its own: repeats to the last bit. `seconds` of each.
Result<StudyTable> hapticContactTable(const DeviceProfile& device, const std::vector<double>& delays, double seconds, const HapticBars& bars,
                                      const std::function<bool(double)>& progress);

/// The same hand, without added delay, while the simulation stands still for 60 ms every 0.7 s, so that forces fade and come back: what a
/// machine that others use does to a run. A row is kept where nothing is made beyond the bar.
Result<StudyTable> hapticSilenceTable(const DeviceProfile& device, double seconds, const HapticBars& bars, const std::function<bool(double)>& progress);

/// Stable, passive and chosen stiffness of a wall against its damper at each delay: what a Z-width picture shows.
StudyTable zWidthTable(const DeviceProfile& device, const std::vector<double>& delays);

/// What the hands of recorded scenes feel (feelRecording), a row for each tool; `scenes` with the names that they are shown by.
Result<StudyTable> hapticRecordedTable(const std::vector<std::pair<std::string, StudyScene>>& scenes, const DeviceProfile& device, double seconds,
                                       const std::function<bool(double)>& progress);

/// The same hands while the simulation stands still as in hapticSilenceTable, without comparison.
Result<StudyTable> hapticRecordedLateTable(const std::vector<std::pair<std::string, StudyScene>>& scenes, const DeviceProfile& device, double seconds,
                                           const HapticBars& bars, const std::function<bool(double)>& progress);

/// How a real thread keeps its clock while this one simulates the soft slab in time with it: `seconds`, and with `load` as many
/// threads that only burn as the machine has processors beside. `progress` false ends it early.
Result<std::vector<StudyCell>> hapticClockRow(const DeviceProfile& device, double seconds, bool load, const HapticBars& bars,
                                              const std::function<bool(double)>& progress);
/// Columns of such rows.
StudyTable emptyHapticClockTable();

}  // namespace glenoid
