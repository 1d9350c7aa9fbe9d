// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/embed/Cells.h"
#include "simcore/scene/Joint.h"

namespace glenoid {

/// What an author wants of one part's body: its visual surface stays, the other two meshes follow.
struct BodyWish {
  PartKind kind = PartKind::Rigid;
  int collisionTriangles = 0;  ///< 0 or at least the visual's number: the visual itself
  double cellSize = 0;         ///< m, soft parts, > 0
  GridAxes axes = GridAxes::World;
  std::vector<double> importance =
      {};  ///< for each vertex of the visual surface where triangles matter, see simplify; or empty
  std::shared_ptr<const TriMesh> collision = nullptr;  ///< made before for the same wish: taken as it is
};

/// How good the meshes are and what they will cost.
struct BodyFigures {
  int visualTriangles = 0, collisionTriangles = 0, tetrahedra = 0, nodes = 0;
  int pieces = 0;            ///< of the tetrahedra, joined by faces; more than one falls apart
  double deviationMax = 0;   ///< m between the two surfaces, either way, at vertices and centres of triangles
  double deviationMean = 0;  ///< m, of the collision surface from the visual one
  double volumeError = 0;    ///< of the collision surface's volume over the visual's, signed
  double meanFill = 0;       ///< share of the tetrahedra's volume that is tissue
  double leastFill = 0;      ///< of a tetrahedron, before the floor that fillFractions keeps
  double stepMs = 0;         ///< see expectedStepMs; 0 where rigid
  double thinnest = 0;       ///< m, twice the volume over half the area: a rough thickness of a sheet
};

struct Body {
  std::shared_ptr<const TriMesh> collision;
  std::shared_ptr<const TetMesh> volume;  ///< null where rigid
  BodyFigures figures;
};

/// Called between pieces of work; true: nobody wants the answer any more.
using IsStale = std::function<bool()>;

/// Collision surface and tetrahedra from a part's visual surface (paper §4.2). Deterministic. Fails as
/// simplify and embedInCells do, the place names the part; with BadMesh for a part without visual surface,
/// and with Cancelled.
Result<Body> makeBody(const Part& part, const BodyWish& wish, const IsStale& isStale = {});

/// The part with another body: kind, meshes and cell size. Regions on the collision surface go to the nearest
/// triangles of the new one; one that would be left empty goes, unless the surface is the same.
Part withBody(const Part& part, const BodyWish& wish, const Body& body);

/// What a soft part adds to a step with the profile `direct`, ms of one core: its assembly by the number of
/// tetrahedra, its factorisation by the products of blocks that the symbolic phase counts, the solve by the
/// blocks of the factor. Contacts and the fill that couplings add are not counted. The coefficients were
/// fitted to blocks of 40 to 8640 tetrahedra on one server core of 2023, where they are right within a factor
/// of 1.5; bench tells the truth.
double expectedStepMs(const TetMesh& volume);

}  // namespace glenoid
