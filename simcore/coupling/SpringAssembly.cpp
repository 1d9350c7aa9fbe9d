// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/coupling/SpringAssembly.h"

namespace glenoid {

namespace {

/// J of p_a − p_b as three rows: term t has its block and the 3×3 whose row d is the coefficient for axis d.
struct SpringTerms {
  int count = 0;
  std::array<int, 2 * kMaxPointTerms> block;
  std::array<Mat3, 2 * kMaxPointTerms> jacobian;
};

void appendSide(const ContactObject& object, const MaterialPoint& point, int base, double sign, const VecX& q,
                SpringTerms& terms) {
  if (base < 0) return;
  RowTerm rows[kMaxPointTerms];
  int count = 0;
  for (int axis = 0; axis < 3; ++axis) {
    count = object.rowTerms(point, sign * Vec3::Unit(axis), q, base, rows);
    for (int i = 0; i < count; ++i) {
      terms.block[terms.count + i] = rows[i].block;
      terms.jacobian[terms.count + i].row(axis) = rows[i].coefficient.transpose();
    }
  }
  terms.count += count;
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
    b.segment<3>(3 * terms.block[i]) += terms.jacobian[i].transpose() * impulse;
    const Mat3 scaled = scale * terms.jacobian[i].transpose();
    for (int j = 0; j <= i; ++j) A.add(spring.entries[at++], scaled * terms.jacobian[j]);
  }
}

}  // namespace glenoid
