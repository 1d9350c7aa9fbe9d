// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "simcore/live/Notice.h"
#include "simcore/step/Stepper.h"
#include "simcore/train/TrainingReport.h"

namespace glenoid {

/// Distribution of a time over the steps of a run, ms. Percentiles by nearest rank.
struct Timing {
  double median = 0, p95 = 0, p99 = 0, p999 = 0, max = 0;
};

/// Nearest-rank percentiles of the values; they are sorted in place. All zero when there is none.
Timing timingOf(std::vector<float>& milliseconds);

/// One coupling as a part sees it.
struct PartCoupling {
  std::string id;         ///< of the coupling
  int part = 0;           ///< number of the part at the other end
  std::string partId;     ///< its id
  int springs = 0;        ///< derived when the scenario was compiled
  double stiffness = 0;   ///< N/m, all springs together
};

struct PartReport {
  std::string id, name;
  int number = 0;
  bool rigid = true;
  int renderTriangles = 0, collisionTriangles = 0;
  int tetrahedra = 0;     ///< soft parts, of the mesh as authored
  int cells = 0;          ///< soft parts that ran as cells (Elements), else 0
  /// Free soft parts, with checks: most elements at once turned inside out, and pressed beyond what their law holds.
  std::optional<int> insideOutMax, pressedMax;
  std::vector<PartCoupling> couplings;
};

/// One effect over the run. `ms` only where the effect has stages of its own; otherwise it is part of a stage
/// that several effects share, and `timedWith` names that stage.
struct EffectReport {
  std::string name, state, reason;  ///< state: "off" or "on"; reason: word of EffectPlan
  std::optional<double> ms;         ///< median thread CPU time of a step
  std::string timedWith;
};

/// What a tool did to a part during a mark of the recording.
struct MarkReport {
  std::string name, tool, part;
  double begin = 0, end = 0;  ///< s
  double seconds = 0;         ///< s during which the net contact force was at least 1 N
  double forceMax = 0;        ///< N
};

/// Rows over the steps, and those of them that press (StepReport); words as in the README of this folder.
struct ContactCounts {
  std::optional<double> rest, pressingRest;  ///< means at rest (RestWatch); nothing when the run has not come to rest
  std::string restReason;                    ///< why not
  double mean = 0, pressingMean = 0;
  int max = 0, pressingMax = 0;
  int droppedMax = 0;          ///< rows that nothing can move
};

/// Which methods solved the contact islands of a run; islands summed over all steps.
struct ContactSolverSummary {
  long pivoting = 0, impulses = 0, velocities = 0, convex = 0;
  int newtonMax = 0, rowsMax = 0;
};

/// How the splitting of the `paper` profile went over the run.
struct PaperSummary {
  long nodeSteps = 0, objectSteps = 0;  ///< steps with contact in which D held these blocks
  double lambdaMax = 0;
  int cgIterationsMax = 0, outerIterationsMax = 0;
  double cgResidualMax = 0, outerResidualMax = 0, outerIterationsMean = 0;
  long cgCappedSteps = 0, outerCappedSteps = 0, divergedSteps = 0;
  std::vector<std::string> departures;  ///< from the step as published: words of PaperSettings
};

/// With `--realtime`: how the clock was kept. A late simulation catches up by a bounded number of steps.
struct PaceReport {
  double wallSeconds = 0;
  long lateSteps = 0;          ///< begun more than one step late
  double latenessMaxMs = 0;
  double slowedSeconds = 0;    ///< s that the run gave up catching up with
};

/// Somebody's own hand in a run.
struct LiveHandReport {
  std::string device;                            ///< as it was asked for
  bool heard = false;                            ///< it ever said where it was
  double lostSeconds = 0, lostFrom = 0;          ///< s, of the clock since the run began: how long it was gone, silent or wild once it had been heard, and when first
};

/// What the hand at one tool felt, and how (simcore/haptic).
struct HapticToolReport {
  std::string tool;
  double stiffness = 0, damping = 0, bound = 0;  ///< N/m, N·s/m, N/m: of the coupling as shown, and the device's bound
  bool saturated = false;                        ///< the scenario asks for a stiffer one than the device can show
  double forceMaxN = 0, energyMaxJ = 0;
  std::optional<double> forceErrorRms, forceRms; ///< N, against the exact step at the haptic rate on the same path
  int rowsMax = 0;
  long overflowTicks = 0, clampedTicks = 0, slewedTicks = 0, lostTicks = 0, silentTicks = 0, heldBackTicks = 0;
  double problemAgeMaxMs = 0;                    ///< oldest problem that a force was computed from
  std::optional<LiveHandReport> live;            ///< nothing: it followed a track
};

/// With `--realtime`: how the haptic threads kept their clock and what they showed; the worst of all tools.
struct HapticReport {
  std::string device;                            ///< id of its profile
  bool realTimeScheduling = true;                ///< false: as ordinary threads, since the system allows no other
  double rateHz = 0;
  double latenessP50Ms = 0, latenessP99Ms = 0, latenessP999Ms = 0, latenessMaxMs = 0;
  long ticks = 0, missed = 0;                    ///< of all tools together; missed ones are not caught up
  double forceMaxN = 0;
  double energyMaxJ = 0;                         ///< made at a handle in the worst 10 s (haptic/PortEnergy.h)
  std::optional<double> forceErrorRms;           ///< N; nothing where it was not compared
  double comparedSeconds = 0;                    ///< s of the run, from its start
  std::vector<HapticToolReport> tools;
};

/// Everything a run tells. SI units, times in ms where the name says so.
struct RunReport {
  std::string scenario, profile, solver, build, isa, jointHash, stateHash;
  double dt = 0, seconds = 0;
  long steps = 0, rejectedSteps = 0;
  long cutSteps = 0;              ///< taken in parts, since the whole would have turned too far
  long boundedSteps = 0;          ///< whose contacts would have cost more than a step may (StepBounded)
  long deepOverlapSteps = 0;      ///< in which surfaces were parted along one way, so deep were they in each other
  long refusedHands = 0;          ///< inputs that were no pose of a hand
  unsigned seed = 1;
  int threads = 1;
  bool finite = true, diverged = false, realtime = false;
  double stepsPerSecond = 0;      ///< wall time inside the step alone
  double stepsPerCpuSecond = 0;   ///< the same by thread CPU time: what a machine that others use too can promise
  double residual = 0;            ///< worst of all steps
  double complementarity = 0;     ///< worst of all steps, m/s
  long pivotsExhausted = 0;       ///< contact islands whose answer is not right to the tolerance
  ContactSolverSummary contactSolver;
  std::string tissueLaw;          ///< of tissue far from rest: "stretch" (fem/StretchLaw.h), or "linear" as published
  std::vector<PartReport> parts;
  int couplingIslands = 0, contactIslandsMax = 0;
  ContactCounts contacts;
  Timing step, stepWall;                     ///< CPU and wall
  std::array<Timing, kStageCount> stages{};  ///< CPU
  double penetrationMax = 0;                 ///< m, collision surfaces, every step
  std::string penetrationPair;               ///< "a / b" where it was found
  std::optional<double> visualPenetrationMax;  ///< m, visual surfaces, every visualPenetrationEvery steps
  std::string visualPenetrationPair;         ///< "a / b" where that was found
  int visualPenetrationEvery = 0;
  std::vector<EffectReport> effects;
  std::vector<MarkReport> marks;
  std::vector<Notice> notices;               ///< what must be said before any figure is believed
  std::optional<PaperSummary> paper;         ///< `paper` profile only
  std::optional<TrainingReport> training;    ///< of a scenario that has tasks
  std::optional<PaceReport> pace;            ///< `--realtime` only
  std::optional<HapticReport> haptic;        ///< likewise
  std::string hapticReason;                  ///< why there is none: a word of RunHaptics
};

/// The parts of a model as reports and tables show them.
std::vector<PartReport> partReports(const Model& model);

/// Indented JSON that resources/schemas/run-report.schema.json describes; ends with a line break. `sentence` says a notice to
/// people; without it the report holds their words and figures only.
std::string toJson(const RunReport& report, const std::function<std::string(const Notice&)>& sentence = {});

/// "direct", "paper", "reference".
const char* profileName(Profile profile);
std::optional<Profile> profileNamed(const std::string& name);

}  // namespace glenoid
