#!/usr/bin/env bash
# Measures how long users have to wait, as ratios within one run, and appends a line for the current commit to
# docs/records/ledger.csv. Prints values that are over 10 % worse than the best of the last ten lines. Run it on an idle machine.
# Usage: tests/bench/ledger.sh [--build FOLDER] [--datasets FOLDER] [--records FILE] [--suite]
#   --suite  also measure the time of the default tests, relative to a build from scratch (takes a quarter of an hour)
set -euo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
build=$source/build datasets=${VANTAGE_DATASETS:-$source/../shared/datasets} records=$source/docs/records/ledger.csv suite=
while [ $# -gt 0 ]; do
    case $1 in
        --build) build=$2 && shift 2 ;;
        --datasets) datasets=$2 && shift 2 ;;
        --records) records=$2 && shift 2 ;;
        --suite) suite=yes && shift ;;
        *) sed -n '2,5s/^# //p' "$0" && exit 2 ;;
    esac
done
vantage=$build/pipeline/vantage player=$build/player/vantage-player ledger=$build/tests/bench
ninja -C "$build" vantage vantage-player ledger-floor ledger-window ledger-draws >/dev/null
work=$(mktemp -d /dev/shm/ledger.XXXXXX)
trap 'rm -rf "$work"' EXIT
cd "$work"
export XDG_CACHE_HOME=$work/cache  # to ignore the machine's history
names=() values=()

best() { printf '%s\n' "$@" | sort -g | head -1; }  # minimum, because other load only adds time
ratio() { awk -v a="$1" -v b="$2" 'BEGIN { if (b > 0) printf "%.3f", a / b }'; }
record() { names+=("$1") values+=("$2") && printf '%-24s %s\n' "$1" "$2"; }
seconds() { local TIMEFORMAT=%R && { time "$@" >/dev/null 2>&1; } 2>&1; }
prepare() { seconds "$vantage" prepare "$1" -o "$2" --no-report --progress none; }
in_window() { xvfb-run -a -s '-screen 0 1280x1024x24' "$@" 2>&1; }

# the time of prepare relative to decoding the photos and writing the package, and the size of the package relative to the
# photos
preparing() {
    local scan=$1 name=$2 took=() least=()
    for _ in 1 2 3; do
        rm -f "$name.vantage"
        took+=("$(prepare "$scan" "$name.vantage")")
        least+=("$("$ledger/ledger-floor" "$scan/images" "$(stat -c %s "$name.vantage")" written)")
        rm -f written
    done
    record "prepare $name" "$(ratio "$(best "${took[@]}")" "$(best "${least[@]}")")"
    record "bytes $name" "$(ratio "$(stat -c %s "$name.vantage")" "$(cat "$scan"/images/* | wc -c)")"
}
# the time to the first picture, relative to the time to show an empty window
first_picture() {
    local shown=() empty=()
    for _ in 1 2 3 4 5 6; do
        shown+=("$(in_window "$player" "$1.vantage" --no-saved-settings --frames 1 --size 1280x720 | sed -n 's/.*after \([0-9]*\) ms.*/\1/p')")
        empty+=("$(in_window "$ledger/ledger-window")")
    done
    record "first picture $1" "$(ratio "$(best "${shown[@]}")" "$(best "${empty[@]}")")"
}
bench() { "$player" bench "$1.vantage" --paths "$2" --modes resident --repeats 1 --path-frames 8 "${@:3}" -o bench --force >/dev/null 2>&1; }
summary() { python3 -c 'import json, sys; print(json.load(open("bench/summary.json"))[0][sys.argv[1]]["median"])' "$1"; }

for name in sceaux fountain-P11 head; do
    if [ -d "$datasets/$name" ]; then preparing "$datasets/$name" $name; else record "prepare $name" "" && record "bytes $name" ""; fi
done
# with_photos NAME COUNT WIDTH HEIGHT: prints data/NAME.toml with this number and size of photos
with_photos() { sed "/^\[photos\]/,/^\[/{s/^count = .*/count = $2/;s/^width = .*/width = $3/;s/^height = .*/height = $4/}" "$source/data/$1.toml"; }
with_photos garden 40 1400 1050 >demo40.toml
"$vantage" synth demo40.toml -o demo40.scan >/dev/null 2>&1
preparing demo40.scan demo40
again=() && for _ in 1 2 3; do again+=("$(prepare demo40.scan demo40.vantage)"); done
once=() && for _ in 1 2 3; do once+=("$(prepare demo40.scan once.vantage && rm -f once.vantage)"); done
record "rerun over run" "$(ratio "$(best "${again[@]}")" "$(best "${once[@]}")")"
for name in sceaux fountain-P11 head demo40; do
    if [ -f $name.vantage ]; then first_picture $name; else record "first picture $name" ""; fi
done
for photos in 1 4 8; do
    frames=() draws=()
    for _ in 1 2; do
        bench demo40 still --max-photos $photos
        frames+=("$(summary ms)")
        draws+=("$("$ledger/ledger-draws" demo40.vantage $photos)")
    done
    record "frame of $photos" "$(ratio "$(best "${frames[@]}")" "$(best "${draws[@]}")")"
done
bench demo40 orbit
record "plan" "$(ratio "$(summary plan_ms)" "$("$ledger/ledger-draws" demo40.vantage 1)")"
for count in 40 400; do
    with_photos tiny $count 160 120 >small.toml
    "$vantage" synth small.toml -o small.scan >/dev/null 2>&1 && prepare small.scan "of$count.vantage" >/dev/null && rm -rf small.scan
done
opened() { best $(for _ in 1 2 3 4 5 6 7; do seconds "$vantage" info "of$1.vantage"; done); }
record "open 400 over 40" "$(ratio "$(opened 400)" "$(opened 40)")"
if [ -n "$suite" ]; then
    cmake -S "$source" -B clean -G Ninja -DCMAKE_BUILD_TYPE=Release >/dev/null
    built=$(CCACHE_DISABLE=1 seconds ninja -C clean suite)
    record "suite over build" "$(ratio "$(seconds ctest --test-dir clean -j "$(nproc)" -LE full)" "$built")"
else
    record "suite over build" ""
fi

mkdir -p "$(dirname "$records")"
header=commit$(printf ',%s' "${names[@]}")
[ -f "$records" ] && [ "$(head -1 "$records")" = "$header" ] || { [ -f "$records" ] && mv "$records" "$records.old"; echo "$header" >"$records"; }
commit=$(git -C "$source" rev-parse --short=9 HEAD)
git -C "$source" diff --quiet HEAD -- || commit+=+
# Lower values are always better. The entries of values that were not measured are empty.
awk -F, -v line="$commit$(printf ',%s' "${values[@]}")" '
    NR == 1 { for (i = 2; i <= NF; ++i) name[i] = $i; next }
    { row[++rows] = $0 }
    END {
        n = split(line, now, ",")
        for (r = rows > 10 ? rows - 9 : 1; r <= rows; ++r) {
            split(row[r], was, ",")
            for (i = 2; i <= n; ++i)
                if (was[i] != "" && (!(i in best) || was[i] + 0 < best[i])) { best[i] = was[i] + 0; of[i] = was[1] }
        }
        for (i = 2; i <= n; ++i)
            if (now[i] != "" && i in best && now[i] > 1.1 * best[i]) {
                printf "worse: %s %s, %s in %s\n", name[i], now[i], best[i], of[i]
                found = 1
            }
        if (!found) print "no value is worse by a tenth than the best of the last ten"
    }' "$records"
echo "$commit$(printf ',%s' "${values[@]}")" >>"$records"
