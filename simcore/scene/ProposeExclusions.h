// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "simcore/scene/Joint.h"

namespace glenoid {

/// When two bonded parts should not collide as well: bonds hold them where contact would push them apart.
struct ExclusionRules {
  double partShare = 0.10;   ///< bonded area over the area of the part whose surface is smaller
  double nearShare = 0.60;   ///< … or over what of the surface lies within `near` of the other part
  double near = 2e-3;        ///< m
  double leastArea = 10e-6;  ///< m²; less is no surface to speak of
};

/// A pair that couplings bond over a large surface and that may still collide.
struct ExclusionProposal {
  std::string partA, partB;  ///< ids, A the part of lower number
  double bonded = 0;         ///< m², the larger of both sides' regions
  double ofPart = 0;         ///< over the smaller part's area, 0…1
  double ofNear = 0;         ///< over the near surface of the side whose regions are larger, 0…1
};

/// In the joint's order of parts. Couplings whose part or region is missing are passed over.
std::vector<ExclusionProposal> proposeExclusions(const Joint& joint, const ExclusionRules& rules = {});

}  // namespace glenoid
