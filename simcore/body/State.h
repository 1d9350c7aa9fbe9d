// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <vector>

#include "simcore/base/Hash.h"
#include "simcore/base/Math.h"

namespace glenoid {

/// What moves, of the whole scene. Object i has q[qOffset…] and v[vOffset…] (see ObjectLayout).
/// Rigid: q = (c_W, quaternion as x y z w), v = (linear, angular), W. Soft: q = nodes, v = node velocities.
/// Copied, hashed, saved. A step is a function of it, so it also holds what the next step starts its
/// searches from: the last rotations of elements, the last hands, the last impulses.
struct State {
  VecX q, v;
  VecX rotations;   ///< unit quaternions x y z w of all elements, in object and element order
  VecX hands;       ///< last hand pose of each tool: position, quaternion x y z w
  double time = 0;  ///< s
  long step = 0;

  /// Contact impulses of the last step by feature key, ascending: the next step's first guess.
  struct Impulse {
    std::uint64_t key;
    double value;  ///< N·s
    Vec3 friction_W = Vec3::Zero();  ///< tangential, N·s
    Vec3 normal_W = Vec3::UnitY();   ///< of the contact, from b to a
  };
  std::vector<Impulse> impulses;
};

/// Hash over the exact bits of everything above.
Hash128 stateHash(const State& state);

/// True when no number in it is NaN or infinite.
bool isFinite(const State& state);

/// A pose as it lies in a state vector (three numbers, then quaternion x y z w), and back.
Pose poseAt(const VecX& values, int offset);
void setPoseAt(VecX& values, int offset, const Pose& pose);

}  // namespace glenoid
