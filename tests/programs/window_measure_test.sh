#!/usr/bin/env bash
# Measures known lengths of a synthetic scene in the window, with real mouse and key events through the X server.
# usage: window_measure_test.sh VANTAGE PLAYER SOURCE_DIR; exits with 77 if no X server is available
set -uo pipefail
source "$(dirname "$0")/window.sh"
under_xvfb 1280x1024 "$@"

vantage=$1 player=$2 source=$3
"$vantage" synth "$source/data/tiny.toml" -o scene >/dev/null && "$vantage" prepare scene -o one.vantage --no-report >/dev/null 2>&1 || exit 1
camera=$(awk '!/^#/ && NF == 10 { print; n++ } n == 3 { exit }' scene/sparse/images.txt | tail -1)
photo=$(echo "$camera" | awk '{ print $10 }')
start() {  # start [PACKAGE], in the system's language $language
  rm -f places
  LC_ALL=${language:-C.UTF-8} "$player" "${1:-one.vantage}" --photo "$photo" --size 900x700 --blended 1 --thumbnails --controls places --fresh >says 2>&1 &
  pid=$!
  find_window
}
# pixel X Y Z [right down]: where the photo's camera shows a point in the window, moved by some pixels
pixel() {
  awk -v x="$1" -v y="$2" -v z="$3" -v right="${4:-0}" -v down="${5:-0}" -v camera="$camera" '
    # Bar and strip leave 900x564 pixels to the photo.
    !/^#/ && NF > 4 && !done {
      high = 900 * $4 / $3
      focal = ($6 ? $6 : $5) * (high < 564 ? high : 564) / $4
      done = 1
    }
    END {
      split(camera, c, " "); w = c[2]; a = c[3]; b = c[4]; d = c[5]
      cx = (1 - 2 * (b * b + d * d)) * x + 2 * (a * b - d * w) * y + 2 * (a * d + b * w) * z + c[6]
      cy = 2 * (a * b + d * w) * x + (1 - 2 * (a * a + d * d)) * y + 2 * (b * d - a * w) * z + c[7]
      cz = 2 * (a * d - b * w) * x + 2 * (b * d + a * w) * y + (1 - 2 * (a * a + b * b)) * z + c[8]
      print int(focal * cx / cz + 450 + right + 0.5), int(focal * cy / cz + 282 + down + 0.5)
    }' scene/sparse/cameras.txt
}
point() {  # point X Y Z [right down]: clicks there
  # shellcheck disable=SC2046
  xdotool mousemove $(pixel "$@") click 1
  frames 3
}
# Files are written while the window goes on.
saved_value() { awk -F'[:,]' '/"value"/ { v = $2 } END { print v + 0 }' "$1" 2>/dev/null; }  # the last one
near() {  # near FILE EXPECTED TOLERANCE
  saved_value "$1" | awk -v wanted="$2" -v off="$3" '{ near = $1 - wanted <= off && wanted - $1 <= off } END { exit !near }'
}
measures() {  # measures EXPECTED TOLERANCE WHAT: compares the last value that is saved
  soon near one.measurements.json "$1" "$2" || fail "$3 is measured as $(saved_value one.measurements.json), expected $1 within $2"
}
count() { grep -cs '"measure":' "${1:-one.measurements.json}"; }
counts() { [ "$(count "${2:-one.measurements.json}")" = "$1" ]; }
type_into() {  # type_into FIELD TEXT
  press "$1"
  xdotool key ctrl+a; frames 2
  xdotool type --delay 40 "$2"; frames 3
  xdotool key Return; frames 3
}
there() { frames 3; place "$1" >/dev/null; }

# An opening of the upper floor: 1.49333 m wide and 2.01 m high. Its corners are vertices of the mesh.
left=1.92 right=3.41333 low=3.54 high=5.55
start
xdotool key m; frames 3
# What the right button drags follows the pointer; the wheel and an orbit leave the point under the pointer where it is.
stays() {  # stays WHAT: the point that was clicked last is under the pointer
  sleep 0.6; frames 3; xdotool click 1; frames 3  # no double click
  soon counts $((measured + 1)) || fail "$1: there is no surface, or no distance"
  measured=$(count)
  measures 0 0.04 "$1: the distance of the point from itself"
}
measured=$(count)
point 2.4 0 2.9
xdotool mousedown 3; frames 2; xdotool mousemove_relative 60 -30; frames 3; xdotool mouseup 3
stays "dragged by the right button"
sleep 0.6; xdotool click 1; frames 3
xdotool click --repeat 3 4
stays "after the wheel"
sleep 0.6
point 2.4 0 2.9 60 -30
xdotool mousedown 1; frames 2; xdotool mousemove_relative 80 20; frames 3; xdotool mouseup 1; frames 2
xdotool mousemove_relative -- -80 -20
stays "orbited"
xdotool key ctrl+q; await_exit "Ctrl+Q"
rm one.measurements.json

start
xdotool key m
there "Snap to vertices" || fail "M does not show the panel"

# On the surface: as exact as a pixel of the window, which is 13 mm there.
point 1.6 0 3.7; point 1.6 0 5.3
measures 1.6 0.03 "a distance on the wall"

# At vertices, some pixels beside them: as exact as the mesh.
press "Snap to vertices"
point $left 0 $low -2 1; point $left 0 $high -2 -1
measures 2.01 0.0001 "the height of the opening"
press "Measure"; press "area"
point $left 0 $low; point $right 0 $low; point $right 0 $high 2 -1; point $left 0 $high
xdotool key Return; frames 3
measures 3.0016 0.0005 "the area of the opening"
press "Measure"; press "angle"
point $right 0 $low; point $left 0 $low; point $left 0 $high
measures 90 0.01 "a corner of the opening"
press "Measure"; press "height"
point $right 0 $low; point $left 0 $high
measures 2.01 0.0001 "the height between two corners"

# Backspace takes the last point back, and a double click ends.
press "Measure"; press "polyline"
point $left 0 $low; point $left 0 $high; point 1.6 0 4
xdotool key BackSpace; frames 2
# shellcheck disable=SC2046
xdotool mousemove $(pixel $right 0 $high); frames 2
xdotool click --repeat 2 --delay 80 1; frames 4
measures 3.50333 0.0005 "a chain of two sides"

# What is no surface sets no point; Esc gives up what is begun, then leaves.
before=$(count)
xdotool mousemove 880 60 click 1; frames 3
point $left 0 $low
xdotool key Escape; frames 3
there "Snap to vertices" || fail "Esc leaves while something is being measured"
xdotool key Return; frames 3
[ "$(count)" = "$before" ] || fail "Esc does not give up a chain"
xdotool key Escape
there "Snap to vertices" && fail "Esc does not leave"
point $left 0 $low; point $left 0 $high
[ "$(count)" = "$before" ] || fail "clicks measure outside of the mode"

# Names, scale, the table.
xdotool key m; frames 3
press "distance 2"
type_into "Name" "Door"
soon grep -q '"name": "Door"' one.measurements.json || fail "the new name is not saved"
type_into "Known length" "6.6"
press "Set scale"
soon grep -q '"unit": "m"' one.measurements.json || fail "the scale is not saved"
press "Shown in"; press "cm"
measures 1150.35 0.5 "the chain with another scale"
press "angle 1"; press "Delete"
soon counts $((before - 1)) || fail "Delete deletes nothing"
press "Export table"
frames 3
soon grep -q '^"Door",distance,660' one-measurements-0001.csv || fail "the table has no door of 660 cm: $(cat one-measurements-0001.csv)"

# A level cut, as a drawing: all of it at one height, and as long as the walls.
xdotool key m; frames 3
xdotool key Tab; frames 3
press "Section Cut"
press "Cut the model"
press "Across"; press "z"
press "Write the cut"
soon grep -qs EOF one-cut-0001.dxf
awk '
  NR % 2 { code = $1; next }
  code == 30 || code == 31 { if (n++ == 0) height = $1; off += $1 - height > 1e-6 || height - $1 > 1e-6 }
  END { exit !(n > 20 && off == 0 && height > 1 && height < 6) }' one-cut-0001.dxf || fail "the cut is not level: $(head -c 400 one-cut-0001.dxf)"
# A box: nothing beside it is left, and its sides are drawn where they cut the walls.
press "Cut by"; press "a box"
press "x from" 0.3
press "Write the cut"
soon grep -qs EOF one-cut-0002.dxf
awk '
  NR % 2 { code = $1; next }
  code == 10 { from = $1 }
  code == 11 { n++; low = n == 1 || from < low ? from : low; low = $1 < low ? $1 : low; at[n] = from == $1 ? $1 : "" }
  END {
    for (i = 1; i <= n; ++i) side += at[i] != "" && at[i] - low < 1e-6
    exit !(side > 10 && low > -8 && low < 0)
  }' one-cut-0002.dxf || fail "the box does not cut at its side: $(head -c 400 one-cut-0002.dxf)"
press "All of it"
press "Cut the model"
# Photos by name, and those that show a point, the sharpest first.
press "Section Picture"; press "Section Blending"; press "Section Photos"
listed() { frames 3; awk -F'\t' '$1 ~ /^Fly to / { print substr($1, 8) }' places | paste -sd' '; }
type_into "Name contains" "${photo%.*}"
[ "$(listed)" = "$photo" ] || fail "of photos named $photo, $(listed) are listed"
type_into "Name contains" ""
xdotool key BackSpace; frames 3
all=$(listed)
press "Of a point"
xdotool mousemove 600 282 click 1; frames 4
[ -n "$(listed)" ] || fail "no photo shows the middle of the picture"
press "Use only these"; press "Fly to $(listed | cut -d' ' -f1)"
sleep 1.5; frames 3
xdotool mousemove 880 60 click 1; frames 3  # beside the model: the point stays
press "Use $(listed | cut -d' ' -f1)"
press "Use all"; press "Of a point"
[ "$(listed)" = "$all" ] || fail "without a point, $(listed) are listed instead of $all"
press "Section Photos"

# An orthophoto while the window is used: that of the command, which tests compare with the surface pixel by pixel.
press "Section Cut"
press "Section Orthophoto"
press "Seen from"; press "front"
type_into "Size of a pixel" "0.05"
press "Write the orthophoto"
for _ in $(seq 300); do [ -f one-orthophoto-0001.pgw ] && break; sleep 0.2; done
"$player" orthophoto one.vantage --plane front --resolution 0.05 -o expected.png >/dev/null || fail "the command orthophoto failed"
cmp -s one-orthophoto-0001.png expected.png || fail "the window's orthophoto is not that of the command"
cmp -s one-orthophoto-0001.pgw expected.pgw || fail "the window's orthophoto has another place: $(cat one-orthophoto-0001.pgw)"
xdotool key ctrl+q; await_exit "Ctrl+Q"

# Orthographically, 200 pixels are as long on the roof as on the ground, 7 m below.
cp one.vantage flat.vantage
start flat.vantage
xdotool key Tab; frames 3
press "View"; press "From the top"
sleep 1.5
press "Orthographic"
xdotool key Tab; frames 3
xdotool key m; frames 3
length() {  # length ROW: that of 200 pixels in this row, beside the middle of the picture
  local before
  before=$(count flat.measurements.json)
  for column in 350 550; do xdotool mousemove $column "$1" click 1; frames 3; done
  soon counts $((${before:-0} + 1)) flat.measurements.json
  saved_value flat.measurements.json
}
ground=$(length 350)
# The middle is 1.8 m before the facade; the roof's ridge runs 2.2 m behind it.
ridge=$(awk -v l="$ground" 'BEGIN { print int(282 - 3.6 * 200 / l) }')
roof=$(length "$ridge")
awk -v a="$ground" -v b="$roof" 'BEGIN { exit !(a > 1 && b / a > 0.998 && b / a < 1.002) }' ||
  fail "200 pixels are $ground on the ground and $roof on the roof"
xdotool mousemove 450 "$ridge" click --repeat 3 4; frames 5
closer=$(length "$ridge")
awk -v a="$roof" -v b="$closer" 'BEGIN { exit !(b / a > 0.727 && b / a < 0.731) }' ||
  fail "three turns of the wheel change 200 pixels from $roof to $closer, expected 0.9^3 of it"
xdotool key c; frames 3
there "Wiper" || fail "an orthographic view cannot be compared with a photo"
xdotool key ctrl+q; await_exit "Ctrl+Q"

# They are there again; a damaged file is left alone.
start
xdotool key m; frames 3
there "Door" || fail "measurements are not read"
xdotool key ctrl+q; await_exit "Ctrl+Q"
head -c 300 one.measurements.json >cut && cp cut one.measurements.json
start
xdotool key m; frames 3
point 1.6 0 3.7; point 1.6 0 5.3
kill -0 $pid 2>/dev/null || fail "a damaged file ends the player"
cmp -s cut one.measurements.json || fail "a damaged file was replaced"
xdotool key ctrl+q; await_exit "Ctrl+Q"

# In the system's language, and in one that is chosen.
cp one.vantage words.vantage
language=de_AT.UTF-8 start words.vantage
xdotool key m; frames 3
point 1.6 0 3.7; point 1.6 0 5.3
soon grep -q '"name": "Abstand 1"' words.measurements.json || fail "in German, a distance is named $(grep '"name"' words.measurements.json)"
xdotool key Tab; frames 3
press "View"
there "Radar" || fail "the menu does not open"
xdotool key Escape; frames 3
there "Radar" && fail "Esc does not close the menu"
there "Snap to vertices" || fail "Esc leaves measuring while a menu is open"
press "View"; press "Language"; press "Français"
xdotool key Tab; frames 3; xdotool key m; frames 3; xdotool key m; frames 3  # the panel is where it was at first
press "Measure"; press "height"
point 1.6 0 3.7; point 1.6 0 5.3
soon grep -q '"name": "hauteur 1"' words.measurements.json || fail "in French, a height is named $(grep '"name"' words.measurements.json)"
xdotool key ctrl+q; await_exit "Ctrl+Q"

[ $failed = 0 ] && echo "measures"
exit $failed
