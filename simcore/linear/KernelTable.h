// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/linear/BlockSymbolic.h"

namespace glenoid {

/// BlockSymbolic as plain pointers, for the inner loops. All indices are elimination positions and slots.
struct FactorTables {
  int columns;
  const int* columnStart;
  const int* rows;
  const int* updateStart;
  const BlockSymbolic::Update* updates;
  const int* targets;
};

/// The inner loops, once for each instruction set. A slot is 12 doubles (three columns of four lanes, see
/// BlockMatrix); a padded vector has four doubles per block, the fourth zero. Diagonal slots of a factor hold
/// the inverse M of L's lower triangular diagonal block.
struct KernelTable {
  const char* name;
  /// l ← L of A in `a`; false when a pivot is not positive or not finite.
  bool (*factor)(const FactorTables& t, const double* a, double* l);
  /// x ← L⁻¹ x and x ← L⁻ᵀ x, padded vector in elimination order.
  void (*forward)(const FactorTables& t, const double* l, double* x);
  void (*backward)(const FactorTables& t, const double* l, double* x);
  /// y ← L⁻¹ y for 4 or 8 right-hand sides at once, on the `count` blocks listed (ascending, closed under
  /// parents); place[position] is a block's place in the list; per listed block 3 × lanes doubles.
  void (*halfSolve)(const FactorTables& t, const double* l, int lanes, const int* blocks, int count,
                    const int* place, double* y);
  /// tile(i, j) = Σ y_iᵀ z_j over `count` shared blocks, given as pairs of places; tile is lanesY × lanesZ by
  /// rows.
  void (*products)(const double* y, int lanesY, const double* z, int lanesZ, const int* pairs, int count,
                   double* tile);
  /// u_block += Σ_lane y(block, ·, lane) λ(lane); u is a padded vector.
  void (*combine)(const double* y, int lanes, const double* lambda, const int* blocks, int count, double* u);
  /// y += A x over the stored blocks of A; padded vectors in the caller's order. The same bits in every
  /// table.
  void (*multiply)(const BlockSymbolic::Stored* stored, int count, const double* a, const double* x,
                   double* y);
};

/// Plain C++.
const KernelTable& portableKernels();
/// AVX2 with fused multiply-add; null where the processor or the compiler has none.
const KernelTable* avx2Kernels();
/// The best of the two, or the portable ones when asked for.
const KernelTable& chooseKernels(bool portable);

}  // namespace glenoid
