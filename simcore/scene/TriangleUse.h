// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/scene/Part.h"

namespace glenoid {

/// Which of the part's material uses each visual triangle shows, as an index into Part::materials: the last use whose
/// region holds it, else the first.
std::vector<int> useOfTriangles(const Part& part);

}  // namespace glenoid
