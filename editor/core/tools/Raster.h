// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "editor/core/tools/Viewport.h"
#include "simcore/mesh/TriMesh.h"

/// Triangles on pixels, on the CPU: for picking and for small pictures, where no window is. Internal to the
/// tools.
namespace glenoid::raster {

inline constexpr float kOutside = -1e6f;

/// Pixel and 1 / depth; 1 / depth is linear over a triangle on the screen. Zero: behind the eye.
struct Corner {
  float x = kOutside, y = kOutside, inverse = 0;
};

std::vector<Corner> cornersOf(const Viewport& viewport, const TriMesh& mesh);

struct Slope {
  float area = 0;          ///< twice the signed area in pixels; negative: faces the viewer (y runs down)
  float byX = 0, byY = 0;  ///< of 1 / depth
};

inline Slope slopeOf(const Corner& a, const Corner& b, const Corner& c) {
  Slope s;
  const float ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
  s.area = ux * vy - uy * vx;
  if (s.area == 0) return s;
  const float du = b.inverse - a.inverse, dv = c.inverse - a.inverse;
  s.byX = (du * vy - dv * uy) / s.area;
  s.byY = (dv * ux - du * vx) / s.area;
  return s;
}

/// First and last pixel whose middle is not below `low` or above `high`; rounding by hand, since without
/// SSE 4.1 ceil and floor are calls that cost more than the small triangle.
inline int firstPixel(float low) {
  const float t = std::max(low - 0.5f, 0.0f);
  const int i = static_cast<int>(t);
  return i + (static_cast<float>(i) < t);
}
inline int lastPixel(float high, int size) {
  const float t = std::min(high - 0.5f, static_cast<float>(size - 1));
  const int i = static_cast<int>(t);
  return i - (static_cast<float>(i) > t);
}

/// Calls visit(x, y, 1 / depth) for every pixel whose middle lies in the triangle.
template <class Visit>
void fill(const Corner& a, const Corner& b, const Corner& c, const Slope& slope, int width, int height,
          Visit&& visit) {
  if (slope.area == 0) return;
  const float lowX = std::min(a.x, std::min(b.x, c.x)), highX = std::max(a.x, std::max(b.x, c.x));
  const float lowY = std::min(a.y, std::min(b.y, c.y)), highY = std::max(a.y, std::max(b.y, c.y));
  if (highX < 0 || highY < 0 || lowX > static_cast<float>(width) || lowY > static_cast<float>(height)) return;
  const int x0 = firstPixel(lowX), x1 = lastPixel(highX, width), y0 = firstPixel(lowY),
            y1 = lastPixel(highY, height);
  const float sign = slope.area > 0 ? 1.0f : -1.0f;
  const auto side = [sign](const Corner& p, const Corner& q, float x, float y) {
    return sign * ((q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x));
  };
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const float px = static_cast<float>(x) + 0.5f, py = static_cast<float>(y) + 0.5f;
      if (side(a, b, px, py) < 0 || side(b, c, px, py) < 0 || side(c, a, px, py) < 0) continue;
      visit(x, y, a.inverse + slope.byX * (px - a.x) + slope.byY * (py - a.y));
    }
}

}  // namespace glenoid::raster
