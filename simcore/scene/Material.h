// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>

namespace glenoid {

/// What a tissue looks like; nothing is computed from it.
enum class Appearance { Plain, Bone, Cartilage, Muscle, Tendon, Ligament, Skin };

/// Isotropic tissue. What the simulation uses is in the plain fields; where that differs from the
/// literature for the sake of interaction, the literature's value and the reason stand beside it.
struct Material {
  std::string id;                   ///< slug, unique in the joint
  std::string name;                 ///< shown to people
  Appearance appearance = Appearance::Plain;
  double density = 1000;            ///< kg/m³, > 0
  double youngsModulus = 1e5;       ///< Pa, > 0
  double poissonRatio = 0.45;       ///< in [0, 0.4999]
  double friction = 0.0;            ///< Coulomb coefficient of this side; a pair uses the geometric mean
  double massDamping = 0.0;         ///< Rayleigh α, 1/s
  double stiffnessDamping = 1e-3;   ///< Rayleigh β, s
  std::optional<double> literatureYoungsModulus;  ///< Pa, where it differs
  std::string reason;               ///< why it differs
  std::string source;               ///< where the figures come from

  bool operator==(const Material&) const = default;
};

}  // namespace glenoid
