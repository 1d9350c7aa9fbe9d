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

double coefficientOf(const Stepper::Work& work, const StepContact& contact) {
  const auto covered = [](const std::vector<char>& cover, const FeaturePoint& feature) {
    return !cover.empty() && cover[feature.vertex[0]];
  };
  for (const FilmModel& film : work.inside->films) {
    const bool over = covered(film.floor[contact.objectA], contact.near->a) && covered(film.roof[contact.objectB], contact.near->b);
    const bool under = covered(film.roof[contact.objectA], contact.near->a) && covered(film.floor[contact.objectB], contact.near->b);
    if (over || under) return film.friction;
  }
  const SceneObject &a = work.model->objects[contact.objectA], &b = work.model->objects[contact.objectB];
  return std::sqrt(frictionAt(a, contact.near->a) * frictionAt(b, contact.near->b));
}

bool appendContactRow(Stepper::Work& work, const State& state, int c, const Vec3& direction,
                      IslandRows IslandWork::* rowsOf) {
  const StepContact& contact = work.contacts[c];
  const auto append = [&](IslandRows& rows, int object, const MaterialPoint& point, const Vec3& along) {
    const ContactObject& moved = *work.inside->objects[object];
    const int base = work.inside->baseOfObject[object];
    if (contact.touch >= 0 && object == contact.objectA) {  // the part: over its patch
      const Touch& touch = work.touches[contact.touch];
      for (std::size_t k = 0; k < touch.points.size(); ++k) rows.append(moved, touch.points[k], kTouchWeights[k] * along, state.q, base);
    } else {
      rows.append(moved, point, along, state.q, base);
    }
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
  const double dt = work.settings.dt, fastest = work.recoverySpeedMax;
  const std::vector<Proximity>& found = *work.proximities;
  work.contacts.clear();
  work.sides.clear();
  for (IslandWork& island : work.islands) island.rows.clear();
  std::size_t at = 0;
  for (std::size_t f = 0; f < found.size(); ++f) {
    if (!work.touchOf.empty() && work.touchOf[f] >= 0) continue;
    const Proximity& near = found[f];
    const CollisionPair& pair = work.finder->pairs()[near.pair];
    const SceneObject &a = work.model->objects[pair.surfaceA], &b = work.model->objects[pair.surfaceB];
    StepContact& contact = work.contacts.emplace_back();
    contact.objectA = pair.surfaceA;
    contact.objectB = pair.surfaceB;
    contact.islandA = work.inside->islandOfObject[contact.objectA];
    contact.islandB = work.inside->islandOfObject[contact.objectB];
    contact.a = materialPoint(a, near.a);
    contact.b = materialPoint(b, near.b);
    contact.near = &near;
    contact.target = std::min(-near.gap / dt, fastest);
    if (const State::Impulse* last = lastImpulse(state, near.key, at)) {
      contact.impulse = last->value;
      contact.friction_W = last->friction_W;
    }
    if (work.inside->friction) {
      contact.coefficient = coefficientOf(work, contact);
      contact.tangent_W[0] = near.normal_W.unitOrthogonal();
      contact.tangent_W[1] = near.normal_W.cross(contact.tangent_W[0]);
    }
    work.sides.push_back({contact.islandA, contact.islandB});
    if (!appendContactRow(work, state, static_cast<int>(work.contacts.size()) - 1, near.normal_W, &IslandWork::rows)) {
      work.sides.back() = {-1, -1};
      contact.impulse = 0;
      contact.friction_W.setZero();
      ++work.report.droppedRows;
    }
  }
  work.report.contacts = static_cast<int>(found.size()) - work.report.droppedRows;
}

void buildFilmContacts(Stepper::Work& work, const State& state) {
  if (work.inside->films.empty()) return;
  const StageClock clock(work.report, Stage::Bursa);
  const double dt = work.settings.dt;
  work.report.filmContacts = 0;
  std::size_t at = 0;
  for (std::size_t f = 0; f < work.films.size(); ++f) {
    const FilmModel& film = work.inside->films[f];
    for (const FilmTouch& touch : *work.films[f]) {
      const Proximity& near = touch.near;
      const FilmSides::Vertex& vertex = film.sides.floor[touch.floor];
      StepContact& contact = work.contacts.emplace_back();
      contact.near = &near;
      contact.film = true;
      contact.objectA = vertex.surface;
      contact.objectB = touch.roofSurface;
      contact.islandA = work.inside->islandOfObject[contact.objectA];
      contact.islandB = work.inside->islandOfObject[contact.objectB];
      contact.a = materialPoint(work.model->objects[contact.objectA], near.a);
      contact.b = materialPoint(work.model->objects[contact.objectB], near.b);
      // Backward Euler of f = k (h − g) − d ġ while f ≥ 0: with λ = Δt f and g after the step = g + Δt J v,
      // J v + λ / (Δt (Δt k + d)) = k (h − g) / (Δt k + d). Outside its thickness the film has nothing to damp.
      const double k = film.stiffnessPerArea * touch.area, open = film.thickness - near.gap;
      const double firm = dt * k + (open > 0 ? film.damping * k : 0.0);
      contact.target = k * open / firm;
      contact.compliance = 1 / (dt * firm);
      if (const State::Impulse* last = lastImpulse(state, near.key, at)) contact.impulse = last->value;
      work.sides.push_back({contact.islandA, contact.islandB});
      const int c = static_cast<int>(work.contacts.size()) - 1;
      if (!appendContactRow(work, state, c, near.normal_W, &IslandWork::rows)) {
        work.sides.back() = {-1, -1};
        contact.impulse = 0;
      } else {
        ++work.report.filmContacts;
      }
    }
  }
}

void showContacts(Stepper::Work& work) {
  StepReport& report = work.report;
  const double dt = work.settings.dt;
  for (std::size_t c = 0; c < work.contacts.size(); ++c) {
    const StepContact& contact = work.contacts[c];
    const Proximity& near = *contact.near;
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
    view.point_W = contact.touch >= 0 ? work.touches[contact.touch].place_W : Vec3(0.5 * (along(near.a, contact.objectA) + along(near.b, contact.objectB)));
    view.film = contact.film;
    if (view.force > 0 && !contact.film && !contact.bed) ++report.active;
    const Vec3 force = view.force * near.normal_W + view.friction_W;
    const SceneObject &a = work.model->objects[contact.objectA], &b = work.model->objects[contact.objectB];
    if (a.tool) report.toolForces[a.toolIndex] += force;
    if (b.tool) report.toolForces[b.toolIndex] -= force;
  }
  showDents(work);
}

}  // namespace glenoid
