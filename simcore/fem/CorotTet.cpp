// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/fem/CorotTet.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace glenoid {

Lame lameFrom(double youngsModulus, double poissonRatio) {
  const double mu = youngsModulus / (2 * (1 + poissonRatio));
  return {2 * mu * poissonRatio / (1 - 2 * poissonRatio), mu};
}

Result<CorotTet> makeCorotTet(const Mat34& x0_E, const Lame& lame, double fill) {
  Mat3 D;
  for (int i = 0; i < 3; ++i) D.col(i) = x0_E.col(i + 1) - x0_E.col(0);
  const double volume = D.determinant() / 6;
  const double longest = D.colwise().norm().maxCoeff();
  // Scaled: a needle of aspect 1e4 has 1e-9; three digits below that a gradient has lost half of its own.
  if (!(volume > 1e-12 * longest * longest * longest / 6)) {
    Error error{Fault::BadElement, {}, {std::to_string(volume)}, "rest volume is not positive"};
    return error;
  }
  CorotTet tet;
  const Mat3 inverse = D.inverse();  // rows are the gradients of nodes 1…3
  tet.gradients_E.rightCols<3>() = inverse.transpose();
  tet.gradients_E.col(0) = -tet.gradients_E.rightCols<3>().rowwise().sum();
  tet.volume = volume * fill;
  tet.lame = lame;
  return tet;
}

namespace {
Mat3 stressOf(const Lame& lame, const Mat3& strain) {
  Mat3 stress = 2 * lame.mu * strain;
  stress.diagonal().array() += lame.lambda * strain.trace();
  return stress;
}

Mat3 strainOf(const Mat3& F, const Mat3& R_WE) {
  const Mat3 U = R_WE.transpose() * F;
  return 0.5 * (U + U.transpose()) - Mat3::Identity();
}
}  // namespace

Mat34 elasticForce(const CorotTet& tet, const Mat3& F, const Mat3& R_WE) {
  return -tet.volume * (R_WE * (stressOf(tet.lame, strainOf(F, R_WE)) * tet.gradients_E));
}

double tensionStiffness(const CorotTet& tet, const Mat3& F, const Mat3& R_WE) {
  // The largest eigenvalue of tr(σ) I − σ is at most a third of its trace and √(2/3) of its deviator's norm; stretches
  // that pull add up to two or more.
  const Mat3 stress = stressOf(tet.lame, strainOf(F, R_WE));
  const double mean = stress.trace() / 3, deviator = std::max(0.0, stress.squaredNorm() - 3 * mean * mean);
  return 0.25 * tet.volume * std::max(0.0, 2 * mean + std::sqrt(2.0 / 3 * deviator));
}

double elasticEnergy(const CorotTet& tet, const Mat3& F, const Mat3& R_WE) {
  const Mat3 strain = strainOf(F, R_WE);
  const double trace = strain.trace();
  return tet.volume * (tet.lame.mu * strain.squaredNorm() + 0.5 * tet.lame.lambda * trace * trace);
}

}  // namespace glenoid
