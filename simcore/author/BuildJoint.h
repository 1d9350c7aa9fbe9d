// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "simcore/author/SeparateStart.h"
#include "simcore/base/Error.h"
#include "simcore/scene/Joint.h"
#include "simcore/scene/Recipe.h"

namespace glenoid {

/// Called before each piece of work: part at hand and how much is done, 0…1. False cancels.
using BuildProgress = std::function<bool(const std::string& part, double done)>;

/// Two parts whose collision surfaces are still too near.
struct NearPair {
  std::string partA, partB;  ///< ids, A the part of lower number
  double distance = 0;       ///< m; 0 when the surfaces cut each other or one lies inside the other
};

struct SeparationReport {
  int iterations = 0;
  int movedVertices = 0;
  double maxShift = 0;         ///< m, greatest displacement of a vertex
  std::vector<NearPair> left;  ///< empty: every pair that may collide keeps the clearance
};

/// What came of the wishes for one part.
struct PartFigures {
  std::string part;
  int visualTriangles = 0, collisionTriangles = 0, tetrahedra = 0;
  int collisionCuts = 0;  ///< pairs of triangles by which the collision surface cuts itself
};

struct BuildReport {
  std::vector<PartFigures> parts;
  SeparationReport separation;  ///< empty when no clearance was asked for
  std::optional<SeparationOutcome> start;  ///< present when the recipe wishes it
};

/// The author's pipeline without the window (paper §4.2 and 4.3): simplify → separate → cells → volume → couplings →
/// cages. Parts come out ascending by number; ids, references and materials are not judged here (that is the joint's
/// check). When surfaces could not be separated the joint is built all the same and the report says so. Fails with
/// NothingNear before any work (see checkNearCouplings), BadMesh, MeshNotClosed, OutOfRange, Unusable (see simplify and
/// chooseCells; the place names the part), UnknownId, TooFewSprings or BadNodes (a coupling that finds too little; the place
/// names it) or Cancelled. Deterministic.
Result<Joint> buildJoint(const JointRecipe& recipe, const BuildProgress& progress = {},
                         BuildReport* report = nullptr);

/// Moves collision vertices until the surfaces of all parts that may collide (those without an Exclusion)
/// keep `clearance` (m, > 0), vertices against faces and edges against edges. Of a pair the soft part yields;
/// of two alike the one of higher number. Displacements are spread over neighbours, so a surface dents
/// instead of folding. Only collision surfaces change: volumes should be cut afterwards. With no iterations
/// it only measures. A part that lies deep inside another cannot be helped this way and stays in `left`.
/// Deterministic. Fails with OutOfRange for a clearance that is not positive, with BadMesh for a part without
/// collision surface.
Result<SeparationReport> separateCollision(Joint& joint, double clearance, int iterations = 200);

}  // namespace glenoid
