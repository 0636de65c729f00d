#!/usr/bin/env bash
# Usage: one_by_one.sh SOURCE BUILD
# Checks that source files of the programs compile separately, which a unity build does not show. It checks a tenth of the
# files, a different tenth for each commit, or all files if EVERY=1. Nothing is linked. Results are kept in BUILD until a source
# changes.
set -euo pipefail
every=${EVERY:-10}
commits=$(git -C "$1" rev-list --count HEAD 2>/dev/null || echo 0)
cmake -S "$1" -B "$2" -G Ninja -DBUILD_TESTING=OFF -DCMAKE_UNITY_BUILD=OFF -DCMAKE_CXX_COMPILER_LAUNCHER="$1/tests/check_syntax.sh" >/dev/null
ninja -C "$2" -t targets all | sed -n 's/\(.*\.cpp\.o\): .*/\1/p' | sort |
  awk -v every="$every" -v turn="$commits" '(NR + turn) % every == 0' | xargs ninja -C "$2" -j 1 -k 0 --quiet
