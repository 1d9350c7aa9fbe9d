#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A sweep in shards under a real Slurm that is started here, on this machine, without systemd: slurm.sh GLENOID FOLDER
# Wants Debian's slurm-wlm and munge, and to be root. FOLDER must not be there; everything that Slurm keeps lies in it. Ends what it started.
# Tasks of the array are batches of shards: Slurm starts a wave of tasks every three seconds or so. SCENE, EXTENT, SHARDS and TASKS of the
# environment choose another sweep (sweep.sh).
set -uo pipefail
export GLENOID=$1
folder=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/sweep.sh"
tasks=${TASKS:-2}
for program in munged slurmctld slurmd sbatch; do
  PATH=$PATH:/usr/sbin command -v "$program" >/dev/null || { say "$program is not installed."; exit 77; }
done
PATH=$PATH:/usr/sbin
[ "$(id -u)" = 0 ] || { say "Slurm's daemons want to be root."; exit 77; }
mkdir "$folder" || exit 2
folder=$(cd "$folder" && pwd)
mkdir "$folder/many" "$folder/state" "$folder/spool" "$folder/munge"

daemons=()
stop() {
  for pid in "${daemons[@]}"; do kill "$pid" 2>/dev/null; done
  sleep 1
  for pid in "${daemons[@]}"; do kill -9 "$pid" 2>/dev/null; done
}
trap stop EXIT

# munged wants a key and a socket of its own user's.
dd if=/dev/urandom of="$folder/munge/key" bs=1024 count=1 status=none
chmod 400 "$folder/munge/key"
chmod 711 "$folder" "$folder/munge"
munged --foreground --force --key-file="$folder/munge/key" --socket="$folder/munge/socket" --pid-file="$folder/munge/pid" --log-file="$folder/munge/log" \
  --seed-file="$folder/munge/seed" >/dev/null 2>&1 &
daemons+=($!)

cores=$(nproc --all)  # OMP_NUM_THREADS would hold it at 1
cat >"$folder/slurm.conf" <<CONF
ClusterName=glenoid
SlurmctldHost=localhost(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
CryptoType=crypto/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SwitchType=switch/none
ReturnToService=2
SlurmctldPort=36817
SlurmdPort=36818
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=5
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
NodeName=localhost NodeAddr=127.0.0.1 CPUs=$cores State=UNKNOWN
PartitionName=main Nodes=localhost Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$folder/slurm.conf
sleep 1
slurmctld -D -c >/dev/null 2>&1 &
daemons+=($!)
slurmd -D -N localhost >/dev/null 2>&1 &
daemons+=($!)
for _ in $(seq 60); do
  sinfo -h -o %t 2>/dev/null | grep -q idle && break
  sleep 1
done
sinfo -h -o %t | grep -q idle || fail "the node does not come up: $(tail -3 "$folder/slurmctld.log" "$folder/slurmd.log")"
say "$(slurmd -V), $cores processors"

cat >"$folder/job" <<JOB
#!/usr/bin/env bash
#SBATCH --ntasks=1 --output=$folder/task-%a.log
source $here/sweep.sh
echo "processors granted: \$SLURM_CPUS_ON_NODE"
# A batch: every $tasks-th shard, from the task's own number on.
for k in \$(seq "\$SLURM_ARRAY_TASK_ID" $tasks $shards); do shard "\$k" $folder/many || exit 1; done
JOB
export SCENE=$scene EXTENT=$extent SHARDS=$shards
array() { sbatch --parsable --wait --array="1-$tasks" "$folder/job"; }

"$GLENOID" study accuracy "$scene" --out "$folder/one" $extent >/dev/null || fail "the run in one part"
# The first task is killed as soon as it has kept a setting, with everything that it started.
SECONDS=0
array >"$folder/first" 2>&1 &
waiting=$!
for _ in $(seq 600); do
  grep -q '"finished": [1-9]' "$folder/many/shard-1-of-$shards.status.json" 2>/dev/null && break
  sleep 0.1
done
kill -9 "$(sed -n 's/.*"pid": \([0-9]*\).*/\1/p' "$folder/many/shard-1-of-$shards.status.json")"
wait "$waiting"
say "sbatch's exit status with a task killed: $?, after $SECONDS s"
if whole "$folder/many"; then fail "a killed shard counts as done"; fi
SECONDS=0
array >"$folder/second" 2>&1
say "sbatch's exit status of the second array: $?, after $SECONDS s"
grep -q "Going on after" "$folder"/task-*.log || fail "the killed shard began anew"
whole "$folder/many" || fail "not all shards are done"
"$GLENOID" study accuracy "$scene" --out "$folder/many" $extent --merge >/dev/null || fail "merging"
compare "$folder/one" "$folder/many"
