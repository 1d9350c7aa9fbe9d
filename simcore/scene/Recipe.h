// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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
  Elements elements = Elements::Tetrahedra;  ///< of a soft part in a run
  std::optional<GridAxes> axes;              ///< none: W's, or the joint's own where its start is freed (author/OwnFrame.h)
  std::vector<MaterialUse> materials;
  std::vector<Region> regions;  ///< on the visual surface
  std::vector<Landmark> landmarks;
  std::string visualFile, collisionFile;  ///< names inside the folder of meshes, may be empty
};

/// A coupling whose region is found: what of part A's visual surface lies within a distance of part B's, or inside it.
struct NearCoupling {
  Coupling coupling;     ///< a region is made and gets the coupling's id; regionA: only what lies in this one, empty: all
  double within = 0;     ///< m, ≥ 0
  Vec3 centre_W = Vec3::Zero();  ///< with `radius`: only triangles whose centre lies in this ball
  double radius = 0;     ///< m; 0: no such limit
};

/// A coupling whose nodes are found on the cells of part A, once they are cut: those that lie in what is given of `within`
/// and the ball, or the nearest one to each point.
struct NodeCoupling {
  Coupling coupling;             ///< without nodes
  std::vector<Vec3> points_W;    ///< m; each node within half the diagonal of a cell. Not empty: neither of the others
  std::optional<double> within;  ///< m, ≥ 0: this near to part B's visual surface, or inside it
  Vec3 centre_W = Vec3::Zero();
  double radius = 0;             ///< m, of the ball; 0: none
};

/// How the start is freed of intersections by cages (paper §4.3).
struct StartWishes {
  double clearance = 1e-3;   ///< m kept between collision surfaces, > 0
  int handles = 100;         ///< of the cages that have to be made
  int iterations = 60;       ///< sweeps over all parts, for each refinement
  int refinements = 2;       ///< times that the cages of parts still in the way get twice the handles
  std::vector<std::string> parts;  ///< ids of soft parts whose cages may move; empty: all
};

/// A joint before its meshes are derived.
struct JointRecipe {
  std::string id, name, description;
  JointSide side = JointSide::Unsaid;
  std::vector<Material> materials;
  std::vector<PartRecipe> parts;
  std::vector<Coupling> couplings;
  std::vector<NearCoupling> nearCouplings;  ///< come after the others
  std::vector<NodeCoupling> nodeCouplings;  ///< come after these
  std::vector<Exclusion> exclusions;
  std::vector<Bursa> bursae;
  Provenance provenance;
  double clearance = 0;  ///< m; > 0: separateCollision before the cells are cut
  int separationIterations = 200;
  bool mirrored = false;  ///< the whole is built as the recipe says and then becomes the joint of the other side (author/MirrorJoint.h)
  std::optional<StartWishes> start;  ///< absent: parts start at rest, whatever overlaps
};

}  // namespace glenoid
