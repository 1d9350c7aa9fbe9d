// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/study/Bench.h"

namespace glenoid {

/// The scene on which other simulators have been measured, in ours and, where the program `bullet_peer` lies beside
/// this one, in Bullet's deformable world, in a process of its own: the section "peers" of the benchmark.
BenchSection peerSection();

}  // namespace glenoid
