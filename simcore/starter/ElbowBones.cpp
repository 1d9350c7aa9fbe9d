// SPDX-License-Identifier: GPL-3.0-or-later
// Lower half of a humerus, an ulna and the two ligaments at its sides. Sizes as of the humerus of the shipped shoulder; the ulna
// is fitted to it. Origin on the axis of the rollers, the elbow bent by 60°.
#include <numbers>

#include "simcore/shape/ElbowEnd.h"
#include "simcore/starter/BoneShapes.h"
#include "simcore/starter/Starter.h"

namespace glenoid {
namespace {

using namespace shape;
using namespace starter;

constexpr double kFlexion = 60 * std::numbers::pi / 180;
constexpr double kJointSpace = 1.6;  ///< mm, both cartilages together

/// Axes of the elbow (x lateral, y forward, z proximal) with the rollers' axis through the origin of W.
Frame elbowFrame() {
  Frame f;
  f.axes.col(0) = Vec3::UnitZ();
  f.axes.col(1) = Vec3::UnitX();
  f.axes.col(2) = Vec3::UnitY();
  f.origin = -(f.axes * kElbowAxis);
  return f;
}

/// Three-edged above, flat between the supracondylar ridges below.
Field humerusField() {
  const Frame f = elbowFrame();
  const Field shaft = swept(f,
                            {{128, {3, -1.3}, {-10.8, 0}, {11, -1}, {0, 11.2}, {0.5, -10.4}, 0.68, 0.72},
                             {109, {3.9, -1.5}, {-10.8, 0}, {11, -2}, {0, 11.2}, {0.5, -10.4}, 0.67, 0.72},
                             {71, {4.7, -1.9}, {-12, -1}, {13.5, -4}, {-0.8, 11.2}, {1.5, -8.8}, 0.62, 0.74},
                             {51, {5, -2.4}, {-14.2, -1}, {16.6, -4.4}, {-1.6, 10.4}, {2, -7.8}, 0.60, 0.73},
                             {35, {4.6, -2.2}, {-17, -0.5}, {20, -4}, {-2, 9.5}, {2, -7.2}, 0.61, 0.72},
                             {23, {3.6, -1.8}, {-21, 0.5}, {24.5, -3.4}, {-2.4, 9}, {2, -7}, 0.62, 0.72},
                             {12, {2, -1.2}, {-26.5, 1}, {28.5, -2.6}, {-2, 8.6}, {1, -7}, 0.64, 0.72},
                             {3, {0.5, -0.5}, {-28, 0.5}, {30, -1}, {-1, 8}, {0, -7}, 0.68, 0.72},
                             {-6, {0, 0.5}, {-22, 0}, {27, 0}, {0, 7}, {0, -6.4}, 0.70, 0.72}},
                            4);
  return withElbow(shaft, f);
}

/// From the ulna's own axes (as the elbow's frame W with the arm straight) to W.
Mat3 bent() { return Eigen::AngleAxisd(kFlexion, Vec3::UnitZ()).toRotationMatrix(); }

/// Olecranon, coronoid process and shaft, and out of them the notch in which the trochlea turns.
Field ulnaField(const Field& humerus) {
  const Field hook = stretched(chain({{{-4, 18, 0}, 5.5}, {{-13, 13, 0}, 7.5}, {{-18.5, 2, 0}, 8.5}, {{-16, -12, 0}, 9}, {{-9, -25, 0}, 8.5}}),
                               Vec3::Zero(), Vec3::UnitZ(), 1.3);
  const Field coronoid = stretched(chain({{{-10, -22, 0}, 8.5}, {{1, -19, 0}, 7}, {{8.5, -15.5, -0.5}, 4.2}}), Vec3::Zero(), Vec3::UnitZ(), 1.45);
  const Field shaft = chain({{{-9, -24, 0}, 9}, {{-7, -45, 0.5}, 8.2}, {{-6, -80, 1}, 6.9}, {{-6, -115, 1.5}, 6}, {{-5, -150, 1.5}, 5.2}});
  const Field whole = smoothUnion({hook, coronoid, shaft}, 5);
  const Mat3 toOwn = bent().transpose();
  const Field own = [whole, toOwn](const Vec3& p) { return whole(toOwn * p); };
  const Field notched = smoothSubtract(own, grown(elbowRollers(elbowFrame()), kJointSpace), 1.5);
  return smoothSubtract(notched, grown(humerus, kJointSpace), 1);
}

}  // namespace

std::vector<StarterSurface> elbowSurfaces() {
  const Field humerus = humerusField(), ulna = ulnaField(humerus), bones = unionOf(humerus, ulna);
  const Mat3 out = bent();
  const auto onUlna = [&](double x, double y, double z) { return Vec3(out * Vec3(x, y, z)); };
  std::vector<StarterSurface> made;
  made.push_back({"humerus", boneSurface(humerus, Box3(Vec3(-34, -26, -48), Vec3(30, 142, 48)), 3000)});
  Box3 box;
  for (const Vec3& corner : {onUlna(-32, -162, -20), onUlna(22, -162, 20), onUlna(-32, 30, -20), onUlna(22, 30, 20)}) box.extend(corner);
  made.push_back({"ulna", boneSurface(ulna, box, 3000)});
  const double lies = 0.3, spans = -1;  // mm over the bone that it grows from
  made.push_back({"ulnar-collateral-ligament",
                  bandSurface({{{-4, 4, -35}, 3.5, lies}, {{7, -2, -25}, 4.5, spans}, {onUlna(3, -20, -14), 4.5, lies}, {onUlna(-2, -30, -14), 4, lies}}, 2.4, bones)});
  made.push_back({"lateral-collateral-ligament",
                  bandSurface({{{-5, 5, 36}, 3.5, lies}, {{5, -12, 31}, 4.5, 0.8}, {onUlna(-4, -26, 17), 4.5, 0.8}, {onUlna(-8, -38, 14), 4, lies}}, 2.4, bones)});
  return made;
}

}  // namespace glenoid
