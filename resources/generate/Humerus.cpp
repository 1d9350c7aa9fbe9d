// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "resources/generate/Bones.h"

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
  const Vec3 axis = canalAxis();
  const auto knot = [](double y, double r) { return Knot{canalAt(y), r}; };
  const Field shaft = chain(
      {knot(-14, 18), knot(-34, 14.2), knot(-62, 11.8), knot(-110, 11), knot(-190, 9.8), knot(-238, 9.2)});

  // Tuberosity of the deltoid, half way down the outer side.
  const Field tuberosity = chain({{canalAt(-76) + Vec3(1, 0, 8), 4},
                                  {canalAt(-99) + Vec3(-0.5, 0, 11.3), 5.6},
                                  {canalAt(-124) + Vec3(-0.5, 0, 8), 4}});

  // Elbow: the shaft flattens into two pillars that end in the epicondyles; between them capitulum and
  // trochlea.
  const Vec3 el = lateralEpicondyle(), em = medialEpicondyle();
  const Vec3 across = (el - em).normalized(), forward = axis.cross(across).normalized(),
             middle = 0.5 * (el + em);
  const Field lateral = chain({{canalAt(-215), 8},
                               {canalAt(-242) + 5 * across, 7},
                               {el - 9 * across + 14 * axis, 5.5},
                               {el - 7 * across, 6.5}});
  const Field medial = chain({{canalAt(-215), 8},
                              {canalAt(-242) - 5 * across, 7},
                              {em + 9 * across + 14 * axis, 5.5},
                              {em + 6 * across, 6.2}});
  const Field web =
      ellipsoid({middle + 18 * axis, (Mat3() << across, axis, forward).finished()}, {22, 30, 4.5});
  const Vec3 joint = middle - 5 * axis + 3 * forward;
  const Field capitulum = sphere(joint + 15 * across + 2 * forward, 10.5);
  const Field trochlea =
      chain({{joint + 6 * across, 8.2}, {joint - 4 * across, 8.6}, {joint - 16 * across, 11.4}});
  Field elbow = smoothUnion({lateral, medial, web, capitulum, trochlea}, 6);
  elbow = smoothSubtract(elbow, sphere(middle + 13 * axis - 12.5 * forward, 10), 4);  // olecranon fossa

  // Proximal end: metaphysis, greater tubercle with its three facets, lesser tubercle.
  const Field neck = ellipsoid({canalAt(-4), Mat3::Identity()}, {16, 22, 15.5});
  const Field greater = chain({{{6.5, 9.8, 16.8}, 11.2},
                               {{-4.5, 4, 16.8}, 10.8},
                               {{-4.5, -9, 16.2}, 9.8},
                               {canalAt(-30) + Vec3(-2, 0, 3), 10.5}});
  const Field lesser =
      chain({{{19.2, 1.2, 0.2}, 8.4}, {{17.4, -8, 3.4}, 8.2}, {canalAt(-32) + Vec3(3, 0, -2), 10}});
  // Crests of the tubercles, the lips of the groove.
  const Field lateralLip =
      chain({{{10.5, 9, 17.5}, 7.6}, {{12.2, 1, 18.2}, 7.2}, {{11.6, -8, 18.6}, 6.8}, {{8, -22, 18.5}, 6.2}});
  const Field medialLip = chain({{{18.8, 2, 4.0}, 8.0}, {{18.0, -8, 5.6}, 7.4}, {{12.5, -24, 8.5}, 6.6}});
  Field bone = smoothUnion({shaft, elbow, tuberosity}, 8);
  bone = smoothUnion({bone, neck, greater, lesser, lateralLip, medialLip}, 5);
  return smoothUnion({bone, sphere(Vec3::Zero(), kHeadRadius)}, 2.5);
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
