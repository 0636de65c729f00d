#!/usr/bin/env bash
# Packs the files that tests/bench/on_card.sh needs on a machine with only a graphics card and its driver:
# programs, libraries, a font and a scan. At most 60 MiB. Usage: tests/bench/pack_for_card.sh [--build FOLDER] [ARCHIVE]
set -euo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
build=$source/build archive=for-card.tar
while [ $# -gt 0 ]; do
    case $1 in
        --build) build=$(cd "$2" && pwd) && shift 2 ;;
        -*) sed -n '2,3s/^# //p' "$0" && exit 2 ;;
        *) archive=$1 && shift ;;
    esac
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
packed=$work/packed card=$work/for-card
mkdir -p "$packed"/{bin,lib} "$card"
programs=("$build/pipeline/vantage" "$build/player/vantage-player" "$build/tests/player_tests")
cp "${programs[@]}" "$packed/bin"
strip "$packed"/bin/*
path_of() { ldconfig -p | awk -v name="$1" '$1 == name { print $NF; exit }'; }
# The C library is not packed, because the machine's own must be used. OpenGL's libraries, which libepoxy loads, are packed,
# because some drivers lack them.
{
    ldd "${programs[@]}" | awk '$3 ~ /^\// { print $3 }'
    for name in libEGL.so.1 libOpenGL.so.0; do path_of $name; done
} | sort -u | grep -Ev '/(ld-linux|libc|libm|libpthread|libdl|librt|libresolv)[-._]' | xargs -I{} cp -L {} "$packed/lib"
strip --strip-unneeded "$packed"/lib/* 2>/dev/null || true
cp /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf "$packed"
# The photos are generated here, because OpenImageIO, which writes them, needs 200 more libraries, which are too large for the
# archive.
"$build/pipeline/vantage" synth "$source/data/garden.toml" -o "$packed/demo.scan" >/dev/null 2>&1
rm -r "$packed/demo.scan/truth"
git -C "$source" describe --always --dirty >"$packed/commit"
# xz is included, because a minimal Debian lacks it.
tar -C "$packed" -cJf "$card/packed.tar.xz" .
cp -L "$(command -v xz)" "$(path_of liblzma.so.5)" "$source/tests/bench/on_card.sh" "$card"
tar -C "$work" -cf "$archive" for-card
size=$(stat -c %s "$archive")
echo "$archive: $((size / 1048576)) MiB"
[ "$size" -le $((60 * 1048576)) ] || { echo "$archive: expected at most 60 MiB" >&2 && exit 1; }
