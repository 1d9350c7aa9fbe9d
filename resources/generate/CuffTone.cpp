// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/CuffTone.h"

#include <cmath>

#include "simcore/spatial/TriangleTree.h"

namespace glenoid::generate {
namespace {

/// Where the two presses of a bend act: shares of the angle of the way round the head. Up to its footprint's end a muscle is
/// bonded to the bone and cannot press on it.
constexpr double kPresses[] = {1.0, 1.3};

Vec3 rounded(const Vec3& value, double unit) {
  return (value / unit).array().round().matrix() * unit;
}

struct Patch {
  Vec3 middle = Vec3::Zero(), normal = Vec3::Zero();
};

/// Middle and mean unit normal of a region on the visual surface of a part at rest.
Patch patchOf(const Joint& joint, const char* id, const char* regionId) {
  const Part& part = joint.parts[findPart(joint, id)];
  const TriMesh& mesh = *part.visual;
  Patch patch;
  double area = 0;
  for (const int t : trianglesOf(*findRegion(part, regionId))) {
    const auto& c = mesh.triangles[t];
    const Vec3 &a = mesh.vertices[c[0]], across = (mesh.vertices[c[1]] - a).cross(mesh.vertices[c[2]] - a);
    patch.middle += across.norm() * (a + mesh.vertices[c[1]] + mesh.vertices[c[2]]) / 3;
    patch.normal += across;
    area += across.norm();
  }
  patch.middle /= area;
  patch.normal.normalize();
  return patch;
}

/// The middle of a muscle's tissue on a ray from the head's centre.
Vec3 middleOn(const TriangleTree& muscle, const Vec3& outward) {
  constexpr double kBeyond = 1e-6;  // m
  const auto inner = muscle.cast(Vec3::Zero(), outward);
  if (!inner) return muscle.closest(outward * 0.03).point;
  const auto outer = muscle.cast((inner->distance + kBeyond) * outward, outward);
  return (inner->distance + (outer ? 0.5 * (outer->distance + kBeyond) : 0)) * outward;
}

void pull(const Joint& joint, const char* muscle, double force, std::vector<Load>& loads) {
  const Vec3 insertion = patchOf(joint, muscle, "insertion").middle, origin = patchOf(joint, muscle, "origin").middle;
  const double radius = insertion.norm();
  const Vec3 up = insertion / radius, on = (origin - origin.dot(up) * up).normalized();
  const double bend = std::atan2(origin.dot(on), origin.dot(up)) - std::acos(radius / origin.norm());
  const auto outward = [&](double angle) { return Vec3(std::cos(angle) * up + std::sin(angle) * on); };
  const auto tangent = [&](double angle) { return Vec3(std::cos(angle) * on - std::sin(angle) * up); };
  const TriangleTree tissue(*joint.parts[findPart(joint, muscle)].visual);
  loads.push_back({"humerus", rounded(force * tangent(0), 1e-3), Vec3::Zero(), rounded(insertion, 1e-4)});
  for (int k = 0; k < 2; ++k) {
    const Vec3 press = force * (tangent(bend * (k + 1) / 2) - tangent(bend * k / 2));
    loads.push_back({muscle, rounded(press, 1e-3), Vec3::Zero(), rounded(middleOn(tissue, outward(kPresses[k] * bend)), 1e-4)});
  }
}

}  // namespace

std::vector<Load> cuffTone(const Joint& joint, const Tone& tone) {
  std::vector<Load> loads;
  pull(joint, "supraspinatus", tone.supraspinatus, loads);
  pull(joint, "infraspinatus", tone.infraspinatus, loads);
  pull(joint, "subscapularis", tone.subscapularis, loads);
  const Vec3 groove = patchOf(joint, "humerus", "bicipital-groove").normal, tendon = patchOf(joint, "biceps-tendon", "in-groove").middle;
  loads.push_back({"biceps-tendon", rounded(-tone.biceps * groove, 1e-3), Vec3::Zero(), rounded(tendon, 1e-4)});
  return loads;
}

}  // namespace glenoid::generate
