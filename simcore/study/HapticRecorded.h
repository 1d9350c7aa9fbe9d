// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "simcore/haptic/DeviceProfile.h"
#include "simcore/study/ContactState.h"

namespace glenoid {

/// What one tool of a recorded scene feels, in a time of its own: the simulation begins a step every Δt, what comes of it is
/// known Δt later, the loop asks at the device's rate; beside the exact step at that rate on the same path.
struct RecordedFeel {
  std::string tool;
  double seconds = 0;
  double forceMax = 0, forceRms = 0;  ///< N: of the loop; of the exact step, over the ticks in which either has a force
  double forceError = 0;              ///< N, rms of their difference there
  double steadyError = 0;             ///< N, its median there: what is left when nothing snaps from one facet to the next
  double energyMade = 0;              ///< J at the handle (PortEnergy)
  long heldBack = 0, silent = 0;      ///< ticks (HapticCounts)
  int rowsMax = 0, overflowMax = 0;
  double publishMs = 0, tickUs = 0;   ///< mean thread CPU time of a step's publishing for all tools, and of a tick
};

/// How the simulation may be late: every so often it stands still for so long, s. Like a run in real time that gives up what it cannot
/// catch up with, it then goes on where it stood, and the hand at half its pace until it is as far behind.
struct Silences {
  double every = 0, length = 0;
};

/// Of each tool that a hand holds. With silences there is no comparison with the exact step. Fails as compileModel does; Cancelled.
Result<std::vector<RecordedFeel>> feelRecording(const StudyScene& scene, const DeviceProfile& device, double seconds,
                                                const std::function<bool(double)>& progress, const Silences& silences = {});

}  // namespace glenoid
