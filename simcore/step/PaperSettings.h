// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "simcore/scene/Scenario.h"

namespace glenoid {

/// What the `paper` profile adds to the step as published, each off unless it is asked for. The other profiles always
/// have all of them.
/// Source: Otaduy et al., "Modeling and Simulation of a Human Shoulder", CEIG 2010, §5.
struct PaperSettings {
  bool tension = false;      ///< the stiffness of taut tissue against turning, in A (fem/README)
  bool recoveryCap = false;  ///< c cut to the scenario's recoverySpeedMax; as published c = −g/Δt whatever the depth
  bool parts = false;        ///< a step that turns too far is cut in up to 64
  bool searchAgain = false;  ///< contacts are looked for anew where the solve moves something unforeseen
  bool stretchLaw = false;   ///< overstretched and crushed tissue leaves the linear law (fem/StretchLaw.h)

  static PaperSettings all() { return {true, true, true, true, true}; }
};

/// Where the iterations of the `paper` profile end. The publication gives no figure; these are ours, and what a run takes
/// unless somebody asks for others (`glenoid study accuracy` measures what each costs and brings).
struct PaperLimits {
  double cgTolerance = 1e-6;      ///< relative residual of the unconstrained solve
  int cgIterations = 2000;        ///< block-Jacobi preconditioned
  int outerIterations = 40;       ///< Jacobi over velocities
  double outerTolerance = 1e-4;   ///< change of v between two iterations, relative
  int innerSweeps = 30;           ///< projected Gauss–Seidel on B = J D⁻¹ Jᵀ
  int powerIterations = 15;       ///< estimate of λmax(D⁻¹A)
  double lambdaMaxForNodes = 1.9; ///< above it D holds objects instead of nodes
  bool operator==(const PaperLimits&) const = default;
};

/// Whether the steps of a profile have the stretch law.
inline bool hasStretchLaw(Profile profile, const PaperSettings& paper = {}) { return profile != Profile::Paper || paper.stretchLaw; }

/// The member of a word ("tension", "recovery-cap", "parts", "search-again", "stretch-law"); null for another word.
bool* paperSetting(PaperSettings& settings, const std::string& word);

/// Words of all departures of a `paper` step from the publication: those that are on, then those that have no switch.
///   "explicit-b"           B = J D⁻¹ Jᵀ is kept as a matrix; the publication visits object by object. The same sums.
///   "geometric-left-out"   of ∂F/∂q what comes of turning levers and rotations, which may make A indefinite
///   "springs-in-regions"   couplings are springs at integration points of a region, as in all profiles, not at nodes; not
///                          where `regions` is false: then all hold at nodes
std::vector<std::string> paperDepartures(const PaperSettings& settings, bool regions = true);

}  // namespace glenoid
