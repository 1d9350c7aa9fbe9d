// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/body/RigidObject.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "simcore/base/Turns.h"

namespace glenoid {

Result<MassProperties> massPropertiesOf(const TriMesh& surface, double density) {
  // Sum over tetrahedra (o, a, b, c) with o near the mesh; second moments by the quadrature that is exact for
  // quadratics: ∫ x xᵀ = V/20 (Σ x_i x_iᵀ + (Σ x_i)(Σ x_i)ᵀ) with the vertex o at zero.
  const Vec3 o = boundsOf(surface).center();
  double volume = 0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  for (const auto& t : surface.triangles) {
    const Vec3 a = surface.vertices[t[0]] - o, b = surface.vertices[t[1]] - o, c = surface.vertices[t[2]] - o;
    const double v = a.dot(b.cross(c)) / 6;
    const Vec3 sum = a + b + c;
    volume += v;
    first += v / 4 * sum;
    second += v / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  if (!(volume > 0)) return Error{Fault::BadMesh, {}, {"volume"}, "the surface encloses no positive volume"};
  const Vec3 centre = first / volume;
  const Mat3 central = second - volume * centre * centre.transpose();
  return MassProperties{density * volume, o + centre,
                        density * (central.trace() * Mat3::Identity() - central)};
}

RigidObject::RigidObject(const ObjectLayout& layout, const MassProperties& properties, double massDamping, bool withWeight)
    : ContactObject(layout), m_properties(properties), m_massDamping(massDamping), m_withWeight(withWeight) {}

void RigidObject::appendBlockPairs(int, std::vector<std::array<int, 2>>&) const {}

std::vector<BlockEntry> RigidObject::blockEntries(const BlockSymbolic& symbolic, int base) const {
  if (!layout().free) return {};
  return {symbolic.entry(base, base), symbolic.entry(base + 1, base + 1)};
}

Mat3 RigidObject::inertia_W(const VecX& q) const {
  const Mat3 R = pose(q).q_WB.toRotationMatrix();
  return R * m_properties.inertia * R.transpose();
}

void RigidObject::assemble(const StepSettings& settings, const State& state, std::span<const BlockEntry> entries, VecX&,
                           BlockMatrix& A, Eigen::Ref<VecX> b) const {
  const double dt = settings.dt;
  const double drag = settings.damping ? 1 + dt * m_massDamping : 1;
  const Mat3 I_W = inertia_W(state.q);
  const Vec3 velocity = state.v.segment<3>(layout().vOffset), omega = state.v.segment<3>(layout().vOffset + 3);
  A.add(entries[0], drag * m_properties.mass * Mat3::Identity());
  A.add(entries[1], drag * I_W);
  b.segment<3>(0) += m_properties.mass * velocity;
  if (m_withWeight) b.segment<3>(0) += dt * m_properties.mass * settings.gravity_W;
  b.segment<3>(3) += I_W * omega;  // what turning does to ω is in advance()
}

void RigidObject::advance(double dt, State& state) const {
  if (!layout().free) return;
  Pose pose = poseAt(state.q, layout().qOffset);
  pose.p_WB += dt * state.v.segment<3>(layout().vOffset);
  auto omega = state.v.segment<3>(layout().vOffset + 3);
  if (!omega.isZero(0)) {
    // Turns freely with its angular momentum kept: with Ω = I⁻¹ (L + L')/2 in body axes and the turn exp(h Ω), the new
    // momentum L' = exp(−h Ω) L differs from L at right angles to Ω, so the energy ½ L·I⁻¹L stays to the last digits.
    constexpr double kTurnMax = 0.25;  // rad in one go: there the fixed point below contracts well
    constexpr int kTurnsMost = 64, kRounds = 30;
    const Mat3& inertia = m_properties.inertia;
    const Mat3 inverse = inertia.inverse();
    const Vec3 momentum_W = pose.q_WB * (inertia * (pose.q_WB.conjugate() * omega));
    const int turns = static_cast<int>(std::min<double>(kTurnsMost, std::ceil(dt * omega.norm() / kTurnMax)));
    const double h = dt / turns;
    for (int turn = 0; turn < turns; ++turn) {
      const Vec3 L = pose.q_WB.conjugate() * momentum_W;
      Vec3 spin = inverse * L;
      for (int round = 0; round < kRounds; ++round) {
        const Vec3 next = 0.5 * (inverse * (L + turnBy(-h * spin) * L));
        const double change = (next - spin).norm();
        spin = next;
        if (change <= 1e-15 * spin.norm()) break;
      }
      pose.q_WB = (pose.q_WB * turnBy(h * spin)).normalized();
    }
    omega = pose.q_WB * (inverse * (pose.q_WB.conjugate() * momentum_W));
  }
  setPoseAt(state.q, layout().qOffset, pose);
}

Vec3 RigidObject::position(const MaterialPoint& point, const VecX& q) const { return pose(q) * point.r_B; }

Vec3 RigidObject::velocity(const MaterialPoint& point, const VecX& q, const VecX& v) const {
  if (!layout().free) return Vec3::Zero();
  return v.segment<3>(layout().vOffset) + v.segment<3>(layout().vOffset + 3).cross(pose(q).q_WB * point.r_B);
}

int RigidObject::rowTerms(const MaterialPoint& point, const Vec3& d, const VecX& q, int base, RowTerm* terms) const {
  if (!layout().free) return 0;
  terms[0] = {base, d};
  terms[1] = {base + 1, (pose(q).q_WB * point.r_B).cross(d)};  // d·(ω × r) = ω·(r × d)
  return 2;
}

double RigidObject::kineticEnergy(const State& state) const {
  if (!layout().free) return 0;
  const Vec3 omega = state.v.segment<3>(layout().vOffset + 3);
  return 0.5 * m_properties.mass * state.v.segment<3>(layout().vOffset).squaredNorm() +
         0.5 * omega.dot(inertia_W(state.q) * omega);
}

Vec6 RigidObject::momentum(const State& state) const {
  if (!layout().free) return Vec6::Zero();
  return momentumOf(state.q, state.v.segment<6>(layout().vOffset));
}

Vec6 RigidObject::momentumOf(const VecX& q, const Eigen::Ref<const VecX>& v) const {
  Vec6 sum;
  sum.head<3>() = m_properties.mass * v.head<3>();
  sum.tail<3>() = pose(q).p_WB.cross(sum.head<3>()) + inertia_W(q) * v.tail<3>();
  return sum;
}

void RigidObject::addUniform(const Vec3& acceleration_W, Eigen::Ref<VecX> f) const {
  f.head<3>() += m_properties.mass * acceleration_W;
}

}  // namespace glenoid
