// SPDX-License-Identifier: GPL-3.0-or-later
// From what the detector found to rows, and from impulses back to what a report shows. The solve between the two
// stands in ContactSolve.cpp (direct, reference) and PaperSolve.cpp.
#include <algorithm>
#include <cmath>

#include "simcore/step/StepWork.h"

namespace glenoid {

namespace {

MaterialPoint materialPoint(const SceneObject& object, const FeaturePoint& feature) {
  return pointAt(object.collision, object.layout.rigid, {feature.vertex.data(), static_cast<std::size_t>(feature.count)},
                 {feature.weight.data(), static_cast<std::size_t>(feature.count)});
}

/// Coulomb's coefficient of one side at a point of its collision surface.
double frictionAt(const SceneObject& object, const FeaturePoint& feature) {
  double friction = 0;
  for (int i = 0; i < feature.count; ++i) friction += feature.weight[i] * object.friction[feature.vertex[i]];
  return friction;
}

/// Last step's impulse of the same features, zero for a new contact. Both lists ascend by key.
const State::Impulse* lastImpulse(const State& state, std::uint64_t key, std::size_t& at) {
  while (at < state.impulses.size() && state.impulses[at].key < key) ++at;
  return at < state.impulses.size() && state.impulses[at].key == key ? &state.impulses[at] : nullptr;
}

}  // namespace

bool appendContactRow(Stepper::Work& work, const State& state, int c, const Vec3& direction,
                      IslandRows IslandWork::* rowsOf) {
  const StepContact& contact = work.contacts[c];
  const auto append = [&](IslandRows& rows, int object, const MaterialPoint& point, const Vec3& along) {
    rows.append(*work.inside->objects[object], point, along, state.q, work.inside->baseOfObject[object]);
  };
  bool moves = false;
  if (contact.islandA >= 0) {
    IslandRows& rows = work.islands[contact.islandA].*rowsOf;
    rows.begin(c);
    append(rows, contact.objectA, contact.a, direction);
    if (contact.islandB == contact.islandA) append(rows, contact.objectB, contact.b, -direction);
    moves = rows.finish();
  }
  if (contact.islandB >= 0 && contact.islandB != contact.islandA) {
    IslandRows& rows = work.islands[contact.islandB].*rowsOf;
    rows.begin(c);
    append(rows, contact.objectB, contact.b, -direction);
    moves = rows.finish() || moves;
  }
  return moves;
}

void buildContacts(Stepper::Work& work, const State& state) {
  const StageClock clock(work.report, Stage::Islands);
  const double dt = work.settings.dt, fastest = work.model->scenario.recoverySpeedMax;
  const std::vector<Proximity>& found = *work.proximities;
  work.contacts.clear();
  work.sides.clear();
  for (IslandWork& island : work.islands) island.rows.clear();
  std::size_t at = 0;
  for (std::size_t c = 0; c < found.size(); ++c) {
    const Proximity& near = found[c];
    const CollisionPair& pair = work.finder->pairs()[near.pair];
    const SceneObject &a = work.model->objects[pair.surfaceA], &b = work.model->objects[pair.surfaceB];
    StepContact& contact = work.contacts.emplace_back();
    contact.objectA = pair.surfaceA;
    contact.objectB = pair.surfaceB;
    contact.islandA = work.inside->islandOfObject[contact.objectA];
    contact.islandB = work.inside->islandOfObject[contact.objectB];
    contact.a = materialPoint(a, near.a);
    contact.b = materialPoint(b, near.b);
    contact.target = std::min(-near.gap / dt, fastest);
    if (const State::Impulse* last = lastImpulse(state, near.key, at)) {
      contact.impulse = last->value;
      contact.friction_W = last->friction_W;
    }
    if (work.inside->friction) {
      contact.coefficient = std::sqrt(frictionAt(a, near.a) * frictionAt(b, near.b));
      contact.tangent_W[0] = near.normal_W.unitOrthogonal();
      contact.tangent_W[1] = near.normal_W.cross(contact.tangent_W[0]);
    }
    work.sides.push_back({contact.islandA, contact.islandB});
    if (!appendContactRow(work, state, static_cast<int>(c), near.normal_W, &IslandWork::rows)) {
      work.sides.back() = {-1, -1};
      contact.impulse = 0;
      contact.friction_W.setZero();
      ++work.report.droppedRows;
    }
  }
  work.report.contacts = static_cast<int>(found.size()) - work.report.droppedRows;
}

void showContacts(Stepper::Work& work) {
  StepReport& report = work.report;
  const double dt = work.settings.dt;
  for (std::size_t c = 0; c < work.contacts.size(); ++c) {
    const StepContact& contact = work.contacts[c];
    const Proximity& near = (*work.proximities)[c];
    ContactView& view = report.contactViews.emplace_back();
    view.objectA = contact.objectA;
    view.objectB = contact.objectB;
    view.normal_W = near.normal_W;
    view.gap = near.gap;
    view.force = contact.impulse / dt;
    view.friction_W = contact.friction_W / dt;
    const auto along = [&](const FeaturePoint& feature, int object) {
      Vec3 p = Vec3::Zero();
      for (int i = 0; i < feature.count; ++i) p += feature.weight[i] * work.positions[object][feature.vertex[i]];
      return p;
    };
    view.point_W = 0.5 * (along(near.a, contact.objectA) + along(near.b, contact.objectB));
    if (view.force > 0) ++report.active;
    const Vec3 force = view.force * near.normal_W + view.friction_W;
    const SceneObject &a = work.model->objects[contact.objectA], &b = work.model->objects[contact.objectB];
    if (a.tool) report.toolForces[a.toolIndex] += force;
    if (b.tool) report.toolForces[b.toolIndex] -= force;
  }
}

}  // namespace glenoid
