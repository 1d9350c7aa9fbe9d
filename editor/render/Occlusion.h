// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "editor/render/SceneGeometry.h"

/// How much of the sky above each vertex of the visual surfaces is hidden by parts near it: cast once for a scene's
/// start state, with rays that remember whom they meet. So a part that is hidden, faded or moved away takes its share
/// of the dark along, without another ray. Tools are left out: they move all the time (see surface.frag). No OpenGL.
namespace glenoid {

/// Rays reach this far; what a ray meets near its origin counts most, m.
inline constexpr double kOcclusionReach = 0.03;
/// Over each vertex, evenly spread over the hemisphere's projection (cosine-weighted).
inline constexpr int kOcclusionRays = 48;

class Occlusion {
 public:
  Occlusion() = default;
  /// Casts the rays in state q, in `threads` threads (the same answer for any number). Stops early, with an unfinished
  /// answer, once `cancelled` says so. Takes about 0.5 µs a ray: under a second for the built-in shoulder.
  Occlusion(const SceneGeometry& scene, const VecX& q, int threads, const std::atomic<bool>& cancelled);

  /// Whether this is also the answer for that scene: same surfaces at the same places.
  bool holdsFor(const SceneGeometry& scene, const VecX& q) const;

  /// How much each object hides, one for each pair [receiver × objects + occluder], 0 … 1: → share of open sky by vertex
  /// of the SceneGeometry, 1 where nothing hides anything, and for all that is no visual surface of a part. A little
  /// smoothed over each surface.
  std::vector<float> openness(const SceneGeometry& scene, std::span<const float> presence) const;

  /// How much objects still hide of each other in state q: an occluder that has moved relative to the receiver since
  /// the rays were cast fades, from 4 to 16 mm, in steps of an eighth. Times `opacity` of the occluder, by object.
  std::vector<float> presence(const SceneGeometry& scene, const VecX& q, std::span<const float> opacity) const;

 private:
  struct Hit {
    std::uint8_t ray;
    std::uint8_t strength;  ///< 255: at the origin, 0: at the end of the reach
    std::uint16_t object;
  };
  /// What one vertex' rays met, in order of rays.
  struct Receiver {
    int vertex = 0, object = 0;
    Range hits;
  };
  /// A few vertices at the corners of an object, by which its motion is seen.
  using Corners = std::vector<int>;

  Vec3 motionOf(const SceneGeometry& scene, int object, const VecX& q) const;
  void castAll(const SceneGeometry& scene, int threads, const std::atomic<bool>& cancelled);

  std::vector<Eigen::Vector3f> m_at;     ///< by vertex of the SceneGeometry, start state; zero for other vertices
  std::vector<std::uint32_t> m_indices;  ///< of all visual surfaces of parts, one after the other
  std::vector<Corners> m_corners;        ///< by object
  std::vector<Receiver> m_receivers;
  std::vector<Hit> m_hits;
};

}  // namespace glenoid
