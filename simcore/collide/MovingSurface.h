// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "simcore/collide/CollisionSurface.h"
#include "simcore/spatial/BoxTree.h"
#include "simcore/spatial/TrianglePoint.h"

namespace glenoid {

enum class FeatureKind { Face, Edge, Vertex };

/// One collision surface as it lies in this step: normals and a refitted tree. Scratch of the proximity
/// search; everything is recomputed from positions by update(). Frames: W, m. Not-finite input makes it
/// unusable.
class MovingSurface {
 public:
  explicit MovingSurface(std::shared_ptr<const CollisionSurface> topology);
  static constexpr int kMotionsMost = 8;

  /// Boxes reach margin = contactDistance / 2 + min(speed · dt, ahead()) beyond their triangle, with the largest speed
  /// of any motion against the surface's own drift in it. An empty motion is rest. The spans must outlive the queries.
  void update(std::span<const Vec3> positions, std::span<const std::span<const Vec3>> motions, double contactDistance,
              double dt);
  /// Mean velocity of all vertices in one of the motions, m/s.
  const Vec3& drift(int motion) const { return m_drift[motion]; }
  /// Most that the search looks ahead for this surface, m: a bound for what moves absurdly.
  double ahead() const { return kAhead * m_topology->size; }

  const CollisionSurface& topology() const { return *m_topology; }
  bool usable() const { return m_usable; }
  const BoxTree& tree() const { return m_tree; }
  const Vec3& x(int vertex) const { return m_x[vertex]; }
  Vec3 v(int motion, int vertex) const { return m_v[motion].empty() ? Vec3::Zero() : m_v[motion][vertex]; }
  const Vec3& faceNormal(int triangle) const {
    return m_faceNormal[triangle];
  }  ///< unit, or zero without area
  /// A triangle that has an inside and an outside now: not empty, and not flattened by the motion.
  bool hasFace(int triangle) const { return m_hasFace[triangle] != 0; }
  double height(int triangle, const Vec3& p) const {
    return m_faceNormal[triangle].dot(p) - m_faceOffset[triangle];
  }
  double margin(int triangle) const { return m_margin[triangle]; }

  /// Corners and plane of a triangle in single precision, four lanes (the last repeats the first corner): for
  /// throwing away pairs that are far apart, a cache line for each triangle.
  struct alignas(64) Lanes {
    std::array<float, 4> x, y, z;
    std::array<float, 3> normal;
    float offset;
  };
  const Lanes& lanes(int triangle) const { return m_lanes[triangle]; }
  /// Bound on what single precision does to a height over a plane and to a coordinate, m.
  float laneSlack() const { return m_laneSlack; }
  /// How the faces beside an edge bend away from it. Convex: by more than about 0.06°.
  /// Dentable: neither, and the surface deforms. The rest, open edges too, plays no part of its own.
  enum class Bend : std::uint8_t { None, Dentable, Convex };
  Bend bend(int edge) const { return m_bend[edge]; }
  /// Bit k is of the triangle's edge k.
  struct Bends {
    std::uint8_t convex = 0, dentable = 0;
  };
  const Bends& bends(int triangle) const { return m_bends[triangle]; }

  /// Pseudo-normals, not unit. Source: Bærentzen and Aanæs, IEEE TVCG 11(3), 2005.
  Vec3 edgeNormal(int edge) const;
  const Vec3& vertexNormal(int vertex);  ///< angle-weighted; worked out on first use in a step

  /// The feature of a triangle that carries a nearest point, by which of its weights are not zero.
  struct Feature {
    FeatureKind kind = FeatureKind::Face;
    int id = -1;  ///< triangle, edge or vertex
  };
  Feature featureOf(int triangle, const Vec3& barycentric) const;
  Vec3 normalOf(const Feature& feature);

  struct Nearest {
    int triangle = -1;  ///< −1: nothing within reach
    Vec3 barycentric = Vec3::UnitX(), point = Vec3::Zero();
    double distance = 0;
    Feature feature;
    bool inside = false;  ///< by the feature's pseudo-normal; on the surface counts as inside
  };
  /// Nearest point of the whole surface nearer than `reach`; on triangles that have a face.
  Nearest nearest(const Vec3& p, double reach);
  /// The same of the triangles for which counts(triangle, squared distance) holds.
  template <class Counts>
  Nearest nearestOf(const Vec3& p, double reach, Counts&& counts) {
    Nearest found;
    const double best = m_tree.nearest(p, reach * reach, [&](int t, double bestSoFar) {
      const double h = height(t, p);
      if (h * h > bestSoFar) return h * h;
      if (!m_hasFace[t]) return 2 * bestSoFar + 1;  // without a normal it would take everything for inside
      const auto [i, j, k] = m_topology->triangles[t];
      const Vec3 w = nearestBarycentric(p, m_x[i], m_x[j], m_x[k]);
      const Vec3 q = w[0] * m_x[i] + w[1] * m_x[j] + w[2] * m_x[k];
      const double d = (q - p).squaredNorm();
      const bool nearer = d < bestSoFar || (d == bestSoFar && found.triangle > t);
      if (nearer && !counts(t, d)) return 2 * bestSoFar + 1;
      if (nearer) {
        found.triangle = t;
        found.barycentric = w;
        found.point = q;
      }
      return d;
    });
    if (found.triangle < 0) return found;
    found.distance = std::sqrt(best);
    found.feature = featureOf(found.triangle, found.barycentric);
    found.inside = normalOf(found.feature).dot(p - found.point) <= 0;
    return found;
  }
  /// Nearest point of a face behind whose plane `p` lies, right over the face (its border too, to within `slack`), of those
  /// whose normal is allowed(normal, triangle, depth²).
  template <class Allowed>
  Nearest nearestFace(const Vec3& p, double reach, double slack, Allowed&& allowed) const {
    Nearest found;
    const double best = m_tree.nearest(p, reach * reach, [&](int t, double bestSoFar) {
      const double h = height(t, p), none = 2 * bestSoFar + 1;
      if (!m_hasFace[t] || h > 0 || h * h >= bestSoFar || !allowed(m_faceNormal[t], t, h * h)) return none;
      const auto [i, j, k] = m_topology->triangles[t];
      const Vec3 w = nearestBarycentric(p, m_x[i], m_x[j], m_x[k]);
      const Vec3 foot = w[0] * m_x[i] + w[1] * m_x[j] + w[2] * m_x[k];
      if ((foot - p - h * -m_faceNormal[t]).squaredNorm() > slack * slack) return none;
      found.triangle = t;
      found.barycentric = w;
      found.point = foot;
      return h * h;
    });
    if (found.triangle < 0) return found;
    found.distance = std::sqrt(best);
    found.feature = {FeatureKind::Face, found.triangle};
    found.inside = true;
    return found;
  }
  /// Where a ray from p along a unit direction first leaves the body through a face (its border too, to within `slack`).
  Nearest leaving(const Vec3& p, const Vec3& way, double slack) const;

 private:
  static constexpr double kAhead = 2;  ///< times the surface's size

  std::shared_ptr<const CollisionSurface> m_topology;
  BoxTree m_tree;
  std::span<const Vec3> m_x;
  std::array<std::span<const Vec3>, kMotionsMost> m_v;  ///< by motion
  std::array<Vec3, kMotionsMost> m_drift;               ///< by motion
  std::vector<double> m_speed;               ///< by vertex, against the drift, the largest of any motion
  std::vector<Vec3> m_faceNormal;
  std::vector<double> m_faceOffset, m_margin;
  std::vector<Lanes> m_lanes;
  float m_laneSlack = 0;
  std::vector<char> m_hasFace;
  std::vector<Bend> m_bend;
  std::vector<Bends> m_bends;
  std::vector<Vec3> m_vertexNormal;
  std::vector<long> m_vertexNormalStep;
  long m_step = 0;
  bool m_usable = false;
};

}  // namespace glenoid
