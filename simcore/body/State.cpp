// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/body/State.h"

namespace glenoid {

Hash128 stateHash(const State& state) {
  Hash128 hash = hashBytes(&state.time, sizeof state.time, static_cast<std::uint64_t>(state.step));
  const auto mix = [&hash](const void* data, std::size_t size) {
    hash = hashBytes(data, size, hash.low ^ (hash.high * 0x9e3779b97f4a7c15ull));
  };
  for (const VecX* values : {&state.q, &state.v, &state.rotations, &state.hands})
    mix(values->data(), sizeof(double) * values->size());
  for (const State::Impulse& impulse : state.impulses) {
    mix(&impulse.key, sizeof impulse.key);
    mix(&impulse.value, sizeof impulse.value);
    mix(impulse.friction_W.data(), sizeof impulse.friction_W);
    mix(impulse.normal_W.data(), sizeof impulse.normal_W);
  }
  return hash;
}

bool isFinite(const State& state) {
  return state.q.allFinite() && state.v.allFinite() && state.rotations.allFinite();
}

Pose poseAt(const VecX& values, int offset) {
  return {values.segment<3>(offset),
          Quat(values[offset + 6], values[offset + 3], values[offset + 4], values[offset + 5])};
}

void setPoseAt(VecX& values, int offset, const Pose& pose) {
  values.segment<3>(offset) = pose.p_WB;
  values.segment<4>(offset + 3) = pose.q_WB.coeffs();  // x y z w
}

}  // namespace glenoid
