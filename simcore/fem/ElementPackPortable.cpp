// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/fem/ElementPack.h"

namespace glenoid {
#define KERNEL_NAME elementPackPortable
#include "simcore/fem/ElementPackBody.inc"

PackKernel packKernel(bool portable) {
  return !portable && __builtin_cpu_supports("avx2") ? elementPackAvx2 : elementPackPortable;
}

}  // namespace glenoid
