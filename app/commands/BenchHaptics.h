// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace glenoid {

/// `bench haptics`, below the command `bench`.
void addBenchHaptics(CLI::App& bench, int& status);

}  // namespace glenoid
