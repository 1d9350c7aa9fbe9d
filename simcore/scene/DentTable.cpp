// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/DentTable.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "simcore/base/PlainMath.h"

namespace glenoid {

namespace {

/// How far two places are from each other, m.
double apart(const Vec3& a, const DentField::Facing& facingA, const Vec3& b, const DentField::Facing& facingB) {
  const double turn = DentField::kTurn * std::max(0.0, 1 - facingA.normal_W.dot(facingB.normal_W));
  const double other = facingA.tissue == facingB.tissue ? 0 : DentField::kOther;
  return std::sqrt((a - b).squaredNorm() + turn * turn + other * other);
}

}  // namespace

DentField::DentField(const DentTable& table, std::span<const Facing> facings) : m_radii(table.radii) {
  const auto n = static_cast<Eigen::Index>(table.samples.size());
  if (n == 0) return;
  m_least.fill(1e300);
  m_most.fill(-1e300);
  MatX A = MatX::Zero(n + 1, n + 1), values = MatX::Zero(n + 1, static_cast<Eigen::Index>(kValues));
  for (Eigen::Index i = 0; i < n; ++i) {
    const DentSample& sample = table.samples[static_cast<std::size_t>(i)];
    m_places.push_back({sample.at_W, facings[static_cast<std::size_t>(i)], {}});
    Values of{plain::logarithm(sample.modulus)};
    for (std::size_t k = 0; k < DentSample::kRadii; ++k) of[k + 1] = plain::logarithm(sample.compliance[k]);
    of[kValues - 1] = sample.depthMost;
    for (std::size_t k = 0; k < kValues; ++k) {
      values(i, static_cast<Eigen::Index>(k)) = of[k];
      m_least[k] = std::min(m_least[k], of[k]);
      m_most[k] = std::max(m_most[k], of[k]);
    }
  }
  constexpr double kSame = 1e-5;  // m: samples at one place make no system without a solution
  for (Eigen::Index i = 0; i < n; ++i) {
    const Place& a = m_places[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < n; ++j) {
      const Place& b = m_places[static_cast<std::size_t>(j)];
      A(i, j) = i == j ? -kSame : apart(a.at_W, a.facing, b.at_W, b.facing);
    }
    A(i, n) = A(n, i) = 1;
  }
  const MatX solved = A.partialPivLu().solve(values);
  for (std::size_t k = 0; k < kValues; ++k) {
    for (Eigen::Index i = 0; i < n; ++i) m_places[static_cast<std::size_t>(i)].factor[k] = solved(i, static_cast<Eigen::Index>(k));
    m_even[k] = solved(n, static_cast<Eigen::Index>(k));
  }
}

TissueGive DentField::at(const Vec3& place_W, const Facing& facing) const {
  Values value = m_even;
  for (const Place& place : m_places) {
    const double far = apart(place_W, facing, place.at_W, place.facing);
    for (std::size_t k = 0; k < kValues; ++k) value[k] += far * place.factor[k];
  }
  for (std::size_t k = 0; k < kValues; ++k) value[k] = std::clamp(value[k], m_least[k], m_most[k]);
  TissueGive give{plain::exponential(value[0]), {}, value[kValues - 1]};
  for (std::size_t k = 0; k < DentSample::kRadii; ++k) give.compliance[k] = plain::exponential(value[k + 1]);
  return give;
}

}  // namespace glenoid
