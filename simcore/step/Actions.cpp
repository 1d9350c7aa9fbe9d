// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/step/Actions.h"

namespace glenoid {

namespace {

/// Adds Jᵀ f of a force at a point to a right-hand side.
void addForce(const ContactObject& object, const MaterialPoint& point, int base, const Vec3& force_W, const VecX& q, VecX& b) {
  RowTerm terms[kMaxPointTerms];
  const int count = object.rowTerms(point, force_W, q, base, terms);  // linear in the direction
  for (int i = 0; i < count; ++i) b.segment<3>(3 * terms[i].block) += terms[i].coefficient;
}

/// Vector area of a flat triangle, m², outwards.
Vec3 areaOf(const Vec3& a, const Vec3& b, const Vec3& c) { return 0.5 * (b - a).cross(c - a); }

}  // namespace

void assembleLoad(const BoundLoad& load, const ContactObject& object, double dt, const VecX& q, VecX& b) {
  if (load.spread)
    object.addUniform(dt / object.mass() * load.force_W, b.segment(3 * load.base, 3 * object.blockCount()));
  else
    addForce(object, load.point, load.base, dt * load.force_W, q, b);
  if (object.layout().rigid) b.segment<3>(3 * load.base + 3) += dt * load.torque_W;
}

void assemblePressure(const BoundPressure& pressure, const ContactObject& object, double dt, const VecX& q, std::vector<Vec3>& scratch,
                      VecX& b) {
  const std::size_t count = pressure.points.size();
  for (std::size_t k = 0; k < count; ++k) {
    scratch[k] = object.position(pressure.points[k], q);
    scratch[count + k].setZero();
  }
  for (const auto& t : pressure.triangles) {
    const Vec3 third = -dt * pressure.value / 3 * areaOf(scratch[t[0]], scratch[t[1]], scratch[t[2]]);
    for (const int corner : t) scratch[count + static_cast<std::size_t>(corner)] += third;
  }
  for (std::size_t k = 0; k < count; ++k) addForce(object, pressure.points[k], pressure.base, scratch[count + k], q, b);
}

Vec6 pressureWrench(const BoundPressure& pressure, const ContactObject& object, const VecX& q) {
  Vec6 sum = Vec6::Zero();
  for (const auto& t : pressure.triangles) {
    const Vec3 a = object.position(pressure.points[t[0]], q), b = object.position(pressure.points[t[1]], q),
               c = object.position(pressure.points[t[2]], q);
    const Vec3 force = -pressure.value * areaOf(a, b, c);
    sum.head<3>() += force;
    sum.tail<3>() += ((a + b + c) / 3).cross(force);
  }
  return sum;
}

void assembleSupport(const BoundSupport& support, double dt, const VecX& q, BlockMatrix& A, VecX& b) {
  RowTerm rows[3][kMaxPointTerms];
  int count = 0;
  for (int axis = 0; axis < 3; ++axis) count = support.object->rowTerms(support.point, Vec3::Unit(axis), q, support.base, rows[axis]);
  const Vec3 scale = dt * dt * support.stiffness + dt * support.damping;
  const Vec3 impulse = -dt * support.stiffness.cwiseProduct(support.object->position(support.point, q) - support.rest_W);
  int at = 0;
  for (int i = 0; i < count; ++i) {
    Mat3 scaled;  // Jᵢᵀ diag(scale)
    for (int axis = 0; axis < 3; ++axis) {
      b.segment<3>(3 * rows[axis][i].block) += impulse[axis] * rows[axis][i].coefficient;
      scaled.col(axis) = scale[axis] * rows[axis][i].coefficient;
    }
    for (int j = 0; j <= i; ++j) {
      Mat3 block = Mat3::Zero();
      for (int axis = 0; axis < 3; ++axis) block += scaled.col(axis) * rows[axis][j].coefficient.transpose();
      A.add(support.entries[at++], block);
    }
  }
}

}  // namespace glenoid
