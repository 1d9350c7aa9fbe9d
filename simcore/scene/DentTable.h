// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "simcore/base/Math.h"

namespace glenoid {

/// A place on a part's surface at rest and what it gives under a tip.
struct DentSample {
  Vec3 at_W = Vec3::Zero();  ///< m
  double compliance = 0;     ///< m/N, >= 0
  double depthMost = 0;      ///< m, >= 0: a tip sinks no deeper into the surface

  bool operator==(const DentSample&) const = default;
};

/// How much more a soft part gives under the tip of a tool than its own coarse tetrahedra show: found once by fine
/// static solves (simcore/author/MakeDents) and kept with the part. It holds while the part is what it was computed
/// from; afterwards it counts as absent.
struct DentTable {
  double radius = 0;                ///< of the patch that a tip presses, m, > 0
  std::vector<DentSample> samples;  ///< spread over the surface; never empty
  std::string basis;                ///< dentBasis() of what it was computed from

  bool operator==(const DentTable&) const = default;
};

}  // namespace glenoid
