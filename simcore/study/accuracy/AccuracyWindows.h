// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "simcore/study/ContactState.h"

namespace glenoid {

/// A short stretch of a scene's run that every setting repeats from the same state.
struct AccuracyWindow {
  double time = 0;      ///< s of the run, where it begins: a whole multiple of the grid
  bool loaded = false;  ///< chosen for what presses; else for what moves
  std::string mark;     ///< of the recording, where one covers it
  double speed = 0;     ///< m/s, mean over the window of the fastest object's
  double force = 0;     ///< N, mean of what presses on the tools; in a scene without tools of all contact forces
  State state;          ///< where it begins
  std::string stateHash;  ///< its hash, which stays where the state is not kept
};

struct WindowWishes {
  int count = 20;
  double seconds = 0.2;  ///< length of each, a whole multiple of the grid
  double grid = 0.02;    ///< s; windows begin, and are looked at, on it: a multiple of every time step that is compared
  double idleSeconds = 2;  ///< of a scene without recording, motions or rising loads
};

/// How long the scene is played to find them: the input, the last key of a motion, the rise of the loads and as long
/// again; at least what a scene without any of these gets.
double playedSeconds(const StudyScene& scene, const WindowWishes& wishes);

/// Plays the scene once to rate it and once more to take the states. The run is cut in half as many equal stretches as windows
/// are wanted, and each gives its fastest and its most loaded window, so that they lie all over it; windows do not overlap while
/// there is room. Fewer than wanted where the run is too short. Deterministic; by time. `model`: the scene compiled as it is. Fails with Cancelled, with
/// Unusable where the run is shorter than one window, and where it is not finite.
Result<std::vector<AccuracyWindow>> findWindows(const StudyScene& scene, std::shared_ptr<const Model> model, const WindowWishes& wishes,
                                                const std::function<bool(double)>& progress = {});

}  // namespace glenoid
