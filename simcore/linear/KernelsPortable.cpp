// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "simcore/linear/KernelTable.h"

// Four lanes as two pairs, in the vector notation of GCC and Clang: the compiler makes of it what the base
// instruction set offers (SSE2, NEON, scalars). No fused operation, so the bits are the same on every
// processor.
#define GLENOID_KERNEL static
#define GLENOID_LANE_OP static inline __attribute__((always_inline))
namespace glenoid {
namespace {

typedef double V2 __attribute__((vector_size(16), may_alias));
struct V4 {
  V2 low, high;
};
GLENOID_LANE_OP V4 load(const double* p) {
  return {*reinterpret_cast<const V2*>(p), *reinterpret_cast<const V2*>(p + 2)};
}
GLENOID_LANE_OP void store(double* p, const V4& v) {
  *reinterpret_cast<V2*>(p) = v.low;
  *reinterpret_cast<V2*>(p + 2) = v.high;
}
GLENOID_LANE_OP V4 spread(double s) {
  return {V2{s, s}, V2{s, s}};
}
GLENOID_LANE_OP V4 add(const V4& x, const V4& y) {
  return {x.low + y.low, x.high + y.high};
}
GLENOID_LANE_OP V4 mul(const V4& x, const V4& y) {
  return {x.low * y.low, x.high * y.high};
}
GLENOID_LANE_OP V4 addMul(const V4& c, const V4& x, const V4& y) {  // c + x y
  return {c.low + x.low * y.low, c.high + x.high * y.high};
}
GLENOID_LANE_OP V4 subMul(const V4& c, const V4& x, const V4& y) {  // c − x y
  return {c.low - x.low * y.low, c.high - x.high * y.high};
}
GLENOID_LANE_OP V4 inverseRoots(double x, double y, double z) {
  return {V2{1.0 / std::sqrt(x), 1.0 / std::sqrt(y)}, V2{1.0 / std::sqrt(z), 1.0}};
}

#include "simcore/linear/KernelBodies.inc"

}  // namespace

const KernelTable& portableKernels() {
  static constexpr KernelTable table = makeTable("portable");
  return table;
}

}  // namespace glenoid
