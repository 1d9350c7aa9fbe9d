// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "editor/render/GlResources.h"
#include "editor/render/SceneGeometry.h"

namespace glenoid {

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

  /// Sends q and evaluates; nothing is done when q is what it was.
  void evaluate(const VecX& q);

  /// Vertex array with positions, normals and the scene's indices, as surface.vert reads them.
  unsigned surfaces() { return m_surfaces.id(); }
  /// The same with positions only (lines, dots); attribute 1 is free for a constant colour.
  unsigned points() { return m_points.id(); }

  /// Back from the GPU: vertices [range.first, range.first + range.count).
  std::vector<Eigen::Vector4f> readPositions(Range range) { return read(m_positions, range); }
  std::vector<Eigen::Vector4f> readNormals(Range range) { return read(m_normals, range); }

 private:
  std::vector<Eigen::Vector4f> read(GlBuffer& buffer, Range range);

  Program m_positionPass, m_normalPass;
  GlBuffer m_entities, m_rings, m_tissue, m_indices, m_neighbours, m_q, m_positions, m_normals, m_openness;
  GlFramebuffer
      m_frame;  ///< a draw needs a complete one, even when nothing is rasterised; a headless context has none
  GlRenderbuffer m_pixel;
  GlTexture m_qTexture, m_positionTexture, m_neighbourTexture;
  GlVertexArray m_entityArray, m_ringArray, m_surfaces, m_points;
  std::vector<float> m_sent, m_new;  ///< q as last sent, and as it comes
  int m_vertexCount = 0;
};

}  // namespace glenoid
