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
  plate_.outline = closedCurve({{-3, 0},
                                {5, 18},
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
                                {8, -129},
                                {-1, -122},
                                {-5, -90},
                                {-6, -50},
                                {-4, -20}},
                               5);
  plate_.thickness = 3.4;
  plate_.rounding = 1.6;
  plate_.height = bend;
  const auto knot = [](double x, double y, double r, double d = 0) { return Knot{onBlade(x, y, d), r}; };
  const Field lateral = chain(
      {knot(8, -124, 3.0), knot(34, -110, 4.2), knot(58, -85, 4.6), knot(82, -60, 5.2), knot(100, -38, 6.5)});
  const Field medial = chain({knot(7, -124, 3.2), knot(-2, -95, 2.3), knot(-3, -50, 2.4), knot(-1, 0, 2.6),
                              knot(7, 19, 2.3), knot(23, 32, 2.3), knot(38, 36, 2.4)});
  return smoothUnion({plate(plate_), lateral, medial}, 5);
}

Field spineField() {
  Plate wall;
  wall.frame = blade();
  // In this plate x runs along the spine, y dorsally, z is the height in the blade's plane.
  wall.frame.axes << blade().axes.col(0), blade().axes.col(2), -blade().axes.col(1);
  wall.outline = closedCurve({{-2, -2},
                              {12, 6},
                              {32, 13},
                              {60, 26},
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
  const Field lip = stretched(chain({{crest(-1, 0, 0), 2.6},
                                     {crest(14, 0.5, 7), 3.2},
                                     {crest(34, 1.5, 14), 3.8},
                                     {crest(62, 3.5, 27), 4.0},
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
  // Pear: 37 high, 28 wide below, 19 in the upper third.
  return closedCurve({{-1, 18.7},
                      {-6.5, 16.2},
                      {-9.3, 10},
                      {-11.5, 2},
                      {-13.8, -6},
                      {-12, -13.5},
                      {-6.5, -17.4},
                      {0, -18.4},
                      {7, -17},
                      {12.2, -13},
                      {14, -6},
                      {11.6, 2},
                      {9.6, 10},
                      {5.5, 16.6}},
                     6);
}

Vec3 onBlade(double x, double y, double dorsal) {
  return blade().toWorld({x, y, bend(x, y) + dorsal});
}

std::vector<Knot> coracoid() {
  return {{{-9, 6, -41}, 9.5},      {{-3, 16.5, -44}, 8.6}, {{7, 22.5, -43.0}, 7.4},
          {{17, 20.0, -37.5}, 6.9}, {{24, 14.5, -33}, 6.4}, {{27, 11, -31.5}, 5.6}};
}

Field coracoidField() {
  // 15 mm wide and 10 to 11 mm thick: flattened from above.
  return stretched(chain(coracoid()), coracoid()[2].at, Vec3(-0.2, 0.85, 0.5), 0.78);
}

Field acromionField() {
  Plate roof;
  roof.frame = acromion();
  roof.outline = closedCurve({{-27, -9},
                              {-14, -13.5},
                              {2, -13.5},
                              {15, -11},
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
                        1.2);
}

}  // namespace glenoid::generate::scapula
