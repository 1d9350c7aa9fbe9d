// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <memory>

#include "simcore/live/HandInput.h"
#include "simcore/live/StepWatch.h"
#include "simcore/base/TripleBuffer.h"
#include "simcore/step/Stepper.h"

namespace glenoid {

/// How a run keeps up with the clock, over the last half second or so.
struct LiveRates {
  double stepsPerSecond = 0;
  double msPerStep = 0;       ///< mean wall time of a step, ms
  double realTimeFactor = 0;  ///< simulated time over wall time; 1: as fast as life
  double forgiven = 0;        ///< s of wall time given up since play was pressed
};

/// What the simulation thread shows the others after a step or a command. A value: reading it needs no lock.
struct Snapshot {
  std::shared_ptr<const Model> model;  ///< q belongs to this one; null before the first model
  VecX q;
  VecX rotations;            ///< State's, for reading tissue; empty unless asked for (setRotationsWanted)
  double time = 0;           ///< s, simulated
  long step = 0;
  bool playing = false;
  StepReport report;         ///< of the last step; default after a reset
  std::vector<Pose> hands;   ///< where each hand wanted its tool, W
  LiveRates rates;
  long rejectedSteps = 0;    ///< steps that were not finite and not taken, since reset
  /// What must be said about the run since reset or the last change of model or recording; null without a watch. Another
  /// list when something is new.
  std::shared_ptr<const std::vector<Notice>> notices;
  RestState rest;            ///< nothing known without a watch
};

/// One step of a run; what makes it is chosen by a StepMaker. The report is valid until the next call.
using StepFunction = std::function<const StepReport&(const Inputs&, State&)>;
using StepMaker = std::function<StepFunction(std::shared_ptr<const Model>, const StepperOptions&)>;

/// The StepMaker of a real run: a Stepper.
StepFunction makeStepperStep(std::shared_ptr<const Model> model, const StepperOptions& options);

/// Runs a model against the clock in a thread of its own. State and scratch live in that thread only;
/// commands go in by a queue, hand poses and snapshots through triple buffers. Pacing: see StepClock. A new model
/// takes over the running one's state by id (carryState). The destructor stops the run and joins.
/// Threads: commands from any thread; setHands from one thread; takeSnapshot and snapshot from one thread.
class SimulationThread {
 public:
  /// A run that takes so long (s of the clock) for fewer than kFewSteps steps is paused and says so: nobody can work with it.
  static constexpr double kPatience = 60;
  static constexpr long kFewSteps = 20;

  /// Without a WatchMaker nothing is said about the run.
  explicit SimulationThread(StepMaker maker, WatchMaker watchMaker = {}, double patience = kPatience);
  ~SimulationThread();
  SimulationThread(const SimulationThread&) = delete;
  SimulationThread& operator=(const SimulationThread&) = delete;

  /// `carry`: keep what moves by id, else start over. The hands keep their place when carried; carried into an equal
  /// model, a run goes on to the same bits as if nothing had happened.
  void setModel(std::shared_ptr<const Model> model, const StepperOptions& options, bool carry);
  /// Null: tools that nobody holds stay where they are.
  void setRecording(std::shared_ptr<const Recording> recording);
  void play();
  void pause();
  void stepOnce();  ///< pauses, then takes one step
  void reset();     ///< back to the model's start; goes on playing if it was

  /// Whether snapshots hold rotations, from the next one on, which comes at once. Off at first: they are a copy for each step.
  void setRotationsWanted(bool wanted);

  /// Newest wishes by tool order; the run takes them up at its next step.
  void setHands(const std::vector<HandWish>& wishes);

  /// True when there is something newer than what snapshot() shows, which it shows from then on.
  bool takeSnapshot() { return m_snapshots.take(); }
  const Snapshot& snapshot() const { return m_snapshots.front(); }

 private:
  struct Run;
  TripleBuffer<Snapshot> m_snapshots;
  TripleBuffer<std::vector<HandWish>> m_hands;
  std::unique_ptr<Run> m_run;
};

}  // namespace glenoid
