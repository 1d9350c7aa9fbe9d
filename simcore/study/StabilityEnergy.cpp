// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/StabilityEnergy.h"

#include <algorithm>

#include "simcore/body/RigidObject.h"
#include "simcore/step/StepModel.h"

namespace glenoid {

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

/// Of a point with the velocities that the step solved for, at the place where it put the force.
Vec3 velocityOf(const ContactObject& object, const MaterialPoint& point, const State& before, const State& after) {
  if (!object.layout().rigid) return object.velocity(point, before.q, after.v);
  const auto& body = static_cast<const RigidObject&>(object);
  return after.v.segment<3>(object.layout().vOffset) + solvedOmega(body, before, after).cross(body.pose(before.q).q_WB * point.r_B);
}

double powerOf(const BoundLoad& load, const ContactObject& object, const State& before, const State& after) {
  double power = load.spread ? load.force_W.dot(object.momentum(after).head<3>()) / object.mass()
                             : load.force_W.dot(velocityOf(object, load.point, before, after));
  if (object.layout().rigid) power += load.torque_W.dot(solvedOmega(static_cast<const RigidObject&>(object), before, after));
  return power;
}

double powerOf(const BoundPressure& pressure, const ContactObject& object, const State& before, const State& after) {
  double power = 0;
  for (const auto& t : pressure.triangles) {
    const Vec3 a = object.position(pressure.points[t[0]], before.q), b = object.position(pressure.points[t[1]], before.q),
               c = object.position(pressure.points[t[2]], before.q);
    const Vec3 third = -pressure.value / 6 * (b - a).cross(c - a);
    for (const int corner : t) power += third.dot(velocityOf(object, pressure.points[corner], before, after));
  }
  return power;
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
  // What the step took of the loads: the time of a state stays through the parts of a step.
  const double loaded = dt * loadShareAt(m_model->scenario, before.time + dt);
  for (const CouplingIslandModel& island : inside.islands) {
    for (const BoundLoad& load : island.loads) work += loaded * powerOf(load, *inside.objects[load.object], before, after);
    for (const BoundPressure& pressure : island.pressures) work += dt * powerOf(pressure, *inside.objects[pressure.object], before, after);
    for (const BoundSupport& support : island.supports) {
      const Vec3 velocity = velocityOf(*support.object, support.point, before, after);
      const Vec3 stretch = support.object->position(support.point, before.q) - support.rest_W;
      const Vec3 impulse = -dt * support.stiffness.cwiseProduct(stretch) - (dt * dt * support.stiffness + dt * support.damping).cwiseProduct(velocity);
      work += impulse.dot(velocity);
    }
    for (const BoundPoseSpring& bound : island.poseSprings) {
      const auto& body = static_cast<const RigidObject&>(*inside.objects[bound.object]);
      const PoseSpring& spring = bound.spring;
      const PoseTarget target = bound.tool < 0 ? bound.rest
                                               : handTarget(poseAt(after.hands, 7 * bound.tool), poseAt(before.hands, 7 * bound.tool), dt);
      const Vec6 wrench = driveWrench(spring, body, target, before.q);
      const Vec3 lever = body.pose(before.q).q_WB * spring.anchor_B;
      const Vec3 omega = solvedOmega(body, before, after);
      const Vec3 velocity = after.v.segment<3>(body.layout().vOffset) + omega.cross(lever);
      const Vec3 k = (dt * dt * spring.stiffness + dt * spring.damping) * spring.axes;
      const Vec3 kAngular = (dt * dt * spring.angularStiffness + dt * spring.angularDamping) * spring.angularAxes;
      work += (dt * wrench.head<3>() - k.cwiseProduct(velocity)).dot(velocity) + (dt * wrench.tail<3>() - kAngular.cwiseProduct(omega)).dot(omega);
    }
  }
  return work;
}

void EnergyBooks::take(double work, const State& after) {
  m_work += work;
  m_energy = energyOf(after);
  m_most = std::max(m_most, m_start + m_work);
}

void EnergyBooks::add(const State& before, const State& after, double dt) { take(workOf(before, after, dt), after); }

void EnergyBooks::push(const State& before, const State& after) {
  double work = 0;
  for (const auto& object : m_model->inside->objects) work += object->kineticEnergy(after) - object->kineticEnergy(before);
  take(work, after);
}

}  // namespace glenoid
