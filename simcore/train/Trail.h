// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "simcore/base/Math.h"

/// Figures of a path that was sampled at equal times: m, s.
namespace glenoid {

inline constexpr double kTrailCutOff = 10;  ///< Hz, half power

/// Σ of the lengths between samples.
double pathLength(std::span<const Vec3> trail);

/// The samples through a Gaussian whose half power lies at kTrailCutOff (σ = √(ln 2) / (2π f) = 13.25 ms), cut at four σ, weights made to
/// sum to one. Only those that have all their neighbours, so fewer than went in by twice the reach of the Gaussian.
std::vector<Vec3> filteredTrail(std::span<const Vec3> trail, double dt);

/// ln of the dimensionless squared jerk of the filtered trail, ∫ ‖x‴‖² dt · T⁵ / L², with third differences
/// (x₊₂ − 2 x₊₁ + 2 x₋₁ − x₋₂) / (2 Δt³), the integral as a sum, T and L of the samples that have one. Nothing where fewer than
/// five filtered samples or less than a millimetre of path are there.
/// Source: Hogan and Sternad, "Sensitivity of smoothness measures to movement duration, amplitude, and arrests", J. Motor
/// Behavior 41, 2009; their amplitude is the length of the path here, since no single reach is looked at.
std::optional<double> logJerk(std::span<const Vec3> trail, double dt);

}  // namespace glenoid
