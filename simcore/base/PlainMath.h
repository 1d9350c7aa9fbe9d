// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Elementary functions in +, −, ×, ÷ and √ alone, which IEEE 754 rounds the same way everywhere. The C library's own
/// choose their code by the processor (with or without fused multiply-add) and differ between its versions, so nothing
/// that reaches a state may call them: a recording would end in other bits on another machine. std::sqrt, std::floor,
/// std::ceil, std::round, std::abs, std::frexp and std::ldexp are exact by the standard and may be used.
/// Series of Taylor about the middle of a reduced range, as many terms as leave less than 1/20 of the last digit.
/// Errors are in units in the last place of the result (ulp); NaN where an argument is NaN.
/// Needs a compiler that does not contract a·b + c (-ffp-contract=off).
/// Source of the reductions: Muller, "Elementary Functions", 3rd edition, 2016, chapter 11 (Cody and Waite).
namespace glenoid::plain {

/// Within 1 ulp for |x| ≤ 10⁵ rad; beyond, the angle itself is no longer known to its last digit.
double sine(double x);
double cosine(double x);

/// Angle of the point (x, y), −π … π, within 2 ulp; finite arguments. The angle of (0, 0) is 0, of (−0, 0) π as in C.
double arcTangent(double y, double x);
/// −π/2 … π/2, within 3 ulp; |x| > 1 counts as 1.
double arcSine(double x);

/// Within 1 ulp; infinite above 709.78, zero below −745.2.
double exponential(double x);
/// Within 1 ulp, of x ≥ 2⁻¹⁰²²; −∞ at zero, NaN below.
double logarithm(double x);
/// Within 1 ulp; odd.
double cubeRoot(double x);

}  // namespace glenoid::plain
