// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/fem/CellPack.h"

// Only this file's own functions are built for AVX2; nothing shared with other files is compiled here.
#pragma GCC target("avx2")
namespace glenoid {
#define KERNEL_NAME cellPackAvx2
#include "simcore/fem/CellPackBody.inc"
}  // namespace glenoid
