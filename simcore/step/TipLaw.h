// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>

#include "simcore/scene/DentTable.h"

namespace glenoid {

/// How a ball of radius R sinks into elastic tissue under a force f. On a half-space of modulus E* the radius of contact is
/// a = ∛(3 f R / 4 E*) and the depth a²/R (Hertz 1881). Tissue that is no half-space gives another c(a) under an even pressure on a
/// patch of that radius than the half-space's k(a) = 16/(3π² E* a); what is near the contact does not know of it, so
///
///   Δ(f) = a²/R − (k(a) − c(a)) f,
///
/// right to first order in a over the thickness of a layer (Dimitriadis et al. 2002, whose χ it is), and right at any for tissue
/// that bends or moves as a whole. The difference is linear in a between the table's radii. Where a would be more than R the ball
/// is a punch of its own radius; below a = 0.3 R, where Hertz' law has no slope, Δ is linear.
struct TipLaw {
  TissueGive give;
  std::array<double, DentSample::kRadii> radii{};  ///< m, ascending
  double radius = 0;                               ///< of the ball, m

  double contactRadius(double force) const;  ///< m, from 0.3 to 1 of the ball's
  double depth(double force) const;          ///< Δ, m
  double slope(double force) const;          ///< dΔ/df with k − c as it is there, m/N, > 0
  double force(double depth) const;          ///< of which this is the depth, N; zero for none
};

}  // namespace glenoid
