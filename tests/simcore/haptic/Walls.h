// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>

#include "simcore/contact/LocalProblem.h"

namespace glenoid::test {

inline constexpr double T = 0.001;                  ///< s of a tick
inline constexpr std::int64_t kMs = 1'000'000;      ///< ns

/// A tool whose tip is its origin, above what gives `compliance` m/N: one row, along Y, open by `slack` where the tool stands at zero.
inline LocalProblem wall(double compliance = 0, double slack = 0) {
  LocalProblem problem;
  problem.valid = true;
  problem.tool = 0;
  problem.dt = 0.005;
  problem.bodyCount = 1;
  problem.stiffness = 800;
  problem.angularStiffness = 2;
  problem.forceMax = problem.torqueMax = 1e300;
  problem.rowCount = 1;
  problem.slack[0] = slack;
  problem.J(0, 1) = 1;
  problem.C(0, 0) = compliance;
  return problem;
}

inline Pose handAtHeight(double y) { return {Vec3(0, y, 0), Quat::Identity()}; }

}  // namespace glenoid::test
