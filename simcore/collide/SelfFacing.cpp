// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/collide/SelfFacing.h"

#include <array>
#include <cmath>

namespace glenoid {
namespace {

/// Cosine of the widest angle to an axis. A contact's normal may leave a dentable edge's faces by 32° (PairEdges.cpp), so
/// 58° and that stay within the right angle to the axis.
constexpr double kWithin = 0.53;

constexpr int kAxes = 13;
std::array<Vec3, kAxes> axes() {
  std::array<Vec3, kAxes> list;
  int n = 0;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (9 * x + 3 * y + z > 0) list[n++] = Vec3(x, y, z) / std::sqrt(double(x * x + y * y + z * z));
  return list;
}

}  // namespace

void SelfFacing::update(const MovingSurface& surface) {
  static const std::array<Vec3, kAxes> kAxis = axes();
  const CollisionSurface& s = surface.topology();
  m_ofTriangle.resize(s.triangles.size());
  m_ofVertex.assign(s.vertexCount, ~std::uint32_t{0});
  m_ofNode.resize(surface.tree().nodes().size());
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    std::uint32_t along = 0;  // none of a triangle without a face, so it is never left out
    const Vec3& normal = surface.faceNormal(static_cast<int>(t));
    for (int k = 0; k < kAxes; ++k) {
      const double cosine = normal.dot(kAxis[k]);
      along |= std::uint32_t{cosine >= kWithin} << (2 * k) | std::uint32_t{cosine <= -kWithin} << (2 * k + 1);
    }
    m_ofTriangle[t] = along;
    for (const int v : s.triangles[t]) m_ofVertex[v] &= along;
  }
  // A triangle stands for its vertices and edges too, whose cones reach to the normals of all that is beside them.
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const auto [i, j, k] = s.triangles[t];
    m_ofTriangle[t] = m_ofVertex[i] & m_ofVertex[j] & m_ofVertex[k];
  }
  const auto nodes = surface.tree().nodes();
  for (std::size_t n = nodes.size(); n-- > 0;)
    m_ofNode[n] = nodes[n].leaf() ? m_ofTriangle[nodes[n].item()] : m_ofNode[nodes[n].first] & m_ofNode[nodes[n].second];
}

}  // namespace glenoid
