// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/linear/KernelTable.h"

#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
#include <immintrin.h>

// Only these functions are compiled for AVX2; the file keeps the base flags, so nothing that it shares with
// other files (inline functions of headers) can end up with instructions an older processor lacks.
#define GLENOID_KERNEL __attribute__((target("avx2,fma"))) static
#define GLENOID_LANE_OP __attribute__((target("avx2,fma"), always_inline)) static inline
namespace glenoid {
namespace {

using V4 = __m256d;
GLENOID_LANE_OP V4 load(const double* p) {
  return _mm256_load_pd(p);
}
GLENOID_LANE_OP void store(double* p, V4 v) {
  _mm256_store_pd(p, v);
}
GLENOID_LANE_OP V4 spread(double s) {
  return _mm256_set1_pd(s);
}
GLENOID_LANE_OP V4 add(V4 x, V4 y) {
  return _mm256_add_pd(x, y);
}
GLENOID_LANE_OP V4 mul(V4 x, V4 y) {
  return _mm256_mul_pd(x, y);
}
GLENOID_LANE_OP V4 addMul(V4 c, V4 x, V4 y) {
  return _mm256_fmadd_pd(x, y, c);
}
GLENOID_LANE_OP V4 subMul(V4 c, V4 x, V4 y) {
  return _mm256_fnmadd_pd(x, y, c);
}
GLENOID_LANE_OP V4 inverseRoots(double x, double y, double z) {
  return _mm256_div_pd(_mm256_set1_pd(1.0), _mm256_sqrt_pd(_mm256_setr_pd(x, y, z, 1.0)));
}

#include "simcore/linear/KernelBodies.inc"

}  // namespace

const KernelTable* avx2Kernels() {
  static constexpr KernelTable table = makeTable("avx2-fma");
  static const bool supported = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return supported ? &table : nullptr;
}

}  // namespace glenoid
#else
namespace glenoid {
const KernelTable* avx2Kernels() {
  return nullptr;
}
}  // namespace glenoid
#endif
