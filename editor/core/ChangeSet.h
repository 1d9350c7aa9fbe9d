// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <set>
#include <string>

namespace glenoid {

/// What one edit touched, by id, so that views refresh only that. Sets unite when commands are merged.
struct ChangeSet {
  bool everything = false;  ///< another scene: forget all ids
  bool model = false;       ///< what the simulation computes has changed: compile again
  bool restart = false;     ///< where things were means nothing now: the run begins anew
  bool settings = false;    ///< profile, effects, time step
  std::set<std::string> parts, materials, couplings;
};

}  // namespace glenoid
