// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/shape/Tube.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glenoid::shape {

namespace {

template <class T>
T catmullRom(const T& p0, const T& p1, const T& p2, const T& p3, double t) {
  return T(0.5 * (2 * p1 + t * (p2 - p0) + t * t * (2 * p0 - 5 * p1 + 4 * p2 - p3) +
                  t * t * t * (3 * p1 - p0 - 3 * p2 + p3)));
}

/// Sizes must not overshoot between two stations, so they go by a smooth step.
double eased(double a, double b, double t) {
  return a + (b - a) * t * t * (3 - 2 * t);
}

Station between(const Station& s0, const Station& s1, const Station& s2, const Station& s3, double t) {
  Station s;
  s.base = catmullRom(s0.base, s1.base, s2.base, s3.base, t);
  s.up = ((1 - t) * s1.up.normalized() + t * s2.up.normalized()).normalized();
  s.halfWidth = eased(s1.halfWidth, s2.halfWidth, t);
  s.thickness = eased(s1.thickness, s2.thickness, t);
  s.clearance = eased(s1.clearance, s2.clearance, t);
  s.reach = eased(s1.reach, s2.reach, t);
  s.radial = eased(s1.radial, s2.radial, t);
  s.seat = eased(s1.seat, s2.seat, t);
  return s;
}

/// |x|^e with the sign of x.
double power(double x, double e) {
  return std::copysign(std::pow(std::abs(x), e), x);
}

/// Triangles of a quad strip between ring a and ring b (vertex indices a + k, b + k), wound outwards when the
/// rings turn counter-clockwise seen from b's side.
void joinRings(TriMesh& mesh, int a, int b, int around) {
  for (int k = 0; k < around; ++k) {
    const int l = (k + 1) % around;
    // Alternating diagonals keep the surface free of a twist to one side.
    if ((k + a / around) % 2 == 0) {
      mesh.triangles.push_back({a + k, a + l, b + l});
      mesh.triangles.push_back({a + k, b + l, b + k});
    } else {
      mesh.triangles.push_back({a + k, a + l, b + k});
      mesh.triangles.push_back({a + l, b + l, b + k});
    }
  }
}

void windOutwards(TriMesh& mesh) {
  if (enclosedVolume(mesh) >= 0) return;
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
}

}  // namespace

Station stationAt(const std::vector<Station>& st, double s) {
  const int n = int(st.size());
  // Parameter by chord length, so that rings are spread evenly however the stations lie.
  std::vector<double> at(n, 0.0);
  for (int i = 1; i < n; ++i) at[i] = at[i - 1] + (st[i].base - st[i - 1].base).norm();
  const double x = std::clamp(s, 0.0, 1.0) * at[n - 1];
  int i = 0;
  while (i + 2 < n && at[i + 1] < x) ++i;
  const double t = (x - at[i]) / (at[i + 1] - at[i]);
  return between(st[std::max(i - 1, 0)], st[i], st[i + 1], st[std::min(i + 2, n - 1)], t);
}

TriMesh sweep(const Tube& tube, int around, int along) {
  TriMesh mesh;
  const auto ringPoint = [&](double s, double x, double y, double scale) {
    const Station st = stationAt(tube.stations, s);
    const Vec3 tangent =
        (stationAt(tube.stations, s + 0.01).base - stationAt(tube.stations, s - 0.01).base).normalized();
    const Vec3 width = tangent.cross(st.up).normalized();
    const Vec3 up = width.cross(tangent).normalized();
    Vec3 near = st.base + st.halfWidth * scale * x * width;
    const Vec3 out = ((1 - st.radial) * up + st.radial * near.normalized()).normalized();
    if (tube.bone) {
      // Who would fall almost as far as he may falls less, or neighbours of whom one finds bone and one does not would tear.
      const Vec3 settled = settle(tube.bone, near, out, st.clearance, st.reach);
      const double fall = (near - settled).dot(out) / std::max(st.reach, 1e-9);
      const double kept = std::clamp((1 - fall) / 0.25, 0.0, 1.0);
      near += kept * kept * (3 - 2 * kept) * (settled - near);
    }
    // Both sides meet on the rim, at mid thickness or, with a seat, nearer the bone, and are fully apart in the middle.
    const double rim = 0.5 * (1 - st.seat);
    const double height = st.thickness * (rim + (y < 0 ? rim : 1 - rim) * scale * y);
    Vec3 p = near + height * out;
    if (tube.roof && tube.roof(p) < tube.roofClearance) {
      double fall = 0;  // never so far that the far side meets the near side
      while (fall > -0.7 * height && tube.roof(p + fall * out) < tube.roofClearance) fall -= 0.2;
      p += fall * out;
    }
    return p;
  };
  const double first = 0.4 / along;
  for (int j = 0; j < along; ++j) {
    const double s = tube.places.empty() ? first + (1 - 2 * first) * j / (along - 1.0) : tube.places[j];
    const double toEnd = std::min(s, 1 - s) / std::max(tube.endLength, 1e-9);
    const double scale = toEnd >= 1 ? 1.0 : std::sqrt(1 - (1 - toEnd) * (1 - toEnd));
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * std::numbers::pi * (k + tube.phase) / around;
      mesh.vertices.push_back(ringPoint(s, power(std::cos(angle), tube.roundness),
                                        power(std::sin(angle), tube.roundness), scale));
    }
  }
  for (int j = 0; j + 1 < along; ++j) joinRings(mesh, j * around, (j + 1) * around, around);
  const int last = (along - 1) * around, head = last + around, tail = head + 1;
  if (tube.flatEnds) {
    for (int k = 1; k + 1 < around; ++k) {
      mesh.triangles.push_back({0, k + 1, k});
      mesh.triangles.push_back({last, last + k, last + k + 1});
    }
    windOutwards(mesh);
    return mesh;
  }
  mesh.vertices.push_back(ringPoint(0, 0, 0, 0));
  mesh.vertices.push_back(ringPoint(1, 0, 0, 0));
  for (int k = 0; k < around; ++k) {
    const int l = (k + 1) % around;
    mesh.triangles.push_back({l, k, head});
    mesh.triangles.push_back({last + k, last + l, tail});
  }
  windOutwards(mesh);
  return mesh;
}

TriMesh torus(const std::vector<std::vector<Vec3>>& rings) {
  TriMesh mesh;
  const int along = int(rings.size()), around = int(rings[0].size());
  for (const auto& ring : rings) mesh.vertices.insert(mesh.vertices.end(), ring.begin(), ring.end());
  for (int j = 0; j < along; ++j) joinRings(mesh, j * around, (j + 1) % along * around, around);
  windOutwards(mesh);
  return mesh;
}

void keepClear(TriMesh& mesh, const Field& obstacle, double clearance) {
  constexpr int kSamples = 8;  // along an edge
  for (int round = 0; round < 60; ++round) {
    std::vector<Vec3> push(mesh.vertices.size(), Vec3::Zero());
    bool clear = true;
    for (const auto& t : mesh.triangles) {
      const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
      double worst = 0;
      Vec3 weight = Vec3::Zero(), direction = Vec3::Zero();
      for (int i = 0; i <= kSamples; ++i)
        for (int j = 0; i + j <= kSamples; ++j) {
          const Vec3 w(double(i) / kSamples, double(j) / kSamples, double(kSamples - i - j) / kSamples);
          const Vec3 p = w[0] * a + w[1] * b + w[2] * c;
          const double lack = clearance - obstacle(p);
          if (lack <= worst) continue;
          worst = lack;
          weight = w;
          direction = gradient(obstacle, p).normalized();
        }
      if (worst < 1e-3) continue;
      clear = false;
      for (int k = 0; k < 3; ++k) {
        const Vec3 move = (worst + 0.01) * weight[k] / weight.squaredNorm() * direction;
        if (move.squaredNorm() > push[t[k]].squaredNorm()) push[t[k]] = move;
      }
    }
    if (clear) return;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) mesh.vertices[i] += push[i];
  }
}

}  // namespace glenoid::shape
