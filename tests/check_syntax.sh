#!/usr/bin/env bash
# A compiler's launcher that stops before it would write code, and leaves an empty file in its place. Precompiled headers are made.
set -euo pipefail
for word in "$@"; do
  [[ $word == *.gch ]] && exec "$@"
  [[ ${last:-} == -o ]] && object=$word
  last=$word
done
"$@" -fsyntax-only && : >"${object:?}"
