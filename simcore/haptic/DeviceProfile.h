// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "simcore/base/Error.h"

namespace glenoid {

/// What is known of a force-feedback device, at its handle. Everything a gain is chosen from. Zero where nothing is known of
/// friction or resolution; the damping is always a number, a careful one where nobody has measured it.
struct DeviceProfile {
  std::string id, name;
  std::string source;       ///< where the numbers come from, or that they are assumed
  double damping = 0;       ///< viscous, of the mechanism itself, N·s/m, at the place and in the direction where it has least
  double friction = 0;      ///< Coulomb's, N
  double resolution = 0;    ///< of a position, m
  double mass = 0;          ///< apparent, kg
  double forceMax = 0;      ///< N that may be asked for
  double slewMax = 0;       ///< N/s
  double rate = 1000;       ///< Hz at which forces are sent
  double delay = 0;         ///< s between a position and the force that answers it, the hold of one tick left out
};

/// Why a coupling is no stiffer.
enum class GainLimit { Wish, Damping, Resolution };

/// Spring and damper between a device and what it moves.
struct CouplingGains {
  double stiffness = 0;     ///< N/m
  double damping = 0;       ///< N·s/m
  double bound = 0;         ///< N/m: the stiffest spring that the device can show and stay passive, without a damper
  GainLimit limit = GainLimit::Wish;  ///< not Wish: saturated, the wish was stiffer
};

/// Damping, N·s/m, that a device must have for a spring K and damper B, sampled every T and answered `delay` later, held for
/// T, to be passive for whoever holds it, however he moves:
///   b ≥ sup over 0 < θ ≤ π of  K T/2 · sin((n + ½)θ)/sin(θ/2) − B cos((n + 1)θ),   n = delay/T
/// which without delay is Colgate's K T/2 + |B|. Source: Colgate and Schenkel, "Passivity of a class of sampled-data systems:
/// application to haptic interfaces", J. Robotic Systems 14 (1997), their condition with z⁻ⁿ put before the wall.
double dampingNeeded(double stiffness, double damping, double period, double delay);

/// The same from above in closed form, K (T/2 + delay) + |B|, which gains are chosen by: the first term is largest at θ → 0, the
/// second is at most |B|. Hulin, Gil and others find the edge of *stability* at K = (b + B)/(T/2 + delay) where a device is
/// heavy ("Stability boundary for haptic rendering: influence of damping and delay", ICRA 2007).
double dampingEnough(double stiffness, double damping, double period, double delay);

/// Gains at `rate` with `addedDelay` beyond the device's own: of the damping that the device has, a tenth goes to the damper and
/// the rest to the spring; no stiffer than wished, nor than 2 f_c/Δ where friction f_c and resolution Δ are known, by
/// which an encoder's steps do no work that friction does not take (Abbott and Okamura, IEEE Trans. Robotics 21, 2005).
CouplingGains gainsFor(const DeviceProfile& device, double wishedStiffness, double rate, double addedDelay = 0);

/// What is taken of a device that no list holds: 0.1 N·s/m, 3 N. Lightly built desktop devices have about that much and more
/// once a hand holds them; who knows his device writes a profile.
DeviceProfile unknownDevice();

/// Reads {"devices": [{"id": …, "damping": …, …}]}. Fails as readJson does, with SchemaMismatch where a member is missing or of
/// the wrong kind, OutOfRange, DuplicateId; places name the pointer.
Result<std::vector<DeviceProfile>> readDeviceProfiles(const std::string& path);

}  // namespace glenoid
