#!/usr/bin/env bash
# A compiler launcher that only checks the syntax and writes an empty object file. Only precompiled headers are actually compiled.
set -euo pipefail
for word in "$@"; do
  [[ $word == *.gch ]] && exec "$@"
  [[ ${last:-} == -o ]] && object=$word
  last=$word
done
"$@" -fsyntax-only && : >"${object:?}"
