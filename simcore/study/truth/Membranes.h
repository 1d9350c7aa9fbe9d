// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/study/truth/BrickProblem.h"
#include "simcore/study/truth/EmbeddedBody.h"
#include "simcore/study/truth/TruthProblem.h"

/// Published problems of linear elasticity, as bodies of embedded elements, as scenes and for another
/// program. SI units, but for Cook's.
namespace glenoid::truth {

/// NAFEMS LE1 (The Standard NAFEMS Benchmarks, 1990): elliptic membrane of 0.1 m, σ_yy at D (2, 0) 92.7 MPa.
inline constexpr double kLe1Stress = 92.7e6;
Result<TruthValue> ellipticMembrane(const TruthSetup& setup, double cell);
TruthScene ellipticMembraneScene(const TruthSetup& setup, double cell);
BrickProblem ellipticMembraneBricks();

/// NAFEMS LE10: thick plate under pressure, σ_yy at D (2, 0) of the pressed surface −5.38 MPa.
inline constexpr double kLe10Stress = -5.38e6;
Result<TruthValue> thickPlate(const TruthSetup& setup, double cell);
TruthScene thickPlateScene(const TruthSetup& setup, double cell);
BrickProblem thickPlateBricks();

/// NAFEMS FV32: tapered membrane held at its wide end, natural frequencies in its plane, 1/s.
inline constexpr double kFv32Frequencies[] = {44.623, 130.03, 162.70, 246.05, 379.90, 391.44};
std::vector<double> taperedMembrane(const TruthSetup& setup, double cell, int count);

/// Cook's membrane (Cook 1974), plane stress, E 1, ν 1/3: how far the middle of its right side rises under a
/// force of 1, 23.96.
inline constexpr double kCookRise = 23.96;
Result<TruthValue> cookMembrane(const TruthSetup& setup, double cell);
/// The same outline as a solid between two planes of symmetry, E 70 MPa, ν 0.33, shear of 6.25 MPa, clamped:
/// its upper right corner rises by 32.27 mm (CalculiX, fine quadratic mesh; Code_Aster 32.20, Elmer 32.28).
/// Source: CoFEA, benchmark 002.
inline constexpr double kCookSolidRise = 32.27;
Result<TruthValue> cookSolid(const TruthSetup& setup, double cell);

/// Elastic ball, ν 1/4 (Lamb 1882): ω a / c_s of its lowest spheroidal mode.
inline constexpr double kLambSpheroidal = 2.640;
Result<TruthValue> elasticBall(const TruthSetup& setup, double cellInRadii);

/// A smooth field without body force (Papkovich and Neuber) in a box that lies askew in the grid, given at
/// all nodes but those inside: error of displacements, root mean square over the box, as a share of theirs.
/// `cell`: of a box of 1 × 0.8 × 0.6.
Result<TruthValue> smoothField(const TruthSetup& setup, double cell);

/// One deformation gradient everywhere, with a large turn, in a box that lies askew in the grid: what is out
/// of balance.
Result<TruthValue> affinePatch(const TruthSetup& setup, double cell);

}  // namespace glenoid::truth
