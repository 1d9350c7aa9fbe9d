// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/linear/Kernels.h"

#include "simcore/linear/KernelTable.h"

namespace glenoid {

const KernelTable& chooseKernels(bool portable) {
  const KernelTable* fast = portable ? nullptr : avx2Kernels();
  return fast ? *fast : portableKernels();
}

const char* kernelIsaName(bool portable) {
  return chooseKernels(portable).name;
}

}  // namespace glenoid
