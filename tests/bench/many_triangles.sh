#!/usr/bin/env bash
# Measures the time and memory of `prepare` for 0.16 to 20 million triangles and two photos of 800x600 pixels, taken close
# up, where the mesh fills the frame, and from 20 times as far away, where hundreds of triangles share a pixel. It measures the
# whole command and vertex visibility alone, and records the estimate that prepare makes before it reads the first photo, on a
# machine without history. Writes many_triangles.tsv and many_triangles.svg into FOLDER.
# Usage: many_triangles.sh VANTAGE FOLDER [MILLIONS...]
set -euo pipefail
vantage=$1
folder=$2
shift 2
[ $# -gt 0 ] || set -- 0.16 0.64 1.28 2.5 5 10 20
mkdir -p "$folder"
export XDG_CACHE_HOME=$folder/cache

make_scene() {  # make_scene FOLDER MILLIONS DISTANCE: a wavy grid 2 units wide
  python3 - "$@" <<'PYTHON'
import array, math, os, struct, sys, zlib
folder, side, distance = sys.argv[1], round(math.sqrt(float(sys.argv[2]) * 1e6 / 2)), float(sys.argv[3])
width, height = 800, 600
os.makedirs(folder + "/images")
os.makedirs(folder + "/sparse")
with open(folder + "/mesh.ply", "wb") as mesh:
    mesh.write(f"""ply
format binary_little_endian 1.0
element vertex {(side + 1) ** 2}
property float x
property float y
property float z
element face {2 * side * side}
property list uchar int vertex_indices
end_header
""".encode())
    along = [2 * i / side - 1 for i in range(side + 1)]
    for y in along:
        wave = 0.1 * math.cos(5 * y)
        row = array.array("f")
        for x in along:
            row.extend((x, y, wave * math.sin(7 * x) + 0.02 * math.sin(40 * x + 30 * y)))
        mesh.write(row.tobytes())
    for i in range(side):
        first = i * (side + 1)
        mesh.write(b"".join(struct.pack("<B3iB3i", 3, a, a + 1, a + side + 2, 3, a, a + side + 2, a + side + 1)
                            for a in range(first, first + side)))
pixels = b"".join(b"\0" + bytes((x * y // (9 + c)) & 255 for x in range(width) for c in range(3)) for y in range(height))
def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
with open(folder + "/sparse/cameras.txt", "w") as cameras:
    cameras.write(f"1 PINHOLE {width} {height} 800 800 400 300\n")
open(folder + "/sparse/points3D.txt", "w").close()
with open(folder + "/sparse/images.txt", "w") as images:
    for i in range(2):
        with open(f"{folder}/images/{i}.png", "wb") as photo:
            photo.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0)) +
                        chunk(b"IDAT", zlib.compress(pixels)) + chunk(b"IEND", b""))
        images.write(f"{i + 1} 0 1 0 0 {-0.1 * i * distance} 0 {2.6 * distance} 1 {i}.png\n\n")
PYTHON
}
seconds() {  # seconds TRACE SPAN: total duration of the spans in the trace
  tr '{' '\n' <"$1" | grep -oP "\"dur\":[0-9.]+,\"name\":\"$2\"" | awk -F'[:,]' '{ s += $2 } END { printf "%.2f", s / 1e6 }'
}
prepare() {  # prepare SCENE: total, estimated and visibility seconds; memory and its estimate in MB
  rm -rf "$folder/package"* "$XDG_CACHE_HOME"
  local printed
  printed=$("$vantage" prepare "$1" -o "$folder/package.vantage" --progress none --no-report --trace "$folder/trace.json")
  echo -ne "\t$(grep -oP '^package .*, \K[0-9.]+(?= s\))' <<<"$printed")"
  echo -ne "\t$(grep -oP '^needs .*about \K[0-9]+' <<<"$printed")\t$(seconds "$folder/trace.json" coordinates)"
  echo -ne "\t$(awk '$1 == "memory" { print $2 }' <<<"$printed")\t$(grep -oP '^needs .*at most \K[0-9]+' <<<"$printed")"
}

table=$folder/many_triangles.tsv
columns="s\testimated_s\tvisibility_s\tMB\testimated_MB"
echo -e "million\tnear_$columns\tfar_$columns" | tee "$table"
for millions in "$@"; do
  line=$millions
  for distance in 1 20; do
    scene=$folder/$millions-$distance
    [ -d "$scene" ] || make_scene "$scene" "$millions" "$distance"
    line+=$(prepare "$scene")
  done
  echo "$line" | tee -a "$table"
done
rm -rf "$folder/package"* "$folder/trace.json" "$XDG_CACHE_HOME"
curves() {  # curves TITLE YRANGE NEAR FAR NEAR_ESTIMATED FAR_ESTIMATED WORDS: columns of the table as lines and points
  cat <<PLOT
set title "$1"
set yrange $2
plot "$table" every ::1 using 1:$3 with linespoints linewidth 2 pointtype 7 linecolor rgb "#1565c0" title "near", \
  "" every ::1 using 1:$4 with linespoints linewidth 2 pointtype 7 linecolor rgb "#c62828" title "20 times as far", \
  "" every ::1 using 1:$5 with points pointtype 6 linecolor rgb "#1565c0" title "near, $7", \
  "" every ::1 using 1:$6 with points pointtype 4 linecolor rgb "#c62828" title "far, $7"
PLOT
}
gnuplot <<PLOT
set terminal svg size 900,460 font "sans,13" background "white"
set output "$folder/many_triangles.svg"
set multiplot layout 1,2
set logscale xy
set xlabel "million triangles"
set xrange [0.1:30]
set grid
set border 3
set tics nomirror
set key below vertical maxrows 4 Left reverse
set pointsize 0.6
$(curves seconds "[0.1:100]" 2 7 3 8 "as estimated")
$(curves "peak memory, MB" "[50:20000]" 5 10 6 11 "at most as estimated")
PLOT
