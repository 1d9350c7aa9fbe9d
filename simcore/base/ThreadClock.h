// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <ctime>

namespace glenoid {

/// CPU time that the calling thread has used, ms: what a stage costs, whoever else the machine works for.
inline double threadCpuMs() {
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

}  // namespace glenoid
