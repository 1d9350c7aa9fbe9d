// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdint>

#include "simcore/base/Math.h"

namespace glenoid {

/// What one tool can touch for the next few milliseconds, copied out of a step: small enough to be solved anew at a haptic rate
/// by somebody who knows nothing of the scene. A plain value of fixed size; copying it allocates nothing.
///
/// Bodies are the tool that the hand holds and, where it carries another one (a finger on the skin and the same one inside), that.
/// A displacement d has six numbers for each body: of its origin, m, and a rotation vector, rad, both in W, from the pose
/// it has here. A row i says how far apart two features are, in m, and may not become negative:
///   s_i(d, f, t) = slack_i + J_i d + approach_i t + Σ_j C_ij (f_j − force_j) ≥ 0   ⊥   f_i ≥ 0
/// with f in N, t in s since the step. C is what the other sides give, tissue, other tools and films, the tool's own part left
/// out: whoever solves this puts the tool in as it moves at his own rate. What else presses those other sides stays shut.
/// Nothing in it is of a body that nothing holds, so a row on a fixed part has C = 0.
/// Source: Otaduy and Gross, "Transparent rendering of tool contact with compliant environments", World Haptics 2007
/// (linear handles of a slow simulation in a fast loop).
struct LocalProblem {
  static constexpr int kRows = 32, kBodies = 2, kLinks = 8, kUnknowns = 6 * kBodies;
  /// Where a simulation is as late as it may be, a problem is used from one step's length after the state that it describes until two; so its rows
  /// are best those of the middle.
  static constexpr double kStepsAhead = 1.5;

  /// One of the springs by which a tool carries another; ends in the bodies' frames.
  struct Link {
    Vec3 a_B = Vec3::Zero(), b_B = Vec3::Zero();  ///< on body 0 and on body 1, m
    double stiffness = 0;                         ///< N/m
  };

  bool valid = false;                      ///< false: nothing is known, which is not the same as nothing being near
  int tool = -1;                           ///< in the scenario's order
  std::int64_t stamp = 0;                  ///< ns of the steady clock at which the hand of that step was read; the publisher's user sets it
  double time = 0;                         ///< s, simulated, at the end of the step
  double dt = 0;                           ///< s between two steps

  int bodyCount = 0;
  std::array<Pose, kBodies> pose;          ///< at the end of the step, W
  Vec3 grip_B = Vec3::Zero();              ///< where the hand pulls at body 0, m
  double stiffness = 0, angularStiffness = 0;  ///< of that pull as the scenario has it, N/m and N·m/rad
  double forceMax = 0, torqueMax = 0;      ///< of it, N and N·m
  int linkCount = 0;
  std::array<Link, kLinks> links;

  int rowCount = 0;
  int overflow = 0;                        ///< rows in reach that found no place, the farthest
  std::array<double, kRows> slack{};       ///< m, at the end of the step; 0 for what presses
  std::array<double, kRows> force{};       ///< N, of the step
  std::array<double, kRows> approach{};    ///< m/s: how the other side moves on by itself
  Eigen::Matrix<double, kRows, kUnknowns> J = Eigen::Matrix<double, kRows, kUnknowns>::Zero();
  Eigen::Matrix<double, kRows, kRows> C = Eigen::Matrix<double, kRows, kRows>::Zero();  ///< m/N, symmetric
};

}  // namespace glenoid
