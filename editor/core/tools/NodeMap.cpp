// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/tools/NodeMap.h"

#include <algorithm>
#include <cmath>

#include "editor/core/tools/Raster.h"
#include "simcore/mesh/NodePatch.h"
#include "simcore/mesh/TetTools.h"

namespace glenoid {

using raster::Corner;

NodeMap::NodeMap(const Viewport& viewport, const TetMesh& cells, std::span<const std::shared_ptr<const TriMesh>> others) {
  const int width = std::max(viewport.width, 1), height = std::max(viewport.height, 1);
  std::vector<float> nearest(static_cast<std::size_t>(width) * height, 0);
  const auto draw = [&](const TriMesh& mesh) {
    std::vector<Corner> corners = raster::cornersOf(viewport, mesh);
    for (const auto& t : mesh.triangles) {
      const Corner &a = corners[t[0]], &b = corners[t[1]], &c = corners[t[2]];
      if (!(a.inverse > 0 && b.inverse > 0 && c.inverse > 0)) continue;
      raster::fill(a, b, c, raster::slopeOf(a, b, c), width, height, [&](int x, int y, float inverse) {
        float& there = nearest[x + y * width];
        there = std::max(there, inverse);
      });
    }
    return corners;
  };
  for (const auto& other : others)
    if (other) draw(*other);
  const std::vector<Corner> corners = draw(boundaryOf(cells));  // keeps the numbers of nodes
  m_centres.assign(cells.nodes.size(), Eigen::Vector2f(raster::kOutside, raster::kOutside));
  m_inverse.assign(cells.nodes.size(), 0);
  m_seen.assign(cells.nodes.size(), 0);
  // A node is a corner of what hides it, and depths are those of the middles of pixels: a steep face may come nearer there.
  const float steepest = static_cast<float>(10 * 2 * std::tan(viewport.view.fieldOfView / 2) / height);
  for (const int node : usedNodes(cells)) {
    const Corner& at = corners[node];
    if (!(at.inverse > 0)) continue;
    m_centres[node] = {at.x, at.y};
    m_inverse[node] = at.inverse;
    if (!(at.x >= 0 && at.y >= 0 && at.x < static_cast<float>(width) && at.y < static_cast<float>(height))) continue;
    m_seen[node] = at.inverse * (1 + steepest) >= nearest[static_cast<int>(at.x) + static_cast<int>(at.y) * width];
  }
}

int NodeMap::at(const Vec2& pixel, bool through) const {
  constexpr float kReach = 8;
  int best = -1;
  float distance = kReach;
  for (std::size_t node = 0; node < m_centres.size(); ++node) {
    if (m_inverse[node] <= 0 || !(through || m_seen[node])) continue;
    const float d = (m_centres[node] - pixel.cast<float>()).norm();
    if (d > distance || (best >= 0 && d == distance && m_inverse[node] <= m_inverse[best])) continue;
    best = static_cast<int>(node);
    distance = d;
  }
  return best;
}

}  // namespace glenoid
