// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/tool/ToolShape.h"

#include <cmath>
#include <numbers>

#include "simcore/base/PlainMath.h"

namespace glenoid {

namespace {

/// A ring of the sweep: centre and direction of the path there (both in the XZ plane) and radius.
struct Ring {
  Vec3 centre, direction;
  double radius;
};

/// Tube through the rings with a vertex at each end; wound outwards.
TriMesh sweep(const std::vector<Ring>& rings, const Vec3& first, const Vec3& last, int segments) {
  TriMesh mesh;
  mesh.vertices.push_back(first);
  for (const Ring& ring : rings) {
    const Vec3 side = Vec3::UnitY(), up = ring.direction.cross(side);
    for (int s = 0; s < segments; ++s) {
      const double angle = 2 * std::numbers::pi * s / segments;
      mesh.vertices.push_back(ring.centre + ring.radius * (plain::cosine(angle) * up + plain::sine(angle) * side));
    }
  }
  mesh.vertices.push_back(last);
  const int end = static_cast<int>(mesh.vertices.size()) - 1;
  const auto at = [&](int ring, int s) { return 1 + ring * segments + s % segments; };
  const int ringCount = static_cast<int>(rings.size());
  for (int s = 0; s < segments; ++s) {
    mesh.triangles.push_back({0, at(0, s + 1), at(0, s)});
    for (int r = 0; r + 1 < ringCount; ++r) {
      mesh.triangles.push_back({at(r, s), at(r, s + 1), at(r + 1, s + 1)});
      mesh.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r + 1, s)});
    }
    mesh.triangles.push_back({end, at(ringCount - 1, s), at(ringCount - 1, s + 1)});
  }
  if (enclosedVolume(mesh) < 0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// Straight shaft along +Z from a rounded end at the origin, radius growing from `tip` to `full` over `taper`.
TriMesh straight(double length, double tip, double full, double taper, int segments) {
  std::vector<Ring> rings;
  const Vec3 z = Vec3::UnitZ();
  for (const double polar : {0.5, 1.0, 1.5})  // rad from the pole: the rounded end
    rings.push_back({tip * (1 - plain::cosine(polar)) * z, z, tip * plain::sine(polar)});
  for (const double fraction : {0.04, 0.08, 0.14, 0.22, 0.35, 0.6, 1.0}) {
    const double at = std::max(tip * 1.3, fraction * length);
    rings.push_back({at * z, z, tip + (full - tip) * std::min(1.0, at / taper)});
  }
  return sweep(rings, Vec3::Zero(), (length + 0.5 * full) * z, segments);
}

TriMesh hooked(double length, double radius, int segments) {
  // Hook along +X, quarter bend of centre-line radius `bend`, shaft along +Z; the elbow's outside touches z = 0.
  const double bend = 2 * radius, reach = 0.004;
  std::vector<Ring> rings;
  const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ();
  rings.push_back({Vec3(bend + reach, 0, radius), -x, 0.5 * radius});
  rings.push_back({Vec3(bend + reach - 0.4 * radius, 0, radius), -x, 0.8 * radius});
  rings.push_back({Vec3(bend, 0, radius), -x, radius});
  for (const double turn : {0.25, 0.5, 0.75, 1.0}) {
    const double angle = turn * std::numbers::pi / 2;
    rings.push_back({Vec3(bend * (1 - plain::sine(angle)), 0, radius + bend * (1 - plain::cosine(angle))),
                     Vec3(-plain::cosine(angle), 0, plain::sine(angle)), radius});
  }
  for (const double fraction : {0.05, 0.09, 0.14, 0.22, 0.35, 0.6, 1.0})
    rings.push_back({(radius + bend + fraction * (length - radius - bend)) * z, z, radius});
  return sweep(rings, Vec3(bend + reach + 0.3 * radius, 0, radius), (length + 0.5 * radius) * z, segments);
}

/// Sphere that touches the origin from above, then a thin shaft; corners lie on the sphere.
TriMesh ball(double length, double radius, int segments) {
  const double shaft = 0.25 * radius;
  std::vector<Ring> rings;
  const Vec3 z = Vec3::UnitZ();
  for (int k = 1; k < segments / 2; ++k) {
    const double polar = 2 * std::numbers::pi * k / segments, ring = radius * plain::sine(polar);
    if (polar > std::numbers::pi / 2 && ring < 1.5 * shaft) break;  // the shaft begins here
    rings.push_back({radius * (1 - plain::cosine(polar)) * z, z, ring});
  }
  const double neck = radius * (1 + std::sqrt(1 - 0.25 * 0.25));
  for (const double at : {neck, std::max(length, 1.1 * neck)}) rings.push_back({at * z, z, shaft});
  return sweep(rings, Vec3::Zero(), (rings.back().centre.z() + 0.5 * shaft) * z, segments);
}

/// Square bar along +Z from the middle of its end face.
TriMesh bar(double length, double half) {
  TriMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.vertices.push_back({corner & 1 ? half : -half, corner & 2 ? half : -half, corner & 4 ? length : 0});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

}  // namespace

TriMesh makeToolSurface(const Tool& tool, int segments) {
  switch (tool.kind) {
    case ToolKind::Probe: return hooked(tool.length, tool.radius, segments);
    case ToolKind::Arthroscope: return straight(tool.length, tool.radius, tool.radius, tool.radius, segments);
    case ToolKind::Finger: return straight(tool.length, 0.75 * tool.radius, tool.radius, 0.4 * tool.length, segments);
    case ToolKind::Ball: return ball(tool.length, tool.radius, 2 * segments);
    case ToolKind::Bar: return bar(tool.length, tool.radius);
  }
  return {};
}

}  // namespace glenoid
