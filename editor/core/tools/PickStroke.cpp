// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/tools/PickStroke.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glenoid {
namespace {

double distanceToSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length2 = along.squaredNorm();
  const double s = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - a - s * along).norm();
}

/// Even-odd rule; the last point is joined to the first.
bool insidePolygon(const Vec2& p, const std::vector<Vec2>& corners) {
  bool inside = false;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Vec2 &a = corners[i], &b = corners[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
      inside = !inside;
  }
  return inside;
}

}  // namespace

void PickStroke::extend(const Vec2& at) {
  // A lasso without the hand's trembling is as good and costs less for every triangle.
  if (m_mode == PickMode::Lasso && (at - m_path.back()).norm() < 2) return;
  if (m_mode == PickMode::Box && m_path.size() > 1) {
    m_path.back() = at;
  } else if (m_mode == PickMode::Click) {
    m_path.front() = at;
  } else {
    m_path.push_back(at);
  }
}

bool PickStroke::covers(const Vec2& p) const {
  if (m_path.empty()) return false;
  switch (m_mode) {
    case PickMode::Click:
      return (p - last()).cwiseAbs().maxCoeff() <= 5;
    case PickMode::Box: {
      const Vec2 low = first().cwiseMin(last()), high = first().cwiseMax(last());
      return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
    }
    case PickMode::Lasso:
      return m_path.size() > 2 && insidePolygon(p, m_path);
    case PickMode::Brush:
      return distanceToSegment(p, previous(), last()) <= m_radius;
  }
  return false;
}

std::vector<Vec2> circleOutline(const Vec2& centre, double radius) {
  std::vector<Vec2> line;
  constexpr int kPieces = 48;
  for (int i = 0; i < kPieces; ++i) {
    const double angle = 2 * std::numbers::pi * i / kPieces;
    line.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return line;
}

std::vector<Vec2> PickStroke::outline() const {
  if (m_path.empty()) return {};
  switch (m_mode) {
    case PickMode::Click:
      return {};
    case PickMode::Box:
      return {first(), Vec2(last().x(), first().y()), last(), Vec2(first().x(), last().y())};
    case PickMode::Lasso:
      return m_path;
    case PickMode::Brush:
      return circleOutline(last(), m_radius);
  }
  return {};
}

}  // namespace glenoid
