// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/embed/Cells.h"
#include "simcore/scene/Joint.h"

namespace glenoid {

/// What an author decides about one part; the pipeline makes the rest from it. Lengths in metres, frame W.
struct PartRecipe {
  std::string id;
  int number = 0;
  std::string name;
  PartKind kind = PartKind::Rigid;
  std::array<float, 3> color{0.8f, 0.8f, 0.8f};
  std::shared_ptr<const TriMesh> visual;     ///< closed; loadRecipe reads it from `visualFile`
  std::shared_ptr<const TriMesh> collision;  ///< optional: used as it is instead of simplifying
  int collisionTriangles = 0;                ///< wanted; 0 or at least the visual's number: the visual itself
  int tetrahedra = 0;                        ///< wanted, soft parts; used when cellSize is 0
  double cellSize = 0;                       ///< m, soft parts; when > 0 the cells are exactly this
  GridAxes axes = GridAxes::World;
  std::vector<MaterialUse> materials;
  std::vector<Region> regions;  ///< on the visual surface
  std::vector<Landmark> landmarks;
  std::string visualFile, collisionFile;  ///< names inside the folder of meshes, may be empty
};

/// A joint before its meshes are derived.
struct JointRecipe {
  std::string id, name;
  std::vector<Material> materials;
  std::vector<PartRecipe> parts;
  std::vector<Coupling> couplings;
  std::vector<Exclusion> exclusions;
  std::vector<Bursa> bursae;
  Provenance provenance;
  double clearance = 0;  ///< m; > 0: separateCollision before the cells are cut
  int separationIterations = 200;
};

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
};

/// The author's pipeline without the window (paper §4.2): simplify → separate → cells → volume. Parts come
/// out ascending by number; ids, references and materials are not judged here (that is the joint's check).
/// When surfaces could not be separated the joint is built all the same and the report says so. Fails with
/// BadMesh, MeshNotClosed, OutOfRange, Unusable (see simplify and chooseCells; the place names the part) or
/// Cancelled. Deterministic.
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
