// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/capsule/Portals.h"

#include "resources/generate/Bones.h"

namespace glenoid::generate {

std::vector<Landmark> portals() {
  // Measured on the reference body and scaled with it by 1.0975; the posterior one from the joint's own landmark, which stands
  // 4 mm higher than the scaled one for the subacromial gap.
  const Vec3 angle = project(scapula::field(), Vec3(-42.9, 22.5, 1.4));
  return {
      {"portal-posterior", "Porta posterior (posterior portal, soft spot)", 1e-3 * (angle + Vec3(0, -20, -12))},
      {"portal-anterior", "Porta anterior (anterior portal, rotator interval)", 1e-3 * Vec3(41.7, 6.6, -16.5)},
      {"portal-lateral", "Porta lateralis (lateral portal)", 1e-3 * Vec3(-11, 2.2, 65.9)},
  };
}

}  // namespace glenoid::generate
