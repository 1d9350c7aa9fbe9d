// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/BandShape.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <map>

#include "simcore/embed/Cells.h"

namespace glenoid {

namespace {

using Vec10 = Eigen::Matrix<double, 10, 1>;
using Mat10 = Eigen::Matrix<double, 10, 10>;

/// Where the middle surface hardly depends on a term, its coefficient stays small.
constexpr double kRidge = 1e-9;
constexpr int kCutsMost = 6;

Vec10 terms(double x, double y) {
  Vec10 t;
  t << 1, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y;
  return t;
}

/// Splits edges at their middles, each middle once, until no edge leaves its image.
class Cutter {
 public:
  Cutter(const BandShape& band, TriMesh& mesh, double tolerance) : m_band(band), m_mesh(mesh), m_tolerance(tolerance) {}

  bool leaves(int a, int b) const {
    const Vec3 &p = m_mesh.vertices[a], &q = m_mesh.vertices[b];
    return std::abs(m_band.heightOver(0.5 * (p + q)) - 0.5 * (m_band.heightOver(p) + m_band.heightOver(q))) > m_tolerance;
  }
  int middleOf(int a, int b) {
    const auto [entry, isNew] = m_middle.try_emplace(std::minmax(a, b), static_cast<int>(m_mesh.vertices.size()));
    if (isNew) m_mesh.vertices.push_back(0.5 * (m_mesh.vertices[a] + m_mesh.vertices[b]));
    return entry->second;
  }

 private:
  const BandShape& m_band;
  TriMesh& m_mesh;
  double m_tolerance;
  std::map<std::pair<int, int>, int> m_middle;
};

/// One round: each triangle in two, three or four by those of its edges that leave. Whether anything was cut.
bool cutOnce(const BandShape& band, TriMesh& mesh, double tolerance) {
  Cutter cutter(band, mesh, tolerance);
  std::vector<std::array<int, 3>> pieces;
  bool any = false;
  for (const auto t : std::vector<std::array<int, 3>>(mesh.triangles.begin(), mesh.triangles.end())) {
    int m[3], count = 0;
    for (int k = 0; k < 3; ++k) {
      m[k] = cutter.leaves(t[k], t[(k + 1) % 3]) ? cutter.middleOf(t[k], t[(k + 1) % 3]) : -1;
      count += m[k] >= 0;
    }
    any = any || count > 0;
    if (count == 0) {
      pieces.push_back(t);
    } else if (count == 3) {
      pieces.insert(pieces.end(), {{t[0], m[0], m[2]}, {m[0], t[1], m[1]}, {m[2], m[1], t[2]}, {m[0], m[1], m[2]}});
    } else {
      int k = 0;  // turned so that the first edge is cut and, where only one is whole, the last is that one
      while (m[k] < 0 || (count == 2 && m[(k + 1) % 3] < 0)) ++k;
      const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3], ab = m[k], bc = m[(k + 1) % 3];
      if (count == 1)
        pieces.insert(pieces.end(), {{a, ab, c}, {ab, b, c}});
      else
        pieces.insert(pieces.end(), {{a, ab, c}, {ab, bc, c}, {ab, b, bc}});
    }
  }
  mesh.triangles.assign(pieces.begin(), pieces.end());
  return any;
}

}  // namespace

double BandShape::heightOver(const Vec3& p_W) const {
  const Vec3 local = axes.transpose() * (p_W - origin) / length;
  const Vec10 t = terms(local.x(), local.y());
  double sum = 0;
  for (int k = 0; k < 10; ++k) sum += height[k] * t[k];
  return sum;
}

BandShape bandOf(const TriMesh& surface) {
  BandShape band;
  band.axes = principalAxes(surface).toRotationMatrix();
  const Box3 box = boundsOf(surface);
  band.origin = box.center();
  band.length = 0.5 * box.diagonal().norm();
  if (!(band.length > 0)) return band;
  Mat10 normal = Mat10::Zero();
  Vec10 right = Vec10::Zero();
  for (const auto& t : surface.triangles) {
    Vec3 p[3];
    for (int k = 0; k < 3; ++k) p[k] = band.axes.transpose() * (surface.vertices[t[k]] - band.origin) / band.length;
    const double third = std::abs((p[1] - p[0]).cross(p[2] - p[0]).z()) / 6;
    for (int k = 0; k < 3; ++k) {
      const Vec3 middle = 0.5 * (p[k] + p[(k + 1) % 3]);
      const Vec10 at = terms(middle.x(), middle.y());
      normal += third * at * at.transpose();
      right += third * middle.z() * at;
    }
  }
  normal.diagonal().array() += kRidge * normal.diagonal().maxCoeff();
  const Vec10 found = band.length * normal.ldlt().solve(right);
  std::copy(found.data(), found.data() + 10, band.height.begin());
  return band;
}

TriMesh flattened(const BandShape& band, const TriMesh& surface, double tolerance) {
  TriMesh flat = surface;
  for (int n = 0; n < kCutsMost && cutOnce(band, flat, tolerance); ++n) {
  }
  for (Vec3& v : flat.vertices) v = band.flattened(v);
  return flat;
}

}  // namespace glenoid
