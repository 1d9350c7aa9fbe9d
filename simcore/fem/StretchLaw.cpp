// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/fem/StretchLaw.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "simcore/base/PlainMath.h"
#include "simcore/base/Turns.h"

namespace glenoid {

using namespace stretch_law;

namespace {

/// h and its first two derivatives.
struct Measure {
  double h, slope, bend;
};
Measure measureOf(double s, bool whole) {
  if (s > kLinearTo) {
    const double slope = kReach / (kReach + s - kLinearTo);
    return {kLinearTo - 1 + kReach * plain::logarithm(1 / slope), slope, -slope * slope / kReach};
  }
  if (s >= kLinearFrom || !whole) return {s - 1, 1, 0};
  const double last = std::max(s, kLogarithmTo), slope = kLinearFrom / last;
  const double h = kLinearFrom - 1 - kLinearFrom * plain::logarithm(slope);
  return s >= kLogarithmTo ? Measure{h, slope, -slope * slope / kLinearFrom} : Measure{h + slope * (s - kLogarithmTo), slope, 0};
}

/// Sylvester: whether the symmetric matrix is positive definite.
bool isDefinite(double a, double b, double c, double ab, double ac, double bc) {
  const double minor = a * b - ab * ab;
  return a > 0 && minor > 0 && c * minor + 2 * ab * ac * bc - a * bc * bc - b * ac * ac > 0;
}

Vec3 linearStress(const Lame& lame, const Vec3& s) {
  const Vec3 strain = s - Vec3::Ones();
  return 2 * lame.mu * strain + Vec3::Constant(lame.lambda * strain.sum());
}

double linearEnergy(const Lame& lame, const Vec3& s) {
  const Vec3 strain = s - Vec3::Ones();
  return lame.mu * strain.squaredNorm() + 0.5 * lame.lambda * strain.sum() * strain.sum();
}

/// Two stretches that add up to less count as this where they pull: the stiffness against turning grows without bound in
/// flat elements, whose R is hardly unique.
constexpr double kSumLeast = 0.5;

/// The largest stiffness against turning in the planes of two principal stretches, Pa; 0 where nothing pulls.
double turningOf(const Vec3& stress, const Vec3& s) {
  double most = 0;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    most = std::max(most, (stress[i] + stress[j]) / std::max(s[i] + s[j], kSumLeast));
  }
  return most;
}

/// The bound of tensionStiffness, Pa.
double linearTurning(const Vec3& stress) {
  const double mean = stress.sum() / 3, deviator = std::max(0.0, stress.squaredNorm() - 3 * mean * mean);
  return 0.5 * std::max(0.0, 2 * mean + std::sqrt(2.0 / 3 * deviator));
}

}  // namespace

double youngsModulusOf(const Lame& lame) { return lame.mu * (3 * lame.lambda + 2 * lame.mu) / (lame.lambda + lame.mu); }

bool isLinearRange(const Mat3& S) {
  return isDefinite(kLinearTo - S(0, 0), kLinearTo - S(1, 1), kLinearTo - S(2, 2), -S(1, 0), -S(2, 0), -S(2, 1)) &&
         isDefinite(S(0, 0) - kLinearFrom, S(1, 1) - kLinearFrom, S(2, 2) - kLinearFrom, S(1, 0), S(2, 0), S(2, 1));
}

Vec3 principalStress(const Lame& lame, const Vec3& stretches, bool whole) {
  const double E = youngsModulusOf(lame);
  Measure m[3];
  for (int k = 0; k < 3; ++k) m[k] = measureOf(stretches[k], whole);
  const double trace = m[0].h + m[1].h + m[2].h;
  Vec3 P;
  for (int k = 0; k < 3; ++k) {
    P[k] = m[k].slope * (2 * lame.mu * m[k].h + lame.lambda * trace);
    if (stretches[k] > kLinearTo) P[k] += E * (stretches[k] - 1 - m[k].h * m[k].slope);
  }
  return P;
}

double energyDensity(const Lame& lame, const Vec3& stretches, bool whole) {
  const double E = youngsModulusOf(lame);
  double squares = 0, trace = 0, beyond = 0;
  for (int k = 0; k < 3; ++k) {
    const double h = measureOf(stretches[k], whole).h, strain = stretches[k] - 1;
    squares += h * h;
    trace += h;
    if (stretches[k] > kLinearTo) beyond += strain * strain - h * h;
  }
  return lame.mu * squares + 0.5 * lame.lambda * trace * trace + 0.5 * E * beyond;
}

Mat3 principalTangent(const Lame& lame, const Vec3& stretches, bool whole) {
  const double E = youngsModulusOf(lame);
  Measure m[3];
  for (int k = 0; k < 3; ++k) m[k] = measureOf(stretches[k], whole);
  const double trace = m[0].h + m[1].h + m[2].h;
  Mat3 H;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) H(i, j) = lame.lambda * m[i].slope * m[j].slope;
    H(i, i) += 2 * lame.mu * m[i].slope * m[i].slope + m[i].bend * (2 * lame.mu * m[i].h + lame.lambda * trace);
    if (stretches[i] > kLinearTo) H(i, i) += E * (1 - m[i].slope * m[i].slope - m[i].h * m[i].bend);
  }
  return H;
}

std::optional<StretchCorrection> stretchCorrection(const Lame& law, const Lame& linear, const Mat3& F, const Mat3& R_WE, bool whole) {
  const Mat3 M = R_WE.transpose() * F, S = 0.5 * (M + M.transpose());
  if (isLinearRange(S) || !S.allFinite()) return {};
  const SymmetricEigen axes = symmetricEigen(S);
  const Vec3& s = axes.values;
  const Vec3 P = principalStress(law, s, whole), less = P - linearStress(law, s);
  const Mat3 H = principalTangent(law, s, whole);
  StretchCorrection c;
  c.stress_E = axes.vectors * less.asDiagonal() * axes.vectors.transpose();
  c.energy = energyDensity(law, s, whole) - linearEnergy(law, s);
  const auto add = [&](double stiffness, const Mat3& direction) {
    if (stiffness > 0) c.terms[c.count++] = {stiffness, axes.vectors * direction * axes.vectors.transpose()};
  };
  Mat3 rise = H;
  rise.array() -= law.lambda;
  rise.diagonal().array() -= 2 * law.mu;
  const SymmetricEigen modes = symmetricEigen(rise);
  for (int k = 0; k < 3; ++k) add(modes.values[k], modes.vectors.col(k).asDiagonal());
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const double apart = s[i] - s[j];
    const double shear = std::abs(apart) > 1e-6 ? (P[i] - P[j]) / apart : 0.5 * (H(i, i) - 2 * H(i, j) + H(j, j));
    Mat3 D = Mat3::Zero();
    D(i, j) = D(j, i) = std::sqrt(0.5);
    add(shear - 2 * law.mu, D);
  }
  const Vec3 before = linearStress(linear, s);
  c.turning = 0.5 * (turningOf(before + less, s) - linearTurning(before));
  return c;
}

LawRange lawRange(int notSound, int elements) {
  constexpr double kHundredth = 0.01, kTwentieth = 0.05;
  if (notSound > kTwentieth * elements) return LawRange::Linear;
  return notSound > kHundredth * elements ? LawRange::TensionOnly : LawRange::Whole;
}

bool plainlySound(const Lame& lame, const Mat3& S) {
  if (!isLinearRange(S)) return false;
  Mat3 above = 2 * lame.mu * S;  // the stress and kPressMost E: positive definite, by its leading minors
  above.diagonal().array() += lame.lambda * (S.trace() - 3) - 2 * lame.mu + stretch_law::kPressMost * youngsModulusOf(lame);
  return above(0, 0) > 0 && above(0, 0) * above(1, 1) > above(0, 1) * above(0, 1) && above.determinant() > 0;
}

TissueState tissueState(const Lame& lame, const Mat3& F, bool stretchLaw) {
  if (F.determinant() <= 0) return TissueState::InsideOut;
  const Mat3 C = F.transpose() * F;
  const double E = youngsModulusOf(lame);
  const Mat3 green = C - Mat3::Identity();
  const double size2 = green.squaredNorm();
  // Within 0.3 all stretches lie in 0.83 … 1.15, s − 1 ≥ g/2 − 0.18 g² with g = s² − 1, and 2 µ (s − 1) > −0.2 E.
  if (size2 < 0.09 && lame.lambda * (0.5 * green.trace() - 0.18 * size2) > 0.2 * E - kPressMost * E) return TissueState::Sound;
  const Vec3 s = symmetricEigen(C).values.cwiseMax(0.0).cwiseSqrt();
  const Vec3 P = stretchLaw ? principalStress(lame, s) : linearStress(lame, s);
  return P.minCoeff() <= -kPressMost * E ? TissueState::Pressed : TissueState::Sound;
}

}  // namespace glenoid
