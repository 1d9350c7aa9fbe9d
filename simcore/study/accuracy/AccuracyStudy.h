// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <map>
#include <optional>

#include "simcore/study/accuracy/AccuracyErrors.h"
#include "simcore/study/accuracy/AccuracySetting.h"

namespace glenoid {

/// What a setting is compared with. Each reference is the last of two refinements; what the other still differs from it is the
/// reference's own error, below which nothing can be told.
enum class AccuracyAgainst {
  FinerCells,  ///< the same scene in finer cells and steps: what cells leave out counts too
  OwnCells     ///< the scene in its own cells, in very small steps: the solving alone counts
};
inline constexpr int kAccuracyReferences = 2;
/// "finer-cells", "own-cells".
const char* againstKey(AccuracyAgainst against);

struct AccuracyResult;

/// How thorough a study is. Refinements: times as many tetrahedra, and into how many parts a step is cut.
struct AccuracyOptions {
  WindowWishes windows;            ///< grid: 0: four of the scene's steps
  int repeats = 7;                 ///< of the timing, interleaved
  int stepsTimed = 3;              ///< a repeat takes so many from a window's state, after one that is not counted
  double secondsTimed = 1;         ///< at most about so long for one repeat of one setting, by fewer windows
  int slowWindows = 4;             ///< so many, spread over all, for the profiles `paper` and `reference` and where visual surfaces touch
  std::array<double, 2> cells{4, 8};
  std::array<int, 2> cuts{2, 4}, ownCuts{16, 32};
  bool quick = false;              ///< fewer settings
  int shard = 1, shards = 1;       ///< of the settings every shards-th, from the shard-th (1 …) on; all windows and references
  std::string machine;             ///< for the rows
  std::vector<AccuracySetting> settings;  ///< in place of those that the study sweeps; the first is the scene
  std::function<bool(const std::string& what, double fraction)> progress;  ///< false cancels
  /// Of a run that was stopped: its rows are not played again. Windows and references are made anew and must
  /// be the same bit for bit; all are timed anew, since times are interleaved.
  const AccuracyResult* resume = nullptr;
  /// What is there so far, without times: when the references are made, and after every setting.
  std::function<Result<Done>(const AccuracyResult&)> keep;
  /// What is known so far, for who watches: after each reference, and of the row whose errors or, repeat by repeat, times have come.
  std::function<void(const AccuracyResult&, std::optional<std::size_t> row)> told = {};
};
/// Within five minutes for a scene of the shoulder's size.
AccuracyOptions quickAccuracy();

/// Why a setting has no point in the plot.
struct AccuracyFailure {
  std::string reason;    ///< key: "not-built", "not-finite", "diverged"; empty: it has one
  Error error;           ///< of "not-built"
  long count = 0, of = 0;  ///< steps
};

struct AccuracyRow {
  AccuracySetting setting;
  std::size_t index = 0;                         ///< among all settings of the study
  std::string machine;                           ///< that took its times: as the options say
  AccuracyFailure failure;
  bool ownCells = false;                         ///< only the solving differs from the scene's
  int windows = 0;                               ///< in which it was compared
  std::array<std::optional<AccuracyErrors>, kAccuracyReferences> errors;
  long tetrahedra = 0, cappedSteps = 0, unsolvedIslands = 0, steps = 0;
  double contacts = 0, deepest = 0;              ///< mean rows of a step; m, of its own collision surfaces
  std::string deepestWhere;
  Timing cpu, wall;                              ///< of one step, ms: thread CPU time, and by the clock
  long timed = 0;                                ///< steps
  /// ms for as much simulated time as one of the scene's own steps: what settings with other time steps can be compared by.
  Timing work;
  double roughWorkMs = 0;  ///< mean over the windows, as work, before `work` is known: measured while steps were looked at
};

/// A reference and how far its own last refinement moved it. Both are solved by `direct`; that of the scene's own cells is also
/// checked by `reference`, which shares neither its factorization nor its rotations: where the two differ by more over the slow
/// settings' windows in the scene's own steps, that difference is the reference's error.
struct AccuracyReference {
  std::optional<Error> missing;                  ///< why there is none
  AccuracySetting coarser, finest;
  AccuracyErrors floor;                          ///< of `coarser` against `finest`, or the check's where that is larger
  std::optional<AccuracyErrors> check;           ///< `direct` against `reference`, both in the scene's steps
  long tetrahedra = 0;
};

struct AccuracyResult {
  std::vector<AccuracyRow> rows;                 ///< in the order of the settings
  std::array<AccuracyReference, kAccuracyReferences> references;
  std::vector<AccuracyWindow> windows;           ///< with their states; those of merged shards have hashes only
  WindowWishes wishes;
  AccuracySetting scene;
  bool friction = false;
  bool hands = false;                            ///< there are tools
  int repeats = 0;
  long settings = 0;  ///< how many this run is to have rows of
  const AccuracyReference& reference(AccuracyAgainst against) const { return references[static_cast<std::size_t>(against)]; }
};

/// Measures. The errors are a function of scene, options, build and instruction set; times are the machine's. Fails as
/// compileModel does for the scene itself, as findWindows does, and with Cancelled; what fails of a setting stands in its row.
Result<AccuracyResult> studyAccuracy(const StudyScene& scene, const AccuracyOptions& options);

}  // namespace glenoid
