// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>

#include "simcore/base/Math.h"

namespace glenoid {

/// One term of a constraint row: the row's 1×3 coefficient at a block column (caller's numbering).
struct RowTerm {
  int block;
  Vec3 coefficient;
};

/// A sparse row of J, terms ascending by block, each block at most once.
using SparseRow = std::span<const RowTerm>;

}  // namespace glenoid
