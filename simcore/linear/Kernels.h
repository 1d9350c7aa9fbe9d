// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glenoid {

/// Instruction set of the inner loops: "avx2-fma" where the processor has it, else "portable"; always
/// "portable" when asked for. Belongs in every report that names a time or a state hash, because fused
/// multiply-adds round differently.
const char* kernelIsaName(bool portable);

}  // namespace glenoid
