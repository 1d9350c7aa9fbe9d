// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/linear/ReferenceCholesky.h"

#include <cholmod.h>
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

namespace glenoid {
namespace {

constexpr int kRefinements = 2;

/// CHOLMOD's supernodal method calls BLAS; its threads cost more than they bring at this size and make times
/// jump. The function exists only where OpenBLAS is what the process loaded.
void pinBlasThreads() {
  using SetThreads = void (*)(int);
  if (const auto set = reinterpret_cast<SetThreads>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))) set(1);
}

}  // namespace

struct ReferenceCholesky::Impl {
  /// Where one scalar of the compressed columns comes from: index into BlockMatrix::values().
  std::shared_ptr<const BlockSymbolic> symbolic;
  cholmod_common common;
  cholmod_sparse* A = nullptr;  ///< lower triangle, caller's order
  cholmod_factor* L = nullptr;
  cholmod_dense* x = nullptr;
  cholmod_dense* y = nullptr;  ///< CHOLMOD's own scratch for solve2
  cholmod_dense* e = nullptr;
  cholmod_dense* rhs = nullptr;
  std::vector<int> source;
  std::vector<long double> residual;
  bool factored = false;

  Impl(std::shared_ptr<const BlockSymbolic> given, Method method) : symbolic(std::move(given)) {
    pinBlasThreads();
    cholmod_start(&common);
    common.print = 0;
    common.quick_return_if_not_posdef = 1;
    common.supernodal = method == Method::Simplicial   ? CHOLMOD_SIMPLICIAL
                        : method == Method::Supernodal ? CHOLMOD_SUPERNODAL
                                                       : CHOLMOD_AUTO;
    common.final_ll = 1;  // an indefinite matrix then fails, where LDLᵀ would go on
    common.nmethods = 1;  // AMD, as ours
    common.method[0].ordering = CHOLMOD_AMD;
    buildPattern();
    L = cholmod_analyze(A, &common);
    rhs = cholmod_allocate_dense(A->nrow, 1, A->nrow, CHOLMOD_REAL, &common);
    residual.resize(A->nrow);
  }

  ~Impl() {
    cholmod_free_dense(&x, &common);
    cholmod_free_dense(&y, &common);
    cholmod_free_dense(&e, &common);
    cholmod_free_dense(&rhs, &common);
    cholmod_free_factor(&L, &common);
    cholmod_free_sparse(&A, &common);
    cholmod_finish(&common);
  }

  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  /// Scalars of the lower triangle in the caller's order, sorted by column and row.
  void buildPattern() {
    std::vector<std::array<int, 3>> entries;  // column, row, source
    for (const auto& [slot, row, col] : symbolic->stored()) {
      for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) {
          const int i = 3 * row + r, j = 3 * col + c;
          if (row == col && r < c) continue;
          entries.push_back({std::min(i, j), std::max(i, j), BlockMatrix::kSlotSize * slot + 4 * c + r});
        }
      }
    }
    std::sort(entries.begin(), entries.end());
    const auto size = 3 * static_cast<std::size_t>(symbolic->blockCount());
    A = cholmod_allocate_sparse(size, size, entries.size(), 1, 1, -1, CHOLMOD_REAL, &common);
    auto* starts = static_cast<int*>(A->p);
    auto* rows = static_cast<int*>(A->i);
    std::fill(starts, starts + size + 1, 0);
    for (const auto& entry : entries) ++starts[entry[0] + 1];
    for (std::size_t j = 0; j < size; ++j) starts[j + 1] += starts[j];
    for (std::size_t s = 0; s < entries.size(); ++s) {
      rows[s] = entries[s][1];
      source.push_back(entries[s][2]);
    }
    std::fill_n(static_cast<double*>(A->x), entries.size(), 0.0);
  }

  /// rhs ← b − A x, summed in extended precision.
  void computeResidual(const Eigen::Ref<VecX>& b, const double* solution) {
    const auto* starts = static_cast<const int*>(A->p);
    const auto* rows = static_cast<const int*>(A->i);
    const auto* values = static_cast<const double*>(A->x);
    for (std::size_t j = 0; j < A->ncol; ++j) residual[j] = b[static_cast<Eigen::Index>(j)];
    for (std::size_t j = 0; j < A->ncol; ++j) {
      for (int s = starts[j]; s < starts[j + 1]; ++s) {
        const auto i = static_cast<std::size_t>(rows[s]);
        residual[i] -= static_cast<long double>(values[s]) * solution[j];
        if (i != j) residual[j] -= static_cast<long double>(values[s]) * solution[i];
      }
    }
    auto* out = static_cast<double*>(rhs->x);
    for (std::size_t j = 0; j < A->ncol; ++j) out[j] = static_cast<double>(residual[j]);
  }

  void solveRhs() { cholmod_solve2(CHOLMOD_A, L, rhs, nullptr, &x, nullptr, &y, &e, &common); }
};

ReferenceCholesky::ReferenceCholesky(std::shared_ptr<const BlockSymbolic> symbolic, Method method)
    : m_impl(std::make_unique<Impl>(std::move(symbolic), method)) {}
ReferenceCholesky::~ReferenceCholesky() = default;
ReferenceCholesky::ReferenceCholesky(ReferenceCholesky&&) noexcept = default;
ReferenceCholesky& ReferenceCholesky::operator=(ReferenceCholesky&&) noexcept = default;

bool ReferenceCholesky::factor(const BlockMatrix& matrix) {
  assert(&matrix.symbolic() == m_impl->symbolic.get());
  auto* values = static_cast<double*>(m_impl->A->x);
  const auto from = matrix.values();
  bool finite = true;
  for (std::size_t s = 0; s < m_impl->source.size(); ++s) {
    values[s] = from[static_cast<std::size_t>(m_impl->source[s])];
    finite = finite && std::isfinite(values[s]);
  }
  m_impl->factored = false;
  if (!finite) return false;
  if (m_impl->A->nrow == 0) return m_impl->factored = true;
  if (!cholmod_factorize(m_impl->A, m_impl->L, &m_impl->common)) return false;
  m_impl->factored = m_impl->common.status == CHOLMOD_OK && m_impl->L->minor == m_impl->L->n;
  return m_impl->factored;
}

void ReferenceCholesky::solve(Eigen::Ref<VecX> x) {
  Impl& impl = *m_impl;
  assert(impl.factored && static_cast<std::size_t>(x.size()) == impl.A->nrow);
  if (x.size() == 0) return;
  VecX solution(x.size());
  std::copy_n(x.data(), x.size(), static_cast<double*>(impl.rhs->x));
  impl.solveRhs();
  std::copy_n(static_cast<const double*>(impl.x->x), x.size(), solution.data());
  for (int step = 0; step < kRefinements; ++step) {
    impl.computeResidual(x, solution.data());
    impl.solveRhs();
    solution += Eigen::Map<const VecX>(static_cast<const double*>(impl.x->x), x.size());
  }
  x = solution;
}

}  // namespace glenoid
