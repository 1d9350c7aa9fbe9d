// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/mesh/TriMesh.h"
#include "simcore/scene/Material.h"
#include "simcore/scene/Part.h"
#include "simcore/scene/Scenario.h"

namespace glenoid {

/// What a surface vertex looks like beyond its part's colour; constant, from the rest shape and the named
/// regions.
struct TissueVertex {
  /// 0…1, soft at the borders of regions of these kinds; where a muscle passes into its tendon over 22 mm, one half on
  /// the border.
  float tendon = 0, cartilage = 0;
  float fat = 0;  ///< depth below the skin, 0 on the skin, 1 at the fat's far side: a cut shows both
  float nail = 0; ///< of a finger: one half on the nail's border, 1 and 0 a millimetre from it
  /// Where the grain is sampled, m. Muscle and bands of collagen: across the fibres, through the sheet, along
  /// the fibres; else rest position.
  float across = 0, through = 0, along = 0;
};

/// What a surface's pattern is; the numbers are the shader's.
enum class Grain { None = 0, Muscle = 1, Bone = 2, Collagen = 3, Skin = 4, Finger = 5 };

struct Tissue {
  Grain grain = Grain::None;
  float roughness = 0.4f;  ///< of the highlight: moist tissue 0.3, bone 0.55
  float wet = 0;           ///< 0…1: a film of fluid with a highlight of its own
  std::vector<TissueVertex> vertices;  ///< by vertex of the mesh
};

/// Regions must lie inside the mesh. `part` may be null (a tool): no region counts. `appearance`: of the part's
/// default material. Fibres of a muscle converge to its tendon, or without a region of kind "tendon" they
/// run, along the muscle's bend, to the smaller of the two footprints farthest apart; those of a band run between its two
/// footprints.
Tissue tissueOf(const TriMesh& mesh, const Part* part, Appearance appearance);

/// What a tool that is a finger has more: skin and a nail. Nothing for the other kinds.
void addFinger(const Tool& tool, const TriMesh& look, Tissue& tissue);

}  // namespace glenoid
