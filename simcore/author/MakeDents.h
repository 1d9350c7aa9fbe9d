// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/author/BuildJoint.h"
#include "simcore/author/StaticPart.h"

namespace glenoid {

/// Cells fine enough for a tip of this radius on this part: six across the patch, and some thousand in the whole part.
GradedCells fineCells(const Part& part, double radius);

/// What each soft part of a joint gives under the tip of a tool beyond its own tetrahedra, into Part::dents.
/// At places spread over a part's visual surface a fine static solve of the part alone says how far a patch of
/// `radius` gives for each newton (StaticPart); what the same solve with the part's own tetrahedra gives is
/// subtracted, and the bottom of a dent is the lesser of 2.5 mm and two fifths of the tissue below. A second or two a
/// place, on all processors. Deterministic.
/// Tissue that is so thin that the fine cells hold less than half of it has no dent: the tip bends it as a whole.
/// Fails as StaticPart and embedGraded do, naming the part, and with Cancelled; the joint is then as it was.
struct DentWishes {
  double radius = 1.5e-3;  ///< m: the tip of a probe
  int places = 96;         ///< on each tissue of each part; eight where a dent reaches its bottom anyway
  std::string part;        ///< only this one; empty: all that are soft
};
/// A part that was pressed: its index, at how many places, and at how many of them it is too thin for a dent.
struct DentPlaces {
  int part = -1, count = 0, tooThin = 0;
};
Result<std::vector<DentPlaces>> makeDents(Joint& joint, const DentWishes& wishes = {}, const BuildProgress& progress = {});

}  // namespace glenoid
