#!/usr/bin/env bash
# Prepares one package on a Slurm cluster: a job array with one shard of the photos per job, followed by a merge.
#   configs/slurm/submit.sh INPUT PACKAGE SHARDS [OPTIONS OF vantage prepare]
#   configs/slurm/submit.sh scans/chapel chapel.vantage 8 --max-photo-size 4000
# INPUT and PACKAGE must be on a file system shared by all nodes. $VANTAGE: the program, if it is not on the
# PATH. $SBATCH_OPTIONS: options for all jobs, such as "--partition=night --time=8:00:00". Interrupted jobs
# continue when submitted again. Prints the merge's job ID; 'srun --dependency=afterany:ID true' waits for it.
set -euo pipefail
if [ $# -lt 3 ]; then
  sed -n '2,7s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
input=$(realpath "$1") package=$(realpath -m "$2") shares=$3
shift 3
vantage=${VANTAGE:-vantage}
logs=$package.logs
mkdir -p "$logs"
quoted() { printf ' %q' "$@"; }
out=$(printf '%q' "$package")

# A shard with skipped photos (exit code 9) is still merged; the merge then exits with code 9.
share="$(quoted "$vantage" prepare "$input" --progress lines "$@") --shard \$SLURM_ARRAY_TASK_ID/$shares"
share+=" -o $out.\$SLURM_ARRAY_TASK_ID.shard || [ \$? = 9 ]"
# shellcheck disable=SC2086
array=$(sbatch --parsable ${SBATCH_OPTIONS:-} --job-name=vantage-prepare --array=1-"$shares" --requeue \
  --output="$logs/share-%a.txt" --wrap "$share")

merge="$(quoted "$vantage" merge) -o $out --remove"
for i in $(seq "$shares"); do merge+=" $out.$i.shard"; done
# shellcheck disable=SC2086
sbatch --parsable ${SBATCH_OPTIONS:-} --job-name=vantage-merge --dependency=afterok:"${array%%;*}" \
  --kill-on-invalid-dep=yes --output="$logs/merge.txt" --wrap "$merge"
