// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "simcore/mesh/TetMesh.h"
#include "simcore/mesh/TriMesh.h"
#include "simcore/scene/DentTable.h"
#include "simcore/scene/Elements.h"

namespace glenoid {

enum class PartKind { Rigid, Soft };
enum class SurfaceKind { Visual, Collision };

/// Half-open run of triangles [first, first + count).
struct TriangleRun {
  int first = 0, count = 0;
  bool operator==(const TriangleRun&) const = default;
};

/// Named set of surface triangles of one part in rest coordinates: a footprint, cartilage, a landmark,
/// a groove. Couplings, materials, tasks and metrics refer to it by id.
struct Region {
  std::string id;                      ///< slug, unique in the part
  std::string name;                    ///< shown to people
  std::string kind;                    ///< "footprint", "cartilage", "tendon", "landmark", "groove", "other"
  SurfaceKind surface = SurfaceKind::Visual;
  std::vector<TriangleRun> triangles;  ///< ascending, not overlapping
  bool operator==(const Region&) const = default;
};

/// A material of a part; where `region` is empty it is the part's default. A tetrahedron takes the material
/// whose region holds the visual triangle nearest to its centroid; the last such use wins. A rigid part has the density
/// of its default, but under a region with a thickness: there a layer of that depth has the region's (cartilage on bone).
struct MaterialUse {
  std::string material;  ///< id of a Material
  std::string region;    ///< id of a Region of this part, or empty
  double thickness = 0;  ///< m, rigid parts only, of a region: depth of the layer that weighs as this material; 0: none
  bool operator==(const MaterialUse&) const = default;
};

/// Named point in rest coordinates, for measuring and for palpation tasks.
struct Landmark {
  std::string id;    ///< slug, unique in the part
  std::string name;  ///< shown to people
  Vec3 position_W = Vec3::Zero();  ///< m, rest
  bool operator==(const Landmark&) const = default;
};

/// One anatomical structure: rigid or soft, with its surfaces and, where soft, the mesh of its dynamics.
/// All meshes stand in the joint's rest frame W (metres) and never change; several documents share them.
struct Part {
  std::string id;             ///< slug, unique in the joint
  int number = 0;             ///< as printed in tables, unique, > 0
  std::string name;           ///< shown to people
  PartKind kind = PartKind::Rigid;
  std::array<float, 3> color{0.8f, 0.8f, 0.8f};  ///< sRGB, 0…1
  std::vector<MaterialUse> materials;            ///< first: default
  std::vector<Region> regions;
  std::vector<Landmark> landmarks;
  std::shared_ptr<const TriMesh> visual;
  std::shared_ptr<const TriMesh> collision;
  std::shared_ptr<const TetMesh> volume;  ///< soft parts only, else null
  double cellSize = 0;                    ///< edge of the embedding cells the volume was cut from, m; 0 if rigid
  Elements elements = Elements::Tetrahedra;  ///< what a soft part is made of in a run
  std::shared_ptr<const DentTable> dents; ///< what the volume is too coarse for; null: not computed
};

}  // namespace glenoid
