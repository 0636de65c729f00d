#!/usr/bin/env bash
# Runs the player for MINUTES (default 30) on random flights over a package larger than its memory budget, while the file is
# damaged in place, restored and replaced. Writes frames.csv, soak.svg (frame time and memory over time) and soak.txt (a
# summary) into FOLDER. If the player's exit code is not 0, exits with that code.
# Usage: soak.sh PLAYER PACKAGE FOLDER [MINUTES [PLAYER-OPTIONS...]]
set -euo pipefail
player=$1
valid=$(realpath "$2")
folder=$3
minutes=${4:-30}
shift $(($# < 4 ? $# : 4))
mkdir -p "$folder"
shown=$folder/shown.vantage opened=$folder/opened.vantage
rm -f "$shown" "$opened"
trap 'rm -f "$shown" "$opened"' EXIT
cp "$valid" "$shown"
ln "$shown" "$opened"  # keeps the player's open file accessible after it is replaced
bytes=$(stat -c %s "$valid")

"$player" bench "$shown" --paths flight --modes stream --repeats 1 --minutes "$minutes" --warm \
  --graphics-memory 96 --size 640x360 -o "$folder" "$@" >"$folder/bench.txt" 2>&1 &
flight=$!
trap 'kill $flight 2>/dev/null || true; rm -f "$shown" "$opened" "$folder/next.vantage"' EXIT
sleep 10  # until the first frames

RANDOM=7
place() { echo $(((RANDOM * 32768 * 32768 + RANDOM * 32768 + RANDOM) % (bytes / 4096))); }
copy() { dd if="$1" of="$opened" bs=4096 seek="$2" count=1 ${3:+skip="$3"} conv=notrunc status=none; }
column() { awk -F, -v c="$1" -v from="${2:-0}" -v to="${3:-1}" -v rows="$rows" \
  'NR > 1 + from * rows && NR <= 1 + to * rows { print $c }' "$folder/frames.csv" | sort -g; }
median() { awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }
megabytes() { awk '{ printf "%.1f MB", $1 / 1e6 }'; }
figures() {
  echo "frames                      $rows, median $middle ms, slowest $(column 5 | tail -1) ms," \
    "$(column 5 | awk -v m="$middle" '$1 > 3 * m' | wc -l) over three times the median"
  echo "most damaged tiles at once  $(column 9 | tail -1)"
  echo "resident memory             $(column 14 .1 .2 | median | megabytes) after a tenth," \
    "$(column 14 .9 1 | median | megabytes) at the end"
  echo "anonymous memory            $(column 15 .1 .2 | median | megabytes) after a tenth," \
    "$(column 15 .9 1 | median | megabytes) at the end"
  echo "OpenGL objects              $(column 13 .1 .2 | median | megabytes) after a tenth," \
    "$(column 13 .9 1 | median | megabytes) at the end"
}
damages=0 replacements=0
while kill -0 $flight 2>/dev/null; do
  places=()
  for _ in $(seq 200); do places+=("$(place)"); done
  for p in "${places[@]}"; do copy /dev/urandom "$p"; done
  damages=$((damages + ${#places[@]}))
  sleep 8
  for p in "${places[@]}"; do copy "$valid" "$p" "$p"; done
  cp --reflink=auto "$valid" "$folder/next.vantage"
  mv "$folder/next.vantage" "$shown"
  replacements=$((replacements + 1))
  sleep 8
done
code=0
wait $flight || code=$?
if [ $code = 0 ]; then
  rows=$(($(wc -l <"$folder/frames.csv") - 1))
  middle=$(column 5 | median)
fi
{
  cat "$folder/bench.txt"
  echo "pages damaged and restored  $damages"
  echo "packages replaced           $replacements"
  [ $code = 0 ] && figures
} | tee "$folder/soak.txt"
[ $code = 0 ] || exit $code
# For every five seconds: the time in minutes, the slowest and the mean frame time in ms, and the anonymous memory and OpenGL
# objects in MB.
awk -F, 'NR > 1 {
    at += $5; sum += $5; ++n; slowest = $5 > slowest ? $5 : slowest
    if (at >= next_at) {
      print at / 60000, slowest, sum / n, $15 / 1e6, $13 / 1e6
      next_at = at + 5000; sum = n = slowest = 0
    }
  }' "$folder/frames.csv" >"$folder/soak.tsv"
gnuplot <<PLOT
set terminal svg size 900,520 font "sans,13" background "white"
set output "$folder/soak.svg"
set multiplot layout 2,1
set border 3
set tics nomirror
set grid
set key top right
set yrange [0:*]
set offsets 0, 0, graph 0.45, 0
set lmargin 9
set ylabel "ms"
plot 3 * $middle with lines dashtype 2 linecolor rgb "#888888" title "three times the median frame", \
  "$folder/soak.tsv" using 1:2 with lines linecolor rgb "#c62828" title "slowest in five seconds", \
  "" using 1:3 with lines linewidth 2 linecolor rgb "#1565c0" title "mean in five seconds"
set ylabel "MB"
set xlabel "minutes"
plot "$folder/soak.tsv" using 1:4 with lines linewidth 2 linecolor rgb "#c62828" title "anonymous memory of the process", \
  "" using 1:5 with lines linewidth 2 linecolor rgb "#1565c0" title "OpenGL objects"
PLOT
