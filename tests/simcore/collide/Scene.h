// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <vector>

#include "simcore/collide/ProximityFinder.h"
#include "tests/simcore/spatial/Shapes.h"

namespace glenoid {

/// Meshes where they are now, with what the search wants to have.
struct CollisionScene {
  std::vector<TriMesh> meshes;
  std::vector<std::vector<Vec3>> velocities;  ///< may be empty
  std::vector<CollisionPair> pairs{{0, 1, {}, {}}};
  std::vector<bool> deforms;                  ///< by mesh; may be shorter: the rest are rigid

  std::vector<std::shared_ptr<const CollisionSurface>> surfaces() const {
    std::vector<std::shared_ptr<const CollisionSurface>> result;
    for (std::size_t i = 0; i < meshes.size(); ++i)
      result.push_back(makeCollisionSurface(meshes[i], i < deforms.size() && deforms[i]));
    return result;
  }
  std::vector<std::span<const Vec3>> positionSpans() const {
    std::vector<std::span<const Vec3>> result;
    for (const TriMesh& mesh : meshes) result.emplace_back(mesh.vertices);
    return result;
  }
  std::vector<std::span<const Vec3>> velocitySpans() const {
    std::vector<std::span<const Vec3>> result;
    for (const auto& list : velocities) result.emplace_back(list);
    return result;
  }
  std::vector<Proximity> find(double contactDistance, double dt = 0.005,
                              const ProximityLimits& limits = {}) const {
    ProximityFinder finder(surfaces(), pairs, limits);
    return finder.find(positionSpans(), velocitySpans(), contactDistance, dt);
  }
  Vec3 at(int surface, const FeaturePoint& point) const {
    Vec3 x = Vec3::Zero();
    for (int k = 0; k < point.count; ++k) x += point.weight[k] * meshes[surface].vertices[point.vertex[k]];
    return x;
  }
};

inline CollisionScene twoMeshes(TriMesh a, TriMesh b) {
  CollisionScene scene;
  scene.meshes = {std::move(a), std::move(b)};
  return scene;
}

}  // namespace glenoid
