#!/usr/bin/env bash
# What it takes to make 20 to 320 photos of one scene agree: asking the evidence (always), and registering every camera
# (forced, for the scene does not call for it). Writes many_photos.tsv and many_photos.svg into FOLDER, where the scenes
# stay for another time.
# usage: many_photos.sh VANTAGE FOLDER [PHOTOS...]
set -euo pipefail
vantage=$1
folder=$2
shift 2
[ $# -gt 0 ] || set -- 20 40 80 160 320
mkdir -p "$folder"
demo=$(dirname "$0")/../../data/demo.toml

seconds() {  # seconds TRACE SPAN...: that they took together
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
echo -e "photos\tprepare_MB\tmeasure_s\tconsensus_s\tregister_s\tregister_MB" | tee "$table"
for n in "$@"; do
  scene=$folder/$n
  if [ ! -d "$scene" ]; then
    sed "s/^count = .*/count = $n/; s/^width = 1[0-9]*$/width = 1632/; s/^height = 1[0-9]*$/height = 1224/; s/^samples = .*/samples = 1/" \
      "$demo" >"$scene.toml"
    "$vantage" synth "$scene.toml" -o "$scene" >/dev/null 2>&1
  fi
  usual=$(prepare "$scene")
  measure=$(seconds "$folder/trace.json" register)
  consensus=$(seconds "$folder/trace.json" "consensus|consensus masks")
  registering=$(prepare "$scene" --effect registration=on)
  echo -e "$n\t$usual\t$measure\t$consensus\t$(seconds "$folder/trace.json" register)\t$registering" | tee -a "$table"
done
rm -f "$folder/package"* "$folder/trace.json"
gnuplot <<PLOT
set terminal svg size 720,420 font "sans,14" background "white"
set output "$folder/many_photos.svg"
set logscale xy
set key left top
set xlabel "photos"
set ylabel "s"
set y2label "MB"
set y2tics
set logscale y2
set grid
plot "$table" every ::1 using 1:3 with linespoints title "measure cameras, s", \
  "" every ::1 using 1:4 with linespoints title "ask for consensus, s", \
  "" every ::1 using 1:5 with linespoints title "register, s", \
  "" every ::1 using 1:2 axes x1y2 with linespoints dashtype 2 title "memory of prepare, MB", \
  "" every ::1 using 1:6 axes x1y2 with linespoints dashtype 2 title "memory of registering, MB"
PLOT
