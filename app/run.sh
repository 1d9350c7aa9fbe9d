#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds Glenoid Studio and opens it on the built-in shoulder: app/run.sh [SCENARIO]
# Where there is no display, it runs the scene for ten seconds and leaves a picture and a report in ./out
# (or in the folder that GLENOID_OUT names).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../resources/packaging/prepare.sh"

case "${1:-}" in
  -h | --help)
    sed -n 's/^# \{0,1\}//p' "${BASH_SOURCE[0]}" | sed 1,2d
    exit 0
    ;;
esac
scenario=${1:-builtin:arthroscopy}

glenoid_install_packages
glenoid_make glenoid

program=$glenoid_build/bin/glenoid
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  exec "$program" "$scenario"
fi

out=${GLENOID_OUT:-$PWD/out}
mkdir -p "$out"
name=$(basename "${scenario#builtin:}" .scenario.json)
echo "There is no display: running $scenario for ten seconds instead of opening the window."
"$program" run "$scenario" --seconds 10 --report "$out/$name-report.json" --render "$out/$name.png"
echo "Picture: $out/$name.png"
echo "Report:  $out/$name-report.json"
