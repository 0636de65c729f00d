#!/usr/bin/env bash
# What the window shows and says: tooltips, legends, grayed controls, screenshots, the strip of many photos, their order, damage.
# usage: window_shows_test.sh VANTAGE PLAYER SOURCE_DIR; exits with 77 if no X server is available
set -uo pipefail
source "$(dirname "$0")/window.sh"
under_xvfb 1280x1024 "$@"

vantage=$1 player=$2 source=$3 photos=60
sed "s/^count = .*/count = $photos/; s/^width = 331/width = 96/; s/^height = 250/height = 72/" "$source/data/tiny.toml" >many.toml
"$vantage" synth many.toml -o scene >/dev/null || exit 1
# The order of names is not that around the building.
mv scene/images scene/ordered && mkdir scene/images
new_name() { printf '%04d.jpg' $(($1 * 7 % photos)); }
number=0
for file in scene/ordered/*.jpg; do
  cp "$file" "scene/images/$(new_name $number)"
  sed -i "s/ ${file##*/}\$/ new-$(new_name $number)/" scene/sparse/images.txt
  number=$((number + 1))
done
sed -i 's/ new-/ /' scene/sparse/images.txt
"$vantage" prepare scene -o one.vantage --no-report >/dev/null 2>&1 || { fail "prepare"; exit 1; }
start() {  # start OPTIONS...
  rm -f places
  "$player" one.vantage --size 900x700 --controls places "$@" >says 2>&1 &
  pid=$!
  find_window
}
quit() { xdotool key ctrl+q; await_exit "Ctrl+Q"; }
there() { frames 3; place "$1" >/dev/null; }

# A tooltip explains what is under the pointer; false colors have a legend.
start
there "Tooltip" && fail "a tooltip without a pointer"
# shellcheck disable=SC2046
xdotool mousemove $(place "Bar Light")
there "Tooltip" || fail "the bar explains nothing"
xdotool mousemove 450 200
for legend in yes yes no; do
  xdotool key v; frames 2
  there "Legend" && has=yes || has=no
  [ $has = $legend ] || fail "false colors: legend $has, expected $legend"
done

# The strip has all photos, and is scrolled by the wheel.
there "Photo $photos" || fail "the strip ends before photo $photos"
before=$(place "Photo 4")
# shellcheck disable=SC2046
xdotool mousemove $(place "Photo 2"); frames 2
xdotool click 5; frames 4
after=$(place "Photo 4")
[ $((${before% *} - ${after% *})) -gt 50 ] || fail "the wheel moves the strip from $before to $after"
xdotool mousemove 450 200

# N flies to the next photo around the building, whatever the names.
awk '!/^#/ && NF == 10 {
  a = $2; b = $3; c = $4; d = $5
  x = -((1 - 2 * (c * c + d * d)) * $6 + 2 * (b * c + a * d) * $7 + 2 * (b * d - a * c) * $8)
  y = -(2 * (b * c - a * d) * $6 + (1 - 2 * (b * b + d * d)) * $7 + 2 * (c * d + a * b) * $8)
  print atan2(y, x)
}' scene/sparse/images.txt >angles
angle() {  # of where the camera stands, after the flight
  sleep 1.2; frames 2
  xdotool key r; frames 3; xdotool key r; frames 3
  grep -v '^#' "$(ls one-*.path | tail -1)" | tail -1 | awk '{ print atan2($2, $1) }'
}
xdotool key n
from=$(angle)
for _ in 1 2 3; do
  xdotool key n
  to=$(angle)
  awk -v from="$from" -v to="$to" '
    { between += $1 > (from < to ? from : to) + 1e-4 && $1 < (from < to ? to : from) - 1e-4 }
    END { exit !(between == 0 && from != to) }' angles || fail "N flies from $from to $to, past other photos"
  from=$to
done

# Screenshots show the model alone.
sleep 3; xdotool key p; frames 4
xdotool key F1; frames 3; sleep 3; xdotool key p; frames 4
cmp -s one-0001.png one-0002.png || fail "a screenshot shows the help"
xdotool key F1; frames 2

# Nothing of the picture shines through the help.
help() {  # help FILE.ppm: its pixels, without its rounded corners
  xdotool key F1; frames 4
  # shellcheck disable=SC2046
  screenshot "$1" $(awk -F'\t' '$1 == "Mouse, fingers and keys" { print int($2) + 8, int($3) + 8, int($4) - 16, int($5) - 16 }' places)
  xdotool key F1; frames 2
}
help before.ppm
xdotool key n; sleep 2; frames 2
help after.ppm
cmp -s before.ppm after.ppm || fail "the picture shines through the help"

"$player" one.vantage --fresh --frames 1 --screenshot last.jpg >says 2>&1 && fail "a screenshot named .jpg is taken"
[ ! -e last.jpg ] || fail "last.jpg is no JPEG"

# What does not apply is grayed and does nothing.
xdotool key Tab; frames 3
press "Prefer near" 0.45
press "Section Blending"; press "Section Picture"; press "Section Status"
is_filled() {  # is_filled SHARE: whether the bar of tiles is, at this share of its width
  # shellcheck disable=SC2046
  screenshot bar.ppm $(place tiles "$1") 1 1
  [ "$(tail -c 1 bar.ppm | od -An -tu1)" -gt 150 ]  # blue
}
xdotool mousemove 450 200; frames 3
is_filled 0.01 || fail "the bar of tiles is empty"
is_filled 0.97 && fail "the bar of tiles is full"
quit
remembers exponent 2.0
remembers panel_status true
remembers panel_picture false
start
press "Section Blending"; press "Average"; press "Prefer near" 0.45
quit
awk -F'[:,]' '/"exponent"/ { exit !($2 > 16) }' config/vantage/player.json || fail "what applies does nothing either"

# Damage is said, without any panel.
/usr/bin/python3 - <<'END'
data = bytearray(open("one.vantage", "rb").read())
at = -1
while (at := data.find(b"\xff\xd8\xff", at + 1)) >= 0:  # a tile of colors
    data[at + 2000 : at + 2002] = bytes(2)
open("one.vantage", "wb").write(data)
END
start --fresh
place "Message" >/dev/null || place "Message" >/dev/null || fail "damage is not said: $(cat says)"  # it goes after some seconds
xdotool key ctrl+q
for _ in $(seq 100); do kill -0 $pid 2>/dev/null || break; sleep 0.1; done
kill -0 $pid 2>/dev/null && fail "Ctrl+Q does not end the player"

[ $failed = 0 ] && echo "shows and says"
exit $failed
