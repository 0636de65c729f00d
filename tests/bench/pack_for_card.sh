#!/usr/bin/env bash
# Packs what tests/bench/on_card.sh needs on a machine that has a graphics card, its driver and nothing else: programs, libraries
# and descriptions of scenes. At most 60 MiB. Usage: tests/bench/pack_for_card.sh [--build FOLDER] [ARCHIVE]
set -euo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
build=$source/build archive=for-card.tar.xz
while [ $# -gt 0 ]; do
    case $1 in
        --build) build=$(cd "$2" && pwd) && shift 2 ;;
        -*) sed -n '2,3s/^# //p' "$0" && exit 2 ;;
        *) archive=$1 && shift ;;
    esac
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
packed=$work/for-card
mkdir -p "$packed"/{bin,lib,data}
programs=("$build/pipeline/vantage" "$build/player/vantage-player" "$build/tests/player_tests")
cp "${programs[@]}" "$packed/bin"
strip "$packed"/bin/*
# Not the C library and not OpenGL: these are the machine's, and its driver's.
ldd "${programs[@]}" | awk '$3 ~ /^\// { print $3 }' | sort -u |
    grep -Ev '/(ld-linux|libc|libm|libpthread|libdl|librt|libresolv|libGL|libEGL|libGLX|libGLdispatch|libOpenGL|libgbm|libdrm)[-._]' |
    xargs -I{} cp -L {} "$packed/lib"
strip --strip-unneeded "$packed"/lib/* 2>/dev/null || true
cp "$source"/data/*.toml "$packed/data"
cp "$source/tests/bench/on_card.sh" "$packed"
git -C "$source" describe --always --dirty >"$packed/commit"
tar -C "$work" -cJf "$archive" for-card
size=$(stat -c %s "$archive")
echo "$archive: $((size / 1048576)) MiB"
[ "$size" -le $((60 * 1048576)) ] || { echo "$archive: expected at most 60 MiB" >&2 && exit 1; }
