// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/embed/Binding.h"
#include "simcore/embed/CageWeights.h"
#include "simcore/scene/Joint.h"

namespace glenoid {

/// A soft part in its cage, made ready for moving its handles: how nodes and surfaces follow, and how hard the tissue
/// resists. Handle displacements are one vector u, x y z of handle 0 first. Frames: W, m. The part and its meshes must
/// outlive it.
class CagedPart {
 public:
  /// Fails as cageWeights does; the place names the part.
  static Result<CagedPart> make(const Part& part, const Cage& cage);

  const Part& part() const { return *m_part; }
  const Cage& cage() const { return m_cage; }  ///< with its handles where they are now
  int handleCount() const { return static_cast<int>(m_cage.rest_W.size()); }
  CageCoordinates coordinates() const { return m_nodeWeights.kind; }

  /// Displacements of the handles from rest, 3 × handleCount().
  const VecX& shifts() const { return m_shifts; }
  void setShifts(const VecX& shifts);

  const std::vector<Vec3>& nodes() const { return m_nodes; }
  const TriMesh& collision() const { return m_collision; }
  /// How one collision vertex follows the handles: one weight for each.
  auto collisionWeights(int vertex) const { return m_collisionWeights.row(vertex); }
  /// Volume of each tetrahedron now over that at rest.
  std::vector<double> volumeRatios() const;

  /// Elastic stiffness at the handles, linear about rest, with a little resistance to moving as a whole: symmetric,
  /// positive definite, scaled so that its mean diagonal is one. `hardness`: a factor for each tetrahedron, or empty.
  MatX stiffness(const std::vector<double>& hardness = {}) const;

 private:
  CagedPart() = default;

  const Part* m_part = nullptr;
  Cage m_cage;
  CageWeights m_nodeWeights;
  MatX m_collisionWeights;  ///< collision vertices × handles
  VecX m_shifts;
  std::vector<Vec3> m_nodes;
  TriMesh m_collision;
};

}  // namespace glenoid
