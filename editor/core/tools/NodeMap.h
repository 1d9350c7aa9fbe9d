// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <span>

#include "editor/core/tools/PickMap.h"
#include "editor/core/tools/Viewport.h"
#include "simcore/mesh/TetMesh.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// Nodes of a part's cells as they are seen from one place. The outside of the cells hides what lies behind it, and so
/// do the surfaces of others; the part's own surface, which lies within the cells, does not. Made once for a viewpoint,
/// in time linear in the tetrahedra. Nodes of no tetrahedron are nowhere. Frame W, metres.
class NodeMap : public PickMap {
 public:
  NodeMap(const Viewport& viewport, const TetMesh& cells, std::span<const std::shared_ptr<const TriMesh>> others);

  const std::vector<Eigen::Vector2f>& centres() const override { return m_centres; }
  bool seen(int node) const override { return m_seen[node]; }
  /// The nearest on the screen within 8 pixels; of equals the nearest to the eye.
  int at(const Vec2& pixel, bool through) const override;
  bool haveExtent() const override { return false; }

 private:
  std::vector<Eigen::Vector2f> m_centres;
  std::vector<float> m_inverse;  ///< 1 / depth, 0: not there
  std::vector<char> m_seen;
};

}  // namespace glenoid
