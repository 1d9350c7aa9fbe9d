// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "simcore/linear/AlignedBuffer.h"

namespace glenoid {

/// Y = L⁻¹Jᵀ as BlockCholesky::halfSolve leaves it: rows in panels of up to eight lanes, rows of similar
/// reach side by side, and for each panel only the blocks that one of its rows reaches. Work: may be dropped
/// or reused for anything; it grows only, so a warm object allocates nothing.
class RowPanels {
 public:
  int rowCount() const { return m_rowCount; }
  /// Blocks stored over all panels; a measure of sparsity.
  int storedBlocks() const { return static_cast<int>(m_blocks.size()); }

 private:
  friend class BlockCholesky;
  struct Panel {
    int lanes;       ///< 4 or 8, unused ones are zero
    int firstRow;    ///< index into m_order
    int rows;        ///< used lanes
    int firstBlock;  ///< index into m_blocks
    int blocks;
    std::size_t firstValue;  ///< index into m_values: per block 3 × lanes
  };
  int m_rowCount = 0;
  std::vector<Panel> m_panels;
  std::vector<int> m_order;                 ///< row held by each lane, panel after panel
  std::vector<int> m_blocks;                ///< elimination positions, ascending within a panel
  std::vector<int> m_place;                 ///< panel × blockCount: place of a block in its panel or −1
  std::vector<std::uint64_t> m_reached;     ///< bit set over positions
  std::vector<std::pair<int, int>> m_keys;  ///< sort key and row
  mutable std::vector<int> m_common;        ///< places of blocks that two panels share, pairwise
  AlignedBuffer m_values;
};

}  // namespace glenoid
