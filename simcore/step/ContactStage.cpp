// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "simcore/step/StepWork.h"

namespace glenoid {

namespace {

MaterialPoint materialPoint(const SceneObject& object, const FeaturePoint& feature) {
  return pointAt(object.collision, object.layout.rigid, {feature.vertex.data(), static_cast<std::size_t>(feature.count)},
                 {feature.weight.data(), static_cast<std::size_t>(feature.count)});
}

/// Last step's impulse of the same features, zero for a new contact. Both lists ascend by key.
double lastImpulse(const State& state, std::uint64_t key, std::size_t& at) {
  while (at < state.impulses.size() && state.impulses[at].key < key) ++at;
  return at < state.impulses.size() && state.impulses[at].key == key ? state.impulses[at].value : 0;
}

}  // namespace

void buildContacts(Stepper::Work& work, const State& state) {
  const StageClock clock(work.report, Stage::Islands);
  const double dt = work.settings.dt, fastest = work.model->scenario.recoverySpeedMax;
  const std::vector<Proximity>& found = *work.proximities;
  work.contacts.clear();
  work.sides.clear();
  if (const auto count = static_cast<Eigen::Index>(found.size()); work.impulses.size() < count)
    work.impulses.resize(count + count / 2);  // grows only: Eigen's resize goes to the heap at every change of size
  for (IslandWork& island : work.islands) {
    island.rows.clear();
    island.rowIds.clear();
  }
  std::size_t at = 0;
  for (std::size_t c = 0; c < found.size(); ++c) {
    const Proximity& near = found[c];
    const CollisionPair& pair = work.finder->pairs()[near.pair];
    StepContact contact;
    contact.objectA = pair.surfaceA;
    contact.objectB = pair.surfaceB;
    contact.islandA = work.inside->islandOfObject[contact.objectA];
    contact.islandB = work.inside->islandOfObject[contact.objectB];
    contact.a = materialPoint(work.model->objects[contact.objectA], near.a);
    contact.b = materialPoint(work.model->objects[contact.objectB], near.b);
    contact.target = std::min(-near.gap / dt, fastest);
    work.impulses[c] = lastImpulse(state, near.key, at);
    work.contacts.push_back(contact);
    work.sides.push_back({contact.islandA, contact.islandB});

    const ContactObject &a = *work.inside->objects[contact.objectA], &b = *work.inside->objects[contact.objectB];
    const int baseA = work.inside->baseOfObject[contact.objectA], baseB = work.inside->baseOfObject[contact.objectB];
    const Vec3& n = near.normal_W;
    bool moves = false;
    if (contact.islandA >= 0) {
      IslandRows& rows = work.islands[contact.islandA].rows;
      rows.begin(static_cast<int>(c));
      rows.append(a, contact.a, n, state.q, baseA);
      if (contact.islandB == contact.islandA) rows.append(b, contact.b, -n, state.q, baseB);
      moves = rows.finish();
    }
    if (contact.islandB >= 0 && contact.islandB != contact.islandA) {
      IslandRows& rows = work.islands[contact.islandB].rows;
      rows.begin(static_cast<int>(c));
      rows.append(b, contact.b, -n, state.q, baseB);
      moves = rows.finish() || moves;
    }
    if (!moves) {
      work.sides.back() = {-1, -1};
      work.impulses[c] = 0;
      ++work.report.droppedRows;
    }
  }
  work.report.contacts = static_cast<int>(found.size()) - work.report.droppedRows;
}

namespace {

/// Everything that one contact island needs for its complementarity problem, into W and d.
void buildDelassus(Stepper::Work& work, const ContactIsland& island) {
  const StageClock clock(work.report, Stage::Delassus);
  const Eigen::Index n = static_cast<Eigen::Index>(island.contacts.size());
  if (work.W.rows() < n) {
    const Eigen::Index room = n + n / 2 + 8;
    work.W.resize(room, room);
    work.d.resize(room);
    work.lambda.resize(room);
  }
  auto W = work.W.topLeftCorner(n, n);
  W.setZero();
  for (Eigen::Index i = 0; i < n; ++i) {
    const int contact = island.contacts[i];
    work.d[i] = -work.contacts[contact].target;
    work.lambda[i] = work.impulses[contact];
  }
  for (const int index : island.couplingIslands) {
    IslandWork& part = work.islands[index];
    part.rowIds.clear();
    for (int row = 0; row < part.rows.count(); ++row) {
      part.rowIds.push_back(work.placeOfContact[part.rows.contactOf(row)]);
      work.d[part.rowIds.back()] += part.rows.dot(row, part.v);
    }
    part.response->prepare(part.rows.rows());
    part.response->addDelassus(part.rowIds, W);
  }
}

void applyImpulses(Stepper::Work& work, const ContactIsland& island) {
  for (const int index : island.couplingIslands) {
    IslandWork& part = work.islands[index];
    part.lambda.clear();
    for (const int id : part.rowIds) part.lambda.push_back(work.lambda[id]);
    part.response->addImpulses(part.lambda, part.v);
  }
}

/// ‖A v − b − Jᵀλ‖ / ‖b‖ over all islands: a tool that nothing pulls has b = 0 and no scale of its own.
double momentumResidual(std::vector<IslandWork>& islands, const VecX& impulses) {
  double error = 0, scale = 0;
  for (IslandWork& island : islands) {
    island.A.multiply(island.v, island.residual);
    island.residual -= island.b;
    for (int row = 0; row < island.rows.count(); ++row)
      island.rows.addTransposed(row, -impulses[island.rows.contactOf(row)], island.residual);
    error += island.residual.squaredNorm();
    scale += island.b.squaredNorm();
  }
  return std::sqrt(error / (scale > 0 ? scale : 1));
}

}  // namespace

void solveConstrained(Stepper::Work& work, const State&) {
  StepReport& report = work.report;
  const std::span<const ContactIsland> islands = work.islandBuilder->build(work.sides);
  report.contactIslands = static_cast<int>(islands.size());
  work.placeOfContact.resize(work.contacts.size());
  for (const ContactIsland& island : islands)
    for (std::size_t i = 0; i < island.contacts.size(); ++i) work.placeOfContact[island.contacts[i]] = static_cast<int>(i);

  for (const ContactIsland& island : islands) {
    if (work.options.profile == Profile::Paper) {
      const StageClock clock(report, Stage::Contact);
      solveContactIslandBySplitting(work, island);
      continue;
    }
    buildDelassus(work, island);
    const StageClock clock(report, Stage::Contact);
    const Eigen::Index n = static_cast<Eigen::Index>(island.contacts.size());
    const LcpReport lcp = solveLcp(work.W.topLeftCorner(n, n), work.d.head(n), work.lambda.head(n), {}, work.lcp);
    if (!lcp.exact) ++report.pivotsExhausted;
    report.complementarity = std::max(report.complementarity, lcp.error);
    for (Eigen::Index i = 0; i < n; ++i) work.impulses[island.contacts[i]] = work.lambda[i];
    applyImpulses(work, island);
  }

  const StageClock clock(report, Stage::Contact);
  report.residual = momentumResidual(work.islands, work.impulses);
  if (work.options.profile == Profile::Paper) report.paper.outerResidual = report.residual;
  const double dt = work.settings.dt;
  for (std::size_t c = 0; c < work.contacts.size(); ++c) {
    const StepContact& contact = work.contacts[c];
    const Proximity& near = (*work.proximities)[c];
    ContactView view{contact.objectA, contact.objectB, Vec3::Zero(), near.normal_W, near.gap, work.impulses[c] / dt};
    const auto along = [&](const FeaturePoint& feature, int object) {
      Vec3 p = Vec3::Zero();
      for (int i = 0; i < feature.count; ++i) p += feature.weight[i] * work.positions[object][feature.vertex[i]];
      return p;
    };
    view.point_W = 0.5 * (along(near.a, contact.objectA) + along(near.b, contact.objectB));
    if (view.force > 0) ++report.active;
    const SceneObject &a = work.model->objects[contact.objectA], &b = work.model->objects[contact.objectB];
    if (a.tool) report.toolForces[a.toolIndex] += view.force * near.normal_W;
    if (b.tool) report.toolForces[b.toolIndex] -= view.force * near.normal_W;
    report.contactViews.push_back(view);
  }
}

}  // namespace glenoid
