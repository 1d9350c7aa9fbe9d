// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/author/BuildJoint.h"
#include "simcore/author/StaticPart.h"

namespace glenoid {

/// Cells fine enough for a tip of this radius on this part: four across the patch, and some thousand in the whole part.
GradedCells fineCells(const Part& part, double radius);

/// What each soft part of a joint gives under what presses it, into Part::dents. At places spread over a part's visual
/// surface a fine static solve of the part alone says how far patches of three radii give for each newton (StaticPart):
/// `radius`, twice and four times that, from the tip of a probe to the pad of a finger; less what the surface behind moves, since what
/// the part bends or moves as a whole its own elements show. The bottom of a dent is two fifths of the tissue below. A second or
/// two a place, on all processors. Deterministic.
/// Tissue that is so thin that the fine cells hold less than half of it has no dent: the tip bends it as a whole.
/// Fails as StaticPart and embedGraded do, naming the part, and with Cancelled; the joint is then as it was.
struct DentWishes {
  double radius = 1.5e-3;  ///< m, of the least patch: the tip of a probe
  int places = 96;         ///< at most, on each tissue of each part; fewer where more would tell no more
  std::string part;        ///< only this one; empty: all that are soft
  int jointPlaces = 160;   ///< at most, on all of them; where their area asks for more, each gets its share of these, but no less than eight
};
/// A part that was pressed: its index, at how many places, and at how many of them it is too thin for a dent; and how far apart
/// the places would lie, m, where the limits leave fewer than one in each 16 mm of its surface and the last ones still told more; else 0.
struct DentPlaces {
  int part = -1, count = 0, tooThin = 0;
  double coarse = 0;
};
Result<std::vector<DentPlaces>> makeDents(Joint& joint, const DentWishes& wishes = {}, const BuildProgress& progress = {});

}  // namespace glenoid
