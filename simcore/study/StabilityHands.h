// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/step/Model.h"
#include "simcore/step/Stepper.h"

namespace glenoid {

/// A tool and what it is near: where it would touch, and how deep it could be pushed in. W, m.
struct Touch {
  int tool = -1;                   ///< in scenario.tools
  int toolObject = -1, object = -1;  ///< in model.objects; the second is a part
  Vec3 home_W = Vec3::Zero();      ///< tip of the tool at home
  Vec3 at_W = Vec3::Zero();        ///< nearest place of the part's collision surface
  Vec3 inward_W = Vec3::UnitY();   ///< unit, from home through it
  double inside = 0;               ///< m, along it from `at_W`, to where the part is deepest
};

/// For each tool that a hand moves: the nearest soft and the nearest rigid part that it may collide with, as they lie in `state`.
/// By tool, the nearer first; empty where contact is off.
std::vector<Touch> touchesOf(const Model& model, const State& state);

/// What a hand does with its tool, by time from the beginning, s. The other hands stay at home.
enum class HandPlay {
  Press,   ///< to `amount` m deep (no deeper than the middle) within 0.3 s, stays till 0.6 s, home at 0.9 s
  Jump,    ///< in one step to the deepest place, for `amount` s, and in one step home
  Dash,    ///< at `amount` m/s to 2 cm beyond the deepest place, stays till 0.3 s, and as fast home
  Drag,    ///< in 0.1 s to the deepest place or 1 cm deep, sideways to and fro over 6 cm at `amount` m/s till 0.6 s, home at 0.7 s
  Silent,  ///< as Press, but from 0.35 s on nothing is heard for `amount` s; then the hand is 5 cm aside, home at 0.9 s
  Wild     ///< as Press, but every 20 ms what no hand can do: NaN, 1e30, no rotation; sane and home from `amount` s on
};

/// When it ends, s.
double endOf(const Touch& touch, HandPlay play, double amount);

/// All hands at a time, s.
Inputs playHands(const Model& model, const Touch& touch, HandPlay play, double amount, double time);

/// The n-th thing that a mad device says, from a pose; 0 is the pose itself. Ten of them.
Pose wildPose(const Pose& hand, long n);

}  // namespace glenoid
