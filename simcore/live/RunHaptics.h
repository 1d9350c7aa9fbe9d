// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "simcore/haptic/HapticThread.h"
#include "simcore/haptic/RecordedHand.h"
#include "simcore/live/RunReport.h"
#include "simcore/scene/Recording.h"
#include "simcore/step/LocalPublisher.h"

namespace glenoid {

/// A device of somebody who takes part: it holds a tool in place of the recording.
struct LiveHand {
  HapticDevice* device = nullptr;  ///< outlives the run
  std::string word;                ///< how it was asked for, for the report
  std::string tool;                ///< id of a tool that a hand holds
};

/// What a paced run is felt with, and how long it is compared with the exact step afterwards.
struct HapticWishes {
  DeviceProfile device;
  double compareSeconds = 10;  ///< of the run from its start, at most; 0: not at all. A live hand is not compared
  std::vector<LiveHand> live;  ///< at most one for a tool; other tools follow their tracks
};

/// Haptic threads beside a paced run: one for each tool that a hand holds, each with a device that follows the
/// tool's track by the clock. The run's own hands come from the tracks too, by its steps, and nothing that a haptic
/// thread does comes back to it: its state is that of the run without. A live hand is where its haptic thread last believed it to be when a
/// step begins, at home before its first word; what each step took is kept as a track, with which the run is repeated to the bit.
/// Threads: all calls from the one that steps.
class RunHaptics {
 public:
  /// `seconds`: how long the run is to be. The model, stepper and input outlive this.
  RunHaptics(const Model& model, Stepper& stepper, const Recording* input, const HapticWishes& wishes, double seconds);
  ~RunHaptics();

  /// Before a step, when its time has come: what it begins with is what its problem is stamped with. The threads start
  /// with the first one.
  void beginStep();
  /// The hands of the step that ends at `time`, as live devices have them, into those of the scenario's tools.
  void takeHands(double time, std::vector<Pose>& hands);
  /// What takeHands() answered, a track for each live hand.
  std::vector<HandTrack> liveTracks() const;
  /// After it: `behind`: s that the run has given up so far.
  void endStep(const StepReport& step, const State& state, double behind);
  /// Ends the threads. Then the run is made again, as far as wished, at the rate of the haptic thread, and its forces compared;
  /// `progress` 0…1, false cancels the comparison. What cannot be compared has no figure.
  HapticReport finish(const std::function<bool(double)>& progress);

  /// Thread CPU time of a step's publishing, median, ms.
  double publishMs();

  /// Why there is nothing to feel; empty: there is. "asked-off", "profile-paper", "no-contact" or "no-tool".
  static std::string reasonAgainst(const Model& model, Profile profile);

 private:
  struct Hand;
  void compare(double seconds, const std::function<bool(double)>& progress, HapticReport& report) const;

  const Model& m_model;
  const Recording* m_input;
  HapticWishes m_wishes;
  double m_seconds;
  LocalPublisher m_publisher;
  std::vector<std::unique_ptr<Hand>> m_hands;
  std::int64_t m_stamp = 0;
  bool m_started = false;
  std::vector<float> m_publishMs;
};

}  // namespace glenoid
