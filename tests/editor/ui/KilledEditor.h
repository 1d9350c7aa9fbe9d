// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace glenoid {

/// The test program started with this and a folder is another program that has the block scene open: it makes one edit,
/// says "safe" when its safety copy is written, and waits to be killed.
inline constexpr const char* kKilledEditor = "--edit-until-killed";
int editUntilKilled(int argc, char** argv);

}  // namespace glenoid
