// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>

#include "simcore/base/Error.h"
#include "simcore/file/JsonValue.h"
#include "simcore/step/Stepper.h"
#include "simcore/study/PeerScene.h"

namespace glenoid::peers {

/// What one simulator did in one run of the scene. Times are thread CPU time of a whole step, collision detection
/// included. Depths are of the ball, greatest over the run and at least 0.
struct Row {
  std::string simulator;          ///< "glenoid" or the peer's name and version
  std::string stiffness;
  double dt = 0;                  ///< s
  double simulated = 0;           ///< s; shorter than asked where it was given up
  double msMedian = 0, msP95 = 0, msP99 = 0;
  bool finite = false;            ///< every position of every step; for ours also every step taken
  bool stable = false;            ///< finite, no node further than 50 mm from its rest, no element inverted
  double ballDepth = 0;           ///< m, of the collision surfaces, by PenetrationCheck; peers: as sphereDepth
  double sphereDepth = 0;         ///< m, of the ideal sphere under the blocks' triangles, as measured for every peer
  double anyDepth = 0;            ///< m, as ballDepth but of all pairs, so of the ridge too; ours only
  double ballLag = 0;             ///< m, of the ball behind its hand
  double volumeRatioMin = 1;      ///< J of any element
  double bindingGap = 0;          ///< m, between any bound node and its place on the bone
  double contactsMean = 0;
  int contactsMax = 0;
  bool contactConverged = false;  ///< complementarity below kComplementarity in every step; ours only
  double complementarity = 0;     ///< m/s, worst; ours only
  int contactFallbacks = 0;       ///< contact islands whose exact solve ran out of its limits; ours only
};

/// A contact whose complementarity misses by less moves by less than 1 nm in 20 ms.
inline constexpr double kComplementarity = 5e-8;  ///< m/s

struct MeasureOptions {
  double seconds = kSeconds;
  StepperOptions stepper;
  std::function<void(const State& state, const StepReport& report)> eachStep;  ///< for a closer look
};

/// Runs the scene in ours. Fails as compileModel does.
Result<Row> measure(Stiffness stiffness, double dt, const MeasureOptions& options = {});

JsonValue toJson(const Row& row);
Row toRow(const JsonValue& json);

}  // namespace glenoid::peers
