// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/tools/ScreenMap.h"

#include <algorithm>
#include <cmath>

#include "editor/core/tools/Raster.h"

namespace glenoid {

using raster::Corner;
using raster::kOutside;
using raster::Slope;

ScreenMap::ScreenMap(const Viewport& viewport, const TriMesh& surface,
                     std::span<const std::shared_ptr<const TriMesh>> others)
    : m_width(std::max(viewport.width, 1)), m_height(std::max(viewport.height, 1)) {
  const std::size_t pixels = static_cast<std::size_t>(m_width) * m_height, count = surface.triangles.size();
  m_ids.assign(pixels, -1);
  m_own.assign(pixels, 0);
  m_others.assign(pixels, 0);
  for (const auto& other : others) {
    if (!other) continue;
    const std::vector<Corner> corners = raster::cornersOf(viewport, *other);
    for (const auto& t : other->triangles) {
      const Corner &a = corners[t[0]], &b = corners[t[1]], &c = corners[t[2]];
      if (!(a.inverse > 0 && b.inverse > 0 && c.inverse > 0)) continue;
      raster::fill(a, b, c, raster::slopeOf(a, b, c), m_width, m_height, [this](int x, int y, float inverse) {
        float& nearest = m_others[x + y * m_width];
        nearest = std::max(nearest, inverse);
      });
    }
  }

  const std::vector<Corner> corners = raster::cornersOf(viewport, surface);
  m_centres.assign(count, Eigen::Vector2f(kOutside, kOutside));
  m_seen.assign(count, 0);
  struct Middle {
    float inverse = 0, slack = 0;
  };
  std::vector<Middle> middles(count);
  // A triangle seen at a grazing angle changes much over a pixel; its own slope says how much, up to a steep
  // limit.
  const float steepest = static_cast<float>(10 * 2 * std::tan(viewport.view.fieldOfView / 2) / m_height);
  for (std::size_t t = 0; t < count; ++t) {
    const auto& k = surface.triangles[t];
    const Corner &a = corners[k[0]], &b = corners[k[1]], &c = corners[k[2]];
    if (!(a.inverse > 0 && b.inverse > 0 && c.inverse > 0)) continue;
    const Slope slope = raster::slopeOf(a, b, c);
    m_centres[t] = Eigen::Vector2f(a.x + b.x + c.x, a.y + b.y + c.y) / 3;
    if (slope.area < 0) {
      const float inverse = (a.inverse + b.inverse + c.inverse) / 3;
      middles[t] = {
          inverse, 1e-4f * inverse + std::min(std::abs(slope.byX) + std::abs(slope.byY), steepest * inverse)};
    }
    raster::fill(a, b, c, slope, m_width, m_height, [this, t](int x, int y, float inverse) {
      const int pixel = x + y * m_width;
      if (inverse <= m_own[pixel]) return;
      m_own[pixel] = inverse;
      m_ids[pixel] = static_cast<int>(t);
    });
  }
  for (std::size_t t = 0; t < count; ++t) {
    if (middles[t].inverse <= 0) continue;
    const Eigen::Vector2f& centre = m_centres[t];
    if (!(centre.x() >= 0 && centre.y() >= 0 && centre.x() < static_cast<float>(m_width) &&
          centre.y() < static_cast<float>(m_height)))
      continue;
    const int x = static_cast<int>(centre.x()), y = static_cast<int>(centre.y());
    const float nearest = std::max(m_own[x + y * m_width], m_others[x + y * m_width]);
    m_seen[t] = middles[t].inverse + middles[t].slack >= nearest;
  }
}

int ScreenMap::triangleAt(const Vec2& at, bool through) const {
  const int x = static_cast<int>(std::floor(at.x())), y = static_cast<int>(std::floor(at.y()));
  if (x < 0 || y < 0 || x >= m_width || y >= m_height) return -1;
  const int pixel = x + y * m_width;
  return through || m_own[pixel] >= m_others[pixel] * (1 - 1e-4f) ? m_ids[pixel] : -1;
}

}  // namespace glenoid
