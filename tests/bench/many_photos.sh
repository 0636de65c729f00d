#!/usr/bin/env bash
# Measures the cost of preparing 10 to 1000 photos of one scene with varying exposure. It compares the total time and memory
# with the estimate that prepare makes before it reads the first photo, on a machine without history. It also measures the
# cost of making the photos agree: computing the evidence, which prepare always does; fitting and validating gains; and, for
# up to 320 photos, refining all poses, which must be forced because the scene does not need it. Writes many_photos.tsv and
# many_photos.svg into FOLDER, and keeps the scenes there for reuse. For 1000 photos, this takes 35 GB.
# Usage: many_photos.sh VANTAGE FOLDER [PHOTOS...]
set -euo pipefail
vantage=$1
folder=$2
shift 2
[ $# -gt 0 ] || set -- 10 20 40 80 160 320 1000
mkdir -p "$folder"
export XDG_CACHE_HOME=$folder/cache
garden=$(dirname "$0")/../../data/garden.toml

seconds() {  # seconds TRACE SPANS: total duration of the spans in the trace
  tr '{' '\n' <"$1" | grep -oP "\"dur\":[0-9.]+,\"name\":\"($2)\"" | awk -F'[:,]' '{ s += $2 } END { printf "%.2f", s / 1e6 }'
}
prepare() {  # prepare SCENE OPTIONS...: sets `printed` to the output
  local scene=$1
  shift
  rm -rf "$folder/package"* "$XDG_CACHE_HOME"
  printed=$("$vantage" prepare "$scene" -o "$folder/package.vantage" --progress none --no-report --threads 2 \
    --trace "$folder/trace.json" "$@")
}
megabytes() { awk '$1 == "memory" { print $2 }' <<<"$printed"; }

table=$folder/many_photos.tsv
echo -e "photos\tprepare_s\testimated_s\tprepare_MB\testimated_MB\tmeasure_s\tconsensus_s\tcolors_s\tunjudged_s\tregister_s\tregister_MB" |
  tee "$table"
for n in "$@"; do
  scene=$folder/$n
  if [ ! -d "$scene" ]; then
    sed "s/^count = .*/count = $n/; s/^width = 1[0-9]*$/width = 1632/; s/^height = 1[0-9]*$/height = 1224/; s/^samples = .*/samples = 1/" \
      "$garden" >"$scene.toml"
    printf '\n[exposure]\nstops = 0.3\n' >>"$scene.toml"
    "$vantage" synth "$scene.toml" -o "$scene" >/dev/null 2>&1
  fi
  prepare "$scene" --validate off
  unvalidated=$(seconds "$folder/trace.json" colors)
  prepare "$scene"
  line="$n\t$(grep -oP '^package .*, \K[0-9.]+(?= s\))' <<<"$printed")\t$(grep -oP '^needs .*about \K[0-9]+' <<<"$printed")"
  line+="\t$(megabytes)\t$(grep -oP '^needs .*at most \K[0-9]+' <<<"$printed")"
  for spans in register "transients|transients weight maps" colors; do line+="\t$(seconds "$folder/trace.json" "$spans")"; done
  line+="\t$unvalidated"
  if [ "$n" -le 320 ]; then
    prepare "$scene" --effect pose-refinement=on
    line+="\t$(seconds "$folder/trace.json" register)\t$(megabytes)"
  else
    line+="\t-\t-"
  fi
  echo -e "$line" | tee -a "$table"
done
rm -rf "$XDG_CACHE_HOME"
rm -f "$folder/package"* "$folder/trace.json"
gnuplot <<PLOT
set terminal svg size 900,520 font "sans,13" background "white"
set output "$folder/many_photos.svg"
set multiplot layout 1,2
set logscale xy
set xtics ($(awk 'NR > 1 { printf "%s%s", sep, $1; sep = ", " }' "$table"))
set xlabel "photos"
set grid
set border 3
set tics nomirror
set key below vertical maxrows 6 Left reverse
set pointsize 0.6
set xrange [8:2000]
set datafile missing "-"
set title "seconds"
set yrange [0.01:1000]
plot "$table" every ::1 using 1:10 with linespoints linewidth 2 pointtype 7 linecolor rgb "#c62828" title "camera pose_refinement (if needed)", \
  "" every ::1 using 1:2 with linespoints linewidth 2 pointtype 7 linecolor rgb "#424242" title "prepare", \
  "" every ::1 using 1:3 with points pointtype 6 linecolor rgb "#424242" title "as estimated", \
  "" every ::1 using 1:8 with linespoints linewidth 2 pointtype 7 linecolor rgb "#6a1b9a" title "gains, validated (if needed)", \
  "" every ::1 using 1:7 with linespoints linewidth 2 pointtype 7 linecolor rgb "#2e7d32" title "transients evidence (always)", \
  "" every ::1 using 1:6 with linespoints linewidth 2 pointtype 7 linecolor rgb "#1565c0" title "camera evidence (always)"
set title "peak memory, MB"
set yrange [10:1000]
plot "$table" every ::1 using 1:11 with linespoints linewidth 2 pointtype 7 linecolor rgb "#c62828" title "with pose_refinement", \
  "" every ::1 using 1:4 with linespoints linewidth 2 pointtype 7 linecolor rgb "#424242" title "prepare", \
  "" every ::1 using 1:5 with points pointtype 6 linecolor rgb "#424242" title "at most, as estimated"
PLOT
