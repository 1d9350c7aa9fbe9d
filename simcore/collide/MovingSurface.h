// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "simcore/collide/CollisionSurface.h"
#include "simcore/spatial/BoxTree.h"

namespace glenoid {

enum class FeatureKind { Face, Edge, Vertex };

/// One collision surface as it lies in this step: normals and a refitted tree. Scratch of the proximity
/// search; everything is recomputed from positions by update(). Frames: W, m. Not-finite input makes it
/// unusable.
class MovingSurface {
 public:
  explicit MovingSurface(std::shared_ptr<const CollisionSurface> topology);

  /// Boxes reach margin = contactDistance / 2 + min(speed · dt, lookAhead) beyond their triangle, with the largest speed
  /// of any motion. An empty motion is rest. The spans must outlive the queries.
  void update(std::span<const Vec3> positions, std::span<const std::span<const Vec3>> motions, double contactDistance,
              double dt, double lookAhead);

  const CollisionSurface& topology() const { return *m_topology; }
  bool usable() const { return m_usable; }
  const BoxTree& tree() const { return m_tree; }
  const Vec3& x(int vertex) const { return m_x[vertex]; }
  Vec3 v(int motion, int vertex) const { return m_v[motion].empty() ? Vec3::Zero() : m_v[motion][vertex]; }
  const Vec3& faceNormal(int triangle) const {
    return m_faceNormal[triangle];
  }  ///< unit, or zero without area
  double height(int triangle, const Vec3& p) const {
    return m_faceNormal[triangle].dot(p) - m_faceOffset[triangle];
  }
  double margin(int triangle) const { return m_margin[triangle]; }
  /// The faces beside the edge bend away from it by more than about 0.06°.
  bool convex(int edge) const { return m_convex[edge] != 0; }

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
  /// Nearest point of the whole surface nearer than `reach`.
  Nearest nearest(const Vec3& p, double reach);
  /// Nearest interior point of a face in front of which `p` is not, and whose normal has a component of at
  /// most `facing` along the unit vector `direction`.
  Nearest nearestFacing(const Vec3& p, double reach, const Vec3& direction, double facing);

 private:
  std::shared_ptr<const CollisionSurface> m_topology;
  BoxTree m_tree;
  std::span<const Vec3> m_x;
  std::array<std::span<const Vec3>, 4> m_v;  ///< by motion
  std::vector<double> m_speed;               ///< by vertex, the largest of any motion
  std::vector<Vec3> m_faceNormal;
  std::vector<double> m_faceOffset, m_margin;
  std::vector<char> m_convex;
  std::vector<Vec3> m_vertexNormal;
  std::vector<long> m_vertexNormalStep;
  long m_step = 0;
  bool m_usable = false;
};

}  // namespace glenoid
