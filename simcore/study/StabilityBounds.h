// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glenoid {

/// What a scene that is handled roughly must keep to: of every case of the gauntlet (StabilityCases.h) and of tests/hard.
/// A case is over when what was done to it ends; from then on nothing changes but what the scene does itself.
struct StabilityBounds {
  double energyExcess = 0.05;   ///< energy beyond what there was and what was put in, of the most that these two have been
  double depth = 1e-3;          ///< m, of surfaces that began apart and whole; of the others once they must have recovered
  double thinShare = 0.5;       ///< of the thickness of the thinner of the two, where that is less: deeper, it may come out on the far side
  double secondsToRest = 2;     ///< s until no point moves faster, no element is inside out and no surface too deep
  double restSpeed = 1e-3;      ///< m/s
  long rejectedSteps = 0;       ///< every step is taken
};

}  // namespace glenoid
