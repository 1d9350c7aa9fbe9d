// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "simcore/body/PartMass.h"
#include "simcore/check/CheckParts.h"

namespace glenoid::check {
namespace {

/// ωΔt with which backward Euler still shows a swing: its amplitude falls by a quarter each time, and not at once.
constexpr double kShown = 0.1;

/// Whether steps damp a spring's swing more than its author does, and within one swing. ω in rad/s, damping in s.
bool swallowed(double omega, double damping, double dt) {
  const double own = 0.5 * damping * omega * omega, numerical = std::log1p(omega * omega * dt * dt) / (2 * dt);
  return omega * dt > 1 && 0.5 * damping * omega < 1 && numerical > own;
}

}  // namespace

void checkSteps(Work& work) {
  if (!work.scenario) return;
  const double dt = work.scenario->dt;
  for (const Hold& hold : work.scenario->holds) {
    const int index = findPart(work.joint, hold.part);
    if (index < 0 || !work.usable[index] || work.joint.parts[index].kind != PartKind::Rigid) continue;
    const auto mass = massPropertiesOf(work.joint, work.joint.parts[index]);
    if (!mass || !(mass->mass > 0)) continue;
    // Of its turns the slowest: where that one is lost, all are.
    const double inertia = Eigen::SelfAdjointEigenSolver<Mat3>(mass->inertia, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
    const double swings[] = {std::sqrt(hold.stiffness / mass->mass), inertia > 0 ? std::sqrt(hold.angularStiffness / inertia) : 0};
    double fastest = 0;
    for (const double omega : swings)
      if (std::isfinite(omega) && swallowed(omega, hold.damping, dt)) fastest = std::max(fastest, omega);
    if (fastest == 0) continue;
    Problem& problem = work.add(ProblemKind::StepTooLong, Severity::Warning, hold.part);
    problem.figure = fastest / (2 * std::numbers::pi);
    problem.wanted = kShown / fastest;
  }
}

}  // namespace glenoid::check
