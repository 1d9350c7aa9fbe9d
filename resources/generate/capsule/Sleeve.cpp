// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/capsule/Sleeve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "resources/generate/Bones.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid::generate {
namespace {

constexpr int kTurns = 96, kWays = 30;  ///< places of the grid; a turn's last is its first
constexpr double kMedial = 8;            ///< mm of the ring on the scapula from the rim
constexpr double kNeckAngle = 80;        ///< degrees from the head's axis: the border of the cartilage, 19 mm below the apex
constexpr double kBelow = 22;            ///< degrees farther down the neck, below
constexpr double kSag = 58;              ///< mm: four times the depth of the pouch at rest
constexpr double kRoom = 0.6;            ///< mm between the wall, or what lines it, and bone
constexpr double kBonded = 0.05;         ///< the same where it is bonded
constexpr double kOutside = 33.5;        ///< mm from the head's centre: outside of the biceps tendon
constexpr int kRounds = 100;  ///< few enough to leave it as wide as in a joint that is filled with fluid

double smooth(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

/// One below, where the pouch is, zero elsewhere.
double pouch(double turn) {
  return smooth((0.17 - std::abs(turn - std::floor(turn) - 0.5)) / 0.11);
}

/// Where the sleeve begins and ends, by turns.
struct Rings {
  std::array<Vec3, kTurns> scapula, humerus, intoHumerus, out;
};

/// The rim's point in a direction as seen from the middle of the socket.
Vec3 rimTowards(const Vec3& out) {
  constexpr int kSamples = 720;
  const Frame socket = scapula::glenoid();
  Vec3 best = Vec3::Zero();
  double most = -1e300;
  for (int i = 0; i < kSamples; ++i) {
    const Vec3 at = rimAt(double(i) / kSamples).at, from = at - socket.toWorld({1, 0, 0});
    const double along = (from - from.dot(socket.axes.col(2)) * socket.axes.col(2)).normalized().dot(out);
    if (along > most) most = along, best = at;
  }
  return best;
}

Rings ringsOf(const Bones& bones) {
  Rings rings;
  const Frame socket = scapula::glenoid();
  const Vec3 axis = humerus::headAxis(), lateral = socket.axes.col(2);
  const Quat turned = Quat::FromTwoVectors(lateral, -axis);
  const Field humerusFilled = humerus::filledField();
  for (int i = 0; i < kTurns; ++i) {
    const double turn = double(i) / kTurns, round = 2 * std::numbers::pi * turn;
    const double angle = (kNeckAngle + kBelow * pouch(turn)) * std::numbers::pi / 180;
    const Vec3 out = std::cos(round) * socket.axes.col(1) - std::sin(round) * socket.axes.col(0), aside = turned * out;
    rings.out[i] = out;
    rings.scapula[i] = project(bones.scapulaShape, rimTowards(out) + 3 * out - kMedial * lateral, kBonded);
    rings.humerus[i] = project(humerusFilled, (humerus::kHeadRadius + 1) * (std::cos(angle) * axis + std::sin(angle) * aside), kBonded);
    rings.intoHumerus[i] = -gradient(humerusFilled, rings.humerus[i]).normalized();
  }
  return rings;
}

/// Cubic from a to b that leaves along `from` and arrives along `to`.
Vec3 hermite(const Vec3& a, const Vec3& from, const Vec3& b, const Vec3& to, double s) {
  const double s2 = s * s, s3 = s2 * s;
  return (2 * s3 - 3 * s2 + 1) * a + (s3 - 2 * s2 + s) * from + (3 * s2 - 2 * s3) * b + (s3 - s2) * to;
}

std::vector<Vec3> drawn(const Rings& rings) {
  const Vec3 axis = humerus::headAxis(), lateral = scapula::glenoid().axes.col(2);
  std::vector<Vec3> points;
  for (int j = 0; j < kWays; ++j)
    for (int i = 0; i < kTurns; ++i) {
      const double turn = double(i) / kTurns, sag = pouch(turn);
      const Vec3 &a = rings.scapula[i], &b = rings.humerus[i], &out = rings.out[i];
      const Vec3 from = (1 - sag) * 30 * (0.5 * out + lateral) + sag * kSag * (0.9 * out + 0.25 * lateral).normalized();
      const Vec3 to = (1 - sag) * 30 * -axis + sag * kSag * (0.35 * rings.intoHumerus[i] - 0.9 * out).normalized();
      points.push_back(hermite(a, from, b, to, double(j) / (kWays - 1)));
    }
  return points;
}

/// Moves p out of what a surface encloses until it keeps the clearance.
void keepOff(const TriangleTree& obstacle, double clearance, Vec3& p) {
  constexpr double kDeepest = 40;  // mm
  for (int i = 0; i < 3; ++i) {
    const bool inside = obstacle.inside(p);
    const TriangleTree::Closest nearest = obstacle.closest(p, inside ? kDeepest : clearance);
    if (nearest.triangle < 0 || nearest.distance < 1e-9) return;
    const Vec3 out = (inside ? nearest.point - p : p - nearest.point) / nearest.distance;
    p = nearest.point + clearance * out;
    if (!inside) return;
  }
}

}  // namespace

Sleeve::Sleeve(const Bones& bones, const std::vector<TriMesh>& inside, double thickness, const Lining& lining) : m_points(drawn(ringsOf(bones))) {
  const TriangleTree scapula(bones.scapula.visual), humerus(bones.humerus.visual);
  std::vector<TriangleTree> contents(inside.begin(), inside.end());
  const auto index = [](int i, int j) { return j * kTurns + (i + kTurns) % kTurns; };
  const std::vector<Vec3> start = m_points;
  // It is drawn tight from without, so that it comes to lie on what it contains. Over the groove its border bridges the tendon.
  for (int j = 0; j < kWays; ++j)
    for (int i = 0; i < kTurns; ++i) {
      Vec3& p = m_points[index(i, j)];
      const double way = double(j) / (kWays - 1), blown = (1 - pouch(double(i) / kTurns)) * smooth(std::min(way / 0.3, (1 - way) / 0.15));
      const bool bridges = j > kWays / 2 && contents.back().closest(p, 5).triangle >= 0;
      if (const double radius = p.norm(), wanted = kOutside * (bridges ? 1 : blown); radius < wanted) p *= wanted / radius;
    }
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Vec3> next = m_points;
    for (int j = 0; j < kWays; ++j)
      for (int i = 0; i < kTurns; ++i) {
        const double turn = double(i) / kTurns, way = double(j) / (kWays - 1), sag = pouch(turn);
        Vec3& p = next[index(i, j)];
        if (j > 0 && j + 1 < kWays) {
          // Drawn tight, but for the pouch, which is only made even.
          const Vec3 along = 0.5 * (m_points[index(i, j - 1)] + m_points[index(i, j + 1)]),
                     around = 0.5 * (m_points[index(i - 1, j)] + m_points[index(i + 1, j)]);
          p += (1 - sag) * 0.5 * (along - p) + 0.3 * (around - p) + 0.02 * sag * (start[index(i, j)] - p);
        } else {
          const Vec3 around = 0.5 * (m_points[index(i - 1, j)] + m_points[index(i + 1, j)]);
          p += 0.2 * (around - p) + 0.05 * (start[index(i, j)] - p);
        }
        const double bondedAt = smooth((std::min(way, 1 - way) - 0.02) / 0.1);
        const double off = thickness / 2 + bondedAt * lining({turn, way});
        keepOff(scapula, thickness / 2 + kBonded + bondedAt * 0.3, p);
        for (const TriangleTree& each : contents) keepOff(each, off + kRoom, p);
        keepOff(humerus, off + kBonded + bondedAt * (kRoom - kBonded), p);
      }
    m_points = std::move(next);
  }
}

Vec3 Sleeve::at(const SleevePlace& place) const {
  const double x = (place.turn - std::floor(place.turn)) * kTurns, y = std::clamp(place.way, 0.0, 1.0) * (kWays - 1);
  const int i = int(x) % kTurns, j = std::min(int(y), kWays - 2), k = (i + 1) % kTurns;
  const double u = x - std::floor(x), v = y - j;
  return (1 - v) * ((1 - u) * m_points[j * kTurns + i] + u * m_points[j * kTurns + k]) +
         v * ((1 - u) * m_points[(j + 1) * kTurns + i] + u * m_points[(j + 1) * kTurns + k]);
}

Vec3 Sleeve::outward(const SleevePlace& place) const {
  constexpr double kTurn = 1.5 / kTurns, kWay = 1.5 / kWays;
  const Vec3 around = at({place.turn + kTurn, place.way}) - at({place.turn - kTurn, place.way}),
             along = at({place.turn, place.way + kWay}) - at({place.turn, place.way - kWay});
  return around.cross(along).normalized();
}

std::pair<double, double> Sleeve::turnsNear(const Bones& bones, const Vec3& onScapula, const Vec3& onHumerus) {
  static const Rings rings = ringsOf(bones);
  const auto nearest = [](const std::array<Vec3, kTurns>& ring, const Vec3& p) {
    const auto least = std::min_element(ring.begin(), ring.end(), [&](const Vec3& a, const Vec3& b) { return (a - p).norm() < (b - p).norm(); });
    return double(least - ring.begin()) / kTurns;
  };
  return {nearest(rings.scapula, onScapula), nearest(rings.humerus, onHumerus)};
}

}  // namespace glenoid::generate
