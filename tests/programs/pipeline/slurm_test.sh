#!/usr/bin/env bash
# Prepares a scene as shards on a single-node Slurm cluster and compares the merged package with the package of a single run.
# Usage: slurm_test.sh VANTAGE SOURCE_DIR; exits with 77 if Slurm is not installed or cannot be started.
set -euo pipefail
vantage=$1 source=$2
export PATH=$PATH:/usr/sbin:/sbin
for program in munged slurmctld slurmd sbatch; do
  command -v $program >/dev/null || { echo "skipped: $program is not installed (Debian: slurm-wlm, munge)"; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo "skipped: slurmd needs root"; exit 77; }

work=$(mktemp -d)
pids=()
finish() {
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
  wait 2>/dev/null || true
  rm -rf "$work"
}
trap finish EXIT
host=$(hostname -s)
getent hosts "$host" >/dev/null || { echo "skipped: this machine's host name does not resolve"; exit 77; }
mkdir -p "$work"/{state,spool,munge}
chmod 0700 "$work/munge"

dd if=/dev/urandom of="$work/munge/key" bs=128 count=1 status=none
chmod 0400 "$work/munge/key"
chmod 0755 "$work"
munged --foreground --force --key-file="$work/munge/key" --socket="$work/munge.socket" --pid-file="$work/munge/pid" \
  --log-file="$work/munge/log" --seed-file="$work/munge/seed" &
pids+=($!)

cat >"$work/slurm.conf" <<CONF
ClusterName=vantage
SlurmctldHost=$host
SlurmUser=root
SlurmctldPort=$((20000 + $$ % 10000))
SlurmdPort=$((30000 + $$ % 10000))
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
CredType=cred/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SchedulerType=sched/backfill
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
ReturnToService=2
NodeName=$host CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$work/slurm.conf
for _ in $(seq 50); do [ -S "$work/munge.socket" ] && break; sleep 0.1; done
slurmctld -D -f "$SLURM_CONF" >"$work/slurmctld.out" 2>&1 &
pids+=($!)
slurmd -D -f "$SLURM_CONF" >"$work/slurmd.out" 2>&1 &
pids+=($!)
for _ in $(seq 100); do
  sinfo --noheader --format=%T 2>/dev/null | grep -q idle && break
  sleep 0.2
done
if ! sinfo --noheader --format=%T 2>/dev/null | grep -q idle; then
  echo "skipped: Slurm does not start here"
  tail -n 5 "$work"/slurmctld.log "$work"/slurmd.log "$work"/*.out || true
  exit 77
fi

"$vantage" synth "$source/data/tiny.toml" -o "$work/scene"
"$vantage" prepare "$work/scene" -o "$work/one.vantage" --progress none
merge=$(VANTAGE=$vantage "$source/configs/slurm/submit.sh" "$work/scene" "$work/many.vantage" 3)
for _ in $(seq 300); do
  squeue --noheader --jobs="$merge" 2>/dev/null | grep -q . || break
  sleep 0.2
done
for log in "$work"/many.vantage.logs/*; do echo "== ${log##*/}"; cat "$log"; done
cmp "$work/one.vantage" "$work/many.vantage"
[ -z "$(ls "$work"/*.shard 2>/dev/null)" ]
echo "3 jobs and a merge give the bytes of a single run"
