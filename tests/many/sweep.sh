# SPDX-License-Identifier: GPL-3.0-or-later
# What both schedulers' scripts need. Source it with GLENOID set to the program.
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 QT_QPA_PLATFORM=offscreen LIBGL_ALWAYS_SOFTWARE=1
scene=${SCENE:-$(cd "$(dirname "${BASH_SOURCE[0]}")/../scenes/peers" && pwd)/soft.scenario.json}
extent=${EXTENT:---smallest}
shards=${SHARDS:-4}

say() { printf '%s\n' "$*"; }
fail() { say "FAILED: $*" >&2; exit 1; }

# shard K FOLDER: what one job does. It goes on by itself where an earlier one was stopped.
shard() { "$GLENOID" study accuracy "$scene" --out "$2" $extent --shard "$1/$shards" --resume; }

# Whether all shards are done, by our own files: a scheduler may say 0 of a job that was killed.
whole() { "$GLENOID" study accuracy "$scene" --out "$1" --status; }

# errors FOLDER: accuracy.json without what a clock or a machine decided.
errors() { grep -v -E '"(step|wall|work)(Median|P95|P99)Ms"|"stepsTimed"|"front|"machine"|"build"|"processor"' "$1/accuracy.json"; }

# compare ONE MANY: bit for bit.
compare() {
  errors "$1" >"$1.errors" && errors "$2" >"$2.errors"
  [ "$(grep -c '"setting"' "$1.errors")" -gt 5 ] || fail "there is nothing to compare"
  cmp "$1.errors" "$2.errors" || fail "shards and one run differ"
  say "The errors of $(grep -c '"setting"' "$1.errors") settings agree with one run, bit for bit."
}

# killed FOLDER: a shard that is killed as soon as it has kept a setting, as a scheduler would at the end of its time.
killed() {
  shard 1 "$1" >/dev/null 2>&1 &
  local job=$!
  for _ in $(seq 600); do
    grep -q '"finished": [1-9]' "$1/shard-1-of-$shards.status.json" 2>/dev/null && break
    kill -0 "$job" 2>/dev/null || fail "the shard ended before it could be killed"
    sleep 0.1
  done
  kill -9 "$(sed -n 's/.*"pid": \([0-9]*\).*/\1/p' "$1/shard-1-of-$shards.status.json")"
  wait "$job" 2>/dev/null
  if whole "$1" >"$1.status"; then fail "a killed shard counts as done"; fi
  grep "shard 1 of $shards: ended without a word" "$1.status" || fail "the killed shard is not told: $(cat "$1.status")"
}
