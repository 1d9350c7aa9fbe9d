// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/step/ContactJudge.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace glenoid::test {

ContactJudge::ContactJudge(const Model& model)
    : m_model(model), m_finder(model.collisionSurfaces, model.collisionPairs) {
  for (const SceneObject& object : model.objects) {
    m_positions.emplace_back(object.collision.vertices.size());
    m_velocities.emplace_back(object.collision.vertices.size());
  }
}

ContactJudge::Verdict ContactJudge::judge(const State& before, const State& after) {
  std::vector<std::span<const Vec3>> positions, velocities;
  for (std::size_t i = 0; i < m_model.objects.size(); ++i) {
    const SceneObject& object = m_model.objects[i];
    surfacePositions(object.collision, object.layout, before.q, m_positions[i]);
    surfaceVelocities(object.collision, object.layout, before.q, before.v, m_velocities[i]);
    positions.emplace_back(m_positions[i]);
    velocities.emplace_back(m_velocities[i]);
  }
  std::map<std::uint64_t, double> impulseOf;
  for (const State::Impulse& kept : after.impulses) impulseOf[kept.key] = kept.value;
  const double dt = m_model.scenario.dt;
  // The solved velocities: a rigid body's ω changes while it turns, so that turn is taken back.
  State solved = after;
  solved.v = -solved.v;
  for (const auto& object : m_model.inside->objects) object->advance(dt, solved);
  solved.v = -solved.v;
  Verdict verdict;
  for (const Proximity& near : m_finder.find(positions, velocities, m_model.scenario.contactDistance, dt)) {
    const CollisionPair& pair = m_model.collisionPairs[near.pair];
    const double target = std::min(-near.gap / dt, m_model.scenario.recoverySpeedMax);
    const double speed = near.normal_W.dot(velocityOf(pair.surfaceA, near.a, before, solved) -
                                           velocityOf(pair.surfaceB, near.b, before, solved));
    const auto found = impulseOf.find(near.key);
    const double impulse = found == impulseOf.end() ? 0 : found->second;
    verdict.approach = std::max(verdict.approach, target - speed);
    verdict.pull = std::max(verdict.pull, -impulse);
    if (impulse > 0) {
      verdict.both = std::max(verdict.both, std::abs(speed - target));
      ++verdict.active;
    }
    ++verdict.rows;
  }
  return verdict;
}

Vec3 ContactJudge::velocityOf(int index, const FeaturePoint& feature, const State& before,
                              const State& after) const {
  const SceneObject& object = m_model.objects[index];
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < feature.count; ++i) {
    const MaterialPoint vertex = pointAt(object.collision.vertices[feature.vertex[i]], object.layout.rigid);
    sum += feature.weight[i] * m_model.inside->objects[index]->velocity(vertex, before.q, after.v);
  }
  return sum;
}

}  // namespace glenoid::test
