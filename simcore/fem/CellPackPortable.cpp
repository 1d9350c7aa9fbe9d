// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/fem/CellPack.h"

namespace glenoid {
#define KERNEL_NAME cellPackPortable
#include "simcore/fem/CellPackBody.inc"

CellKernel cellKernel(bool portable) {
  return !portable && __builtin_cpu_supports("avx2") ? cellPackAvx2 : cellPackPortable;
}

}  // namespace glenoid
