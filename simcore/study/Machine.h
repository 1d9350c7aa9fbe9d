// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace glenoid {

/// Name of the processor as the system gives it; "unknown" where it gives none.
std::string processorName();

/// Memory of this process that is in RAM now, and the most there ever was, MiB; 0 where the system does not say.
double residentMiB();
double residentPeakMiB();

}  // namespace glenoid
