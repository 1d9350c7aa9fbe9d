// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "resources/generate/Bones.h"
#include "simcore/shape/ElbowEnd.h"

namespace glenoid::generate::humerus {

namespace {

/// Anatomical axes at rest (Wu et al. 2005): columns anterior, proximal, lateral.
Mat3 anatomicalAxes() {
  const Vec3 elbow = 0.5 * (lateralEpicondyle() + medialEpicondyle());
  const Vec3 y = -elbow.normalized();
  const Vec3 x = y.cross(lateralEpicondyle() - medialEpicondyle()).normalized();
  Mat3 axes;
  axes << x, y, x.cross(y);
  return axes;
}

/// Across the shaft: x lateral, y forward, z proximal; origin on the canal's axis at the height of the head's
/// centre.
Frame canalFrame() {
  const Vec3 z = canalAxis(), elbow = lateralEpicondyle() - medialEpicondyle();
  const Vec3 x = (elbow - elbow.dot(z) * z).normalized();
  Frame f;
  f.origin = canalAt(0);
  f.axes << x, z.cross(x), z;
  return f;
}

/// The same axes, from the middle between the epicondyles.
Frame elbowFrame() {
  Frame f = canalFrame();
  f.origin = 0.5 * (lateralEpicondyle() + medialEpicondyle());
  return f;
}

/// The shaft down to the elbow: round above, with the long flat rise of the deltoid tuberosity at its outer
/// side, then three-edged with a crest in front, then flat between the two supracondylar ridges. It is bowed
/// outward and its lower half forward; the middles of its sections lie on a line between 140 and 215 mm below
/// the head's centre that keeps the offsets of the head (see canalAxis).
Field shaft() {
  const auto ring = [](double z, const Vec2& centre, double r) {
    return Section{z, centre, {-r, 0}, {r, 0}, {0, r}, {0, -r}};
  };
  return swept(canalFrame(),
               {ring(-14, {0, 0}, 18),
                ring(-34, {0.3, 0.2}, 14.2),
                ring(-62, {1.5, 0.6}, 11.9),
                {-82, {2.9, 0.7}, {-11.6, 0}, {12.8, 0.5}, {0.5, 11.9}, {0, -11.4}},
                {-101, {3.6, 0.3}, {-11.4, 0}, {13.8, 0.8}, {1, 12}, {0, -11.2}, 0.72, 0.68},
                {-121, {3.4, -0.5}, {-11.2, 0}, {13.2, 0.4}, {0.8, 11.9}, {0, -11.2}, 0.70, 0.69},
                {-142, {3.12, -1.10}, {-10.9, 0}, {11.6, 0}, {0.4, 11.6}, {0, -11}, 0.69, 0.71},
                {-180, {3.86, -1.54}, {-10.8, 0}, {11, -2}, {0, 11.2}, {0.5, -10.4}, 0.67, 0.72},
                {-218, {4.67, -1.87}, {-12, -1}, {13.5, -4}, {-0.8, 11.2}, {1.5, -8.8}, 0.62, 0.74},
                {-238, {5, -2.4}, {-14.2, -1}, {16.6, -4.4}, {-1.6, 10.4}, {2, -7.8}, 0.60, 0.73},
                {-254, {4.6, -2.2}, {-17, -0.5}, {20, -4}, {-2, 9.5}, {2, -7.2}, 0.61, 0.72},
                {-266, {3.6, -1.8}, {-21, 0.5}, {24.5, -3.4}, {-2.4, 9}, {2, -7}, 0.62, 0.72},
                {-277, {2, -1.2}, {-26.5, 1}, {28.5, -2.6}, {-2, 8.6}, {1, -7}, 0.64, 0.72},
                {-286, {0.5, -0.5}, {-28, 0.5}, {30, -1}, {-1, 8}, {0, -7}, 0.68, 0.72},
                {-295, {0, 0.5}, {-22, 0}, {27, 0}, {0, 7}, {0, -6.4}, 0.70, 0.72}},
               4);
}

}  // namespace

Vec3 lateralEpicondyle() {
  return {-16.0, -286.0, 86.6};
}
Vec3 medialEpicondyle() {
  return {-7.8, -292.2, 17.2};
}

Vec3 canalAxis() {
  // Through the middle of the elbow, passing 6.9 mm lateral and 2.6 mm in front of the head's centre (Boileau
  // and Walch 1997).
  const Vec3 top = anatomicalAxes() * Vec3(2.6, 0, 6.9);
  const Vec3 elbow = 0.5 * (lateralEpicondyle() + medialEpicondyle());
  return (top - elbow).normalized();
}

Vec3 canalAt(double y) {
  const Vec3 top = anatomicalAxes() * Vec3(2.6, 0, 6.9), axis = canalAxis();
  return top + (y - top.y()) / axis.y() * axis;
}

Vec3 headAxis() {
  const double up = std::sin((kNeckShaftAngle - 90) * std::numbers::pi / 180);
  const double flat = std::sqrt(1 - up * up), back = kRetroversion * std::numbers::pi / 180;
  const Mat3 anatomical = anatomicalAxes();
  const Vec3 y = canalAxis();
  const Vec3 z = (anatomical.col(2) - anatomical.col(2).dot(y) * y).normalized(), x = y.cross(z);
  return (flat * (-std::sin(back) * x - std::cos(back) * z) + up * y).normalized();
}

std::vector<Vec3> groovePath() {
  return {{15.8, 13.5, 11.0}, {16.9, 8, 12.4},   {17.2, 2, 13.4},
          {16.6, -7, 14.4},   {15.1, -16, 15.4}, {13.4, -26, 16.2}};
}

Field filledField() {
  // Proximal end: metaphysis, greater tubercle with its three facets, lesser tubercle.
  const Field metaphysis = sphere(canalAt(-10.6), 18.3);
  const Field neck = ellipsoid({canalAt(-4), Mat3::Identity()}, {16, 22, 15.5});
  const Field greater = chain({{{6.5, 9.8, 16.8}, 11.2},
                               {{-4.5, 4, 16.8}, 10.8},
                               {{-4.5, -9, 16.2}, 9.8},
                               {canalAt(-30) + Vec3(-2, 0, 3), 10.5},
                               {canalAt(-66), 8}});
  const Field lesser = chain({{{19.2, 1.2, 0.2}, 8.4},
                              {{17.4, -8, 3.4}, 8.2},
                              {canalAt(-32) + Vec3(3, 0, -2), 10},
                              {canalAt(-66), 8}});
  // Under the head, where the neck's inner side runs into the shaft.
  const Field calcar = chain(
      {{{-3, -12, -2}, 9.5}, {canalAt(-36) + Vec3(-1, 0, -3), 10.5}, {canalAt(-66) + Vec3(0, 0, 1.5), 6.5}});
  // Crests of the tubercles, the lips of the groove.
  const Field lateralLip = chain({{{10.5, 9, 17.5}, 7.6},
                                  {{12.2, 1, 18.2}, 7.2},
                                  {{11.6, -8, 18.6}, 6.8},
                                  {{8, -22, 18.5}, 6.2},
                                  {canalAt(-46) + Vec3(5, 0, 4), 6},
                                  {canalAt(-78), 5}});
  const Field medialLip = chain({{{18.8, 2, 4.0}, 8.0},
                                 {{18.0, -8, 5.6}, 7.4},
                                 {{12.5, -24, 8.5}, 6.6},
                                 {canalAt(-48) + Vec3(5, 0, -2), 6},
                                 {canalAt(-78), 5}});
  Field bone =
      smoothUnion({unionOf(shaft(), metaphysis), neck, calcar, greater, lesser, lateralLip, medialLip}, 5);
  return smoothUnion({withElbow(bone, elbowFrame()), sphere(Vec3::Zero(), kHeadRadius)}, 2.5);
}

Field field() {
  // The groove, 5 mm deep and 8 mm wide, runs out below.
  std::vector<Knot> groove;
  const std::vector<Vec3> floor = groovePath();
  const double radii[] = {4.5, 4.5, 4.5, 4.5, 4.6, 5.0}, lift[] = {0, 0, 0, 1.5, 4.4, 8.0};
  for (std::size_t i = 0; i < floor.size(); ++i) {
    const Vec3 out = (floor[i] - canalAt(floor[i].y())).normalized();
    groove.push_back({floor[i] + (radii[i] + lift[i]) * out, radii[i]});
  }
  groove.insert(groove.begin(), {Vec3(18.5, 22, 9.2), 4.6});
  return smoothSubtract(filledField(), chain(groove), 1.0);
}

}  // namespace glenoid::generate::humerus
