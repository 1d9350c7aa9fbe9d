#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds everything and runs every test: tests/run.sh [--quick] [--sanitizers] [arguments for ctest, such as -R NAME]
# --quick leaves out the tests that are labelled long. Tests with windows run on a virtual screen.
# --sanitizers goes on with simcore's tests in their short form under the address and undefined behaviour sanitizers (but for
# those that run at length what others check once), and those with threads under the thread sanitizer, each in a build of its own (some twenty minutes more on two cores); what
# continuous integration does. Where more than GLENOID_SANITIZERS_UNTIL seconds (3300) have gone into the rest, there is no time
# for them, and that is a failure.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../resources/packaging/prepare.sh"

quick=0 sanitizers=0
arguments=()
for argument in "$@"; do
  case "$argument" in
    --quick) quick=1 ;;
    --sanitizers) sanitizers=1 ;;
    -h | --help)
      sed -n 's/^# \{0,1\}//p' "${BASH_SOURCE[0]}" | sed 1,2d
      exit 0
      ;;
    *) arguments+=("$argument") ;;
  esac
done
without='^gui$'
[ "$quick" = 1 ] && without='^(gui|long)$'

glenoid_lists+=(packages-tests-debian12.txt)
glenoid_install_packages
glenoid_make all

export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1
export LIBGL_ALWAYS_SOFTWARE=1  # the same pictures with and without a graphics card
tests=(ctest --test-dir "$glenoid_build" --output-on-failure ${arguments[@]+"${arguments[@]}"})

count() { "$@" -N | sed -n 's/^Total Tests: //p'; }

failed=0 ran=0
if [ "$(count "${tests[@]}" -LE "$without")" -gt 0 ]; then
  ran=1
  QT_QPA_PLATFORM=offscreen "${tests[@]}" -LE "$without" -j2 </dev/null || failed=1
fi
window=(-L '^gui$')
[ "$quick" = 1 ] && window+=(-LE '^long$')
if [ "$(count "${tests[@]}" "${window[@]}")" -gt 0 ]; then
  ran=1
  QT_QPA_PLATFORM=xcb xvfb-run -a -s "-screen 0 1600x1000x24" "${tests[@]}" "${window[@]}" </dev/null || failed=1
fi

sanitized() {  # PRESET TARGET LABEL: builds one target by a preset and runs the short tests of a label there
  local build=$glenoid_root/build/$1
  if [ ! -f "$build/build.ninja" ]; then
    (cd "$glenoid_root" && cmake --preset "$1" -DGLENOID_TESTS=ON) >&2 || return 1
  fi
  cmake --build "$build" --parallel "$(glenoid_jobs)" --target "$2" >&2 || return 1
  ctest --test-dir "$build" --output-on-failure -L "^$3\$" -LE '^long$' -j2 </dev/null
}
if [ "$sanitizers" = 1 ] && [ "$SECONDS" -gt "${GLENOID_SANITIZERS_UNTIL:-3300}" ]; then
  glenoid_say "No time is left for the sanitizers: $((SECONDS / 60)) minutes have gone into the other tests."
  failed=1
elif [ "$sanitizers" = 1 ]; then
  sanitized asan sanitized_tests sanitized || failed=1
  sanitized tsan thread_tests threads || failed=1
fi
if [ "$ran" = 0 ]; then
  glenoid_say "No test fits these arguments."
  exit 1
fi
exit "$failed"
