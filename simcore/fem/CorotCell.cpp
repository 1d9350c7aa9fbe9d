// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/fem/CorotCell.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "simcore/fem/CellModes.h"
#include "simcore/fem/CellShape.h"

namespace glenoid {

namespace {

using Mat9 = Eigen::Matrix<double, 9, 9>;

/// Modes whose own stiffness is below this share of a full cell's are held instead: along a direction in which the tissue
/// has no extent there is nothing for them to bend.
constexpr double kModeFloor = 1e-6;
/// Where the turning of R counts whole, and where not at all: m = 9 det H / tr² H is 2 at rest and falls with the smallest
/// sum of two principal stretches, below which R is hardly unique.
constexpr double kTurnWhole = 1.2, kTurnNone = 0.2;

/// Strains in the order xx, yy, zz, xy, yz, zx, shears doubled.
Mat6 elasticityOf(const Lame& lame) {
  Mat6 D = Mat6::Zero();
  D.topLeftCorner<3, 3>().setConstant(lame.lambda);
  D.topLeftCorner<3, 3>().diagonal().array() += 2 * lame.mu;
  D.bottomRightCorner<3, 3>().diagonal().setConstant(lame.mu);
  return D;
}

/// From the means of 1/K and 1/µ.
Lame meanCompliance(std::span<const CellTissue> tissue, double volume) {
  double bulk = 0, shear = 0;
  for (const CellTissue& t : tissue) {
    bulk += t.moments.volume() / (t.lame.lambda + 2.0 / 3 * t.lame.mu);
    shear += t.moments.volume() / t.lame.mu;
  }
  const double mu = volume / shear;
  return {volume / bulk - 2.0 / 3 * mu, mu};
}

/// Opposite edges are parallel and of one length, so that shape gradients are linear in each of ξ, η, ζ.
bool isAffine(const Mat38& corners) {
  const double size = (corners.col(7) - corners.col(0)).norm();
  for (int i = 0; i < 8; ++i) {
    Vec3 wanted = corners.col(0);
    for (int a = 0; a < 3; ++a)
      if (i >> a & 1) wanted += corners.col(1 << a) - corners.col(0);
    if ((corners.col(i) - wanted).norm() > 1e-9 * size) return false;
  }
  return true;
}

/// Strain that the corners' displacements make, of no higher degree than one in each of ξ, η, ζ, so that the moments integrate its
/// squares exactly. Their weights may be negative: what they do not integrate exactly may come out with a negative stiffness,
/// and does in a cell twisted by its band whose tissue is thin. A twisted cell has the trilinear field through the true
/// strains at the mean of the tissue ± its standard deviations (Gauss's points of a full cell), its mean over the tissue made the true one,
/// as Hughes, Int. J. Numer. Methods Eng. 15, 1980, replaces parts of B; constant strains stay what they are.
class CornerStrains {
 public:
  CornerStrains(const Mat38& corners, const BoxMoments& tissue, const Mat38& meanGradients) : m_corners(corners) {
    if (isAffine(corners)) return;
    constexpr double kLeastWidth = 1e-3;
    const Vec3 mean = meanOf(tissue), width = varianceOf(tissue).cwiseMax(0.0).cwiseSqrt().cwiseMax(kLeastWidth);
    m_low = mean - width;
    m_wide = 2 * width;
    for (int k = 0; k < 8; ++k) {
      const Vec3 at = m_low + Vec3(k & 1, k >> 1 & 1, k >> 2).cwiseProduct(m_wide);
      m_known.push_back(strainsOf(shapeGradients({at.x(), at.y(), at.z()}, corners)));
    }
    Mat6x24 sum = Mat6x24::Zero();
    for (const BoxPoint& point : boxPoints(tissue)) sum += point.weight * at(point.xi);
    m_shift = strainsOf(meanGradients) - sum / tissue.volume();
  }

  Mat6x24 at(const std::array<double, 3>& xi) const {
    if (m_known.empty()) return strainsOf(shapeGradients(xi, m_corners));
    Mat6x24 B = m_shift;
    for (int k = 0; k < 8; ++k) {
      double share = 1;
      for (int a = 0; a < 3; ++a) {
        const double along = (xi[a] - m_low[a]) / m_wide[a];
        share *= k >> a & 1 ? along : 1 - along;
      }
      B += share * m_known[k];
    }
    return B;
  }

 private:
  Mat38 m_corners;
  Vec3 m_low = Vec3::Zero(), m_wide = Vec3::Ones();
  std::vector<Mat6x24> m_known;  ///< none where the cell is not twisted
  Mat6x24 m_shift = Mat6x24::Zero();
};

/// K_uu − K_ua K_aa⁻¹ K_uaᵀ, and what the modes do, into `modes`, whose corners are given.
Mat24 condensedStiffness(std::span<const CellTissue> tissue, const Mat38& meanGradients, CellModes& modes) {
  BoxMoments all;
  for (const CellTissue& t : tissue) all += t.moments;
  const Vec3 centroid = meanOf(all);
  const CornerStrains strains(modes.corners_E, all, meanGradients);
  modes.inMiddle_E = toGradients({0, 0, 0}, modes.corners_E);
  modes.mean = modeStrains({centroid.x(), centroid.y(), centroid.z()}, modes.inMiddle_E);
  Mat24 K = Mat24::Zero();
  Eigen::Matrix<double, 24, 9> Kua = Eigen::Matrix<double, 24, 9>::Zero();
  Mat9 Kaa = Mat9::Zero();
  Lame stiffest;
  for (const CellTissue& t : tissue) {
    const Mat6 D = elasticityOf(t.lame);
    stiffest = {std::max(stiffest.lambda, t.lame.lambda), std::max(stiffest.mu, t.lame.mu)};
    for (const BoxPoint& point : boxPoints(t.moments)) {
      const Mat6x24 B = strains.at(point.xi);
      const Mat6x9 E = modeStrains(point.xi, modes.inMiddle_E) - modes.mean;
      const Mat6x24 stress = D * B;
      K += point.weight * B.transpose() * stress;
      Kua += point.weight * stress.transpose() * E;
      Kaa += point.weight * E.transpose() * D * E;
    }
  }
  // A share of the full cell's own: ∫ (2 ξ_a |∇ξ_a|)² over it is 4 V |∇ξ_a|² / 3.
  const double whole = 8 / modes.inMiddle_E.determinant();
  for (int a = 0; a < 3; ++a) {
    const Mat6x3 G = strainOf(modes.inMiddle_E.col(a));
    const Mat3 own = G.transpose() * elasticityOf(stiffest) * G;
    Kaa.block<3, 3>(3 * a, 3 * a) += kModeFloor * whole * 4 / 3 * own;
  }
  modes.response = -Kaa.llt().solve(Kua.transpose());
  return K + Kua * modes.response;
}

/// Torque that is left when R is held, Σ y_i × p_i, and the turning vector it makes of R's dependence on the corners.
Vec3 turningOf(const Mat38& y, const Mat38& p, const Mat3& S) {
  Vec3 torque = Vec3::Zero();
  for (int i = 0; i < 8; ++i) torque += y.col(i).cross(p.col(i));
  const Mat3 H = S.trace() * Mat3::Identity() - S;
  const double m = 9 * H.determinant() / (H.trace() * H.trace());
  if (!(m > kTurnNone)) return Vec3::Zero();
  return std::min(1.0, (m - kTurnNone) / (kTurnWhole - kTurnNone)) * (H.inverse() * torque);
}

/// Corners in E less the first.
Mat38 turnedBack(const Mat38& x_W, const Mat3& R_WE) { return R_WE.transpose() * (x_W.colwise() - x_W.col(0)); }

Mat38 pullOf(const CorotCell& cell, const Mat38& y) {
  const Mat38 u = y - cell.x0_E;
  const Eigen::Matrix<double, 24, 1> p = cell.K_E * u.reshaped();
  return p.reshaped(3, 8);
}

}  // namespace

Mat38 cornersOf(const CellBox& box) {
  Mat38 x;
  for (int i = 0; i < 8; ++i) x.col(i) = box.origin + box.axes * Vec3(i & 1, i >> 1 & 1, i >> 2).cwiseProduct(box.edges);
  return x;
}

Result<CorotCell> makeCorotCell(const Mat38& corners, std::span<const CellTissue> tissue, CellModes* modes) {
  CorotCell cell;
  cell.lame = {0, 0};
  cell.x0_E = corners.colwise() - corners.col(0);
  cell.gradients_E = Mat38::Zero();
  for (const CellTissue& t : tissue) {
    cell.volume += t.moments.volume();
    cell.lame.lambda += t.moments.volume() * t.lame.lambda;
    cell.lame.mu += t.moments.volume() * t.lame.mu;
  }
  const Mat3 J = cell.x0_E * shapeDerivatives({0, 0, 0}).transpose();
  if (!(J.determinant() > 0) || !(cell.volume > 0))
    return Error{Fault::BadElement, {}, {std::to_string(cell.volume)}, "a cell without edges or tissue"};
  for (const CellTissue& t : tissue)
    for (const BoxPoint& point : boxPoints(t.moments)) cell.gradients_E += point.weight / cell.volume * shapeGradients(point.xi, cell.x0_E);
  cell.lame = {cell.lame.lambda / cell.volume, cell.lame.mu / cell.volume};
  cell.lameLow = tissue.size() == 1 ? tissue[0].lame : meanCompliance(tissue, cell.volume);
  CellModes inside;
  inside.corners_E = cell.x0_E;
  const Mat24 K = condensedStiffness(tissue, cell.gradients_E, inside);
  if (modes) *modes = inside;
  cell.K_E = 0.5 * (K + K.transpose());
  return cell;
}

Mat8 cellMassShape(const BoxMoments& moments) {
  Mat8 M = Mat8::Zero();
  for (const BoxPoint& point : boxPoints(moments)) {
    Eigen::Matrix<double, 8, 1> N;
    for (int i = 0; i < 8; ++i)
      N[i] = 0.125 * (1 + cornerSign(i, 0) * point.xi[0]) * (1 + cornerSign(i, 1) * point.xi[1]) * (1 + cornerSign(i, 2) * point.xi[2]);
    M += point.weight * N * N.transpose();
  }
  return M;
}

Mat3 deformationGradient(const CorotCell& cell, const Mat38& x_W) {
  return (x_W.colwise() - x_W.col(0)) * cell.gradients_E.transpose();
}

Mat38 elasticForce(const CorotCell& cell, const Mat38& x_W, const Mat3& F, const Mat3& R_WE) {
  const Mat38 y = turnedBack(x_W, R_WE), p = pullOf(cell, y);
  const Mat3 M = R_WE.transpose() * F;
  const Vec3 turning = turningOf(y, p, 0.5 * (M + M.transpose()));
  return -R_WE * (p - skew(turning) * cell.gradients_E);
}

double elasticEnergy(const CorotCell& cell, const Mat38& x_W, const Mat3& R_WE) {
  const Mat38 y = turnedBack(x_W, R_WE);
  return 0.5 * (y - cell.x0_E).cwiseProduct(pullOf(cell, y)).sum();
}

double tensionStiffness(const CorotCell& cell, const Mat3& F, const Mat3& R_WE) {
  CorotTet mean;
  mean.volume = cell.volume;
  mean.lame = cell.lame;
  return tensionStiffness(mean, F, R_WE);
}

}  // namespace glenoid
