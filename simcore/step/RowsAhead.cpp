// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/step/RowsAhead.h"

#include <algorithm>

#include "simcore/base/Turns.h"
#include "simcore/body/RigidObject.h"
#include "simcore/collide/FeatureKey.h"

namespace glenoid {

namespace {
/// Contact distances: a tool that is faster is not foreseen farther.
constexpr double kFarthest = 2;
}  // namespace

RowsAhead::RowsAhead(Stepper& stepper, std::span<const int> bodies) : m_stepper(stepper), m_bodies(bodies.begin(), bodies.end()) {
  const Stepper::Work& work = stepper.work();
  m_rows.resize(work.islands.size());
  if (!work.finder) return;
  const auto& objects = work.model->objects;
  std::vector<CollisionPair> pairs;
  m_used.assign(objects.size(), 0);
  m_ownOf.assign(work.finder->pairs().size(), -1);
  for (std::size_t p = 0; p < work.finder->pairs().size(); ++p) {
    const CollisionPair& pair = work.finder->pairs()[p];
    const auto a = static_cast<std::size_t>(pair.surfaceA), b = static_cast<std::size_t>(pair.surfaceB);
    if (std::none_of(m_bodies.begin(), m_bodies.end(), [&](int body) { return body == pair.surfaceA || body == pair.surfaceB; })) continue;
    m_ownOf[p] = static_cast<int>(pairs.size());
    m_pairOf.push_back(static_cast<int>(p));
    pairs.push_back(pair);
    m_used[a] = m_used[b] = 1;
  }
  m_positions.resize(objects.size());
  m_spans.resize(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (m_used[i]) m_positions[i].resize(objects[i].collision.vertices.size());
    m_spans[i] = m_positions[i];
  }
  m_finder = std::make_unique<ProximityFinder>(work.finder->surfaces(), std::move(pairs));
}

void RowsAhead::find(const State& state, double ahead) {
  Stepper::Work& work = m_stepper.work();
  const Model& model = *work.model;
  m_contacts.clear();
  m_moved.assign(m_bodies.size(), Vec6::Zero());
  for (IslandRows& rows : m_rows) rows.clear();
  if (!m_finder) return;
  m_state = state;
  for (std::size_t b = 0; b < m_bodies.size(); ++b) {
    const ObjectLayout& layout = model.objects[static_cast<std::size_t>(m_bodies[b])].layout;
    m_moved[b] = ahead * state.v.segment<6>(layout.vOffset);
    const double way = m_moved[b].head<3>().norm(), most = kFarthest * model.scenario.contactDistance;
    if (way > most) m_moved[b] *= most / way;
    Pose pose = poseAt(m_state.q, layout.qOffset);
    pose.p_WB += m_moved[b].head<3>();
    pose.q_WB = (turnBy(m_moved[b].tail<3>()) * pose.q_WB).normalized();
    setPoseAt(m_state.q, layout.qOffset, pose);
  }
  for (std::size_t i = 0; i < m_used.size(); ++i)
    if (m_used[i]) surfacePositions(model.objects[i].collision, model.objects[i].layout, m_state.q, m_positions[i]);
  m_last.clear();
  for (const State::Impulse& impulse : state.impulses) {
    const int pair = FeatureKey::pairOf(impulse.key);
    const int own = pair < static_cast<int>(m_ownOf.size()) ? m_ownOf[static_cast<std::size_t>(pair)] : -1;
    if (own >= 0 && !FeatureKey::isTouch(impulse.key)) m_last.push_back({FeatureKey::renamed(impulse.key, own, false), impulse.normal_W});
  }
  const std::vector<Proximity>& near = m_finder->find(m_spans, {}, model.scenario.contactDistance, work.settings.dt, m_last);
  m_found.assign(near.begin(), near.end());
  for (Proximity& each : m_found) {  // own pairs stand in the stepper's order, so this is still sorted
    each.pair = m_pairOf[static_cast<std::size_t>(each.pair)];
    each.key = FeatureKey::renamed(each.key, each.pair, false);
  }

  // The step's own rooms build them, from what was found here, into vectors of this one's.
  const auto exchange = [&] {
    std::swap(work.contacts, m_contacts);
    std::swap(work.sides, m_sides);
    std::swap(work.touches, m_touches);
    std::swap(work.touchOf, m_touchOf);
    for (std::size_t i = 0; i < m_rows.size(); ++i) std::swap(work.islands[i].rows, m_rows[i]);
  };
  const auto times = work.report.cpuMs;
  const int contacts = work.report.contacts, dropped = work.report.droppedRows;
  const auto* proximities = std::exchange(work.proximities, &m_found);
  exchange();
  // As the last part of a step that was cut built its own.
  const double dt = std::exchange(work.settings.dt, work.settings.dt / work.report.parts);
  findTouches(work, m_state);
  buildContacts(work, m_state);
  buildTouches(work, m_state);
  driftContacts(work);
  work.settings.dt = dt;
  exchange();
  work.proximities = proximities;
  work.report.cpuMs = times;
  work.report.contacts = contacts;
  work.report.droppedRows = dropped;
}

}  // namespace glenoid
