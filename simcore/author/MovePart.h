// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Error.h"
#include "simcore/scene/Part.h"

namespace glenoid {

/// How an author puts a part elsewhere after its import: turned about X, then Y, then Z of W through the middle of its box, scaled
/// from there, then shifted.
struct PartMove {
  Vec3 turn_deg = Vec3::Zero();
  double scale = 1;              ///< > 0
  Vec3 shift_W = Vec3::Zero();   ///< m
  bool operator==(const PartMove&) const = default;
};

/// Where a move takes a point and a direction that rest on a part.
struct PartMap {
  Mat3 turn = Mat3::Identity();
  double scale = 1;
  Vec3 about_W = Vec3::Zero(), shift_W = Vec3::Zero();  ///< m
  bool onlyShifts = true;        ///< then points keep their last digits
  Vec3 point(const Vec3& p_W) const { return onlyShifts ? Vec3(p_W + shift_W) : Vec3(scale * (turn * (p_W - about_W)) + about_W + shift_W); }
  Vec3 direction(const Vec3& n_W) const { return onlyShifts ? n_W : Vec3(turn * n_W); }
};
PartMap partMap(const Part& part, const PartMove& move);

/// The part at its new place: surfaces and landmarks, its tetrahedra too; one that runs as cells is cut into cells anew, which
/// stand along the joint's axes. Regions hold, dents are no longer known. Fails with OutOfRange (a scale that is not positive, a
/// number that is none) and as embedAlong does.
Result<Part> movedPart(const Part& part, const PartMove& move);

}  // namespace glenoid
