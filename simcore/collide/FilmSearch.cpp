// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/collide/FilmSearch.h"

#include <algorithm>
#include <cmath>

#include "simcore/collide/FeatureKey.h"
#include "simcore/spatial/TrianglePoint.h"

namespace glenoid {

namespace {
constexpr double kTouching = 1e-9;  ///< m: below this the direction between two points says nothing
/// Least cosine between the way to the nearest point and the roof's normal there; less is beside the roof, past its rim.
constexpr double kUnderneath = 0.5;
}  // namespace

FilmSearch::FilmSearch(FilmSides sides, std::vector<std::shared_ptr<const CollisionSurface>> surfaces, double thickness,
                       int firstKey)
    : m_sides(std::move(sides)), m_surfaces(std::move(surfaces)), m_thickness(thickness), m_firstKey(firstKey) {
  m_boxes.resize(m_sides.roof.size());
  m_result.reserve(m_sides.floor.size());
}

const std::vector<FilmTouch>& FilmSearch::find(std::span<const std::span<const Vec3>> positions) {
  m_result.clear();
  const Vec3 reach = Vec3::Constant(std::max(kMargin * m_thickness, kDepth));
  m_all.setEmpty();
  for (std::size_t t = 0; t < m_boxes.size(); ++t) {
    const FilmSides::Triangle& roof = m_sides.roof[t];
    Box3& box = m_boxes[t];
    box.setEmpty();
    for (const int v : m_surfaces[roof.surface]->triangles[roof.triangle]) box.extend(positions[roof.surface][v]);
    box.min() -= reach;
    box.max() += reach;
    m_all.extend(box);
  }
  FilmTouch found;
  for (int floor = 0; floor < static_cast<int>(m_sides.floor.size()); ++floor)
    if (touch(positions, floor, found)) m_result.push_back(found);
  return m_result;
}

bool FilmSearch::touch(std::span<const std::span<const Vec3>> positions, int floor, FilmTouch& touch) const {
  const FilmSides::Vertex& vertex = m_sides.floor[floor];
  const Vec3& p = positions[vertex.surface][vertex.vertex];
  if (!m_all.contains(p)) return false;
  double best = 1e30;
  int nearest = -1;
  Vec3 weights = Vec3::Zero(), foot = Vec3::Zero();
  for (std::size_t t = 0; t < m_boxes.size(); ++t) {
    if (!m_boxes[t].contains(p)) continue;
    const FilmSides::Triangle& roof = m_sides.roof[t];
    const auto& corners = m_surfaces[roof.surface]->triangles[roof.triangle];
    const auto& at = positions[roof.surface];
    const Vec3 &a = at[corners[0]], &b = at[corners[1]], &c = at[corners[2]], w = nearestBarycentric(p, a, b, c);
    const Vec3 candidate = w[0] * a + w[1] * b + w[2] * c;
    const double d2 = (p - candidate).squaredNorm();
    if (!(d2 < best)) continue;
    best = d2;
    nearest = static_cast<int>(t);
    weights = w;
    foot = candidate;
  }
  if (nearest < 0) return false;

  const FilmSides::Triangle& roof = m_sides.roof[nearest];
  const auto& corners = m_surfaces[roof.surface]->triangles[roof.triangle];
  const auto& at = positions[roof.surface];
  const Vec3 across = (at[corners[1]] - at[corners[0]]).cross(at[corners[2]] - at[corners[0]]);
  const double size = across.norm(), distance = std::sqrt(best);
  if (!(size > 0)) return false;
  const Vec3 outward = across / size;
  const double height = (p - foot).dot(outward);
  if (std::abs(height) < kUnderneath * distance) return false;
  const double gap = height < 0 ? -distance : distance;
  if (gap > kMargin * m_thickness || gap < -kDepth) return false;
  const Vec3 normal = distance > kTouching ? Vec3((p - foot) / gap) : outward;

  // The floor has to look at the roof: a film does not reach through a tendon.
  Vec3 facing = Vec3::Zero();
  const auto& mine = positions[vertex.surface];
  for (const int t : m_surfaces[vertex.surface]->trianglesOf(vertex.vertex)) {
    const auto& c = m_surfaces[vertex.surface]->triangles[t];
    facing += (mine[c[1]] - mine[c[0]]).cross(mine[c[2]] - mine[c[0]]);
  }
  const double area = -facing.dot(normal) / 6;  // a third of each triangle
  if (!(area > 0)) return false;

  touch.floor = floor;
  touch.roofSurface = roof.surface;
  touch.area = area;
  touch.near.a = {1, {vertex.vertex, 0, 0}, {1, 0, 0}};
  touch.near.b = {3, corners, {weights[0], weights[1], weights[2]}};
  touch.near.normal_W = normal;
  touch.near.gap = gap;
  touch.near.key = FeatureKey::make(FeatureKey::kFilm, FeatureKind::Vertex, m_firstKey + floor, FeatureKind::Face, 0);
  return true;
}

}  // namespace glenoid
