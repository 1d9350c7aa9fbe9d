// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/SignedPrisms.h"

#include <algorithm>

namespace glenoid {

SignedPrisms::SignedPrisms(const TriMesh& closed, const Vec3& origin) {
  for (const auto& t : closed.triangles) {
    Prism prism;
    for (int i = 0; i < 3; ++i) {
      prism.corners[i] = closed.vertices[t[i]] - origin;
      prism.box.extend(prism.corners[i]);
    }
    const auto& c = prism.corners;
    prism.normal = (c[1] - c[0]).cross(c[2] - c[0]);
    if (prism.normal.z() == 0) continue;
    m_box.extend(prism.box);
    m_prisms.push_back(prism);
  }
  if (m_prisms.empty()) return;
  const double area = std::max(1e-300, m_box.sizes().x() * m_box.sizes().y());
  m_side = std::sqrt(area / (1 + static_cast<double>(m_prisms.size()) / 8));
  for (int k = 0; k < 2; ++k) m_count[k] = 1 + static_cast<int>(std::min(2000.0, m_box.sizes()[k] / m_side));
  m_squares.resize(static_cast<std::size_t>(m_count[0]) * m_count[1]);
  for (std::size_t p = 0; p < m_prisms.size(); ++p)
    forEachSquare(m_prisms[p].box, [&](auto& list) { list.push_back(static_cast<int>(p)); });
  m_seen.assign(m_prisms.size(), 0);
}

std::array<HalfSpace, 4> SignedPrisms::sidesOf(const Prism& prism, double up) {
  std::array<HalfSpace, 4> sides;
  for (int i = 0; i < 3; ++i) {
    const Vec3 &p = prism.corners[i], edge = prism.corners[(i + 1) % 3] - p;
    const Vec3 out = up * Vec3(edge.y(), -edge.x(), 0);
    sides[i] = {out, out.dot(p)};
  }
  sides[3] = {up * prism.normal, up * prism.normal.dot(prism.corners[0])};
  return sides;
}

template <class Function>
void SignedPrisms::forEachSquare(const Box3& box, Function&& function) {
  int low[2], high[2];
  for (int k = 0; k < 2; ++k) {
    const auto at = [&](double x) { return std::clamp(static_cast<int>((x - m_box.min()[k]) / m_side), 0, m_count[k] - 1); };
    low[k] = at(box.min()[k]), high[k] = at(box.max()[k]);
  }
  for (int y = low[1]; y <= high[1]; ++y)
    for (int x = low[0]; x <= high[0]; ++x) function(m_squares[static_cast<std::size_t>(y) * m_count[0] + x]);
}

const std::vector<int>& SignedPrisms::near(const Box3& box) {
  m_found.clear();
  if (m_prisms.empty()) return m_found;
  ++m_query;
  forEachSquare(box, [&](const auto& list) {
    for (const int p : list) {
      if (m_seen[p] == m_query) continue;
      m_seen[p] = m_query;
      const Box3& other = m_prisms[p].box;
      if (other.max().x() <= box.min().x() || other.min().x() >= box.max().x() || other.max().y() <= box.min().y() ||
          other.min().y() >= box.max().y() || other.max().z() <= box.min().z())
        continue;
      m_found.push_back(p);
    }
  });
  std::sort(m_found.begin(), m_found.end());
  return m_found;
}

}  // namespace glenoid
