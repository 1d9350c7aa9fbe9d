// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/ThreadsGranted.h"

#include <algorithm>
#include <cstdlib>
#include <thread>

namespace glenoid {

int threadsGranted() {
  // SLURM_CPUS_PER_TASK is there only where it was asked for; SLURM_CPUS_ON_NODE always, in a job.
  for (const char* name :
       {"SLURM_CPUS_PER_TASK", "SLURM_CPUS_ON_NODE", "PBS_NUM_PPN", "NSLOTS", "LSB_DJOB_NUMPROC"})
    if (const char* words = std::getenv(name))
      if (const int count = std::atoi(words); count > 0) return count;
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

}  // namespace glenoid
