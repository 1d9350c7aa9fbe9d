// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <vector>

#include "simcore/scene/Recording.h"
#include "simcore/scene/Scenario.h"

namespace glenoid {

/// What a person wants of one tool at this moment: held at a pose, or let go.
struct HandWish {
  bool held = false;
  Pose hand;  ///< W
};

/// Turns wishes and a recording into the hand poses of each step. A held tool follows its hand at a bounded
/// speed, which also smooths a mouse that reports less often than the simulation steps. A tool that was let
/// go glides back onto the recording where there is one, else it stays where it is. A tool that was never held
/// follows the recording exactly. Depends on step count and wishes only, on no clock.
class HandInput {
 public:
  static constexpr double kHeldSpeed = 1.5, kGlideSpeed = 0.15;         ///< m/s
  static constexpr double kHeldTurnSpeed = 15.0, kGlideTurnSpeed = 1.5;  ///< rad/s

  /// Hands go to the tools' home poses. `recording` may be null; tracks of unknown tools are ignored.
  void restart(const Scenario& scenario, std::shared_ptr<const Recording> recording);
  /// For a changed scenario: tools that stay keep the pose of their hand, and go on along the same recording as before;
  /// onto another one they glide.
  void change(const Scenario& scenario, std::shared_ptr<const Recording> recording);
  /// Hand poses at the end of the step that reaches `time`; `wishes` by tool order, may be shorter.
  const std::vector<Pose>& advance(const std::vector<HandWish>& wishes, double time, double dt);
  const std::vector<Pose>& hands() const { return m_hands; }
  /// There is a recording, and every hand is where it has it: none is held, on its way back, or was left somewhere else.
  bool onPath() const;

 private:
  struct Follower {
    std::string tool;
    const HandTrack* track = nullptr;  // into m_recording
    bool gliding = false;
  };
  void bind(const Scenario& scenario, std::shared_ptr<const Recording> recording);

  std::shared_ptr<const Recording> m_recording;
  std::vector<Follower> m_followers;
  std::vector<Pose> m_hands;
};

/// From `from` toward `to` by at most these steps; equal to `to` when it is within reach.
Pose approach(const Pose& from, const Pose& to, double distanceMax, double angleMax);

}  // namespace glenoid
