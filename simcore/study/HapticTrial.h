// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/haptic/HapticLoop.h"
#include "simcore/haptic/VirtualHand.h"
#include "simcore/study/HapticScene.h"

namespace glenoid {

/// A virtual hand presses on a surface through a device, the haptic loop and a simulation, all in a time of their own that
/// repeats to the last bit. The simulation begins a step every Δt with the hand as it is then, and what comes of it is known
/// Δt later: the latest that a simulation in time may be.
struct HapticTrial {
  HapticSurface surface = HapticSurface::Soft;
  DeviceProfile device;
  double wishedStiffness = 1e6;  ///< N/m: more than any device can show, so that its bound decides
  double delay = 0;              ///< s, added between force and hand; the loop is told, and chooses its gains by it
  double dt = 0.005;             ///< s, of the simulation
  double seconds = 10;           ///< cycles of 2.5 s: down, hold, up, away; every other one slides 10 mm during the hold
  double depth = 0.006;          ///< m, to where the hand wants to be
  double silentEvery = 0, silentFor = 0;  ///< s: so often the simulation stands still, for so long; 0: never
  bool compare = false;          ///< with the exact step at the loop's rate on the same path of the hand
};

struct HapticTrialResult {
  CouplingGains gains;
  double energyMade = 0;         ///< J, at the handle: loop and mechanism together, worst window
  double loopEnergyMade = 0;     ///< J, the loop alone
  double forceMax = 0, forceRms = 0;  ///< N, shown; rms over the ticks with any force
  double renderedStiffness = 0;  ///< N/m: force over how far the hand stands below the surface at rest, at the end of the holds
  /// N: rms difference from the exact step of what the loop wanted, over the ticks in which either has a force; and its share of the
  /// exact one's rms there. Zero without `compare`.
  double forceError = 0, forceErrorShare = 0;
  HapticCounts counts;
  std::vector<Vec3> path;        ///< of the hand, at every tick
  std::vector<Vec3> wanted;      ///< N, of the loop, at every tick
};

/// Fails as makeHapticScene does.
Result<HapticTrialResult> runHapticTrial(const HapticTrial& trial);

/// Forces of the exact step along a path of the tool's tip: the whole scene stepped once a tick, its contact problem
/// handed over without delay to the same proxy. `path` at every tick; the answer as long. Fails as makeHapticScene does.
Result<std::vector<Vec3>> exactHapticForces(HapticSurface surface, const CouplingGains& gains, double period, const std::vector<Vec3>& path);

}  // namespace glenoid
