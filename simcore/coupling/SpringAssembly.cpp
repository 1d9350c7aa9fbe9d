// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/coupling/SpringAssembly.h"

namespace glenoid {

namespace {

/// J of p_a − p_b, term by term: a multiple of the identity where a block moves the point as it moves itself (nodes, a
/// rigid body's centre), else a 3×3 whose row d is the coefficient for axis d.
struct SpringTerms {
  int count = 0;
  std::array<int, 2 * kMaxPointTerms> block;
  std::array<bool, 2 * kMaxPointTerms> plain;
  std::array<double, 2 * kMaxPointTerms> weight;    ///< plain
  std::array<Mat3, 2 * kMaxPointTerms> jacobian;    ///< not plain
};

void appendSide(const ContactObject& object, const MaterialPoint& point, int base, double sign, const VecX& q,
                SpringTerms& terms) {
  if (base < 0) return;
  RowTerm rows[3][kMaxPointTerms];
  const bool nodes = point.count > 0;  // one axis says all
  int count = 0;
  for (int axis = 0; axis < (nodes ? 1 : 3); ++axis) count = object.rowTerms(point, sign * Vec3::Unit(axis), q, base, rows[axis]);
  for (int i = 0; i < count; ++i) {
    const int t = terms.count++;
    terms.block[t] = rows[0][i].block;
    terms.plain[t] = nodes || i == 0;
    terms.weight[t] = rows[0][i].coefficient.x();
    if (!terms.plain[t])
      for (int axis = 0; axis < 3; ++axis) terms.jacobian[t].row(axis) = rows[axis][i].coefficient.transpose();
  }
}

SpringTerms termsOf(const BoundSpring& spring, const VecX& q) {
  SpringTerms terms;
  appendSide(*spring.a, spring.pointA, spring.baseA, 1, q, terms);
  appendSide(*spring.b, spring.pointB, spring.baseB, -1, q, terms);
  return terms;
}

}  // namespace

void appendSpringPairs(const BoundSpring& spring, const VecX& q, std::vector<std::array<int, 2>>& pairs) {
  const SpringTerms terms = termsOf(spring, q);
  for (int i = 0; i < terms.count; ++i)
    for (int j = 0; j < i; ++j) pairs.push_back({terms.block[i], terms.block[j]});
}

void bindSpring(BoundSpring& spring, const VecX& q, const BlockSymbolic& symbolic) {
  const SpringTerms terms = termsOf(spring, q);
  spring.entries.clear();
  for (int i = 0; i < terms.count; ++i)
    for (int j = 0; j <= i; ++j) spring.entries.push_back(symbolic.entry(terms.block[i], terms.block[j]));
}

void assembleSpring(const BoundSpring& spring, double dt, const VecX& q, BlockMatrix& A, VecX& b, const Vec3& drift_W) {
  const SpringTerms terms = termsOf(spring, q);
  const Vec3 stretch = spring.a->position(spring.pointA, q) - spring.b->position(spring.pointB, q);
  const double scale = dt * dt * spring.stiffness + dt * spring.damping;
  const Vec3 impulse = -dt * spring.stiffness * stretch - scale * drift_W;
  int at = 0;
  for (int i = 0; i < terms.count; ++i) {
    auto push = b.segment<3>(3 * terms.block[i]);
    if (terms.plain[i])
      push += terms.weight[i] * impulse;
    else
      push += terms.jacobian[i].transpose() * impulse;
    for (int j = 0; j <= i; ++j) {
      const BlockEntry entry = spring.entries[at++];
      if (terms.plain[i] && terms.plain[j]) {
        const double k = scale * terms.weight[i] * terms.weight[j];
        double* slot = A.slot(entry.slot);
        for (int c = 0; c < 3; ++c) slot[5 * c] += k;
      } else if (terms.plain[i]) {
        A.add(entry, scale * terms.weight[i] * terms.jacobian[j]);
      } else if (terms.plain[j]) {
        A.add(entry, scale * terms.weight[j] * terms.jacobian[i].transpose());
      } else {
        A.add(entry, scale * terms.jacobian[i].transpose() * terms.jacobian[j]);
      }
    }
  }
}

}  // namespace glenoid
