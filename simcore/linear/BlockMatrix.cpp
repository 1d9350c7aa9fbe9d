// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/linear/BlockMatrix.h"

#include <algorithm>
#include <cassert>

#include "simcore/linear/KernelTable.h"

namespace glenoid {
namespace {

using Padded = Eigen::Map<Mat3, Eigen::Unaligned, Eigen::OuterStride<4>>;
using ConstPadded = Eigen::Map<const Mat3, Eigen::Unaligned, Eigen::OuterStride<4>>;

}  // namespace

BlockMatrix::BlockMatrix(std::shared_ptr<const BlockSymbolic> symbolic)
    : m_symbolic(std::move(symbolic)),
      m_values(kSlotSize * static_cast<std::size_t>(m_symbolic->slotCount()), 0.0),
      m_padded(8 * static_cast<std::size_t>(m_symbolic->blockCount()), 0.0) {}

void BlockMatrix::setZero() {
  std::fill(m_values.begin(), m_values.end(), 0.0);
}

void BlockMatrix::add(BlockEntry entry, const Mat3& block) {
  assert(entry.slot >= 0 && entry.slot < m_symbolic->slotCount());
  Padded stored(slot(entry.slot));
  if (entry.transposed)
    stored += block.transpose();
  else
    stored += block;
}

Mat3 BlockMatrix::block(int row, int col) const {
  const BlockEntry entry = m_symbolic->entry(row, col);
  if (entry.slot < 0) return Mat3::Zero();
  const ConstPadded stored(slot(entry.slot));
  return entry.transposed ? Mat3(stored.transpose()) : Mat3(stored);
}

void BlockMatrix::multiply(const VecX& x, VecX& y) const {
  const int n = m_symbolic->blockCount();
  assert(x.size() == 3 * n);
  double* in = m_padded.data();
  double* out = in + 4 * static_cast<std::ptrdiff_t>(n);
  for (int i = 0; i < n; ++i) {
    for (int r = 0; r < 3; ++r) in[4 * i + r] = x[3 * i + r];
    in[4 * i + 3] = 0.0;
  }
  std::fill(out, out + 4 * static_cast<std::ptrdiff_t>(n), 0.0);
  const auto stored = m_symbolic->stored();
  chooseKernels(false).multiply(stored.data(), static_cast<int>(stored.size()), m_values.data(), in, out);
  y.resize(3 * n);
  for (int i = 0; i < n; ++i)
    for (int r = 0; r < 3; ++r) y[3 * i + r] = out[4 * i + r];
}

MatX BlockMatrix::toDense() const {
  const int n = m_symbolic->blockCount();
  MatX dense = MatX::Zero(3 * n, 3 * n);
  for (const auto& [index, row, col] : m_symbolic->stored()) {
    const ConstPadded stored(slot(index));
    dense.block<3, 3>(3 * row, 3 * col) = stored;
    if (row != col) dense.block<3, 3>(3 * col, 3 * row) = stored.transpose();
  }
  return dense;
}

}  // namespace glenoid
