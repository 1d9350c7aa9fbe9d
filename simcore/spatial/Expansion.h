// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>

namespace glenoid {

/// Exact sum of doubles: components that do not overlap, smallest first; zero components are dropped. Only
/// for the rare predicate that rounding cannot decide. Exact unless something over- or underflows. N is the
/// most components that it can hold. Source: Shewchuk 1997, sections 2.3 to 2.5.
template <int N>
struct Expansion {
  std::array<double, N> part;
  int count = 0;

  int sign() const { return count == 0 ? 0 : (part[count - 1] > 0 ? 1 : -1); }
};

namespace expansion {

void grow(const double* e, int count, double b, double* out, int& outCount);
void scale(const double* e, int count, double b, double* out, int& outCount);

/// a − b without error.
Expansion<2> difference(double a, double b);

template <int M, int N>
Expansion<M + N> sum(const Expansion<M>& a, const Expansion<N>& b, double signOfB = 1) {
  Expansion<M + N> result;
  for (int i = 0; i < a.count; ++i) result.part[i] = a.part[i];
  result.count = a.count;
  for (int i = 0; i < b.count; ++i) {
    grow(result.part.data(), result.count, signOfB * b.part[i], result.part.data(), result.count);
  }
  return result;
}

template <int M, int N>
Expansion<2 * M * N> product(const Expansion<M>& a, const Expansion<N>& b) {
  Expansion<2 * M * N> result;
  for (int i = 0; i < b.count; ++i) {
    std::array<double, 2 * M> row;
    int rowCount = 0;
    scale(a.part.data(), a.count, b.part[i], row.data(), rowCount);
    for (int k = 0; k < rowCount; ++k) {
      grow(result.part.data(), result.count, row[k], result.part.data(), result.count);
    }
  }
  return result;
}

}  // namespace expansion
}  // namespace glenoid
