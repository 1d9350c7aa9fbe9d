// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <optional>

#include "simcore/fem/CorotTet.h"

namespace glenoid {

/// Isotropic law in the principal stretches s_k that is the corotational linear one while all of them lie in
/// [kLinearFrom, kLinearTo], and beyond that neither turns inside out under tension nor gives way without end when
/// pressed. The linear law's sides shrink by ν (s − 1) and pass zero at s = 1 + 1/ν. Here strain is measured by
///   h(s) = s − 1 between the two, c ln(1 + (s − kLinearTo)/c) further on above, kLinearFrom ln(s/kLinearFrom) below,
/// straight on below kLogarithmTo, so that a flat or inverted element has finite forces that push it back. Energy per volume
///   ψ = µ Σ h_k² + λ/2 (Σ h_k)² + E/2 Σ_{s_k > kLinearTo} ((s_k − 1)² − h_k²),
/// whose derivatives, the principal stresses P_k (Biot, force per rest area), are continuous. Under a dead load along one
/// axis P = E (s − 1) exactly, at any stretch, while the sides have h = −ν h(s). README has the volumes that are kept.
/// Wrong for: permanent set, tearing, and tissue that stiffens as its fibres straighten.
/// Stretches are signed: one is negative where det F < 0, R being a rotation (Rotation.h).
/// Source: an energy in functions of principal stretches, as Hill, "On constitutive inequalities for simple materials",
/// J. Mech. Phys. Solids 16, 1968, and Ogden, "Large deformation isotropic elasticity", Proc. R. Soc. Lond. A 326, 1972.
namespace stretch_law {
inline constexpr double kLinearFrom = 0.4, kLinearTo = 1.2;  ///< principal stretches
inline constexpr double kLogarithmTo = 0.015;
/// c: between what keeps the volume of nearly incompressible tissue under tension (0.4) and what keeps a layer held at its
/// sides from softening when it is pulled apart (0.45 at ν 0.49).
inline constexpr double kReach = 0.45;
/// |S − I|² up to which no principal stretch leaves the linear range: what the packed kernels look at.
inline constexpr double kSurely = 0.04;
/// Pressure in Young's moduli up to which the law holds tissue: along one axis it then has 0.14 to 0.18 of its length.
inline constexpr double kPressMost = 3;
}  // namespace stretch_law

double youngsModulusOf(const Lame& lame);  ///< Pa

/// Whether all eigenvalues of the symmetric S lie inside the linear range.
bool isLinearRange(const Mat3& S);

/// P_k, Pa. `whole`: false leaves the linear law below kLinearFrom (LawRange::TensionOnly).
Vec3 principalStress(const Lame& lame, const Vec3& stretches, bool whole = true);
/// ψ, J/m³.
double energyDensity(const Lame& lame, const Vec3& stretches, bool whole = true);
/// ∂P_i/∂s_j, Pa, symmetric; not definite everywhere.
Mat3 principalTangent(const Lame& lame, const Vec3& stretches, bool whole = true);

/// What an element of the linear law lacks, in its own frame E. For rest gradients g_i and V its volume:
/// force f_i = −V R stress_E g_i, energy V energy, and in A stiffness Σ_m V k_m y_i y_jᵀ with y_i = R D_m g_i, which holds the
/// positive part of the difference of the tangents: with it A's stiffness is above the law's where that is stiffer, and
/// stays the linear one where it is softer.
struct StretchCorrection {
  struct Term {
    double stiffness;  ///< k, Pa, > 0
    Mat3 direction_E;  ///< D, |D| = 1
  };
  Mat3 stress_E;
  double energy = 0;           ///< J/m³
  std::array<Term, 6> terms;   ///< the first `count`
  int count = 0;
  double turning = 0;          ///< Pa: what is to be added to V/2 τ (tensionStiffness); below zero where the law pulls less
};

/// Nothing in the linear range, or where F is not finite. `law`: of the tissue that follows this law; `linear`: of the element,
/// whose tensionStiffness is in A already. The same for a tetrahedron; a cell of several tissues differs.
std::optional<StretchCorrection> stretchCorrection(const Lame& law, const Lame& linear, const Mat3& F, const Mat3& R_WE,
                                                 bool whole = true);

/// How much of the law a body has. What holds pressed elements open also holds the folds of a body that starts entangled, so where
/// more than a hundredth of its elements are not sound (below) they are linear below kLinearFrom again, in which they pass through
/// their flat state, and where more than a twentieth, at any stretch: that many are the work of no load, and it finds back so.
enum class LawRange { Whole, TensionOnly, Linear };
LawRange lawRange(int notSound, int elements);

/// Whether neither what follows nor stretchCorrection has anything to say of an element, without its principal stretches: all
/// of them lie in the linear range, and no principal stress is −kPressMost E or below. S = sym(RᵀF).
bool plainlySound(const Lame& lame, const Mat3& S);

/// How an element fares, from F alone.
enum class TissueState { Sound, Pressed, InsideOut };
/// InsideOut: det F ≤ 0. Pressed: a principal stress of −kPressMost E or below, by this law or by the linear one alone.
TissueState tissueState(const Lame& lame, const Mat3& F, bool stretchLaw);

}  // namespace glenoid
