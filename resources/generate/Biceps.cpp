// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "resources/generate/Bones.h"
#include "resources/generate/Parts.h"

/// Long tendon of the biceps, its root, and the ring that it grows from.
namespace glenoid::generate {

RimPoint rimAt(double turn) {
  const Frame socket = scapula::glenoid();
  const std::vector<Vec2> rim = scapula::glenoidRim();
  const auto point = [&](double x) {
    const double f = (x - std::floor(x)) * double(rim.size());
    const std::size_t i = std::size_t(f) % rim.size();
    return Vec2((1 - (f - std::floor(f))) * rim[i] + (f - std::floor(f)) * rim[(i + 1) % rim.size()]);
  };
  const Vec2 p = point(turn), along = point(turn + 0.01) - point(turn - 0.01);
  Vec2 out(along.y(), -along.x());
  if (out.dot(p) < 0) out = -out;
  out.normalize();
  return {socket.toWorld({p.x(), p.y(), scapula::socketHeight(p.x(), p.y())}),
          socket.axes * Vec3(out.x(), out.y(), 0)};
}

namespace {

constexpr double kOverHead =
    humerus::kHeadRadius + 1.9 + kBicepsHalfThickness;  ///< middle of the tendon over the head

Vec3 rootDirection() {
  return (rimAt(0).at + 1.5 * rimAt(0).out).normalized();
}
Vec3 entranceDirection() {
  return Vec3(19.0, 17.5, 11.2).normalized();
}

/// Along the great circle over the head.
Vec3 overHead(double angle) {
  const Vec3 a = rootDirection(), b = entranceDirection();
  const double whole = std::acos(a.dot(b));
  return (std::sin(whole - angle) * a + std::sin(angle) * b) / std::sin(whole);
}

/// The first `onHead` points of the path turn with the head's sphere, the others with the shaft.
struct Size {
  double halfWidth, thickness;
};
Tube cord(const std::vector<Vec3>& path, std::size_t onHead, const std::function<Size(std::size_t)>& sizeAt) {
  Tube tube;
  tube.roundness = 1;
  tube.endLength = 0.03;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vec3 fromCanal = path[i] - humerus::canalAt(path[i].y());
    const Vec3 up = (i < onHead ? path[i] : fromCanal).normalized();
    const Size size = sizeAt(i);
    tube.stations.push_back({path[i] - size.thickness / 2 * up, up, size.halfWidth, size.thickness, 0, 0, 0});
  }
  return tube;
}

}  // namespace

std::vector<Vec3> bicepsPath() {
  static const Field shaft = humerus::field();
  std::vector<Vec3> path;
  const double whole = std::acos(rootDirection().dot(entranceDirection()));
  for (int i = 0; i <= 8; ++i) {
    const double angle = 9.5 / kOverHead + (whole - 9.5 / kOverHead) * i / 8.0;
    path.push_back((kOverHead + 1.2 * std::pow(1 - i / 8.0, 2)) * overHead(angle));
  }
  const std::vector<Vec3> floor = humerus::groovePath();
  for (std::size_t i = 1; i < floor.size(); ++i) {
    const Vec3 c = humerus::canalAt(floor[i].y()), out = (floor[i] - c).normalized();
    path.push_back(i < 3 ? Vec3(floor[i] + 3.35 * out) : Vec3(settle(shaft, c, out, 0, 0) + 3.2 * out));
  }
  // Below the groove it lies on the shaft.
  for (const double y : {-38.0, -52.0}) {
    const Vec3 c = humerus::canalAt(y), out = (Vec3(12.6, y, 16.8) - c).normalized();
    path.push_back(settle(shaft, c, out, 0, 0) + 3.3 * out);
  }
  return path;
}

Surfaces bicepsTendon(const Bones& bones) {
  // Flat over the head, rounder and narrower in the groove.
  Tube tube = cord(bicepsPath(), 8, [](std::size_t i) {
    return i < 7 ? Size{kBicepsHalfWidth, 2 * kBicepsHalfThickness} : Size{kBicepsHalfWidth - 1.2, 4.3};
  });
  tube.phase = 0.5;
  // The tendon is rigid and its two surfaces are one: it keeps 0.8 mm from what it slides on, fine and
  // coarse.
  tube.bone = unionOf(bones.humerusShape, bones.humerusCoarse);
  for (Station& station : tube.stations) station.clearance = 0.8;
  Surfaces s;
  s.visual = sweep(tube, 6, 22);
  keepClear(s.visual, bones.humerusCoarse, 0.65);
  s.collision = s.visual;
  return s;
}

Surfaces labrumTendon(const Bones& bones, int around, int along) {
  const RimPoint top = rimAt(0);
  const Vec3 n = scapula::glenoid().axes.col(2);
  std::vector<Vec3> path{top.at + 1.0 * top.out - 1.0 * n};
  const double arcs[] = {3.5, 6.5, 9.5, 13.5}, above[] = {2.6, 1.6, 1.2, 1.0};
  for (int i = 0; i < 4; ++i) path.push_back((kOverHead + above[i]) * overHead(arcs[i] / kOverHead));
  // Broad where it leaves the ring, then the tendon's own section.
  const Size sizes[] = {{5.6, 3.4}, {4.4, 4.2}, {3.7, 4.6}, {3.4, 4.6}, {3.3, 4.5}};
  Tube tube = cord(path, path.size(), [&](std::size_t i) { return sizes[i]; });
  tube.bone = unionOf(bones.humerusShape, bones.humerusCoarse);
  for (Station& station : tube.stations) station.clearance = 0.8;
  tube.endLength = 0.1;
  Surfaces s;
  s.collision = sweep(tube, kAnchorAround, kAnchorAlong);
  s.visual = around == kAnchorAround && along == kAnchorAlong ? s.collision : sweep(tube, around, along);
  return s;
}

Surfaces labrum(const Bones& bones) {
  const Vec3 n = scapula::glenoid().axes.col(2);
  // A triangle over the rim: its base on bone, 4.5 wide, its free edge a good millimetre from the head.
  const auto ring = [&](int count, bool rounded, const Field& head, double room) {
    std::vector<std::vector<Vec3>> rings;
    for (int j = 0; j < count; ++j) {
      const RimPoint rim = rimAt(double(j) / count);
      const Vec3 inner = project(bones.scapulaShape, rim.at - 3.7 * rim.out, 0.1),
                 outer = project(bones.scapulaShape, rim.at + 0.8 * rim.out - (rounded ? 4.6 : 4.2) * n, 0.4);
      const Vec3 toEdge = (rim.at + 1.4 * rim.out).normalized();
      const Vec3 edge = settle(head, 30 * toEdge, toEdge, room, 10);
      if (rounded)
        rings.push_back({inner, 0.55 * inner + 0.45 * edge, edge - 0.5 * rim.out, edge + 0.7 * rim.out,
                         0.45 * outer + 0.55 * edge + 1.3 * rim.out, outer});
      else
        rings.push_back({inner, edge, outer});
    }
    return torus(rings);
  };
  return {ring(53, true, bones.humerusShape, 1.3), ring(20, false, bones.humerusCoarse, 1.0)};
}

}  // namespace glenoid::generate
