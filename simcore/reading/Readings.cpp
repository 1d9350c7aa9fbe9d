// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/reading/Readings.h"

#include <Eigen/Cholesky>

#include "simcore/body/RigidObject.h"
#include "simcore/fem/Rotation.h"
#include "simcore/step/Actions.h"

namespace glenoid {

namespace {

/// Velocities of an object alone that moves as one rigid body, whether or not it is free.
VecX rigidMotion(const ObjectLayout& layout, const VecX& q, const Twist& twist) {
  if (layout.rigid) {
    VecX v(6);
    v << twist.of(q.segment<3>(layout.qOffset)), twist.omega_W;
    return v;
  }
  VecX v(3 * layout.nodeCount);
  for (int node = 0; node < layout.nodeCount; ++node) v.segment<3>(3 * node) = twist.of(q.segment<3>(layout.qOffset + 3 * node));
  return v;
}

/// How a motion moved its object in the last step; at rest for every other.
Twist lastTwist(const Model& model, const State& state, int object) {
  const int motion = model.objects[object].motion;
  if (motion < 0) return {};
  return twistOf(model.scenario.motions[motion], state.time - model.scenario.dt, state.time);
}

VecX velocitiesOf(const Model& model, const State& state, int object) {
  const ObjectLayout& layout = model.objects[object].layout;
  if (layout.free) return state.v.segment(layout.vOffset, layout.vSize);
  return rigidMotion(layout, state.q, lastTwist(model, state, object));
}

/// Rotation R with the greatest Σ m (x − c)·R (X − C) over the mass of a soft object, X at rest. The sums come from momenta:
/// with velocities X_k e_j the linear one is Σ m X_k e_j, the angular one Σ m X_k x × e_j.
Quat bestTurn(const SceneObject& object, const ContactObject& dynamics, const VecX& q, const Vec3& centre_W) {
  const std::vector<Vec3>& rest = object.volume->nodes;
  Mat3 sums;
  Vec3 first;
  for (int k = 0; k < 3; ++k) {
    const auto alongAxis = [&](int axis) {
      VecX v = VecX::Zero(3 * object.layout.nodeCount);
      for (int node = 0; node < object.layout.nodeCount; ++node) v[3 * node + axis] = rest[node][k];
      return dynamics.momentumOf(q, v);
    };
    const Vec6 x = alongAxis(0), y = alongAxis(1);
    first[k] = x[0];
    sums.col(k) = Vec3(y[5], -x[5], x[4]);
  }
  const Mat3 correlation = sums - centre_W * first.transpose();
  const double size = correlation.norm();
  return size > 0 ? rotationBySvd(correlation / size) : Quat::Identity();
}

/// Forces at points, gathered about their mean by weight.
class Gather {
 public:
  void add(const Vec3& point_W, const Vec3& force_W, double weight) {
    m_weight += weight;
    m_first += weight * point_W;
    m_force += force_W;
    m_torque += point_W.cross(force_W);
  }
  Wrench wrench() const {
    const Vec3 point = m_weight > 0 ? Vec3(m_first / m_weight) : Vec3::Zero();
    return {point, m_force, m_torque - point.cross(m_force)};
  }

 private:
  double m_weight = 0;
  Vec3 m_first = Vec3::Zero(), m_force = Vec3::Zero(), m_torque = Vec3::Zero();
};

void readActions(const Model& model, const State& state, SceneReading& out) {
  std::vector<Gather> supports(model.scenario.supports.size());
  std::vector<char> acts(supports.size(), 0);
  std::vector<std::pair<int, ActionReading>> pressures;
  for (const CouplingIslandModel& island : model.inside->islands) {
    for (const BoundSupport& bound : island.supports) {
      const Vec3 p = bound.object->position(bound.point, state.q);
      supports[bound.support].add(p,
                                  -bound.stiffness.cwiseProduct(p - bound.rest_W) -
                                      bound.damping.cwiseProduct(bound.object->velocity(bound.point, state.q, state.v)),
                                  bound.stiffness.sum());
      acts[bound.support] = 1;
    }
    for (const BoundPressure& bound : island.pressures) {
      const ContactObject& object = *model.inside->objects[bound.object];
      const Vec6 sum = pressureWrench(bound, object, state.q);
      Gather gather;
      for (const auto& t : bound.triangles) {
        const Vec3 a = object.position(bound.points[t[0]], state.q), b = object.position(bound.points[t[1]], state.q),
                   c = object.position(bound.points[t[2]], state.q);
        gather.add((a + b + c) / 3, Vec3::Zero(), (b - a).cross(c - a).norm());
      }
      const Vec3 point = gather.wrench().point_W;
      const Pressure& wish = model.scenario.pressures[bound.pressure];
      pressures.push_back({bound.pressure, {wish.part, wish.region, {point, sum.head<3>(), sum.tail<3>() - point.cross(sum.head<3>())}}});
    }
  }
  for (std::size_t i = 0; i < supports.size(); ++i)
    if (acts[i]) out.supports.push_back({model.scenario.supports[i].part, model.scenario.supports[i].region, supports[i].wrench()});
  std::sort(pressures.begin(), pressures.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& pressure : pressures) out.pressures.push_back(std::move(pressure.second));
}

void readHoldsAndLoads(const Model& model, const State& state, SceneReading& out) {
  for (const Hold& hold : model.scenario.holds) {
    const int object = findPart(model.joint, hold.part);
    for (const CouplingIslandModel& island : model.inside->islands)
      for (const BoundPoseSpring& bound : island.poseSprings) {
        if (bound.tool >= 0 || bound.object != object) continue;
        const auto& body = static_cast<const RigidObject&>(*model.inside->objects[object]);
        const ObjectLayout& layout = body.layout();
        const PoseSpring& spring = bound.spring;
        const Vec6 pull = springWrench(spring, body, bound.rest, state.q);
        const Vec3 omega = state.v.segment<3>(layout.vOffset + 3);
        const Vec3 speed = state.v.segment<3>(layout.vOffset) + omega.cross(body.pose(state.q).q_WB * spring.anchor_B);
        out.holds.push_back({hold.part, "",
                             {body.pose(state.q) * spring.anchor_B, pull.head<3>() - spring.damping * spring.axes.cwiseProduct(speed),
                              pull.tail<3>() - spring.angularDamping * spring.angularAxes.cwiseProduct(omega)}});
      }
  }
  // Islands keep the scenario's order among the loads of one part; a load that is spread acts at the centre of mass.
  for (const Load& load : model.scenario.loads) {
    const int object = findPart(model.joint, load.part);
    const SceneObject& scene = model.objects[object];
    if (!scene.layout.free) continue;
    std::size_t before = 0;
    for (const Load* other = model.scenario.loads.data(); other != &load; ++other) before += other->part == load.part;
    for (const CouplingIslandModel& island : model.inside->islands)
      for (const BoundLoad& bound : island.loads) {
        if (bound.object != object || before-- != 0) continue;
        const Vec3 point = bound.spread ? readPart(model, state, object).centre_W : model.inside->objects[object]->position(bound.point, state.q);
        const double share = loadShareAt(model.scenario, state.time);
        out.loads.push_back({load.part, "", {point, share * load.force_W, share * load.torque_W}});
      }
  }
}

}  // namespace

PartReading readPart(const Model& model, const State& state, int object) {
  const SceneObject& scene = model.objects[object];
  const ContactObject& dynamics = *model.inside->objects[object];
  const ObjectLayout& layout = scene.layout;
  PartReading part;
  part.id = scene.id;
  part.rigid = layout.rigid;
  part.tool = scene.tool;
  part.fixed = !layout.free;
  part.mass = dynamics.mass();
  const auto momentumOf = [&](const Twist& twist) { return dynamics.momentumOf(state.q, rigidMotion(layout, state.q, twist)); };
  // A shift with unit speed along e has the angular momentum M c × e about the origin.
  const Vec6 x = momentumOf({Vec3::Zero(), Vec3::UnitX(), Vec3::Zero()}), y = momentumOf({Vec3::Zero(), Vec3::UnitY(), Vec3::Zero()});
  part.centre_W = Vec3(y[5], -x[5], x[4]) / part.mass;
  const auto aboutCentre = [&](const Vec6& momentum) { return Vec3(momentum.tail<3>() - part.centre_W.cross(momentum.head<3>())); };
  for (int k = 0; k < 3; ++k) part.inertia_W.col(k) = aboutCentre(momentumOf({part.centre_W, Vec3::Zero(), Vec3::Unit(k)}));
  part.inertia_W = (0.5 * (part.inertia_W + part.inertia_W.transpose())).eval();
  const Vec6 momentum = dynamics.momentumOf(state.q, velocitiesOf(model, state, object));
  part.velocity_W = momentum.head<3>() / part.mass;
  part.angularVelocity_W = part.inertia_W.ldlt().solve(aboutCentre(momentum));
  if (layout.rigid) {
    part.centre_W = state.q.segment<3>(layout.qOffset);  // to the last bit
    part.q_WB = poseAt(state.q, layout.qOffset).q_WB;
  } else {
    part.q_WB = bestTurn(scene, dynamics, state.q, part.centre_W);
    for (int node = 0; node < layout.nodeCount; ++node) part.nodes_W.push_back(state.q.segment<3>(layout.qOffset + 3 * node));
  }
  return part;
}

std::vector<ContactReading> readContacts(const Model& model, const std::vector<ContactView>& contacts) {
  std::vector<ContactReading> out;
  for (const ContactView& view : contacts)
    out.push_back({model.objects[view.objectA].id, model.objects[view.objectB].id, view.point_W, view.normal_W, view.gap, view.force,
                   view.friction_W, view.film});
  return out;
}

std::vector<CouplingReading> readCouplings(const Model& model, const State& state) {
  std::vector<Gather> gathers(model.joint.couplings.size());
  std::vector<int> springs(gathers.size(), 0);
  std::vector<Twist> twists;
  for (std::size_t i = 0; i < model.objects.size(); ++i) twists.push_back(lastTwist(model, state, static_cast<int>(i)));
  for (const SpringView& spring : model.springs) {
    if (spring.coupling < 0) continue;
    const auto end = [&](int object, const VertexBinding& binding) {
      const ContactObject& dynamics = *model.inside->objects[object];
      const MaterialPoint point = pointAt(binding, dynamics.layout().rigid);
      const Vec3 p = dynamics.position(point, state.q);
      return std::pair<Vec3, Vec3>(p, dynamics.velocity(point, state.q, state.v) + twists[object].of(p));
    };
    const auto [pA, vA] = end(spring.objectA, spring.a);
    const auto [pB, vB] = end(spring.objectB, spring.b);
    gathers[spring.coupling].add(pA, -spring.stiffness * (pA - pB) - spring.damping * (vA - vB), spring.stiffness);
    ++springs[spring.coupling];
  }
  std::vector<CouplingReading> out;
  for (std::size_t c = 0; c < gathers.size(); ++c)
    if (springs[c] > 0)
      out.push_back({model.joint.couplings[c].id, model.joint.couplings[c].partA, model.joint.couplings[c].partB, springs[c], gathers[c].wrench()});
  return out;
}

SceneReading readScene(const Model& model, const State& state, const std::vector<ContactView>& contacts) {
  SceneReading out;
  out.time = state.time;
  out.step = state.step;
  for (std::size_t i = 0; i < model.objects.size(); ++i) out.parts.push_back(readPart(model, state, static_cast<int>(i)));
  out.contacts = readContacts(model, contacts);
  out.couplings = readCouplings(model, state);
  readActions(model, state, out);
  readHoldsAndLoads(model, state, out);
  return out;
}

void addPeaks(const Model& model, const State& state, const std::vector<ContactView>& contacts, bool stretchLaw, SceneReading& reading) {
  // The field does not outlive the caller's model.
  const SurfaceField field(std::shared_ptr<const Model>(std::shared_ptr<const Model>(), &model));
  for (const Quantity quantity : kQuantities) {
    const SurfaceValues values = field.read(quantity, state, contacts, stretchLaw);
    for (std::size_t i = 0; i < reading.parts.size(); ++i) {
      const auto most = peakOf(model, values, static_cast<int>(i), state.q);
      if (most && (quantity != Quantity::Contact || most->value > 0)) reading.parts[i].peaks.push_back({quantity, *most});
    }
  }
}

}  // namespace glenoid
