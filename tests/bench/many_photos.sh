#!/usr/bin/env bash
# The cost of making 10 to 320 photos of one scene agree, whose exposures differ: of computing the evidence, which prepare
# always does; of fitting and judging gains; and of registering all cameras, which has to be forced because the scene does not
# need it. Writes many_photos.tsv and
# many_photos.svg into FOLDER, where the scenes are kept for reuse.
# usage: many_photos.sh VANTAGE FOLDER [PHOTOS...]
set -euo pipefail
vantage=$1
folder=$2
shift 2
[ $# -gt 0 ] || set -- 10 20 40 80 160 320
mkdir -p "$folder"
demo=$(dirname "$0")/../../data/demo.toml

seconds() {  # seconds TRACE SPANS: total duration of the spans in the trace
  tr '{' '\n' <"$1" | grep -oP "\"dur\":[0-9.]+,\"name\":\"($2)\"" | awk -F'[:,]' '{ s += $2 } END { printf "%.2f", s / 1e6 }'
}
prepare() {  # prepare SCENE OPTIONS...: peak memory, MB
  local scene=$1
  shift
  rm -f "$folder/package"*
  "$vantage" prepare "$scene" -o "$folder/package.vantage" --progress none --no-report --threads 2 \
    --trace "$folder/trace.json" "$@" | awk '$1 == "memory" { print $2 }'
}

table=$folder/many_photos.tsv
echo -e "photos\tprepare_MB\tmeasure_s\tconsensus_s\tregister_s\tregister_MB\tcolors_s\tunjudged_s\tprepare_s" | tee "$table"
for n in "$@"; do
  scene=$folder/$n
  if [ ! -d "$scene" ]; then
    sed "s/^count = .*/count = $n/; s/^width = 1[0-9]*$/width = 1632/; s/^height = 1[0-9]*$/height = 1224/; s/^samples = .*/samples = 1/" \
      "$demo" >"$scene.toml"
    printf '\n[exposure]\nstops = 0.3\n' >>"$scene.toml"
    "$vantage" synth "$scene.toml" -o "$scene" >/dev/null 2>&1
  fi
  usual=$(prepare "$scene" --judge off)
  unjudged=$(seconds "$folder/trace.json" colors)
  started=$(date +%s.%N)
  usual=$(prepare "$scene")
  all=$(echo "$(date +%s.%N) $started" | awk '{ printf "%.1f", $1 - $2 }')
  colors=$(seconds "$folder/trace.json" colors)
  measure=$(seconds "$folder/trace.json" register)
  consensus=$(seconds "$folder/trace.json" "consensus|consensus masks")
  registering=$(prepare "$scene" --effect registration=on)
  echo -e "$n\t$usual\t$measure\t$consensus\t$(seconds "$folder/trace.json" register)\t$registering\t$colors\t$unjudged\t$all" | tee -a "$table"
done
rm -f "$folder/package"* "$folder/trace.json"
gnuplot <<PLOT
set terminal svg size 900,380 font "sans,13" background "white"
set output "$folder/many_photos.svg"
set multiplot layout 1,2
set logscale xy
set xtics ($(awk 'NR > 1 { printf "%s%s", sep, $1; sep = ", " }' "$table"))
set xlabel "photos"
set grid
set border 3
set tics nomirror
set key top left Left reverse
set pointsize 0.6
set xrange [10:600]
set title "seconds"
set yrange [0.01:30000]
plot "$table" every ::1 using 1:5 with linespoints linewidth 2 pointtype 7 linecolor rgb "#c62828" title "camera registration (if needed)", \
  "" every ::1 using 1:7 with linespoints linewidth 2 pointtype 7 linecolor rgb "#6a1b9a" title "gains, judged (if needed)", \
  "" every ::1 using 1:4 with linespoints linewidth 2 pointtype 7 linecolor rgb "#2e7d32" title "consensus evidence (always)", \
  "" every ::1 using 1:3 with linespoints linewidth 2 pointtype 7 linecolor rgb "#1565c0" title "camera evidence (always)"
set title "peak memory, MB"
set yrange [10:2000]
plot "$table" every ::1 using 1:6 with linespoints linewidth 2 pointtype 7 linecolor rgb "#c62828" title "with registration", \
  "" every ::1 using 1:2 with linespoints linewidth 2 pointtype 7 linecolor rgb "#1565c0" title "without registration"
PLOT
