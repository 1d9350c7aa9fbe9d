// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/RigidAdvice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simcore/author/BuildJoint.h"
#include "simcore/author/MakeCollision.h"
#include "simcore/author/Overlaps.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/spatial/Intersect.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

Joint pairOf(const Part& a, const Part& b) {
  Joint joint;
  joint.parts = {a, b};
  for (Part& part : joint.parts) part.kind = PartKind::Rigid;
  return joint;
}

bool apart(const Joint& pair, SurfaceKind kind) {
  std::vector<TriMesh> surfaces;
  for (const Part& part : pair.parts) surfaces.push_back(kind == SurfaceKind::Visual ? *part.visual : *part.collision);
  return findOverlaps(pair, surfaces).empty();
}

bool sound(const Joint& pair) {
  return std::all_of(pair.parts.begin(), pair.parts.end(), [](const Part& part) { return countSelfIntersections(*part.collision) == 0; });
}

/// Least distance from a vertex of either surface to the other, m.
double roomBetween(const TriMesh& a, const TriMesh& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : {std::pair{&a, &b}, {&b, &a}}) {
    const TriangleTree tree(*to);
    for (const Vec3& vertex : from->vertices) least = std::min(least, tree.closest(vertex, least).distance);
  }
  return least;
}

/// Two figures that count, downwards: what somebody would type.
double rounded(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return std::floor(value / unit * (1 + 1e-12)) * unit;
}

/// False where it cannot be.
bool simplifyTo(Part& part, int triangles) {
  auto mesh = makeCollision(*part.visual, triangles);
  if (mesh) part.collision = std::make_shared<const TriMesh>(std::move(*mesh));
  return mesh.ok();
}

int trianglesThatDo(const Part& a, const Part& b, const std::function<bool()>& goOn) {
  const auto hundreds = [](std::size_t count) { return static_cast<int>((count + 99) / 100 * 100); };
  const int now = hundreds(std::max(a.collision->triangles.size(), b.collision->triangles.size()));
  const int most = hundreds(std::max(a.visual->triangles.size(), b.visual->triangles.size()));
  for (int factor = 2; factor <= 16; factor *= 2) {
    if (goOn && !goOn()) return 0;
    const int wanted = std::min(factor * now, most);
    Joint pair = pairOf(a, b);
    if (!simplifyTo(pair.parts[0], wanted) || !simplifyTo(pair.parts[1], wanted)) return 0;
    if (sound(pair) && apart(pair, SurfaceKind::Collision)) return wanted;
    if (wanted == most) return 0;
  }
  return 0;
}

double clearanceThatDoes(const Part& a, const Part& b) {
  constexpr double kMost = 2e-3;  // m: a dent deeper than that is another shape
  const double room = roomBetween(*a.visual, *b.visual);
  if (!(room > 1e-6)) return 0;
  const double clearance = rounded(std::min(0.5 * room, kMost));
  Joint pair = pairOf(a, b);
  const auto separated = separateCollision(pair, clearance);
  return separated && separated->left.empty() && sound(pair) && apart(pair, SurfaceKind::Collision) ? clearance : 0;
}

}  // namespace

RigidAdvice adviseRigid(const Part& a, const Part& b, const std::function<bool()>& goOn) {
  RigidAdvice advice;
  advice.surfacesOverlap = !apart(pairOf(a, b), SurfaceKind::Visual);
  if (advice.surfacesOverlap) return advice;
  if (!goOn || goOn()) advice.clearance = clearanceThatDoes(a, b);
  advice.triangles = trianglesThatDo(a, b, goOn);
  return advice;
}

}  // namespace glenoid
