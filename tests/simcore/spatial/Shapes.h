// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

#include "simcore/mesh/TriMesh.h"

/// Closed test surfaces, wound outwards, and numbers that are the same on every machine.
namespace glenoid::shapes {

inline TriMesh box(const Vec3& low, const Vec3& high) {
  TriMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back(
        {i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z()});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// Octahedron split `level` times and blown up: 8·4^level triangles.
inline TriMesh sphere(const Vec3& centre, double radius, int level) {
  TriMesh mesh;
  mesh.vertices = {Vec3(1, 0, 0),  Vec3(-1, 0, 0), Vec3(0, 1, 0),
                   Vec3(0, -1, 0), Vec3(0, 0, 1),  Vec3(0, 0, -1)};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int l = 0; l < level; ++l) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [it, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.vertices.size()));
      if (fresh) mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
      return it->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  for (Vec3& x : mesh.vertices) x = centre + radius * x;
  return mesh;
}

/// Around the z axis.
inline TriMesh torus(double ring, double tube, int around, int across) {
  TriMesh mesh;
  constexpr double turn = 2 * std::numbers::pi;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = turn * i / around, v = turn * j / across, r = ring + tube * std::cos(v);
      mesh.vertices.push_back({r * std::cos(u), r * std::sin(u), tube * std::sin(v)});
      const int i1 = (i + 1) % around, j1 = (j + 1) % across;
      const int a = i * across + j, b = i1 * across + j, c = i1 * across + j1, d = i * across + j1;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

inline TriMesh moved(TriMesh mesh, const Pose& pose) {
  for (Vec3& x : mesh.vertices) x = pose * x;
  return mesh;
}

inline Pose poseOf(const Vec3& p, const Vec3& axis, double angle) {
  return {p, Quat(Eigen::AngleAxisd(angle, axis.normalized()))};
}

/// splitmix64 (Steele, Lea and Flood 2014): numbers in [low, high).
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : m_state(seed) {}
  double in(double low, double high) {
    std::uint64_t z = (m_state += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return low + (high - low) * (static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53);
  }
  Vec3 point(double half) { return {in(-half, half), in(-half, half), in(-half, half)}; }
  Pose pose(double half) { return poseOf(point(half), point(1) + Vec3(0.01, 0, 0), in(-3, 3)); }

 private:
  std::uint64_t m_state;
};

}  // namespace glenoid::shapes
