// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/linear/BlockCholesky.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "simcore/linear/KernelTable.h"

namespace glenoid {
namespace {

constexpr int kLanes = 8;

FactorTables tablesOf(const BlockSymbolic& s) {
  return {s.blockCount(),          s.columnStarts().data(), s.rows().data(),
          s.updateStarts().data(), s.updates().data(),      s.targets().data()};
}

}  // namespace

BlockCholesky::BlockCholesky(std::shared_ptr<const BlockSymbolic> symbolic, bool portable)
    : m_symbolic(std::move(symbolic)),
      m_kernels(&chooseKernels(portable)),
      m_factor(BlockMatrix::kSlotSize * static_cast<std::size_t>(m_symbolic->slotCount())),
      m_padded(4 * static_cast<std::size_t>(m_symbolic->blockCount())) {}

bool BlockCholesky::factor(const BlockMatrix& A) {
  assert(&A.symbolic() == m_symbolic.get());
  return m_kernels->factor(tablesOf(*m_symbolic), A.values().data(), m_factor.data());
}

void BlockCholesky::solve(Eigen::Ref<VecX> x) const {
  const int n = m_symbolic->blockCount();
  assert(x.size() == 3 * n);
  for (int j = 0; j < n; ++j) {
    const double* from = x.data() + 3 * m_symbolic->blockAt(j);
    double* to = m_padded.data() + 4 * j;
    to[0] = from[0];
    to[1] = from[1];
    to[2] = from[2];
    to[3] = 0.0;
  }
  const FactorTables tables = tablesOf(*m_symbolic);
  m_kernels->forward(tables, m_factor.data(), m_padded.data());
  m_kernels->backward(tables, m_factor.data(), m_padded.data());
  for (int j = 0; j < n; ++j)
    x.segment<3>(3 * m_symbolic->blockAt(j)) = Eigen::Map<const Vec3>(&m_padded[4 * j]);
}

void BlockCholesky::halfSolve(std::span<const SparseRow> rows, RowPanels& y) const {
  const int n = m_symbolic->blockCount();
  const auto parents = m_symbolic->parents();
  const auto depths = m_symbolic->depths();
  y.m_rowCount = static_cast<int>(rows.size());

  // Rows whose longest way to the root starts close by reach nearly the same blocks: they share a panel.
  y.m_keys.clear();
  for (int r = 0; r < y.m_rowCount; ++r) {
    int key = -1;
    for (const RowTerm& term : rows[r]) {
      assert(term.block >= 0 && term.block < n);
      const int position = m_symbolic->position(term.block);
      if (key < 0 || depths[position] > depths[key]) key = position;
    }
    y.m_keys.emplace_back(key, r);
  }
  std::sort(y.m_keys.begin(), y.m_keys.end());
  y.m_order.clear();
  for (const auto& key : y.m_keys) y.m_order.push_back(key.second);

  y.m_panels.clear();
  y.m_blocks.clear();
  std::size_t values = 0;
  for (int first = 0; first < y.m_rowCount; first += kLanes) {
    const int count = std::min(kLanes, y.m_rowCount - first);
    const int lanes = count <= 4 ? 4 : kLanes;
    y.m_reached.assign(static_cast<std::size_t>(n + 63) / 64, 0);
    for (int lane = 0; lane < count; ++lane) {
      for (const RowTerm& term : rows[y.m_order[first + lane]]) {
        for (int p = m_symbolic->position(term.block); p >= 0; p = parents[p]) {
          std::uint64_t& word = y.m_reached[static_cast<std::size_t>(p) / 64];
          const std::uint64_t bit = std::uint64_t{1} << (p % 64);
          if (word & bit) break;
          word |= bit;
        }
      }
    }
    const int firstBlock = static_cast<int>(y.m_blocks.size());
    for (std::size_t w = 0; w < y.m_reached.size(); ++w)
      for (std::uint64_t word = y.m_reached[w]; word; word &= word - 1)
        y.m_blocks.push_back(static_cast<int>(64 * w) + std::countr_zero(word));
    const int blocks = static_cast<int>(y.m_blocks.size()) - firstBlock;
    y.m_panels.push_back({lanes, first, count, firstBlock, blocks, values});
    values += 3 * static_cast<std::size_t>(lanes * blocks);
  }

  y.m_place.assign(y.m_panels.size() * static_cast<std::size_t>(n), -1);
  y.m_values.assign(values, 0.0);
  const FactorTables tables = tablesOf(*m_symbolic);
  for (std::size_t g = 0; g < y.m_panels.size(); ++g) {
    const RowPanels::Panel& panel = y.m_panels[g];
    const int* blocks = y.m_blocks.data() + panel.firstBlock;
    int* place = y.m_place.data() + g * static_cast<std::size_t>(n);
    double* data = y.m_values.data() + panel.firstValue;
    for (int p = 0; p < panel.blocks; ++p) place[blocks[p]] = p;
    for (int lane = 0; lane < panel.rows; ++lane) {
      for (const RowTerm& term : rows[y.m_order[panel.firstRow + lane]]) {
        double* to = data + 3 * panel.lanes * place[m_symbolic->position(term.block)] + lane;
        for (int r = 0; r < 3; ++r) to[r * panel.lanes] += term.coefficient[r];
      }
    }
    m_kernels->halfSolve(tables, m_factor.data(), panel.lanes, blocks, panel.blocks, place, data);
  }
}

void BlockCholesky::addDelassus(const RowPanels& y, std::span<const int> rowIds, Eigen::Ref<MatX> W) const {
  assert(static_cast<int>(rowIds.size()) == y.m_rowCount);
  const auto n = static_cast<std::size_t>(m_symbolic->blockCount());
  alignas(64) double tile[kLanes * kLanes];
  y.m_common.resize(std::max(y.m_common.size(), 2 * (n + 1)));
  for (std::size_t g = 0; g < y.m_panels.size(); ++g) {
    const RowPanels::Panel& left = y.m_panels[g];
    const int* place = y.m_place.data() + g * n;
    for (std::size_t h = 0; h <= g; ++h) {
      const RowPanels::Panel& right = y.m_panels[h];
      const int* blocks = y.m_blocks.data() + right.firstBlock;
      int* common = y.m_common.data();
      int count = 0;
      for (int p = 0; p < right.blocks; ++p) {  // without a branch: kept only where both have the block
        common[2 * count] = place[blocks[p]];
        common[2 * count + 1] = p;
        count += place[blocks[p]] >= 0;
      }
      if (count == 0) continue;
      m_kernels->products(y.m_values.data() + left.firstValue, left.lanes,
                          y.m_values.data() + right.firstValue, right.lanes, common, count, tile);
      for (int i = 0; i < left.rows; ++i) {
        const int row = rowIds[y.m_order[left.firstRow + i]];
        const int end = g == h ? i + 1 : right.rows;
        for (int j = 0; j < end; ++j) {
          const int col = rowIds[y.m_order[right.firstRow + j]];
          const double value = tile[right.lanes * i + j];
          W(row, col) += value;
          if (g != h || i != j) W(col, row) += value;
        }
      }
    }
  }
}

void BlockCholesky::addImpulses(const RowPanels& y, std::span<const double> lambda,
                                Eigen::Ref<VecX> v) const {
  const int n = m_symbolic->blockCount();
  assert(static_cast<int>(lambda.size()) == y.m_rowCount && v.size() == 3 * n);
  std::fill(m_padded.begin(), m_padded.end(), 0.0);
  for (const RowPanels::Panel& panel : y.m_panels) {
    alignas(64) double own[kLanes] = {};
    bool any = false;
    for (int lane = 0; lane < panel.rows; ++lane) {
      own[lane] = lambda[y.m_order[panel.firstRow + lane]];
      any = any || own[lane] != 0.0;
    }
    if (!any) continue;  // inactive contacts are common
    m_kernels->combine(y.m_values.data() + panel.firstValue, panel.lanes, own,
                       y.m_blocks.data() + panel.firstBlock, panel.blocks, m_padded.data());
  }
  m_kernels->backward(tablesOf(*m_symbolic), m_factor.data(), m_padded.data());
  for (int j = 0; j < n; ++j)
    v.segment<3>(3 * m_symbolic->blockAt(j)) += Eigen::Map<const Vec3>(&m_padded[4 * j]);
}

}  // namespace glenoid
