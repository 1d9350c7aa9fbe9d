// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <numeric>

#include "simcore/linear/BlockCholesky.h"
#include "simcore/linear/ConjugateGradients.h"
#include "tests/simcore/linear/Problems.h"

namespace {
std::atomic<long> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
  if (void* p = std::aligned_alloc(alignment, rounded ? rounded : alignment)) return p;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}
void* operator new[](std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t a) {
  return counted(size, static_cast<std::size_t>(a));
}
void* operator new[](std::size_t size, std::align_val_t a) {
  return counted(size, static_cast<std::size_t>(a));
}
void operator delete(void* p) noexcept {
  std::free(p);
}
void operator delete[](void* p) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}
void operator delete[](void* p, std::size_t) noexcept {
  std::free(p);
}
void operator delete(void* p, std::align_val_t) noexcept {
  std::free(p);
}
void operator delete[](void* p, std::align_val_t) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept {
  std::free(p);
}
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept {
  std::free(p);
}

namespace glenoid::test {

TEST(LinearAllocation, countingWorks) {
  const long before = allocations;
  const AlignedBuffer buffer(100);
  const std::vector<int> plain(100);
  EXPECT_EQ(allocations - before, 2) << buffer.size() + plain.size();
}

TEST(LinearAllocation, warmStepsAllocateNothing) {
  const ShoulderSize problem = shoulderSize();
  const int size = 3 * problem.symbolic->blockCount();
  BlockMatrix A = *problem.A;
  BlockCholesky cholesky(problem.symbolic);
  RowPanels panels;
  const VecX b = Random(1).vector(size);
  VecX x = b, y(size), guess = VecX::Zero(size);
  MatX W(65, 65);
  CgWork work;
  PowerWork power;
  const std::function<void(VecX&)> identity = [](VecX&) {};
  std::vector<std::vector<std::vector<RowTerm>>> rows;
  std::vector<std::vector<SparseRow>> J;
  for (const int count : {65, 30, 65, 17}) {
    rows.push_back(problem.contactRows(count, 9));
    J.push_back(asRows(rows.back()));
  }
  std::vector<int> ids(65);
  std::iota(ids.begin(), ids.end(), 0);
  const std::vector<double> lambda(65, 1.0);

  long counted = 0;
  for (int step = 0; step < 6; ++step) {
    const long before = allocations;
    A.setZero();
    std::copy(problem.A->values().begin(), problem.A->values().end(), A.values().begin());
    A.add(A.symbolic().entry(step, step), Mat3::Identity());
    const bool factored = cholesky.factor(A);
    x = b;
    cholesky.solve(x);
    // Fewer rows later: a smaller problem must not shrink anything.
    const auto& own = J[static_cast<std::size_t>(step % 4)];
    cholesky.halfSolve(own, panels);
    W.setZero();
    cholesky.addDelassus(panels, {ids.data(), own.size()}, W);
    cholesky.addImpulses(panels, {lambda.data(), own.size()}, x);
    guess.setZero();
    solveConjugateGradients(A, b, guess, {1e-6, 20}, work, step % 2 == 1);
    estimateLambdaMax(A, identity, 3, power);
    A.multiply(b, y);
    if (step >= 2) counted += allocations - before;
    ASSERT_TRUE(factored);
  }
  EXPECT_EQ(counted, 0);
}

}  // namespace glenoid::test
