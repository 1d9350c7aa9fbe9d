// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hard/Energy.h"

#include <algorithm>

#include "simcore/body/RigidObject.h"
#include "simcore/step/StepModel.h"

namespace glenoid::hard {

namespace {

/// Energies below this say nothing: a nanojoule lifts a gram by a tenth of a micrometre.
constexpr double kNothing = 1e-9;

/// The angular velocity that the step solved for. The body has since turned and its inertia with it; its angular
/// momentum is what stayed.
Vec3 solvedOmega(const RigidObject& body, const State& before, const State& after) {
  const int offset = body.layout().vOffset + 3;
  const auto inertia = [&](const State& state) {
    const Mat3 R = body.pose(state.q).q_WB.toRotationMatrix();
    return Mat3(R * body.properties().inertia * R.transpose());
  };
  return inertia(before).inverse() * (inertia(after) * after.v.segment<3>(offset));
}

}  // namespace

EnergyBooks::EnergyBooks(std::shared_ptr<const Model> model, const State& start) : m_model(std::move(model)) {
  m_start = m_energy = energyOf(start);
  m_most = std::max(m_start, kNothing);
}

double EnergyBooks::energyOf(const State& state) const {
  double sum = 0;
  for (const auto& object : m_model->inside->objects) sum += object->kineticEnergy(state) + object->elasticEnergy(state);
  for (const SpringView& spring : m_model->springs) {
    const ContactObject &a = *m_model->inside->objects[spring.objectA], &b = *m_model->inside->objects[spring.objectB];
    const Vec3 stretch = a.position(pointAt(spring.a, a.layout().rigid), state.q) -
                         b.position(pointAt(spring.b, b.layout().rigid), state.q);
    sum += 0.5 * spring.stiffness * stretch.squaredNorm();
  }
  return sum;
}

double EnergyBooks::workOf(const State& before, const State& after, double dt) const {
  const StepModel& inside = *m_model->inside;
  double work = 0;
  for (std::size_t i = 0; i < inside.objects.size(); ++i)
    if (!m_model->objects[i].tool) work += dt * inside.settings.gravity_W.dot(inside.objects[i]->momentum(after).head<3>());
  for (const CouplingIslandModel& island : inside.islands)
    for (const BoundPoseSpring& bound : island.poseSprings) {
      const auto& body = static_cast<const RigidObject&>(*inside.objects[bound.object]);
      const PoseSpring& spring = bound.spring;
      const PoseTarget target = bound.tool < 0 ? bound.rest
                                               : handTarget(poseAt(after.hands, 7 * bound.tool), poseAt(before.hands, 7 * bound.tool), dt);
      const Vec6 wrench = driveWrench(spring, body, target, before.q);
      const Vec3 lever = body.pose(before.q).q_WB * spring.anchor_B;
      const Vec3 omega = solvedOmega(body, before, after);
      const Vec3 velocity = after.v.segment<3>(body.layout().vOffset) + omega.cross(lever);
      const double k = dt * dt * spring.stiffness + dt * spring.damping;
      const double kAngular = dt * dt * spring.angularStiffness + dt * spring.angularDamping;
      work += (dt * wrench.head<3>() - k * velocity).dot(velocity) + (dt * wrench.tail<3>() - kAngular * omega).dot(omega);
    }
  return work;
}

void EnergyBooks::add(const State& before, const State& after, double dt) {
  m_work += workOf(before, after, dt);
  m_energy = energyOf(after);
  m_most = std::max(m_most, m_start + m_work);
}

double EnergyBooks::excess() const { return (m_energy - m_start - m_work) / m_most; }

}  // namespace glenoid::hard
