// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "editor/render/Layers.h"
#include "editor/render/Tissue.h"
#include "simcore/base/Error.h"
#include "simcore/step/Model.h"

/// A model as flat arrays for the GPU, made once; no OpenGL here.
namespace glenoid {

/// One point entity, ready for positions.vert: see there.
struct GpuVertex {
  std::array<std::int32_t, 4> node{0, -1, 0, 0};  ///< offsets into q; rigid: {qOffset, −1, 0, 0}
  std::array<float, 4> weight{0, 0, 0, 0};        ///< rigid: r_B, m
};

struct Range {
  int first = 0, count = 0;
};

/// A surface in the arrays below. A vertex at a crease stands there once for each side of the crease.
struct SurfaceRanges {
  bool present = false;
  Range vertices;   ///< in SceneGeometry::vertices
  Range triangles;  ///< indices, three for each triangle, in the mesh's order
  Range edges;      ///< indices, two for each edge
  int meshVertices = 0;
};

/// Named region drawn as an overlay.
struct RegionRanges {
  int object = 0;
  SurfaceKind surface = SurfaceKind::Visual;
  std::string id, kind, name;
  std::vector<TriangleRun> runs;  ///< triangles of the mesh
  Range triangles;                ///< indices
};

/// A tool as what darkens tissue near it: from its tip's middle along +Z, about its mass centre as the vertices are.
struct ToolShaft {
  Eigen::Vector3f from_B = Eigen::Vector3f::Zero(), to_B = Eigen::Vector3f::Zero();
  float radius = 0;  ///< m
};

struct ObjectGeometry {
  std::string id, name;
  bool tool = false;
  Grain grain = Grain::None;     ///< of its visual surface, see Tissue
  float roughness = 0.4f, wet = 0;
  std::array<float, 3> color{};  ///< sRGB
  ObjectLayout layout;
  SurfaceRanges visual, collision;
  ToolShaft shaft;  ///< tools only
  Range tetEdges;   ///< indices, two for each edge
  const SurfaceRanges& surface(SurfaceKind kind) const {
    return kind == SurfaceKind::Visual ? visual : collision;
  }
};

struct SceneGeometry {
  int qSize = 0;
  std::vector<GpuVertex> vertices;                 ///< surfaces, tetrahedra's nodes, springs' ends
  std::vector<TissueVertex> tissue;                ///< by vertex
  std::vector<std::int32_t> source;                ///< surface vertex of the mesh; −1 for the others
  std::vector<std::array<std::int32_t, 2>> rings;  ///< by vertex: first and count in neighbours
  std::vector<std::array<std::int32_t, 2>>
      neighbours;  ///< other two vertices of an incident triangle, in order
  std::vector<std::uint32_t> indices;
  std::vector<ObjectGeometry> objects;
  std::vector<RegionRanges> regions;
  Range springs;  ///< vertices: the ends, a and b by turns
  std::vector<std::array<int, 2>> springObjects;
};

/// Triangles that meet at an edge under a larger angle than this are shaded as two sides of a crease, rad.
inline constexpr double kCreaseAngle = 1.05;

/// Fails with BadIndex, naming the object, when an index, a binding or a q range lies outside its array.
Result<SceneGeometry> buildSceneGeometry(const Model& model);

/// Position of one entity for q, W: what the GPU computes, in double.
Vec3 positionOf(const GpuVertex& vertex, const VecX& q);

}  // namespace glenoid
