// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/shape/Field.h"

namespace glenoid::generate {

/// A sheet of rows of `across` points, rings where `closed`, and the way out of the joint at each. Millimetres, frame W.
struct Sheet {
  std::vector<Vec3> points, out;
  int across = 0;
  bool closed = false;
};

/// Moves the points of a sheet that lines the joint inwards until they lie `room` off what lies over it, evened out over
/// their neighbours; never nearer to the head than `least`, where that leaves less. A tendon lies so near to the head that a
/// wall of even thickness would lie within it, and the tendon would be seen from inside the joint.
void moveUnder(Sheet& sheet, const shape::Field& over, const shape::Field& head, double room, double least);

}  // namespace glenoid::generate
