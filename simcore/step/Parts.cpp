// SPDX-License-Identifier: GPL-3.0-or-later
// When a step must be cut. Positions follow velocities along a straight line, x + Δt ω × r, while a body turns: a turn
// by θ in one step leaves each point ½ θ² r from where the linearisation had it. In a spring of stiffness k that is an
// energy of ⅛ θ⁴ k r², out of nothing; in tissue a strain of ½ θ². And contacts keep the normals of the step's start: where a
// soft surface turns while it is pressed, what lies beside a contact goes in by its distance times the turn.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "simcore/body/RigidObject.h"
#include "simcore/step/StepWork.h"

namespace glenoid {

namespace {

constexpr int kPartsMost = 64;
/// Tissue, rad in one part: a strain of 1 %.
constexpr double kTurnMax = 0.15;
/// A pressed soft surface, rad in one part.
constexpr double kPressedTurnMax = 0.3;
/// Energy that stiff couplings may so gain in one part, of the kinetic energy of their island.
constexpr double kGainMax = 0.02;

/// Angular velocity of the whole of a soft object, each node with the same weight; zero where it has no extent.
Vec3 spinOf(const ObjectLayout& layout, const VecX& q, const VecX& v) {
  Vec3 centre = Vec3::Zero(), drift = Vec3::Zero();
  for (int node = 0; node < layout.nodeCount; ++node) {
    centre += q.segment<3>(layout.qOffset + 3 * node);
    drift += v.segment<3>(layout.vOffset + 3 * node);
  }
  centre /= layout.nodeCount;
  drift /= layout.nodeCount;
  Mat3 inertia = Mat3::Zero();
  Vec3 momentum = Vec3::Zero();
  for (int node = 0; node < layout.nodeCount; ++node) {
    const Vec3 r = q.segment<3>(layout.qOffset + 3 * node) - centre;
    momentum += r.cross(v.segment<3>(layout.vOffset + 3 * node) - drift);
    inertia -= r * r.transpose();
  }
  const double size = -inertia.trace();
  inertia.diagonal().array() += size;
  if (!(inertia.determinant() > 1e-9 * size * size * size)) return Vec3::Zero();
  return inertia.inverse() * momentum;
}

/// Largest angle by which a triangle of a soft surface turns in the step that was just solved, at a contact that presses, as the chord
/// of the angle, which no two C libraries see differently. Surfaces move by the last motion searched (Work::searchAgain).
double pressedTurn(const Stepper::Work& work) {
  const auto& motion = work.velocities[std::min(work.motionCount, ProximityFinder::kMotionsMost - 1)];
  const double dt = work.settings.dt;
  double least = 1;  // cosine
  for (const StepContact& contact : work.contacts) {
    if (!(contact.impulse > 0) || contact.film) continue;
    const CollisionPair& pair = work.model->collisionPairs[contact.near->pair];
    for (const auto& [index, feature] : {std::pair{pair.surfaceA, &contact.near->a}, {pair.surfaceB, &contact.near->b}}) {
      const ObjectLayout& layout = work.model->objects[index].layout;
      if (layout.rigid || !layout.free) continue;
      const CollisionSurface& surface = *work.model->collisionSurfaces[index];
      const auto& x = work.positions[index];
      const auto& v = motion[index];
      for (int k = 0; k < feature->count; ++k)
        for (const int t : surface.trianglesOf(feature->vertex[k])) {
          const auto& [a, b, c] = surface.triangles[t];
          const Vec3 before = (x[b] - x[a]).cross(x[c] - x[a]);
          const Vec3 after = (x[b] - x[a] + dt * (v[b] - v[a])).cross(x[c] - x[a] + dt * (v[c] - v[a]));
          const double size = before.norm() * after.norm();
          if (size > 0) least = std::min(least, before.dot(after) / size);
        }
    }
  }
  return std::sqrt(2 * std::max(0.0, 1 - least));
}

}  // namespace

std::vector<double> turnStiffnessOf(const StepModel& inside) {
  std::vector<double> stiffness(inside.objects.size(), 0);
  for (const CouplingIslandModel& island : inside.islands)
    for (const BoundSpring& spring : island.springs)
      for (std::size_t object = 0; object < inside.objects.size(); ++object) {
        const ContactObject* mine = inside.objects[object].get();
        if (!mine->layout().rigid || !mine->layout().free) continue;
        if (spring.a == mine) stiffness[object] += spring.stiffness * spring.pointA.r_B.squaredNorm();
        if (spring.b == mine) stiffness[object] += spring.stiffness * spring.pointB.r_B.squaredNorm();
      }
  for (const CouplingIslandModel& island : inside.islands)
    for (const BoundSupport& support : island.supports)
      for (std::size_t object = 0; object < inside.objects.size(); ++object)
        if (inside.objects[object].get() == support.object && support.object->layout().rigid)
          stiffness[object] += support.stiffness.maxCoeff() * support.point.r_B.squaredNorm();
  return stiffness;
}

int partsOf(const Stepper::Work& work, const State& state) {
  const double dt = work.settings.dt;
  double parts = work.inside->contact && work.additions.searchAgain ? std::max(1.0, pressedTurn(work) / kPressedTurnMax) : 1.0;
  for (const CouplingIslandModel& island : work.inside->islands) {
    double gain = 0, kinetic = 0;
    for (const int object : island.objects) {
      const ContactObject& mine = *work.inside->objects[object];
      const ObjectLayout& layout = mine.layout();
      if (!layout.rigid) {
        parts = std::max(parts, dt * spinOf(layout, state.q, work.solved).norm() / kTurnMax);
      } else if (work.turnStiffness[object] > 0) {
        const Vec3 velocity = work.solved.segment<3>(layout.vOffset), omega = work.solved.segment<3>(layout.vOffset + 3);
        const double turn2 = dt * dt * omega.squaredNorm();
        gain += turn2 * turn2 * work.turnStiffness[object] / 8;
        kinetic += 0.5 * mine.mass() * velocity.squaredNorm();
      }
    }
    // The gain falls with the fourth power of the parts.
    if (gain > kGainMax * kinetic && kinetic > 0) parts = std::max(parts, std::sqrt(std::sqrt(gain / (kGainMax * kinetic))));
  }
  return static_cast<int>(std::ceil(std::min<double>(parts, kPartsMost)));
}

}  // namespace glenoid
