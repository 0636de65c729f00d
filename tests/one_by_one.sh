#!/usr/bin/env bash
# Usage: one_by_one.sh SOURCE BUILD
# Whether each source of the programs compiles by itself, which a unity build does not show. Nothing is linked.
set -euo pipefail
cmake -S "$1" -B "$2" -G Ninja -DCMAKE_UNITY_BUILD=OFF >/dev/null
cmake --build "$2" --target vantage_precompiled >/dev/null
ninja -C "$2" -t compdb |
  python3 -c '
import json, sys
for e in json.load(sys.stdin):
    if e["file"].endswith(".cpp") and sys.argv[1] + "/tests/" not in e["file"] and sys.argv[2] not in e["file"]:
        print(e["command"].split(" -MD ")[0], "-fsyntax-only -c", e["file"], end="\0")' "$1" "$2" |
  xargs -0 -P "$(nproc)" -I{} sh -c 'cd "$1" && eval "$2" || exit 1' sh "$2" {}
