// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "resources/generate/Bones.h"

namespace glenoid::generate::scapula {

namespace {

const Vec3 kTrigonum(-77.8, -15.9, -113.5), kInferiorAngle(-78.4, -136.1, -78.3);
const Vec3 kAcromialAngle(-42.9, 23.3, 1.4), kAcromionTip(4.6, 38.0, -5.8);

/// How far the blade bends dorsally (+): the part above the spine dips forward to the coracoid's root, the
/// fossa below is hollow in front.
double bend(double x, double y) {
  const auto bump = [&](double cx, double cy, double wx, double wy) {
    return std::exp(-std::pow((x - cx) / wx, 2) - std::pow((y - cy) / wy, 2));
  };
  return -9 * bump(80, 20, 36, 22) + 4 * bump(45, -50, 40, 45);
}

Field bladeField() {
  Plate plate_;
  plate_.frame = blade();
  // From the root of the spine over the upper angle, down the upper border to the suprascapular notch beside
  // the coracoid, under the neck and down the outer border to the lower angle; the inner border is bowed.
  plate_.outline =
      closedCurve({{-1, 0},     {3.5, 12}, {12, 25},    {24, 34},   {37, 38.5}, {46, 35},  {57, 26},
                   {68, 17},    {77, 9.5}, {83, 6.5},   {89, 9},    {100, 10},  {108, -2}, {108, -30},
                   {100, -42},  {80, -64}, {56, -92},   {26, -120}, {9, -127},  {1, -121}, {-4, -105},
                   {-7.5, -82}, {-8, -56}, {-5.5, -30}, {-2.5, -14}},
                  5);
  plate_.thickness = 3.4;
  plate_.rounding = 1.6;
  plate_.height = bend;
  const auto knot = [](double x, double y, double r, double d = 0) { return Knot{onBlade(x, y, d), r}; };
  const Field lateral = chain({knot(9, -122, 2.8),
                               knot(34, -110, 3.3),
                               knot(58, -85, 3.6),
                               knot(82, -60, 4.0),
                               knot(100, -39, 4.8),
                               {glenoid().toWorld({0, -15, -7}), 6.5}});
  const Field medial =
      chain({knot(8, -122, 2.8), knot(-3, -97, 1.7), knot(-6, -60, 1.6), knot(-2.5, -22, 1.6),
             knot(1.4, 0, 1.5), knot(8, 17, 1.7), knot(23, 31.5, 1.8), knot(37, 36.2, 1.9)});
  return smoothUnion({smoothUnion({plate(plate_), lateral}, 5), medial}, 2.5);
}

/// The spine: a wall from the blade to its crest, which broadens outward into the acromion. Its free outer
/// border is hollow and comes near the neck of the socket, from which the spinoglenoid notch separates it.
Field spineField() {
  Plate wall;
  wall.frame = blade();
  // In this plate x runs along the spine, y dorsally, z is the height in the blade's plane.
  wall.frame.axes << blade().axes.col(0), blade().axes.col(2), -blade().axes.col(1);
  wall.outline = closedCurve({{5, -1},
                              {12, 2.5},
                              {32, 9.5},
                              {60, 24},
                              {88, 38},
                              {106, 41.5},
                              {112, 40},
                              {111, 33},
                              {105, 26},
                              {99, 21},
                              {96.5, 16},
                              {97.5, 10},
                              {97, 3},
                              {94, -5},
                              {70, -4},
                              {40, -1.5},
                              {15, -1.2}},
                             5);
  wall.thickness = 4.2;
  wall.rounding = 2;
  wall.height = [](double x, double y) { return -(0.06 * x * y / 40 + 0.03 * x); };
  const auto crest = [](double x, double y, double z) { return blade().toWorld({x, y, z}); };
  // The crest's two edges start together in a smooth triangle at the inner border and part on their way out.
  const Field upper = chain({{crest(5, 0.6, 0.6), 1.8},
                             {crest(16, 1.4, 5.2), 2.3},
                             {crest(36, 3.6, 11.6), 2.5},
                             {crest(62, 7.6, 25), 2.7},
                             {crest(82, 11, 33.5), 2.9},
                             {crest(94, 13.5, 34.5), 3.2}});
  const Field lower = chain({{crest(5, -0.6, 1.4), 1.8},
                             {crest(10, -1, 4.5), 2.4},
                             {crest(22, -2.8, 8.4), 2.6},
                             {crest(37, -2.8, 13.8), 2.8},
                             {crest(62, 2.2, 27.5), 3.0},
                             {crest(88, 5.0, 39), 3.3},
                             {crest(103, 4.6, 41), 3.4},
                             {crest(113, 4.4, 40.8), 3.4}});
  return smoothUnion({plate(wall), smoothUnion({upper, lower}, 4)}, 4);
}

/// Acromion and the broad end of the spine's crest that runs into it, as one bent plate.
Field roofField() {
  Plate roof;
  roof.frame = acromion();
  roof.outline = closedCurve({{-28.5, -4.5},
                              {-25, -7.8},
                              {-14, -10.8},
                              {0, -11.8},
                              {13, -10.2},
                              {20.5, -6.6},
                              {24.8, -1},
                              {23.5, 5},
                              {17, 9.6},
                              {6, 11.8},
                              {-5, 13},
                              {-12, 15.5},
                              {-18, 19},
                              {-23, 25},
                              {-28, 31},
                              {-32, 31},
                              {-33.5, 24},
                              {-32.6, 12},
                              {-30.4, 1}},
                             5);
  roof.thickness = 8.4;
  roof.rounding = 3;
  roof.height = [](double x, double y) {
    const double inward = std::max(y - 12, 0.0);
    return 3.2 * (1 - x * x / 676) - (inward > 0 ? 1.73 + 0.25 * inward : 0.012 * y * y);
  };
  roof.taper = [](double, double y) { return 1 - 0.3 * std::clamp((y - 12) / 24, 0.0, 1.0); };
  return plate(roof);
}

}  // namespace

double socketHeight(double x, double y) {
  return kSocketRadius - std::sqrt(std::max(kSocketRadius * kSocketRadius - x * x - y * y, 0.0));
}

Frame blade() {
  const Vec3 up = (kTrigonum - kInferiorAngle).normalized();
  const Vec3 toSocket = glenoid().origin - kTrigonum;
  Frame f;
  f.origin = kTrigonum;
  const Vec3 x = (toSocket - toSocket.dot(up) * up).normalized();
  f.axes << x, up, x.cross(up);
  return f;
}

Frame glenoid() {
  Frame f;
  const Vec3 z = Vec3(0.475, 0.188, 0.861).normalized();
  const Vec3 sup(8.9, 33.8, -12.3);
  const Vec3 y = (sup - sup.dot(z) * z).normalized();
  f.axes << y.cross(z), y, z;
  f.origin = -kSocketDepth * z;
  return f;
}

Frame acromion() {
  Frame f;
  const Vec3 x = (kAcromionTip - kAcromialAngle).normalized();
  const Vec3 z = Vec3(-0.29, 0.95, 0.10);
  const Vec3 up = (z - z.dot(x) * x).normalized();
  f.axes << x, up.cross(x), up;  // y medial
  f.origin = Vec3(-18.5, 32.0, -5.0);
  return f;
}

std::vector<Vec2> glenoidRim() {
  // Pear: 37 high, 28 wide below, 19 in the upper third; a little in front of and above the deepest point.
  return closedCurve({{0.2, 19.0},
                      {-5.3, 16.5},
                      {-8.6, 10.3},
                      {-10.3, 2.3},
                      {-12.6, -5.7},
                      {-10.8, -13.2},
                      {-5.3, -17.1},
                      {1.2, -18.1},
                      {8.2, -16.7},
                      {13.4, -12.7},
                      {15.2, -5.7},
                      {12.8, 2.3},
                      {11.2, 10.3},
                      {6.7, 16.9}},
                     6);
}

Vec3 onBlade(double x, double y, double dorsal) {
  return blade().toWorld({x, y, bend(x, y) + dorsal});
}

std::vector<Knot> coracoid() {
  return {{{-9, 6, -41}, 9.5},      {{-3.5, 16.5, -44.5}, 8.4}, {{6.8, 22.0, -43.6}, 7.5},
          {{17, 20.0, -37.6}, 6.9}, {{23.3, 14.9, -33}, 6.4},   {{25.6, 12.0, -31.8}, 5.6}};
}

Field coracoidField() {
  // 15 mm wide and 10 to 11 mm thick: flattened from above.
  return stretched(chain(coracoid()), coracoid()[2].at, Vec3(-0.2, 0.85, 0.5), 0.78);
}

Field acromionField() {
  return [roof = roofField(), frame = acromion()](const Vec3& p) {
    return std::max(roof(p), frame.toLocal(p).y() - 16);
  };
}

Field field() {
  const Frame socket = glenoid();
  // Head of the scapula: the rim's outline carried medially, narrowing to the neck.
  const std::vector<Vec2> rim = glenoidRim();
  const Field block = [socket, rim](const Vec3& p) {
    const Vec3 q = socket.toLocal(p);
    const double inward = std::clamp(4 - q.z(), 0.0, 30.0);
    const double side = polygonDistance(rim, q.head<2>()) + 0.32 * inward + 1.6;
    const double end = std::max(q.z() - 7, -20 - q.z());
    return std::min(std::max(side, end), 0.0) + Vec2(std::max(side, 0.0), std::max(end, 0.0)).norm() - 1.6;
  };
  const Field neck =
      chain({{onBlade(84, -13, 0), 1}, {onBlade(94, -13, 0.5), 5}, {socket.toWorld({0, -2, -14}), 10.5}});
  // The coracoid's root: broad, with a corner over the suprascapular notch.
  const Field root = chain({{onBlade(93, 6, 1), 4.5},
                            {blade().toWorld({95.5, 13.5, -14}), 4.6},
                            {coracoid()[1].at + Vec3(-1, -2, -2), 6}});
  Field bone = smoothUnion({bladeField(), neck}, 9);
  bone = smoothUnion({bone, block}, 5);
  bone = smoothUnion({bone, spineField()}, 6);
  bone = smoothUnion({bone, roofField()}, 7);
  bone = smoothUnion({bone, smoothUnion({coracoidField(), root}, 4)}, 6);
  return smoothSubtract(bone, sphere((kSocketRadius - kSocketDepth) * socket.axes.col(2), kSocketRadius),
                        2.0);
}

}  // namespace glenoid::generate::scapula
