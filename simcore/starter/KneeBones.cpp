// SPDX-License-Identifier: GPL-3.0-or-later
// Lower end of a femur, upper ends of tibia and fibula in one piece, and the two collateral ligaments. Condyles: posterior radius
// about 20 mm and 80 mm over the epicondyles, as of an adult man. Origin on the axis through the condyles.
#include "simcore/shape/Field.h"
#include "simcore/starter/BoneShapes.h"
#include "simcore/starter/Starter.h"

namespace glenoid {
namespace {

using namespace shape;
using namespace starter;

constexpr double kJointSpace = 4;  ///< mm, both cartilages and the menisci

/// z up the shaft, x to the right, y backward: right-handed about Y up.
Frame upFrame() {
  Frame f;
  f.axes.col(0) = Vec3::UnitZ();
  f.axes.col(1) = Vec3::UnitX();
  f.axes.col(2) = Vec3::UnitY();
  return f;
}

Section ring(double height, double middleForward, double halfWidth, double halfDepth) {
  return {height, {0, middleForward}, {-halfWidth, 0}, {halfWidth, 0}, {0, halfDepth}, {0, -halfDepth}};
}

/// Both condyles, longer than high, as they roll on the tibia.
Field condyles() {
  const Field medial = smoothUnion({ellipsoid({{-3, -1, -23}, Mat3::Identity()}, {25, 21.5, 13}), ellipsoid({{-11, 1, -24}, Mat3::Identity()}, {20, 20, 12})}, 4);
  const Field lateral = smoothUnion({ellipsoid({{-1, -1, 23}, Mat3::Identity()}, {25, 21, 13}), ellipsoid({{-9, 1, 24}, Mat3::Identity()}, {19, 19.5, 12})}, 4);
  return unionOf(medial, lateral);
}

Field femurField() {
  const Field shaft = swept(upFrame(), {ring(135, 9, 13.5, 13.5), ring(100, 8, 13.8, 13.5), ring(70, 7, 16.5, 14.5), ring(45, 5, 24, 17), ring(25, 3, 33, 20),
                                        ring(10, 2, 36, 19), ring(-4, 3, 30, 14)}, 5);
  const Field flange = smoothUnion({ellipsoid({{19, 10, 14}, Mat3::Identity()}, {12, 19, 14}), ellipsoid({{17, 9, -13}, Mat3::Identity()}, {12, 18, 13})}, 4);
  const Field epicondyles = unionOf(sphere({-6, 6, -36.5}, 6), sphere({-5, 6, 35}, 5.5));
  Field bone = smoothUnion({shaft, smoothUnion({condyles(), flange}, 5), epicondyles}, 7);
  bone = smoothSubtract(bone, chain({{{40, -4, 1}, 9}, {{35, 16, 1}, 8}, {{31, 36, 1}, 6}}), 8);            // groove of the patella
  bone = smoothSubtract(bone, chain({{{-45, -8, 0}, 10.5}, {{-12, -10, 0}, 10}, {{3, -20, 0}, 8.5}}), 4);   // between the condyles
  return smoothSubtract(bone, ellipsoid({{-32, 32, 0}, Mat3::Identity()}, {14, 24, 22}), 8);                // flat of the back of the knee
}

/// Plateau with the two hollows that the condyles stand in, the ridge between them, the tuberosity, and the fibula at its side.
Field tibiaField(const Field& femur) {
  const Field shaft = swept(upFrame(), {ring(-21, -4, 37, 23), ring(-30, -4, 36.5, 23), ring(-42, -3, 30, 20), ring(-60, -1, 21, 17.5), ring(-85, 1, 15, 15.5),
                                        ring(-120, 2, 12.5, 14), ring(-150, 2, 11.5, 13)}, 5);
  const Field tuberosity = chain({{{16, -48, 1}, 6}, {{18, -58, 1}, 6.5}, {{14, -75, 1}, 6}});
  const Field ridge = unionOf(chain({{{-8, -22, -4.5}, 5}, {{-4, -15.5, -4}, 2.8}}), chain({{{-8, -22, 4.5}, 5}, {{-5, -16.5, 4}, 2.6}}));
  const Field fibula = chain({{{-17, -36, 35}, 8.5}, {{-17, -48, 36}, 7.5}, {{-14, -70, 33}, 5.2}, {{-11, -110, 30}, 5}, {{-10, -150, 29}, 5.2}});
  const Field whole = smoothUnion({smoothUnion({shaft, tuberosity}, 8), smoothUnion({ridge, fibula}, 3)}, 4);
  return smoothSubtract(whole, grown(femur, kJointSpace), 2);
}

}  // namespace

std::vector<StarterSurface> kneeSurfaces() {
  const Field femur = femurField(), tibia = tibiaField(femur), bones = unionOf(femur, tibia);
  std::vector<StarterSurface> made;
  made.push_back({"femur", boneSurface(femur, Box3(Vec3(-46, -34, -56), Vec3(46, 150, 56)), 3500)});
  made.push_back({"tibia", boneSurface(tibia, Box3(Vec3(-44, -166, -56), Vec3(44, 2, 56)), 3500)});
  const double lies = 0.3, spans = -1;  // mm over the bone that it grows from
  made.push_back({"medial-collateral-ligament",
                  bandSurface({{{-7, 11, -46}, 5, lies}, {{-4, -16, -42}, 6, spans}, {{1, -44, -40}, 6, 0.8}, {{3, -70, -28}, 4.5, lies}}, 2.6, bones)});
  made.push_back({"lateral-collateral-ligament",
                  bandSurface({{{-4, 11, 44}, 3.2, lies}, {{-10, -14, 43.5}, 3.5, spans}, {{-17, -39, 48}, 3.2, lies}}, 3, bones)});
  return made;
}

}  // namespace glenoid
