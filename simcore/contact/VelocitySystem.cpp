// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/contact/VelocitySystem.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "simcore/linear/ExpectedFill.h"

namespace glenoid {

namespace {

Mat3 storedBlock(const BlockMatrix& A, int slot) {
  return Eigen::Map<const Mat3, Eigen::Unaligned, Eigen::OuterStride<4>>(A.slot(slot));
}

}  // namespace

bool VelocitySystem::set(std::span<const VelocityIsland> islands, std::span<const ContactUnknowns> contacts,
                         std::span<const double> compliance, const Eigen::Ref<const VecX>& d, double updatesMost) {
  m_islands = islands;
  m_contacts = contacts;
  m_compliance = compliance;
  m_rows = static_cast<int>(d.size());
  m_d = d;
  m_base.clear();
  m_blocks = 0;
  for (const VelocityIsland& island : islands) {
    m_base.push_back(m_blocks);
    m_blocks += island.A->symbolic().blockCount();
  }
  for (VecX* vector : {&m_v, &m_momentum, &m_gradient, &m_dv, &m_product}) vector->resize(3 * m_blocks);
  if (m_local.size() < islands.size()) m_local.resize(islands.size());
  gatherTerms();
  m_joined = 0;
  for (std::size_t c = 0; c < m_contacts.size(); ++c) m_joined += static_cast<double>(m_terms[c].size() * (m_terms[c].size() + 1)) / 2;
  if (kLaidOut * m_joined > updatesMost) return false;
  m_renewed = !patternHolds();
  if (m_renewed && !renewPattern(updatesMost)) return false;
  gatherAnswers();
  mapEntries();
  return true;
}

void VelocitySystem::gatherTerms() {
  if (m_terms.size() < m_contacts.size()) m_terms.resize(m_contacts.size() + m_contacts.size() / 2 + 8);
  m_contactOfRow.resize(m_rows);
  for (std::size_t c = 0; c < m_contacts.size(); ++c) {
    m_terms[c].clear();
    for (int k = 0; k < m_contacts[c].rows(); ++k) m_contactOfRow[m_contacts[c].row + k] = static_cast<int>(c);
  }
  for (std::size_t i = 0; i < m_islands.size(); ++i)
    for (std::size_t r = 0; r < m_islands[i].rows.size(); ++r) {
      const int id = m_islands[i].ids[r], c = m_contactOfRow[id], k = id - m_contacts[c].row;
      for (const RowTerm& term : m_islands[i].rows[r]) {
        const int block = m_base[i] + term.block;
        auto at = std::find_if(m_terms[c].begin(), m_terms[c].end(), [block](const Term& known) { return known.block == block; });
        if (at == m_terms[c].end()) at = m_terms[c].insert(at, {block, Mat3::Zero()});
        at->C.row(k) = term.coefficient.transpose();
      }
    }
}

double VelocitySystem::yieldOf(std::size_t island) {
  constexpr std::size_t kSamples = 8;
  const VelocityIsland& part = m_islands[island];
  const std::size_t rows = part.rows.size(), every = std::max<std::size_t>(1, rows / kSamples);
  std::array<double, kSamples> ratios{};
  std::size_t count = 0;
  VecX& push = m_local[island][0];
  for (std::size_t r = 0; r < rows && count < kSamples; r += every) {
    double alone = 0;
    for (const RowTerm& term : part.rows[r]) alone += term.coefficient.dot(m_inverse[m_base[island] + term.block] * term.coefficient);
    if (!(alone > 0)) continue;
    push.setZero(part.b->size());
    addTransposed(part.rows[r], 1, push);
    part.response->solve(push);
    ratios[count++] = dot(part.rows[r], push) / alone;
  }
  if (count == 0) return 1;
  std::sort(ratios.begin(), ratios.begin() + count);
  return std::max(1.0, ratios[count / 2]);
}

void VelocitySystem::gatherAnswers() {
  m_inverse.resize(m_blocks);
  for (std::size_t i = 0; i < m_islands.size(); ++i) {
    const int blocks = m_islands[i].A->symbolic().blockCount();
    for (int block = 0; block < blocks; ++block) m_inverse[m_base[i] + block] = m_islands[i].A->block(block, block).inverse();
    const double yield = yieldOf(i);
    for (int block = 0; block < blocks; ++block) m_inverse[m_base[i] + block] *= yield;
  }
  m_answers.resize(m_contacts.size());
  for (std::size_t c = 0; c < m_contacts.size(); ++c) {
    Vec3 sum = Vec3::Zero();
    for (const Term& term : m_terms[c]) sum += (term.C * m_inverse[term.block] * term.C.transpose()).diagonal();
    m_answers[c] = sum.maxCoeff();
  }
}

bool VelocitySystem::patternHolds() const {
  if (m_patterns.size() != m_islands.size()) return false;
  for (std::size_t i = 0; i < m_islands.size(); ++i)
    if (m_patterns[i] != &m_islands[i].A->symbolic()) return false;
  for (std::size_t c = 0; c < m_contacts.size(); ++c)
    for (std::size_t a = 0; a < m_terms[c].size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (m_symbolic->entry(m_terms[c][a].block, m_terms[c][b].block).slot < 0) return false;
  return true;
}

bool VelocitySystem::renewPattern(double updatesMost) {
  constexpr int kBlocksUnasked = 300;  // even full that costs little
  std::vector<std::array<int, 2>> pairs;
  m_patterns.clear();
  for (std::size_t i = 0; i < m_islands.size(); ++i) {
    m_patterns.push_back(&m_islands[i].A->symbolic());
    for (const auto& [slot, row, col] : m_islands[i].A->symbolic().stored()) pairs.push_back({m_base[i] + row, m_base[i] + col});
  }
  for (std::size_t c = 0; c < m_contacts.size(); ++c)
    for (std::size_t a = 0; a < m_terms[c].size(); ++a)
      for (std::size_t b = 0; b < a; ++b) pairs.push_back({m_terms[c][a].block, m_terms[c][b].block});
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  if (m_blocks > kBlocksUnasked && expectedUpdates(m_blocks, pairs) > updatesMost) {
    m_patterns.clear();  // no pattern holds
    return false;
  }
  m_symbolic = std::make_shared<BlockSymbolic>(m_blocks, pairs);
  m_H = std::make_unique<BlockMatrix>(m_symbolic);
  m_factor = std::make_unique<BlockCholesky>(m_symbolic, m_portable);
  m_fromA.clear();
  for (std::size_t i = 0; i < m_islands.size(); ++i)
    for (const auto& [slot, row, col] : m_islands[i].A->symbolic().stored()) m_fromA.push_back(m_symbolic->entry(m_base[i] + row, m_base[i] + col));
  return true;
}

void VelocitySystem::mapEntries() {
  m_fromContacts.clear();
  for (std::size_t c = 0; c < m_contacts.size(); ++c)
    for (std::size_t a = 0; a < m_terms[c].size(); ++a)
      for (std::size_t b = 0; b <= a; ++b) m_fromContacts.push_back(m_symbolic->entry(m_terms[c][a].block, m_terms[c][b].block));
}

void VelocitySystem::speeds(const VecX& v, VecX& w) const {
  for (std::size_t c = 0; c < m_contacts.size(); ++c) {
    Vec3 sum = Vec3::Zero();
    for (const Term& term : m_terms[c]) sum += term.C * v.segment<3>(3 * term.block);
    setRowsOf(m_contacts[c], sum, w);
  }
}

void VelocitySystem::addPush(const VecX& lambda, double sign, VecX& r) const {
  for (std::size_t c = 0; c < m_contacts.size(); ++c) {
    const Vec3 push = sign * rowsOf(m_contacts[c], lambda);
    if (push.isZero(0)) continue;
    for (const Term& term : m_terms[c]) r.segment<3>(3 * term.block) += term.C.transpose() * push;
  }
}

void VelocitySystem::multiplyA(const VecX& v, VecX& r) {
  for (std::size_t i = 0; i < m_islands.size(); ++i) {
    auto& [in, out] = m_local[i];
    const Eigen::Index size = m_islands[i].b->size();
    in = v.segment(3 * m_base[i], size);
    m_islands[i].A->multiply(in, out);
    r.segment(3 * m_base[i], size) = out;
  }
}

void VelocitySystem::momentum() {
  multiplyA(m_v, m_momentum);
  for (std::size_t i = 0; i < m_islands.size(); ++i) m_momentum.segment(3 * m_base[i], m_islands[i].b->size()) -= *m_islands[i].b;
}

void VelocitySystem::scatter() {
  for (std::size_t i = 0; i < m_islands.size(); ++i) *m_islands[i].v = m_v.segment(3 * m_base[i], m_islands[i].b->size());
}

void VelocitySystem::begin(const VecX& lambda, VecX& w) {
  for (std::size_t i = 0; i < m_islands.size(); ++i) m_v.segment(3 * m_base[i], m_islands[i].b->size()) = *m_islands[i].b;
  addPush(lambda, 1, m_v);
  for (std::size_t i = 0; i < m_islands.size(); ++i) m_islands[i].response->solve(m_v.segment(3 * m_base[i], m_islands[i].b->size()));
  momentum();
  speeds(m_v, w);
  w.head(m_rows) += m_d;
  scatter();
}

void VelocitySystem::residual(const VecX& lambda) {
  m_gradient = m_momentum;
  addPush(lambda, -1, m_gradient);
}

bool VelocitySystem::factor(std::span<const ConePoint> points) {
  m_H->setZero();
  std::size_t next = 0;
  for (const VelocityIsland& island : m_islands)
    for (const auto& [slot, row, col] : island.A->symbolic().stored()) m_H->add(m_fromA[next++], storedBlock(*island.A, slot));
  next = 0;
  for (std::size_t c = 0; c < m_contacts.size(); ++c) {
    const int rank = std::min(points[c].rank, m_contacts[c].rows());
    const std::size_t count = m_terms[c].size();
    if (rank > 0) {
      Mat3 root = Mat3::Zero();
      root.leftCols(rank) = points[c].root.leftCols(rank);
      const Mat3 slope = root * root.transpose();
      std::size_t at = next;
      for (std::size_t a = 0; a < count; ++a) {
        const Mat3 left = m_terms[c][a].C.transpose() * slope;
        for (std::size_t b = 0; b <= a; ++b) {
          Mat3 block = left * m_terms[c][b].C;
          if (a == b) block = 0.5 * (block + block.transpose()).eval();  // diagonal blocks must be symmetric to the bit
          m_H->add(m_fromContacts[at++], block);
        }
      }
    }
    next += count * (count + 1) / 2;
  }
  return m_factor->factor(*m_H);
}

ContactSystem::Along VelocitySystem::step(VecX& dw) {
  m_dv = -m_gradient;
  m_factor->solve(m_dv);
  speeds(m_dv, dw);
  multiplyA(m_dv, m_product);
  return {m_momentum.dot(m_dv), m_product.dot(m_dv)};
}

void VelocitySystem::respond(const VecX& impulses, VecX& dw) {
  m_product.setZero();
  addPush(impulses, 1, m_product);
  m_factor->solve(m_product);
  speeds(m_product, dw);
}

void VelocitySystem::move(double alpha, VecX& w) {
  m_v += alpha * m_dv;
  momentum();
  speeds(m_v, w);
  w.head(m_rows) += m_d;
  scatter();
}

double VelocitySystem::imbalance(const VecX& lambda) {
  m_product = m_momentum;
  addPush(lambda, -1, m_product);
  double worst = 0;
  for (int block = 0; block < m_blocks; ++block)
    worst = std::max(worst, (m_inverse[block] * m_product.segment<3>(3 * block)).cwiseAbs().maxCoeff());
  return worst;
}

}  // namespace glenoid
