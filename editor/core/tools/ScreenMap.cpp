// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/tools/ScreenMap.h"

#include <algorithm>
#include <cmath>

namespace glenoid {
namespace {

constexpr float kOutside = -1e6f;

/// Pixel and 1 / depth; 1 / depth is linear over a triangle on the screen. Zero: behind the eye.
struct Corner {
  float x = kOutside, y = kOutside, inverse = 0;
};

std::vector<Corner> cornersOf(const Viewport& viewport, const TriMesh& mesh) {
  const ViewAxes axes = axesOf(viewport.view);
  const double scale = viewport.height / (2 * std::tan(viewport.view.fieldOfView / 2));
  const double x0 = viewport.width / 2.0, y0 = viewport.height / 2.0;
  std::vector<Corner> corners(mesh.vertices.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 d = mesh.vertices[i] - viewport.view.eye_W;
    const double depth = -d.dot(axes.back_W);
    if (depth < 1e-5) continue;
    corners[i] = {static_cast<float>(x0 + scale * d.dot(axes.right_W) / depth),
                  static_cast<float>(y0 - scale * d.dot(axes.up_W) / depth), static_cast<float>(1 / depth)};
  }
  return corners;
}

struct Slope {
  float area = 0;         ///< twice the signed area in pixels; negative: faces the viewer (y runs down)
  float byX = 0, byY = 0; ///< of 1 / depth
};

Slope slopeOf(const Corner& a, const Corner& b, const Corner& c) {
  Slope s;
  const float ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
  s.area = ux * vy - uy * vx;
  if (s.area == 0) return s;
  const float du = b.inverse - a.inverse, dv = c.inverse - a.inverse;
  s.byX = (du * vy - dv * uy) / s.area;
  s.byY = (dv * ux - du * vx) / s.area;
  return s;
}

/// Calls visit(pixel, 1 / depth) for every pixel whose middle lies in the triangle.
template <class Visit>
void fill(const Corner& a, const Corner& b, const Corner& c, const Slope& slope, int width, int height, Visit&& visit) {
  if (slope.area == 0) return;
  const auto [lowX, highX] = std::minmax({a.x, b.x, c.x});
  const auto [lowY, highY] = std::minmax({a.y, b.y, c.y});
  if (highX < 0 || highY < 0 || lowX > static_cast<float>(width) || lowY > static_cast<float>(height)) return;
  const int x0 = std::max(0, static_cast<int>(std::ceil(lowX - 0.5f)));
  const int x1 = std::min(width - 1, static_cast<int>(std::floor(highX - 0.5f)));
  const int y0 = std::max(0, static_cast<int>(std::ceil(lowY - 0.5f)));
  const int y1 = std::min(height - 1, static_cast<int>(std::floor(highY - 0.5f)));
  const float sign = slope.area > 0 ? 1.0f : -1.0f;
  const auto side = [sign](const Corner& p, const Corner& q, float x, float y) {
    return sign * ((q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x));
  };
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const float px = static_cast<float>(x) + 0.5f, py = static_cast<float>(y) + 0.5f;
      if (side(a, b, px, py) < 0 || side(b, c, px, py) < 0 || side(c, a, px, py) < 0) continue;
      visit(x + y * width, a.inverse + slope.byX * (px - a.x) + slope.byY * (py - a.y));
    }
}

}  // namespace

bool sameViewport(const Viewport& a, const Viewport& b) {
  return a.width == b.width && a.height == b.height && a.view.eye_W == b.view.eye_W &&
         a.view.target_W == b.view.target_W && a.view.up_W == b.view.up_W && a.view.fieldOfView == b.view.fieldOfView;
}

ScreenMap::ScreenMap(const Viewport& viewport, const TriMesh& surface,
                     std::span<const std::shared_ptr<const TriMesh>> others)
    : m_width(std::max(viewport.width, 1)), m_height(std::max(viewport.height, 1)) {
  const std::size_t pixels = static_cast<std::size_t>(m_width) * m_height, count = surface.triangles.size();
  m_ids.assign(pixels, -1);
  m_own.assign(pixels, 0);
  m_others.assign(pixels, 0);
  for (const auto& other : others) {
    if (!other) continue;
    const std::vector<Corner> corners = cornersOf(viewport, *other);
    for (const auto& t : other->triangles) {
      const Corner &a = corners[t[0]], &b = corners[t[1]], &c = corners[t[2]];
      if (!(a.inverse > 0 && b.inverse > 0 && c.inverse > 0)) continue;
      fill(a, b, c, slopeOf(a, b, c), m_width, m_height,
           [this](int pixel, float inverse) { m_others[pixel] = std::max(m_others[pixel], inverse); });
    }
  }

  const std::vector<Corner> corners = cornersOf(viewport, surface);
  m_centres.assign(count, Eigen::Vector2f(kOutside, kOutside));
  m_seen.assign(count, 0);
  struct Middle {
    float inverse = 0, slack = 0;
  };
  std::vector<Middle> middles(count);
  // A triangle seen at a grazing angle changes much over a pixel; its own slope says how much, up to a steep limit.
  const float steepest = static_cast<float>(10 * 2 * std::tan(viewport.view.fieldOfView / 2) / m_height);
  for (std::size_t t = 0; t < count; ++t) {
    const auto& k = surface.triangles[t];
    const Corner &a = corners[k[0]], &b = corners[k[1]], &c = corners[k[2]];
    if (!(a.inverse > 0 && b.inverse > 0 && c.inverse > 0)) continue;
    const Slope slope = slopeOf(a, b, c);
    m_centres[t] = Eigen::Vector2f(a.x + b.x + c.x, a.y + b.y + c.y) / 3;
    if (slope.area < 0) {
      const float inverse = (a.inverse + b.inverse + c.inverse) / 3;
      middles[t] = {inverse, 1e-4f * inverse + std::min(std::abs(slope.byX) + std::abs(slope.byY), steepest * inverse)};
    }
    fill(a, b, c, slope, m_width, m_height, [this, t](int pixel, float inverse) {
      if (inverse <= m_own[pixel]) return;
      m_own[pixel] = inverse;
      m_ids[pixel] = static_cast<int>(t);
    });
  }
  for (std::size_t t = 0; t < count; ++t) {
    if (middles[t].inverse <= 0) continue;
    const int x = static_cast<int>(std::floor(m_centres[t].x())), y = static_cast<int>(std::floor(m_centres[t].y()));
    if (x < 0 || y < 0 || x >= m_width || y >= m_height) continue;
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
