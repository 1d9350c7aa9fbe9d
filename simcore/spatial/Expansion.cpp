// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/spatial/Expansion.h"

#include <cmath>

namespace glenoid::expansion {
namespace {

/// a + b = sum + error exactly.
void twoSum(double a, double b, double& sum, double& error) {
  sum = a + b;
  const double bVirtual = sum - a;
  error = (a - (sum - bVirtual)) + (b - bVirtual);
}

}  // namespace

Expansion<2> difference(double a, double b) {
  Expansion<2> result;
  double high, low;
  twoSum(a, -b, high, low);
  if (low != 0) result.part[result.count++] = low;
  if (high != 0) result.part[result.count++] = high;
  return result;
}

/// `out` may be `e`: each component is read before its place, or an earlier one, is written.
void grow(const double* e, int count, double b, double* out, int& outCount) {
  double carry = b;
  int written = 0;
  for (int i = 0; i < count; ++i) {
    double low;
    twoSum(carry, e[i], carry, low);
    if (low != 0) out[written++] = low;
  }
  if (carry != 0) out[written++] = carry;
  outCount = written;
}

/// Every product is split by a fused multiply-add, which is exact by definition; so is the sum of the parts.
void scale(const double* e, int count, double b, double* out, int& outCount) {
  outCount = 0;
  for (int i = 0; i < count; ++i) {
    const double high = e[i] * b;
    const double low = std::fma(e[i], b, -high);
    if (low != 0) grow(out, outCount, low, out, outCount);
    if (high != 0) grow(out, outCount, high, out, outCount);
  }
}

}  // namespace glenoid::expansion
