// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/shape/ElbowEnd.h"

namespace glenoid::shape {

Field elbowRollers(const Frame& elbow) {
  const Field capitulum = ellipsoid({elbow.toWorld({21, 6.5, -8}), elbow.axes}, {9.6, 10.8, 10.8});
  Frame spool = elbow;
  spool.origin = elbow.toWorld(kElbowAxis);
  const Field trochlea =
      turned(spool, {{-17, 9}, {-14.2, 13}, {-9, 11.3}, {-2, 9}, {5, 9.2}, {10.5, 10.4}, {15, 9}}, 2.2);
  return smoothUnion({capitulum, trochlea}, 3);
}

Field withElbow(Field bone, const Frame& elbow) {
  const auto at = [&](double lateral, double forward, double up) {
    return elbow.toWorld({lateral, forward, up});
  };
  const Field medial = chain({{at(-20, -1, 4), 8}, {at(-28.8, -2, 1.2), 6.6}});
  const Field outer = chain({{at(21, 0, 2), 7}, {at(29.4, 0, -1.8), 5.6}});
  bone = smoothUnion({bone, smoothUnion({medial, outer}, 4)}, 7);
  bone = smoothUnion({bone, elbowRollers(elbow)}, 4);
  const auto hollow = [&](const Vec3& centre, const Vec3& halfAxes) {
    return ellipsoid({centre, elbow.axes}, halfAxes);
  };
  bone = smoothSubtract(bone, hollow(at(-1, -11, 9.5), {12.5, 9, 9.5}), 3);   // olecranon fossa
  bone = smoothSubtract(bone, hollow(at(-4, 11.5, 10.5), {7.5, 8.5, 6}), 3);  // coronoid fossa
  return smoothSubtract(bone, hollow(at(17, 12, 9), {6, 6.5, 5}), 3);         // radial fossa
}

}  // namespace glenoid::shape
