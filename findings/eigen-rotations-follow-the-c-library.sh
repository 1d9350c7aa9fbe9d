#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Eigen 3.4.0 (Debian 12): turning and blending rotations gives other bits on another processor, although the program is
# the same file, compiled without any vector extension and without contraction.
#
# Quaternion::slerp, AngleAxis to and from matrices and quaternions, and SelfAdjointEigenSolver::computeDirect call the C
# library's sin, cos, acos and atan2. glibc chooses among several versions of these when the program starts, by what the
# processor can do, and those that use fused multiply-add round a few last bits otherwise. Products, sums, norms,
# inverses, Quaternion from and to matrices and the iterative SelfAdjointEigenSolver stay the same.
#
# Guess before trying: what takes or gives an angle. The guess missed computeDirect, whose closed form solves the cubic by an
# angle, and slerp between close orientations.
#
# Installs pinned public packages in a temporary folder, states what it saw, ends with 1 where that is no longer so and
# with 2 where this machine cannot tell (no fused multiply-add, another C library).
set -euo pipefail
eigen=3.4.0-4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libeigen3-dev=$eigen" >/dev/null 2>&1
dpkg -x libeigen3-dev_*.deb .
grep -qw fma /proc/cpuinfo || { echo "This processor has no fused multiply-add."; exit 2; }
ldd --version 2>&1 | grep -q "2\.36" || { echo "Another C library than glibc 2.36."; exit 2; }

cat >bits.cpp <<'CODE'
#include <Eigen/Dense>
#include <cstdint>
#include <cstdio>
#include <cstring>
using namespace Eigen;
struct Bits {
  const char* name;
  std::uint64_t hash = 14695981039346656037u;
  void add(const double* x, int n) {
    for (int i = 0; i < n; ++i) {
      std::uint64_t b;
      std::memcpy(&b, x + i, 8);
      hash = (hash ^ b) * 1099511628211u;
    }
  }
};
int main() {
  Bits slerp{"slerp"}, axis{"AngleAxis"}, direct{"computeDirect"}, iterative{"compute"}, product{"product"};
  std::uint64_t state = 1;
  const auto random = [&] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 11) / 9007199254740992.0 - 0.5;
  };
  for (int i = 0; i < 20000; ++i) {
    const Quaterniond a = Quaterniond(random(), random(), random(), random()).normalized();
    const Quaterniond b = Quaterniond(random(), random(), random(), random()).normalized();
    const Quaterniond s = a.slerp(0.3, b), p = a * b;
    slerp.add(s.coeffs().data(), 4);
    product.add(p.coeffs().data(), 4);
    const Matrix3d r = AngleAxisd(3 * random(), a.vec().normalized()).toRotationMatrix();
    axis.add(r.data(), 9);
    Matrix3d m = Matrix3d::NullaryExpr([&] { return random(); });
    m = (m + m.transpose()).eval();
    SelfAdjointEigenSolver<Matrix3d> e;
    e.computeDirect(m);
    direct.add(e.eigenvalues().data(), 3);
    e.compute(m);
    iterative.add(e.eigenvalues().data(), 3);
  }
  for (const Bits& b : {slerp, axis, direct, iterative, product})
    std::printf("%s %016llx\n", b.name, static_cast<unsigned long long>(b.hash));
}
CODE
c++ -std=c++17 -O2 -ffp-contract=off -I usr/include/eigen3 bits.cpp -o bits
./bits >with
GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2,-AVX2_Usable,-FMA_Usable ./bits >without
echo "libeigen3-dev $eigen, $(c++ --version | head -1), glibc 2.36"
status=0
for name in slerp AngleAxis computeDirect compute product; do
  if [ "$(grep "^$name " with)" = "$(grep "^$name " without)" ]; then same="the same bits"; else same="other bits"; fi
  case $name in slerp | AngleAxis | computeDirect) expected="other bits" ;; *) expected="the same bits" ;; esac
  echo "$name with and without the C library's fused multiply-add: $same"
  [ "$same" = "$expected" ] || { echo "  expected: $expected"; status=1; }
done
exit "$status"
