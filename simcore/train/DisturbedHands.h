// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>

#include "simcore/scene/Recording.h"

namespace glenoid {

/// How hands are less sure than a recording: each direction moves by a sum of sines with seeded frequencies and phases.
struct Disturbance {
  double tremor = 0;        ///< m, root mean square in each direction, 4 to 9 Hz as of a hand that holds a tool
  double wander = 0;        ///< m, likewise, 0.2 to 0.8 Hz
  std::uint64_t seed = 1;
};

/// The recording with hands that tremble and wander, keys every 10 ms from its first to its last key. Before the first key hands
/// are still. Marks stay; what a run left in it (hashes, build) goes. Same bits for the same seed on any machine with the same
/// std::sin.
Recording disturbedHands(const Recording& recording, const Disturbance& disturbance);

}  // namespace glenoid
