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
  plate_.outline = closedCurve({{0.5, 0},
                                {6, 18},
                                {22, 33},
                                {38, 38},
                                {55, 31},
                                {76, 19},
                                {88, 11},
                                {100, 10},
                                {108, -2},
                                {108, -30},
                                {100, -42},
                                {80, -64},
                                {56, -92},
                                {26, -120},
                                {9, -127},
                                {2, -121},
                                {-1, -90},
                                {-1.5, -50},
                                {0, -20}},
                               5);
  plate_.thickness = 3.4;
  plate_.rounding = 1.6;
  plate_.height = bend;
  const auto knot = [](double x, double y, double r, double d = 0) { return Knot{onBlade(x, y, d), r}; };
  const Field lateral = chain(
      {knot(9, -122, 2.8), knot(34, -110, 3.3), knot(58, -85, 3.6), knot(82, -60, 4.0), knot(100, -38, 6.0)});
  const Field medial = chain({knot(8, -122, 2.8), knot(2, -95, 1.8), knot(1.5, -50, 1.8), knot(3, 0, 2.0),
                              knot(8, 19, 2.1), knot(23, 32, 2.3), knot(38, 36, 2.4)});
  return smoothUnion({smoothUnion({plate(plate_), lateral}, 5), medial}, 2.5);
}

Field spineField() {
  Plate wall;
  wall.frame = blade();
  // In this plate x runs along the spine, y dorsally, z is the height in the blade's plane.
  wall.frame.axes << blade().axes.col(0), blade().axes.col(2), -blade().axes.col(1);
  wall.outline = closedCurve({{1, -2},
                              {12, 2.5},
                              {32, 9.5},
                              {60, 24},
                              {88, 38},
                              {108, 43},
                              {116, 42},
                              {110, 36},
                              {100, 29},
                              {93, 18},
                              {90, 6},
                              {88, -4},
                              {40, -4}},
                             5);
  wall.thickness = 4.6;
  wall.rounding = 2.2;
  wall.height = [](double x, double y) { return -(0.05 * x * y / 40 + 0.02 * x); };
  const auto crest = [](double x, double y, double z) { return blade().toWorld({x, y, z}); };
  const Field lip = stretched(chain({{crest(3, 0, 0), 2.2},
                                     {crest(14, 0.5, 6.5), 2.9},
                                     {crest(34, 1.5, 11.5), 3.4},
                                     {crest(62, 3.5, 25.5), 3.9},
                                     {crest(90, 6, 38.5), 4.2},
                                     {crest(112, 7, 43.5), 4.6}}),
                              crest(60, 3, 26), blade().axes.col(1), 1.35);
  return smoothUnion({plate(wall), lip}, 5);
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
                      {-8.1, 10.3},
                      {-10.3, 2.3},
                      {-12.6, -5.7},
                      {-10.8, -13.2},
                      {-5.3, -17.1},
                      {1.2, -18.1},
                      {8.2, -16.7},
                      {13.4, -12.7},
                      {15.2, -5.7},
                      {12.8, 2.3},
                      {10.8, 10.3},
                      {6.7, 16.9}},
                     6);
}

Vec3 onBlade(double x, double y, double dorsal) {
  return blade().toWorld({x, y, bend(x, y) + dorsal});
}

std::vector<Knot> coracoid() {
  return {{{-9, 6, -41}, 9.5},      {{-3, 16.5, -44}, 8.6},   {{7, 22.5, -43.0}, 7.4},
          {{17, 20.0, -37.5}, 6.9}, {{23.6, 14.7, -33}, 6.4}, {{26.3, 11.5, -31.6}, 5.6}};
}

Field coracoidField() {
  // 15 mm wide and 10 to 11 mm thick: flattened from above.
  return stretched(chain(coracoid()), coracoid()[2].at, Vec3(-0.2, 0.85, 0.5), 0.78);
}

Field acromionField() {
  Plate roof;
  roof.frame = acromion();
  roof.outline = closedCurve({{-27, -9},
                              {-14, -12.6},
                              {2, -12.8},
                              {15, -10.6},
                              {23, -6},
                              {25, -0},
                              {22, 6},
                              {13, 9.5},
                              {0, 10},
                              {-12, 9},
                              {-22, 10},
                              {-32, 14},
                              {-36, 6}},
                             5);
  roof.thickness = 8.4;
  roof.rounding = 3.6;
  roof.height = [](double x, double y) { return 3.2 * (1 - x * x / 676) - 0.012 * y * y; };
  return plate(roof);
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
  const Field neck = chain({{onBlade(82, -12, 0), 5}, {socket.toWorld({0, -2, -14}), 10.5}});
  const Field infraglenoid = chain({{onBlade(98, -40, 0), 6}, {socket.toWorld({0, -15, -7}), 6.5}});
  Field bone = smoothUnion({bladeField(), neck, infraglenoid}, 9);
  bone = smoothUnion({bone, block}, 5);
  bone = smoothUnion({bone, spineField()}, 6);
  bone = smoothUnion({bone, acromionField()}, 7);
  bone = smoothUnion({bone, coracoidField()}, 6);
  return smoothSubtract(bone, sphere((kSocketRadius - kSocketDepth) * socket.axes.col(2), kSocketRadius),
                        2.0);
}

}  // namespace glenoid::generate::scapula
