#!/usr/bin/env bash
# Measures the player on a machine with a graphics card, from the archive that tests/bench/pack_for_card.sh makes, without a network:
# frames at rest and in motion at three sizes, for one eye and two, and pictures without a display. Writes one file. Usage:
#   ./on_card.sh [--quick] [RESULTS]
#   --quick  few frames at one size, to try the script
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
results=$PWD/on-card.txt sizes=(1280x720 1920x1080 3840x2160) frames=300 eye=1440x1600
while [ $# -gt 0 ]; do
    case $1 in
        --quick) sizes=(320x180) frames=5 eye=160x160 && shift ;;
        -*) sed -n '2,6s/^# //p' "$0" && exit 2 ;;
        *) results=$(realpath -m "$1") && shift ;;
    esac
done
work=$(mktemp -d)
trap 'rm -rf "$work" ${lent:-}' EXIT
cd "$work" || exit 1
[ -e "$here/bin" ] || LD_LIBRARY_PATH=$here "$here/xz" -dc "$here/packed.tar.xz" | tar -C "$here" -x || exit 1
# The machine's libraries come first: its driver may need newer ones than those packed.
export LD_LIBRARY_PATH=${LD_LIBRARY_PATH:+$LD_LIBRARY_PATH:}/lib/x86_64-linux-gnu:/lib64:$here/lib XDG_CACHE_HOME=$work/cache
player=$here/bin/vantage-player
: >"$results"
note() { printf '%s\n' "$*" | tee -a "$results"; }
# Notes a command's time, or its exit code and error. Arguments: its name in the results, the command
run() {
    local name=$1 before code took
    shift
    before=$(date +%s%N)
    "$@" >out.txt 2>err.txt
    code=$?
    took=$(($(date +%s%N) - before))
    [ $code -eq 0 ] && took="$((took / 1000000)) ms" || took="exit code $code: $(tail -n 1 err.txt)"
    note "$name: $took"
    return $code
}
bench() {  # name, options
    local name=$1
    shift
    run "bench $name" "$player" bench demo.vantage --path-frames "$frames" --repeats 1 "$@" -o bench --force && note "$(cat out.txt)"
}

note "commit $(cat "$here/commit"), $(date -u +%F), $(nproc) cores"
command -v nvidia-smi >/dev/null && note "$(nvidia-smi --query-gpu=name,driver_version --format=csv,noheader)"
font=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf  # where the player looks for it
[ -e $font ] || { install -D "$here/DejaVuSans.ttf" $font && lent=$font; } ||
    { note "no $font: tests that need it are left out" && without=-PanelPass.TinyTextIsAsBrightAsItShouldBe; }
run "tests of the player" "$here/bin/player_tests" --gtest_brief=1 --gtest_filter="${without:-*}" || note "$(grep -E 'FAILED|Failure' out.txt | head -20)"
run "prepare the demo" "$here/bin/vantage" prepare "$here/demo.scan" -o demo.vantage --no-report || exit 1
for size in "${sizes[@]}"; do
    bench "in full, $size" --size "$size" --paths still,orbit --modes stream,resident --graphics-memory 4000
    for fps in 30 60; do bench "in motion, $fps per second, $size" --size "$size" --paths orbit --modes adaptive --fps $fps; done
done
bench "two eyes of $eye, 90 per second" --size "$eye" --stereo side-by-side --paths orbit --modes adaptive --fps 90
for scale in 0.35 1; do run "a photo's view, scale $scale" "$player" demo.vantage --offscreen --photo 0005 --scale $scale -q -o photo.png --force; done
run "a view of all photos but one" "$player" demo.vantage --offscreen --photo 0005 --exclude 0005 -q -o other.png --force
run "an orthophoto" "$player" orthophoto demo.vantage --plane front --resolution 0.005 -q -o front.tif --force
run "30 frames of video" "$player" demo.vantage --turntable --seconds 1 --size 640x360 -q -o frames --force
