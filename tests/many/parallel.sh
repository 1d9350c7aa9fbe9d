#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A sweep in shards under GNU parallel, one of them killed on the way: parallel.sh GLENOID FOLDER
# FOLDER must not be there. SCENE, EXTENT and SHARDS of the environment choose another sweep (sweep.sh).
set -uo pipefail
export GLENOID=$1
folder=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/sweep.sh"
command -v parallel >/dev/null || { say "GNU parallel is not installed."; exit 77; }
mkdir "$folder" || exit 2
mkdir "$folder/many"

"$GLENOID" study accuracy "$scene" --out "$folder/one" $extent >/dev/null || fail "the run in one part"
killed "$folder/many"
export here folder shards scene extent
parallel -j2 "GLENOID=$GLENOID source $here/sweep.sh; shard {} $folder/many" ::: $(seq "$shards") >"$folder/log" 2>&1
say "parallel's exit status: $?"
grep -q "Going on after" "$folder/log" || fail "the killed shard began anew"
whole "$folder/many" || fail "not all shards are done"
"$GLENOID" study accuracy "$scene" --out "$folder/many" $extent --merge >/dev/null || fail "merging"
compare "$folder/one" "$folder/many"
