// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/step/LocalPublisher.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "simcore/body/RigidObject.h"
#include "simcore/step/RowsAhead.h"
#include "simcore/step/StepWork.h"

namespace glenoid {

struct LocalPublisher::Bodies {
  int count = 0, island = -1;
  std::array<int, LocalProblem::kBodies> object{-1, -1}, base{-1, -1};
  bool has(int other) const { return other == object[0] || (count > 1 && other == object[1]); }
};

namespace {

int objectOfTool(const Model& model, int tool) {
  for (std::size_t i = 0; i < model.objects.size(); ++i)
    if (model.objects[i].tool && model.objects[i].toolIndex == tool) return static_cast<int>(i);
  return -1;
}

const BoundPoseSpring* gripOf(const CouplingIslandModel& island, int tool) {
  for (const BoundPoseSpring& bound : island.poseSprings)
    if (bound.tool == tool) return &bound;
  return nullptr;
}

}  // namespace

LocalPublisher::LocalPublisher(Stepper& stepper, double stepsAhead)
    : m_stepper(stepper), m_stepsAhead(stepsAhead) {
  if (stepsAhead > 0) m_aheadOf.resize(stepper.model().scenario.tools.size());
  m_last.resize(stepper.work().islands.size());
  m_free.resize(m_last.size());
}

LocalPublisher::~LocalPublisher() = default;

const std::vector<StepContact>& LocalPublisher::contacts() const { return m_ahead ? m_ahead->contacts() : m_stepper.work().contacts; }
const IslandRows& LocalPublisher::rowsOf(std::size_t island) const { return m_ahead ? m_ahead->rows(island) : m_stepper.work().islands[island].rows; }

void LocalPublisher::stepped(const StepReport& report) {
  Stepper::Work& work = m_stepper.work();
  m_taken = report.taken && work.inside->contact;
  if (!m_taken) {
    for (VecX& last : m_last) last.resize(0);
    return;
  }
  // The forces of a step that was cut are those of its last part, over another length of time.
  m_known = report.parts == 1;
  for (std::size_t i = 0; i < work.islands.size(); ++i) {
    IslandWork& island = work.islands[i];
    if (!island.response) {
      m_taken = false;
      return;
    }
    if (m_last[i].size() != island.b.size()) {
      m_known = false;
    } else if (m_known) {
      m_free[i] = island.b + m_last[i];
      island.response->solve(m_free[i]);
    }
    island.A.multiply(island.v, island.residual);
    m_last[i] = island.residual - island.b;
    if (report.parts != 1) m_last[i].resize(0);
  }
}

void LocalPublisher::chooseRows(const Bodies& bodies) {
  const std::vector<StepContact>& all = contacts();
  m_slot.assign(all.size(), -1);
  m_rows.clear();
  for (std::size_t c = 0; c < all.size(); ++c) {
    const bool a = bodies.has(all[c].objectA), b = bodies.has(all[c].objectB);
    if (a != b) m_rows.push_back(static_cast<int>(c));
  }
  // Of the step's own what is near is known after the solve; of those to come before it.
  const auto far = [&](const StepContact& contact) { return m_ahead ? -contact.target : contact.speed; };
  std::stable_sort(m_rows.begin(), m_rows.end(), [&](int i, int j) {
    const StepContact &a = all[i], &b = all[j];
    if ((a.impulse > 0) != (b.impulse > 0)) return a.impulse > 0;
    return a.impulse > 0 ? a.impulse > b.impulse : far(a) < far(b);
  });
}

void LocalPublisher::chooseOthers(const Bodies& bodies) {
  const Stepper::Work& work = m_stepper.work();
  m_reached.assign(work.islands.size(), 0);
  const auto reach = [&](int island) {
    if (island < 0 || island == bodies.island || m_reached[island]) return false;
    m_reached[island] = 1;
    return true;
  };
  m_given.clear();
  m_stepSlot.assign(work.contacts.size(), -1);
  for (const int c : m_rows) {
    reach(contacts()[c].islandA);
    reach(contacts()[c].islandB);
  }
  if (m_ahead)
    for (std::size_t c = 0; c < work.contacts.size(); ++c) {
      const StepContact& contact = work.contacts[c];
      if (!(contact.impulse > 0) || bodies.has(contact.objectA) == bodies.has(contact.objectB)) continue;
      m_given.push_back(static_cast<int>(c));
      reach(contact.islandA);
      reach(contact.islandB);
    }
  m_others.clear();
  for (bool more = true; more;) {
    more = false;
    for (std::size_t c = 0; c < work.contacts.size(); ++c) {
      const StepContact& contact = work.contacts[c];
      if (!(contact.impulse > 0) || contact.islandA == bodies.island || contact.islandB == bodies.island) continue;
      const bool a = contact.islandA >= 0 && m_reached[contact.islandA], b = contact.islandB >= 0 && m_reached[contact.islandB];
      if (!a && !b) continue;
      if (reach(contact.islandA) || reach(contact.islandB)) more = true;
      if (m_stepSlot[c] == -1) {
        m_stepSlot[c] = -2;  // seen
        m_others.push_back(static_cast<int>(c));
      }
    }
  }
  std::stable_sort(m_others.begin(), m_others.end(), [&](int i, int j) { return work.contacts[i].impulse > work.contacts[j].impulse; });
  for (const int c : m_others) m_stepSlot[c] = -1;
  if (m_others.size() > kOthers) m_others.resize(kOthers);
}

void LocalPublisher::condense(double h, LocalProblem& out) {
  Stepper::Work& work = m_stepper.work();
  // First the tool's rows and those of the forces that were, then what stays shut.
  const int rows = out.rowCount, open = rows + static_cast<int>(m_given.size()), n = open + static_cast<int>(m_others.size());
  m_G.setZero(n, n);
  m_w.setZero(n);
  for (std::size_t i = 0; i < work.islands.size(); ++i) {
    if (!m_reached[i]) continue;
    IslandWork& island = work.islands[i];
    m_islandRows.clear();
    m_ids.clear();
    const auto take = [&](const IslandRows& from, const std::vector<int>& slots) {
      for (int row = 0; row < from.count(); ++row) {
        const int slot = slots[from.contactOf(row)];
        if (slot < 0) continue;
        m_islandRows.push_back(from.row(row));
        m_ids.push_back(slot);
        m_w[slot] += dot(from.row(row), m_known ? m_free[i] : island.v);
      }
    };
    take(rowsOf(i), m_slot);
    take(island.rows, m_stepSlot);
    if (m_ids.empty()) continue;
    island.response->prepare(m_islandRows);
    island.response->addDelassus(m_ids, m_G);
  }
  const auto own = [&](const std::vector<StepContact>& list, const std::vector<int>& chosen, const std::vector<int>& slots) {
    for (const int c : chosen)
      if (const int slot = slots[c]; slot >= 0) {
        if (slot < rows || slot >= open) m_G(slot, slot) += list[c].compliance;  // of forces that were only what the far side gives counts
        m_w[slot] += list[c].near->normal_W.dot(list[c].drift_W);
      }
  };
  own(contacts(), m_rows, m_slot);
  own(work.contacts, m_others, m_stepSlot);
  m_C = m_G.topLeftCorner(open, open);
  if (const int others = n - open; others > 0) {
    auto shut = m_G.bottomRightCorner(others, others);
    for (int k = 0; k < others; ++k) shut(k, k) *= 1 + 1e-9;  // rows that say the same twice
    const Eigen::LLT<MatX> factor(shut);
    if (factor.info() == Eigen::Success) {
      m_X = factor.solve(m_G.bottomLeftCorner(others, open));
      m_C -= m_X.transpose() * m_G.bottomLeftCorner(others, open);
      m_w.head(open) -= m_X.transpose() * m_w.tail(others);
    }
  }
  out.C.topLeftCorner(rows, rows) = 0.5 * h * h * (m_C.topLeftCorner(rows, rows) + m_C.topLeftCorner(rows, rows).transpose());
  for (int i = 0; i < rows; ++i) out.approach[i] = m_w[i];
  if (!m_ahead) return;
  // The far side stands where the forces of the step left it: those of other rows than are published.
  for (int i = 0; i < rows; ++i) {
    double there = 0;
    for (int j = 0; j < rows; ++j) there += out.C(i, j) * out.force[j];
    for (std::size_t k = 0; k < m_given.size(); ++k) there -= h * m_C(i, rows + static_cast<int>(k)) * work.contacts[m_given[k]].impulse;
    out.slack[i] += there;
  }
}

/// Gaps, forces and the tool's own share of each row.
void LocalPublisher::fill(const Bodies& bodies, double h, LocalProblem& out) {
  out.J.topRows(out.rowCount).setZero();
  for (int i = 0; i < out.rowCount; ++i) {
    const StepContact& contact = contacts()[m_rows[i]];
    out.force[i] = contact.impulse / h;
    out.slack[i] = m_ahead ? -h * contact.target : contact.impulse > 0 ? 0 : h * contact.speed;
  }
  const IslandRows& own = rowsOf(bodies.island);
  for (int row = 0; row < own.count(); ++row) {
    const int slot = m_slot[own.contactOf(row)];
    if (slot < 0 || slot >= out.rowCount) continue;
    for (const RowTerm& term : own.row(row))
      for (int b = 0; b < bodies.count; ++b)
        if (const int part = term.block - bodies.base[b]; part == 0 || part == 1)
          out.J.block<1, 3>(slot, 6 * b + 3 * part) = term.coefficient.transpose();
  }
  if (!m_ahead) return;
  for (int i = 0; i < out.rowCount; ++i)
    for (int b = 0; b < bodies.count; ++b) out.slack[i] -= out.J.block<1, 6>(i, 6 * b).dot(m_ahead->moved(static_cast<std::size_t>(b)));
}

void LocalPublisher::read(const State& state, int tool, LocalProblem& out) {
  out.valid = false;
  out.tool = tool;
  out.rowCount = out.overflow = out.linkCount = out.bodyCount = 0;
  if (!m_taken) return;
  Stepper::Work& work = m_stepper.work();
  const Model& model = *work.model;
  out.time = state.time;
  out.dt = model.scenario.dt;

  Bodies bodies;
  bodies.object[0] = objectOfTool(model, tool);
  if (bodies.object[0] < 0) return;
  bodies.island = work.inside->islandOfObject[bodies.object[0]];
  const CouplingIslandModel& island = work.inside->islands[bodies.island];
  const BoundPoseSpring* grip = gripOf(island, tool);
  if (!grip) return;
  bodies.count = 1;
  for (const BoundSpring& spring : island.springs)
    if (bodies.count == 1 && spring.objectA == bodies.object[0]) bodies.object[bodies.count++] = spring.objectB;
  for (int b = 0; b < bodies.count; ++b) {
    bodies.base[b] = work.inside->baseOfObject[bodies.object[b]];
    out.pose[b] = poseAt(state.q, model.objects[bodies.object[b]].layout.qOffset);
  }
  out.bodyCount = bodies.count;
  out.grip_B = grip->spring.anchor_B;
  out.stiffness = grip->spring.stiffness;
  out.angularStiffness = grip->spring.angularStiffness;
  out.forceMax = grip->spring.forceMax;
  out.torqueMax = grip->spring.torqueMax;
  for (const BoundSpring& spring : island.springs)
    if (out.linkCount < LocalProblem::kLinks && spring.objectA == bodies.object[0] && bodies.count > 1 && spring.objectB == bodies.object[1])
      out.links[out.linkCount++] = {spring.pointA.r_B, spring.pointB.r_B, spring.stiffness};

  if (!m_aheadOf.empty()) {
    std::unique_ptr<RowsAhead>& own = m_aheadOf[tool];
    if (!own) own = std::make_unique<RowsAhead>(m_stepper, std::span(bodies.object.data(), static_cast<std::size_t>(bodies.count)));
    m_ahead = own.get();
    m_ahead->find(state, m_stepsAhead * out.dt);
  }
  chooseRows(bodies);
  out.rowCount = std::min<int>(LocalProblem::kRows, static_cast<int>(m_rows.size()));
  out.overflow = static_cast<int>(m_rows.size()) - out.rowCount;
  m_rows.resize(out.rowCount);
  chooseOthers(bodies);
  for (int i = 0; i < out.rowCount; ++i) m_slot[m_rows[i]] = i;
  int slot = out.rowCount;
  for (const int c : m_given) m_stepSlot[c] = slot++;
  for (const int c : m_others) m_stepSlot[c] = slot++;

  const double h = work.settings.dt / work.report.parts;
  fill(bodies, h, out);
  condense(h, out);
  out.valid = true;
}

}  // namespace glenoid
