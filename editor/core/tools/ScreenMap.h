// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "editor/core/tools/PickMap.h"
#include "editor/core/tools/Viewport.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// One surface as it is seen from one place among others that may hide it: for each triangle the pixel of its
/// centre and whether it is seen. Made once for a viewpoint, in time linear in the triangles: depths are drawn
/// on the CPU at one sample for each pixel, so it needs no window. Triangles that reach behind the eye are neither seen nor hide anything.
/// Frame W, metres.
class ScreenMap : public PickMap {
 public:
  ScreenMap(const Viewport& viewport, const TriMesh& surface,
            std::span<const std::shared_ptr<const TriMesh>> others);

  /// Pixel of the centre of each triangle; far outside of any window for what lies behind the eye.
  const std::vector<Eigen::Vector2f>& centres() const override { return m_centres; }
  /// Faces the viewer, within the window, not hidden: centre within a pixel's slope of the nearest depth
  /// there.
  bool seen(int triangle) const override { return m_seen[triangle]; }
  /// Nearest triangle under a pixel, −1: none. Without `through` only where nothing else hides it.
  int triangleAt(const Vec2& at, bool through) const;
  int at(const Vec2& pixel, bool through) const override { return triangleAt(pixel, through); }
  bool haveExtent() const override { return true; }

 private:
  int m_width, m_height;
  std::vector<Eigen::Vector2f> m_centres;
  std::vector<char> m_seen;
  std::vector<int> m_ids;       ///< by pixel: nearest triangle of the surface, −1
  std::vector<float> m_own;     ///< by pixel: 1 / depth of the surface, 0: none
  std::vector<float> m_others;  ///< the same of what may hide it
};

}  // namespace glenoid
