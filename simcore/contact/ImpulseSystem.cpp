// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/contact/ImpulseSystem.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

namespace glenoid {

void ImpulseSystem::set(const Eigen::Ref<const MatX>& W, const Eigen::Ref<const VecX>& d,
                        std::span<const ContactUnknowns> contacts, double compliance) {
  m_rows = static_cast<int>(d.size());
  m_contacts = contacts;
  if (m_W.rows() < m_rows) {
    const int room = m_rows + m_rows / 2 + 8;
    m_W.resize(room, room);
    m_factor.resize(room, room);
    for (VecX* vector : {&m_d, &m_impulses, &m_gap, &m_answer, &m_other, &m_change, &m_speeds, &m_inner}) vector->resize(room);
    m_parts.reserve(room);
    m_roots.reserve(room);
  }
  m_W.topLeftCorner(m_rows, m_rows) = W;
  for (int i = 0; i < m_rows; ++i) m_W(i, i) *= 1 + compliance;
  m_d.head(m_rows) = d;
}

double ImpulseSystem::answer(int contact) const {
  const int i = m_contacts[contact].row;
  return m_contacts[contact].tangential ? std::max({m_W(i, i), m_W(i + 1, i + 1), m_W(i + 2, i + 2)}) : m_W(i, i);
}

void ImpulseSystem::multiply(const VecX& impulses, VecX& speeds) const {
  // Contacts that are open cost nothing; four columns at a time, so that the speeds are read and written less.
  auto out = speeds.head(m_rows);
  out.setZero();
  std::array<int, 4> columns{};
  int waiting = 0;
  const auto column = [&](int k) { return impulses[columns[k]] * m_W.col(columns[k]).head(m_rows); };
  for (int j = 0; j < m_rows; ++j) {
    if (impulses[j] == 0) continue;
    columns[waiting++] = j;
    if (waiting < 4) continue;
    out += (column(0) + column(1)) + (column(2) + column(3));
    waiting = 0;
  }
  for (int k = 0; k < waiting; ++k) out += column(k);
}

void ImpulseSystem::begin(const VecX& lambda, VecX& w) {
  m_impulses.head(m_rows) = lambda.head(m_rows);
  multiply(m_impulses, m_speeds);
  w.head(m_rows) = m_d.head(m_rows) + m_speeds.head(m_rows);
}

void ImpulseSystem::residual(const VecX& lambda) {
  m_gap.head(m_rows) = m_impulses.head(m_rows) - lambda.head(m_rows);
}

bool ImpulseSystem::factor(std::span<const ConePoint> points) {
  m_parts.clear();
  m_roots.clear();
  m_columns = 0;
  for (std::size_t c = 0; c < m_contacts.size(); ++c) {
    const int rank = std::min(points[c].rank, m_contacts[c].rows());
    if (rank == 0) continue;
    m_parts.push_back({static_cast<int>(c), m_columns});
    m_roots.push_back({points[c].root, rank});
    m_columns += rank;
  }
  auto M = m_factor.topLeftCorner(m_columns, m_columns);
  for (std::size_t b = 0; b < m_parts.size(); ++b) {
    const ContactUnknowns& across = m_contacts[m_parts[b].contact];
    const int kb = m_roots[b].rank;
    for (std::size_t a = b; a < m_parts.size(); ++a) {
      const ContactUnknowns& down = m_contacts[m_parts[a].contact];
      const int ka = m_roots[a].rank;
      auto block = M.block(m_parts[a].column, m_parts[b].column, ka, kb);
      if (down.tangential && across.tangential) {
        const Mat3 full = m_roots[a].root.transpose() * (m_W.block<3, 3>(down.row, across.row) * m_roots[b].root);
        block = full.topLeftCorner(ka, kb);
      } else {
        block = m_roots[a].root.topLeftCorner(down.rows(), ka).transpose().lazyProduct(
            m_W.block(down.row, across.row, down.rows(), across.rows()).lazyProduct(m_roots[b].root.topLeftCorner(across.rows(), kb)).eval());
      }
    }
  }
  M.diagonal().array() += 1;
  Eigen::LLT<Eigen::Ref<MatX>, Eigen::Lower> llt(M);  // in place
  return llt.info() == Eigen::Success;
}

void ImpulseSystem::newton(const VecX& gap, VecX& change, VecX& speeds) {
  multiply(gap, m_answer);
  for (std::size_t a = 0; a < m_parts.size(); ++a) {
    const Vec3 inner = m_roots[a].root.transpose() * rowsOf(m_contacts[m_parts[a].contact], m_answer);
    m_inner.segment(m_parts[a].column, m_roots[a].rank) = inner.head(m_roots[a].rank);
  }
  const auto L = m_factor.topLeftCorner(m_columns, m_columns);
  auto x = m_inner.head(m_columns);
  L.triangularView<Eigen::Lower>().solveInPlace(x);
  L.transpose().triangularView<Eigen::Upper>().solveInPlace(x);
  change.head(m_rows) = -gap.head(m_rows);
  for (std::size_t a = 0; a < m_parts.size(); ++a) {
    const ContactUnknowns& contact = m_contacts[m_parts[a].contact];
    Vec3 inner = Vec3::Zero();
    inner.head(m_roots[a].rank) = m_inner.segment(m_parts[a].column, m_roots[a].rank);
    setRowsOf(contact, rowsOf(contact, change) + m_roots[a].root * inner, change);
  }
  multiply(change, speeds);
}

ContactSystem::Along ImpulseSystem::step(VecX& dw) {
  newton(m_gap, m_change, m_speeds);
  dw.head(m_rows) = m_speeds.head(m_rows);
  return {m_impulses.head(m_rows).dot(m_speeds.head(m_rows)), m_change.head(m_rows).dot(m_speeds.head(m_rows))};
}

void ImpulseSystem::respond(const VecX& impulses, VecX& dw) {
  // μ − λ falls by what the contacts give more.
  m_other.head(m_rows) = -impulses.head(m_rows);
  newton(m_other, m_gap, dw);  // the step's own gap has served
}

void ImpulseSystem::move(double alpha, VecX& w) {
  m_impulses.head(m_rows) += alpha * m_change.head(m_rows);
  multiply(m_impulses, m_speeds);
  w.head(m_rows) = m_d.head(m_rows) + m_speeds.head(m_rows);
}

}  // namespace glenoid
