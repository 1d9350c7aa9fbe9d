// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/tool/FingerShape.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

namespace glenoid {
namespace {

// Everything below in millimetres of a finger of 8 mm radius.
constexpr double kRadius = 8, kTip = 0.75 * kRadius;
constexpr double kNailAt = 7.6, kNailHalfLength = 5.6, kNailHalfWidth = 5.2;
constexpr double kJoints[] = {24, 46};
constexpr int kAround = 48;

double scaleOf(const Tool& tool) { return tool.radius / (1e-3 * kRadius); }

/// The capsule's radius at height z: a ball at its tip, from 1.3 radii of that on a cone.
double capsule(double z, double length) {
  if (z < kTip) return std::sqrt(std::max(0.0, kTip * kTip - (kTip - z) * (kTip - z)));
  const double joined = 1.3 * kTip, cone = kTip + (kRadius - kTip) * std::min(1.0, std::max(z, joined) / (0.4 * length));
  return z < joined ? kTip + (cone - kTip) * (z - kTip) / (joined - kTip) : cone;
}

double bell(double x, double width) { return std::exp(-(x / width) * (x / width)); }

/// Inside the nail's border; `arc` from the middle of the back, along the skin.
double nail(double arc, double z) {
  const double a = std::abs(arc) / kNailHalfWidth, b = std::abs(z - kNailAt) / kNailHalfLength;
  return 0.5 * (kNailHalfLength + kNailHalfWidth) * (1 - std::cbrt(a * a * a + b * b * b));
}

/// What stands out of the capsule (or lies under it) at an angle from the back.
double relief(double z, double angle, double radius, bool withNail) {
  const double back = std::max(0.0, std::cos(angle)), palm = std::max(0.0, -std::cos(angle));
  const double inside = withNail ? nail(radius * angle, z) : -1e3;
  double out = 0.30 * palm * bell(z - 8, 5);                            // the pad
  const double freeEdge = std::clamp((4.0 - z) / 2, 0.0, 1.0);
  if (inside > -1.5) out -= (0.42 - 0.40 * freeEdge) * bell(inside, 0.45);  // the fold, open where the nail ends
  if (inside > 0) out += 0.30 * freeEdge * std::min(1.0, inside / 0.4) - 0.10 * std::min(1.0, inside);
  for (const double joint : kJoints) {
    out += 0.35 * bell(z - joint, 4.5);
    for (const int line : {-1, 0, 1}) out -= 0.28 * back * bell(z - joint - 1.7 * line, 0.5);
    out -= 0.6 * palm * bell(z - joint + 0.8, 0.65);
  }
  return out;
}

/// Towards the palm, beyond the last joint.
double bend(double z) {
  const double beyond = std::max(0.0, z - 20) / 60;
  return 4.5 * beyond * beyond;
}

std::vector<double> heights(double length) {
  std::vector<double> list;
  for (int k = 1; k <= 11; ++k) list.push_back(kTip * (1 - std::cos(k * std::numbers::pi / 22)));
  while (list.back() < length - 1e-6) {
    const double z = list.back();
    const bool fine = z < 14 || std::any_of(std::begin(kJoints), std::end(kJoints), [&](double j) { return std::abs(z + 1 - j) < 4.5; });
    list.push_back(std::min(length, z + (fine ? 0.6 : 2.2)));
  }
  return list;
}

}  // namespace

TriMesh makeFingerLook(const Tool& tool) {
  const double scale = 1e-3 * scaleOf(tool), length = tool.length / scale;
  TriMesh mesh;
  const auto add = [&](double radius, double angle, double z, double along) {
    mesh.vertices.push_back(scale * Vec3(radius * std::sin(angle), radius * std::cos(angle) - bend(along), z));
  };
  add(0, 0, 0, 0);
  const std::vector<double> rings = heights(length);
  const auto narrowed = [&](double z) {
    const double t = tool.link.empty() ? 0 : std::clamp((z - 6) / 10, 0.0, 1.0);
    return 1 - 0.32 * t * t * (3 - 2 * t);
  };
  const auto ring = [&](double z, double along, double shrink) {
    for (int k = 0; k < kAround; ++k) {
      const double angle = 2 * std::numbers::pi * k / kAround, signedAngle = k <= kAround / 2 ? angle : angle - 2 * std::numbers::pi;
      const double radius = capsule(along, length);
      add(shrink * (radius + relief(along, signedAngle, radius, tool.link.empty())), signedAngle, z, along);
    }
  };
  for (const double z : rings) ring(z, z, narrowed(z));
  constexpr int kCap = 4;  // towards the hand a flat dome
  for (int k = 1; k < kCap; ++k) {
    const double turn = k * std::numbers::pi / (2 * kCap);
    ring(length + 0.4 * kRadius * std::sin(turn), length, narrowed(length) * std::cos(turn));
  }
  add(0, 0, length + 0.4 * kRadius, length);
  const int count = static_cast<int>(rings.size()) + kCap - 1, last = static_cast<int>(mesh.vertices.size()) - 1;
  const auto at = [&](int r, int k) { return 1 + r * kAround + k % kAround; };
  for (int k = 0; k < kAround; ++k) {
    mesh.triangles.push_back({0, at(0, k), at(0, k + 1)});
    for (int r = 0; r + 1 < count; ++r) {
      mesh.triangles.push_back({at(r, k), at(r + 1, k + 1), at(r, k + 1)});
      mesh.triangles.push_back({at(r, k), at(r + 1, k), at(r + 1, k + 1)});
    }
    mesh.triangles.push_back({last, at(count - 1, k + 1), at(count - 1, k)});
  }
  if (enclosedVolume(mesh) < 0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

double insideNail(const Tool& tool, const Vec3& p_T) {
  if (!tool.link.empty()) return -tool.radius;
  const double scale = 1e-3 * scaleOf(tool);
  const Vec3 p = p_T / scale;
  return scale * nail(capsule(p.z(), tool.length / scale) * std::atan2(p.x(), p.y() + bend(p.z())), p.z());
}

}  // namespace glenoid
