// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "editor/render/GlResources.h"
#include "editor/render/SceneGeometry.h"

namespace glenoid {

/// A dent as the GPU applies it to the vertices of one visual surface.
struct ShownDent {
  Range vertices;
  Eigen::Vector4f place_W = Eigen::Vector4f::Zero();  ///< x y z, radius; m
  Eigen::Vector3f way_W = Eigen::Vector3f::Zero();    ///< into the surface, as long as the dent is deep, m
  bool operator==(const ShownDent& o) const {
    return vertices.first == o.vertices.first && vertices.count == o.vertices.count && place_W == o.place_W && way_W == o.way_W;
  }
};

/// Holds a scene's topology on the GPU and turns a state vector q into positions and normals there.
/// Positions and normals are arrays of four floats by vertex of the SceneGeometry.
class StateEvaluator {
 public:
  /// Fails with Internal when a shader does not build.
  Result<Done> build();

  /// Fails with NoGraphics when an array exceeds the driver's buffer textures.
  Result<Done> setScene(const SceneGeometry& geometry);

  /// Share of open sky by vertex of the scene (see Occlusion); 1 everywhere until the first call.
  void setOpenness(const std::vector<float>& open);

  /// Value by vertex of the scene, as surface.vert's attribute 5. Takes no memory before the first call.
  void setField(const std::vector<float>& values);

  /// Sends q and evaluates; nothing is done when all is what it was. Takes the first kDentsMost dents. `shifts`: what vertices
  /// are shifted by after all else, W, m, three numbers by vertex of the scene; empty: none.
  void evaluate(const VecX& q, const std::vector<ShownDent>& dents = {}, const std::vector<float>& shifts = {});
  static constexpr std::size_t kDentsMost = 4;

  /// Vertex array with positions, normals and the scene's indices, as surface.vert reads them.
  unsigned surfaces() { return m_surfaces.id(); }
  /// The same with positions only (lines, dots); attribute 1 is free for a constant colour.
  unsigned points() { return m_points.id(); }

  /// Back from the GPU: vertices [range.first, range.first + range.count).
  std::vector<Eigen::Vector4f> readPositions(Range range) { return read(m_positions, range); }
  std::vector<Eigen::Vector4f> readNormals(Range range) { return read(m_normals, range); }

 private:
  std::vector<Eigen::Vector4f> read(GlBuffer& buffer, Range range);
  void sendShifts(const std::vector<float>& shifts);

  Program m_positionPass, m_normalPass;
  GlBuffer m_entities, m_rings, m_tissue, m_indices, m_neighbours, m_q, m_positions, m_normals, m_openness, m_field, m_shift;
  GlFramebuffer
      m_frame;  ///< a draw needs a complete one, even when nothing is rasterised; a headless context has none
  GlRenderbuffer m_pixel;
  GlTexture m_qTexture, m_positionTexture, m_neighbourTexture;
  GlVertexArray m_entityArray, m_ringArray, m_surfaces, m_points;
  std::vector<float> m_sent, m_new;  ///< q as last sent, and as it comes
  std::vector<ShownDent> m_dents;     ///< as last evaluated
  std::vector<float> m_shifts;        ///< as last evaluated
  int m_vertexCount = 0;
};

}  // namespace glenoid
