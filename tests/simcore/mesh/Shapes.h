// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cmath>
#include <functional>
#include <map>

#include "simcore/mesh/TriMesh.h"

/// Closed surfaces for tests, wound outwards, metres.
namespace glenoid::shapes {

/// Eight points, twelve triangles.
inline TriMesh box(const Vec3& low, const Vec3& high) {
  TriMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back(
        {i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z()});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// Both in one mesh, without a vertex in common.
inline TriMesh joined(const TriMesh& a, const TriMesh& b) {
  TriMesh out = a;
  const int base = static_cast<int>(a.vertices.size());
  out.vertices.insert(out.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles) out.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  return out;
}

/// Rows × columns of quads closed in both directions: torus about Y.
inline TriMesh torus(double major, double minor, int around, int across) {
  TriMesh mesh;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2 * M_PI * i / around, v = 2 * M_PI * j / across;
      const double r = major + minor * std::cos(v);
      mesh.vertices.push_back({r * std::cos(u), minor * std::sin(v), r * std::sin(u)});
    }
  const auto at = [&](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  return mesh;
}

/// Surface of revolution about Y between two poles: `profile(s)` gives (radius, height) for s in (0, 1).
inline TriMesh revolved(const std::function<Vec2(double)>& profile, double bottom, double top, int around,
                        int rings) {
  TriMesh mesh;
  mesh.vertices.push_back({0, bottom, 0});
  for (int i = 1; i <= rings; ++i)
    for (int j = 0; j < around; ++j) {
      const Vec2 p = profile(static_cast<double>(i) / (rings + 1));
      const double u = 2 * M_PI * j / around;
      mesh.vertices.push_back({p.x() * std::cos(u), p.y(), p.x() * std::sin(u)});
    }
  mesh.vertices.push_back({0, top, 0});
  const int last = static_cast<int>(mesh.vertices.size()) - 1;
  const auto at = [&](int i, int j) { return 1 + (i - 1) * around + j % around; };
  for (int j = 0; j < around; ++j) {
    mesh.triangles.push_back({0, at(1, j), at(1, j + 1)});
    mesh.triangles.push_back({last, at(rings, j + 1), at(rings, j)});
    for (int i = 1; i < rings; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

inline TriMesh sphere(double radius, int around = 48, int rings = 31) {
  return revolved([=](double s) { return Vec2(radius * std::sin(M_PI * s), -radius * std::cos(M_PI * s)); },
                  -radius, radius, around, rings);
}

/// Cylinder with half spheres, axis Y, centred.
inline TriMesh capsule(double radius, double length, int around = 24, int rings = 60) {
  const double whole = length + M_PI * radius;
  const auto profile = [=](double s) {
    const double d = s * whole, quarter = M_PI * radius / 2;
    if (d < quarter) return Vec2(radius * std::sin(d / radius), -length / 2 - radius * std::cos(d / radius));
    if (d > quarter + length) {
      const double e = (whole - d) / radius;
      return Vec2(radius * std::sin(e), length / 2 + radius * std::cos(e));
    }
    return Vec2(radius, -length / 2 + d - quarter);
  };
  return revolved(profile, -length / 2 - radius, length / 2 + radius, around, rings);
}

/// Bent sheet with rounded rims, like a ligament: a flattened capsule laid over an arc.
inline TriMesh sheet(double length, double width, double thickness, double bend, int around = 24,
                     int rings = 60) {
  TriMesh mesh = capsule(width / 2, length - width, around, rings);
  for (Vec3& v : mesh.vertices) {
    v.z() *= thickness / width;
    const double angle = bend * v.y() / length, r = length / bend + v.z();
    v = Vec3(v.x(), r * std::sin(angle), r * std::cos(angle) - length / bend);
  }
  return mesh;
}

inline TriMesh moved(TriMesh mesh, const Pose& pose) {
  for (Vec3& v : mesh.vertices) v = pose * v;
  return mesh;
}

}  // namespace glenoid::shapes
