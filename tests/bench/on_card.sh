#!/usr/bin/env bash
# Measures the player on a machine with a graphics card, offline, from the archive made by
# tests/bench/pack_for_card.sh: the player's tests; frames at rest and in motion in each mode at three sizes, for one eye and
# for two; and pictures rendered without a display. Writes one file. Usage:
#   ./on_card.sh [--quick] [RESULTS]
#   --quick  draw only a few frames at one size, to try out the script
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
results=$PWD/on-card.txt sizes=(1280x720 1920x1080 3840x2160) frames=300 eye=1440x1600 seconds=1
while [ $# -gt 0 ]; do
    case $1 in
        --quick) sizes=(320x180) frames=6 eye=160x160 seconds=0.1 && shift ;;
        -*) sed -n '2,7s/^# //p' "$0" && exit 2 ;;
        *) results=$(realpath -m "$1") && shift ;;
    esac
done
work=$(mktemp -d)
trap 'rm -rf "$work" ${lent:-}' EXIT
cd "$work" || exit 1
[ -e "$here/bin" ] || LD_LIBRARY_PATH=$here "$here/xz" -dc "$here/packed.tar.xz" | tar -C "$here" -x || exit 1
# The machine's libraries take precedence, because its driver may need newer ones than those in the archive.
export LD_LIBRARY_PATH=${LD_LIBRARY_PATH:+$LD_LIBRARY_PATH:}/lib/x86_64-linux-gnu:/lib64:$here/lib XDG_CACHE_HOME=$work/cache
player=$here/bin/vantage-player
: >"$results"
note() { printf '%s\n' "$*" | tee -a "$results"; }
# Records a command's time, or its exit code and errors. Arguments: the command's name in the results, and the command
run() {
    local name=$1 before code
    shift
    before=$(date +%s%N)
    timeout 180 "$@" >out.txt 2>err.txt
    code=$?
    [ $code -eq 0 ] && note "$name: $((($(date +%s%N) - before) / 1000000)) ms" && return
    note "$name: exit code $code"
    note "$(tail -n 3 err.txt)"
    return $code
}
bench() {  # name, options
    local name=$1
    shift
    run "bench $name" "$player" bench demo.vantage --repeats 1 --graphics-memory 4000 "$@" -o bench --force || return
    tee -a "$results" <out.txt
}

note "commit $(cat "$here/commit"), $(date -u +%F), $(nproc) cores,$(grep -m 1 'model name' /proc/cpuinfo | cut -d : -f 2)"
command -v nvidia-smi >/dev/null && note "$(nvidia-smi --query-gpu=name,driver_version --format=csv,noheader)"
font=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf  # where the player expects it
[ -e $font ] || { install -D "$here/DejaVuSans.ttf" $font && lent=$font; } ||
    { note "no $font: tests that need it are skipped" && without=-PanelPass.TinyTextIsAsBrightAsItShouldBe; }
VANTAGE_DEBUG_GL=1 run "tests of the player" "$here/bin/player_tests" --gtest_brief=1 --gtest_filter="${without:-*}"
note "$(grep -E '^\[  (PASSED|SKIPPED|FAILED)|Failure|^needs|C\+\+ exception' out.txt | head -n 30)"
run "prepare the demo" "$here/bin/vantage" prepare "$here/demo.scan" -o demo.vantage --no-report || exit 1
for size in "${sizes[@]}"; do
    bench "in full, $size" --size "$size" --paths still,orbit --modes stream,resident,whole --path-frames $((frames / 3))
    for fps in 30 60; do
        bench "in motion, $fps per second, $size" --size "$size" --paths orbit --modes adaptive --fps $fps --path-frames $frames
    done
done
eyes=(--size "$eye" --stereo side-by-side --paths orbit)
bench "two eyes of $eye, 90 per second" "${eyes[@]}" --modes adaptive --fps 90 --path-frames $frames
bench "two eyes of $eye, in full" "${eyes[@]}" --modes stream,resident --path-frames $((frames / 3))
export VANTAGE_DEBUG_GL=1  # from here on, error messages of the driver terminate programs
run "bench in each mode, driver's messages on" "$player" bench demo.vantage --size "${sizes[0]}" --path-frames $((frames / 10 + 2)) \
    --repeats 1 --modes stream,resident,whole,adaptive -o bench --force
for scale in 0.35 1; do
    run "a photo's view, scale $scale" "$player" render demo.vantage --photo 0005 --scale $scale -q -o photo.png --force
done
run "a view of all photos but one" "$player" render demo.vantage --photo 0005 --exclude 0005 -q -o other.png --force
run "an orthophoto" "$player" orthophoto demo.vantage --plane front --resolution 0.005 -q -o front.tif --force
run "$seconds s of video" "$player" video demo.vantage --turntable --seconds $seconds --size 640x360 -q -o frames --force
note "OpenGL errors: $(grep -c 'OpenGL failed' "$results"), commands that failed: $(grep -c ': exit code' "$results"), $SECONDS s"
