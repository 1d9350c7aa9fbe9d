#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Eigen 3.4.0 (Debian 12): -fsanitize=address changes how Eigen's matrices are allocated and freed, as another binary interface.
#
# Where malloc aligns to 16 bytes, Eigen takes what malloc gives and hands it back to free. Under the address sanitizer it asks
# for 16 bytes more, keeps the first address in front of the numbers and frees that. So an object file that was compiled with the
# sanitizer must not free what another one without it has allocated: a test compiled with it beside a library without it reports
# a heap overflow in Eigen's own code where both are right. EIGEN_MALLOC_ALREADY_ALIGNED=1 in the sanitized file
# brings both together again.
#
# Guess before trying: the sanitizer replaces malloc and instruments accesses; which bytes a library asks for stays the same, so
# a library without it may be linked to a test with it, whose own code alone is then watched.
#
# Installs pinned public packages in a temporary folder, states what it saw, ends with 1 where that is no longer so.
set -euo pipefail
eigen=3.4.0-4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libeigen3-dev=$eigen" >/dev/null 2>&1
dpkg -x libeigen3-dev_*.deb .

cat >asked.cpp <<'CODE'
#include <Eigen/Core>
#include <cstdio>
static std::size_t asked = 0;
extern "C" void* __real_malloc(std::size_t size);
extern "C" void* __wrap_malloc(std::size_t size) {
  asked = size;
  return __real_malloc(size);
}
int main() {
  const Eigen::VectorXd numbers = Eigen::VectorXd::Zero(100);
  const std::size_t bytes = asked;
  std::printf("%d %zu %zu\n", EIGEN_MALLOC_ALREADY_ALIGNED, bytes, static_cast<std::size_t>(numbers.size()) * sizeof(double));
}
CODE
build() { c++ -std=c++17 -O1 -I usr/include/eigen3 -Wl,--wrap=malloc "$@" asked.cpp -o asked && ASAN_OPTIONS=detect_leaks=0 ./asked; }
plain=$(build)
sanitized=$(build -fsanitize=address)
told=$(build -fsanitize=address -DEIGEN_MALLOC_ALREADY_ALIGNED=1)
echo "libeigen3-dev $eigen, $(c++ --version | head -1)"
echo "a vector of 100 doubles (takes malloc's alignment, bytes asked for, bytes of numbers):"
echo "  plain:                                 $plain"
echo "  -fsanitize=address:                    $sanitized"
echo "  and EIGEN_MALLOC_ALREADY_ALIGNED=1:    $told"
[ "$plain" = "1 800 800" ] && [ "$sanitized" = "0 816 800" ] && [ "$told" = "1 800 800" ]
