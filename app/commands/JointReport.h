// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "simcore/mesh/MeshHealth.h"
#include "simcore/step/Model.h"

namespace glenoid {

/// `joint info`: the parts beside the paper's Table 1 (where the joint is its shoulder) and the couplings with
/// their springs, as text or JSON. The model is compiled from the joint alone.
std::string jointInfoText(const Model& model);
std::string jointInfoJson(const Model& model);

/// One surface of one part as `joint check` sees it.
struct SurfaceCheck {
  std::string part;
  bool collision = false;
  MeshHealth health;
  int selfIntersections = 0;   ///< pairs of triangles; 0 where an index is bad
  /// A visual surface that cuts itself is drawn wrong in one place, which is worth a note; a collision surface that
  /// does gives contacts that push the wrong way, which is a failure.
  bool holds() const { return health.healthy() && (!collision || selfIntersections == 0); }
};

/// Two parts whose collision surfaces cut each other at the start although they may collide.
struct StartIntersection {
  std::string partA, partB;
  int pairs = 0;  ///< of triangles
};

/// Everything `joint check` looks at.
struct JointCheck {
  std::vector<SurfaceCheck> surfaces;
  std::vector<StartIntersection> intersections;
  int flatTetrahedra = 0;      ///< without positive volume
  int couplings = 0, springsMin = 0;
  bool holds() const;
};

JointCheck checkJoint(const Model& model);
std::string jointCheckText(const Model& model, const JointCheck& check);
std::string jointCheckJson(const Model& model, const JointCheck& check);

}  // namespace glenoid
