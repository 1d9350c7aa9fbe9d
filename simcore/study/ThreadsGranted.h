// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glenoid {

/// How many threads this process may use at once, ≥ 1: what a scheduler granted (Slurm, PBS, Grid Engine, LSF
/// by their variables), since a job of one processor sees all of them; without a scheduler all that there
/// are.
int threadsGranted();

}  // namespace glenoid
