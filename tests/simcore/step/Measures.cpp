// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/step/Measures.h"

namespace glenoid::test {

Vec6 momentumOf(const Model& model, const State& state) {
  Vec6 sum = Vec6::Zero();
  for (const auto& object : model.inside->objects) sum += object->momentum(state);
  return sum;
}

double energyOf(const Model& model, const State& state) {
  double sum = 0;
  for (const auto& object : model.inside->objects)
    sum += object->kineticEnergy(state) + object->elasticEnergy(state);
  for (const CouplingIslandModel& island : model.inside->islands)
    for (const BoundSpring& spring : island.springs)
      sum += 0.5 * spring.stiffness *
             (spring.a->position(spring.pointA, state.q) - spring.b->position(spring.pointB, state.q))
                 .squaredNorm();
  return sum;
}

void setInMotion(const Model& model, int object, const Vec3& linear, const Vec3& omega, State& state) {
  const ObjectLayout& layout = model.objects[object].layout;
  if (layout.rigid) state.v.segment<3>(layout.vOffset + 3) = omega;
  for (int node = 0; node < (layout.rigid ? 1 : layout.nodeCount); ++node)
    state.v.segment<3>(layout.vOffset + 3 * node) =
        linear + omega.cross(state.q.segment<3>(layout.qOffset + 3 * node));
}

Eigen::VectorBlock<const VecX> positionsOf(const Model& model, int object, const State& state) {
  const ObjectLayout& layout = model.objects[object].layout;
  return state.q.segment(layout.qOffset, layout.qSize);
}

Eigen::VectorBlock<const VecX> velocitiesOf(const Model& model, int object, const State& state) {
  const ObjectLayout& layout = model.objects[object].layout;
  return state.v.segment(layout.vOffset, layout.vSize);
}

IslandSystem systemOf(const StepModel& inside, const CouplingIslandModel& island, const State& state) {
  IslandSystem system{BlockMatrix(island.symbolic), VecX::Zero(3 * island.blockCount)};
  system.A.setZero();
  VecX rotations = state.rotations;
  for (std::size_t k = 0; k < island.objects.size(); ++k) {
    const ContactObject& object = *inside.objects[island.objects[k]];
    object.assemble(inside.settings, state, island.entries[k], rotations, system.A,
                    system.b.segment(3 * island.base[k], 3 * object.blockCount()));
  }
  for (const BoundSpring& spring : island.springs)
    assembleSpring(spring, inside.settings.dt, state.q, system.A, system.b);
  return system;
}

}  // namespace glenoid::test
