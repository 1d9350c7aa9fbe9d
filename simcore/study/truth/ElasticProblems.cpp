// SPDX-License-Identifier: GPL-3.0-or-later
// What one body of embedded elements answers alone: static problems and free vibration.
#include <cmath>

#include "simcore/study/truth/Membranes.h"

namespace glenoid::truth {

std::vector<TruthProblem> elasticProblems() {
  std::vector<TruthProblem> all;
  all.push_back({"affine-patch", "Affine patch: one deformation everywhere, with a large turn", "forces out of balance", "", 0,
                 "exact; the test is of Bazeley, Cheung, Irons and Zienkiewicz 1965", "cell", "of a box of 1 × 0.8 × 0.6", {0.3, 0.2, 0.15}, 3, true,
                 {1e-11, 1e-11}, {1e-11, 1e-11}, affinePatch, {}, "every node is moved by hand, and a scenario moves rigid parts only"});
  all.push_back({"smooth-field", "A smooth field in a box askew to its grid", "displacement, root mean square of what is off", "", 0,
                 "exact: Papkovich and Neuber's solution with b = exp(2x) cos √2(y + z)", "cell", "of a box of 1 × 0.8 × 0.6", {0.1, 0.07, 0.05}, 3, true,
                 {0.003, 0.003, 1.8}, {0.003, 0.003, 1.8}, smoothField, {}, "every node is moved by hand, and a scenario moves rigid parts only"});
  all.push_back({"cook", "Cook's membrane, plane stress", "rise of the right side's middle", "", kCookRise, "Cook 1974; 23.96", "cell", "", {12, 6, 3, 1.5}, 3, true,
                 {0.02, 0.05, 1.2}, {0.005, 0.015, 0.9}, cookMembrane, {}, "its load is a shear over a side, and a scenario has pressures"});
  all.push_back({"cook-solid", "Cook's membrane as a solid between two planes of symmetry", "rise of the upper right corner", "mm", kCookSolidRise,
                 "CoFEA, benchmark 002, fine quadratic meshes: CalculiX 32.27, Code_Aster 32.20, Elmer 32.28", "cell", "mm", {5, 2.5, 1.25, 0.625}, 3, true,
                 {0.04, 0.08, 0.8}, {0.03, 0.05, 0.6}, cookSolid, {}, "its load is a shear over a side, and a scenario has pressures"});
  all.push_back({"le1", "NAFEMS LE1: elliptic membrane", "σyy at D", "Pa", kLe1Stress, "The Standard NAFEMS Benchmarks, 1990: 92.7 MPa", "cell", "m",
                 {0.25, 0.125, 0.0625}, 2, true, {0.05, 0.06}, {0.02, 0.05}, ellipticMembrane, ellipticMembraneScene});
  all.push_back({"le10", "NAFEMS LE10: thick plate", "σyy at D", "Pa", kLe10Stress, "The Standard NAFEMS Benchmarks, 1990: −5.38 MPa", "cell", "m",
                 {0.25, 0.125, 0.25 / 3}, 2, true, {0.05, 0.1}, {0.05, 0.1}, thickPlate, thickPlateScene});
  all.push_back({"fv32", "NAFEMS FV32: tapered membrane", "first natural frequency", "1/s", kFv32Frequencies[0], "Abbassian, Dawswell and Knowles, Free Vibration Benchmarks, NAFEMS 1987: 44.623 Hz", "cell", "m",
                 {1, 0.5, 0.25}, 2, true, {0.045, 0.25, 1.5}, {0.002, 0.002},
                 [](const TruthSetup& setup, double cell) -> Result<TruthValue> {
                   const double found = taperedMembrane(setup, cell, 6)[0];
                   return TruthValue{found, std::abs(found / kFv32Frequencies[0] - 1)};
                 },
                 {}, "a frequency is no state of a run"});
  all.push_back({"elastic-ball", "Free vibration of an elastic ball", "ω a / c of the lowest spheroidal mode", "", kLambSpheroidal,
                 "Lamb 1882, ν 1/4: 2.640", "cell", "radii", {0.8, 0.4, 0.2}, 2, true, {0.03, 0.08, 1.0}, {0.015, 0.04, 1.0}, elasticBall, {}, "a frequency is no state of a run"});
  return all;
}

}  // namespace glenoid::truth
