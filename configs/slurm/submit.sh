#!/usr/bin/env bash
# Prepares one package on a Slurm cluster: an array of jobs, each a share of the photos, and a merge after them.
#   configs/slurm/submit.sh INPUT PACKAGE SHARES [OPTIONS OF vantage prepare]
#   configs/slurm/submit.sh scans/chapel chapel.vantage 8 --config overnight
# INPUT and PACKAGE lie on a disk that all nodes see. $VANTAGE: the program, if not on the PATH; $SBATCH_OPTIONS: more for
# both jobs, such as "--partition=night --time=8:00:00". A job that is cut off goes on where it was when it is submitted
# again. Prints the number of the merge: 'srun --dependency=afterany:NUMBER true' waits for it.
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

# A share that lacks a photo (exit code 9) is merged all the same: the merge says so in the end.
share="$(quoted "$vantage" prepare "$input" --progress lines "$@") --shard \$SLURM_ARRAY_TASK_ID/$shares"
share+=" -o $out.\$SLURM_ARRAY_TASK_ID.share || [ \$? = 9 ]"
# shellcheck disable=SC2086
array=$(sbatch --parsable ${SBATCH_OPTIONS:-} --job-name=vantage-prepare --array=1-"$shares" --requeue \
  --output="$logs/share-%a.txt" --wrap "$share")

merge="$(quoted "$vantage" merge) -o $out --remove"
for i in $(seq "$shares"); do merge+=" $out.$i.share"; done
# shellcheck disable=SC2086
sbatch --parsable ${SBATCH_OPTIONS:-} --job-name=vantage-merge --dependency=afterok:"${array%%;*}" \
  --kill-on-invalid-dep=yes --output="$logs/merge.txt" --wrap "$merge"
