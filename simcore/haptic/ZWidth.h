// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glenoid {

/// A device that nobody holds, in front of a wall of spring and damper.
struct WallDevice {
  double mass = 0.1;      ///< kg, > 0
  double damping = 1;     ///< N·s/m, > 0
  double period = 0.001;  ///< s
  int delayTicks = 0;     ///< between a position and the force that answers it, beside the hold
};

/// Largest modulus of the eigenvalues of one tick with a wall of stiffness K and damper B on the difference of two positions:
/// above 1 it swings up. Exact: the mass moves in closed form while a force is held.
double wallGrowth(const WallDevice& device, double stiffness, double damping);

/// The stiffest wall that does not swing up, N/m, by bisection to 1e-6 of it; 0 where the damper alone does. Between 0 and
/// this all are stable, which a test looks at.
double stiffestStable(const WallDevice& device, double damping);

/// The stiffest wall that is passive for whoever holds the device (dampingNeeded), N/m; 0 where the damper alone is not.
double stiffestPassive(const WallDevice& device, double damping);

}  // namespace glenoid
