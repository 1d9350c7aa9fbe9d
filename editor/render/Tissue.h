// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/mesh/TriMesh.h"
#include "simcore/scene/Part.h"

namespace glenoid {

/// What a surface vertex looks like beyond its part's colour; constant, from the rest shape and the named
/// regions.
struct TissueVertex {
  float tendon = 0, cartilage = 0;  ///< 0…1, soft at the borders of regions of these kinds
  /// Where the grain is sampled, m. Muscle: across the fibres, through the sheet, along the fibres; else rest
  /// position.
  float across = 0, through = 0, along = 0;
};

struct Tissue {
  bool fibres = false;  ///< muscle: a soft part with a region of kind "tendon", towards which its fibres run
  std::vector<TissueVertex> vertices;  ///< by vertex of the mesh
};

/// Regions must lie inside the mesh. `part` may be null (a tool): no region counts.
Tissue tissueOf(const TriMesh& mesh, const Part* part);

}  // namespace glenoid
