#!/usr/bin/env bash
# Simulates a visitor who uses a kiosk by touch only: orbits, finds a dormer on the roof, zooms in, compares it with the photo and
# returns to the home view.
# Usage: visitor_test.sh VANTAGE PLAYER SOURCE_DIR FIND_PICTURE [WIDTHxHEIGHT [FOLDER for screenshots]]
# Exits with 77 if there is no X server with a touch screen, or no photos (VANTAGE_DATASETS).
set -uo pipefail
source "$(dirname "$0")/window.sh"
size=${5:-1280x1024} pictures=${6:-}
[ -d "${VANTAGE_DATASETS:-}/sceaux-small" ] || { echo "skipped: VANTAGE_DATASETS has no sceaux-small"; exit 77; }
under_touch_screen "$size" "$@"

vantage=$1 player=$2 find_picture=$4
set=$VANTAGE_DATASETS/sceaux-small
"$vantage" prepare "$set" -o sceaux.vantage --no-report >/dev/null 2>&1 || { fail "prepare"; exit 1; }
wide=${size%x*} high=${size#*x}

# shot NAME: takes the screenshot NAME.ppm once the picture has been still for ten frames, because X may deliver events late
shot() {
  local still=0 last now rests
  last=$(frame)
  while [ $still -lt 10 ]; do
    within 60 has_drawn $((last + 1)) || { fail "the window never comes to rest"; return; }
    read -r now rests < <(awk -F'\t' '$1 == "frame" { print $2, $3; exit }' places)
    [ "$rests" = rests ] && still=$((still + now - last)) || still=0
    last=$now
  done
  screenshot "$1.ppm"
  [ -z "$pictures" ] || cp "$1.ppm" "$pictures/$1-$size.ppm"
}
# look NAME: finds the dormer in a screenshot; sets its position x and y, its scale `times` and its similarity `likeness`
look() {
  shot "$1"
  read -r x y times likeness <<<"$("$find_picture" "$1.ppm" "$set/images/00003.jpg" 323 193 54 60)"
  echo "$1: the dormer is at $x, $y, $times times the photo's size, similar by $likeness"
  is "$likeness > 0.5" || fail "$1: the dormer is not visible"
}
is() { awk "BEGIN { exit !($1) }"; }
# Taps a control at its position, which is read from the file of controls.
touch_control() {
  local at
  at=$(place "$1") || { fail "there is no '$1'"; return; }
  # shellcheck disable=SC2086
  finger tap $at
}

"$player" kiosk sceaux.vantage --idle-timeout 3600 --photo 00003 --no-saved-settings --controls places >says 2>&1 &
pid=$!
within 20 is_at "Bar Home"
covers() { local at; at=$(place "Bar Home") && [ "${at#* }" -gt $((high * 9 / 10)) ]; }
within 10 covers || fail "the kiosk does not cover the screen"
look home
home=($x $y $times)

# One finger orbits the building. Moving it back without lifting it restores the view.
finger drag $((wide / 2)) $((high / 3)) $((wide / 2 + wide / 8)) $((high / 3))
shot around
cmp -s home.ppm around.ppm && fail "one finger does not turn the model"
touch_control "Bar Home"
shot homed
finger swing $((wide / 2)) $((high / 3)) $((wide / 2 + wide / 8)) $((high / 3))
look back
is "sqrt(($x - ${home[0]})^2 + ($y - ${home[1]})^2) < 0.01 * $wide" || fail "dragging back does not restore the view"

# Two taps on the dormer bring it to the middle; two fingers zoom in further.
finger double "$x" "$y"
look closer
is "$times > 1.7 * ${home[2]}" || fail "two taps do not bring the dormer closer"
is "($x - $wide / 2)^2 < (0.1 * $wide)^2" || fail "two taps do not bring the dormer to the middle"
before=($x $y $times)
finger pinch "$x" "$y" $((high / 6)) $((high / 4)) 0
look pinched
is "$times > 1.3 * ${before[2]} && $times < 1.7 * ${before[2]}" || fail "fingers that spread by half enlarge by $times / ${before[2]}"
is "sqrt(($x - ${before[0]})^2 + ($y - ${before[1]})^2) < 0.05 * $wide" || fail "the point between the fingers moved"
before=($x $y)
finger pan "$x" "$y" $((x + wide / 10)) $((y + high / 20))
look panned
is "($x - ${before[0]} - $wide / 10)^2 + ($y - ${before[1]} - $high / 20)^2 < (0.03 * $wide)^2" || fail "two fingers do not move the picture with them"

# Compares the view with the photo: the line between them follows the finger.
touch_control "Bar Compare"
shot compared
place Swipe >/dev/null || fail "Compare shows no line to drag"
at=$(place Swipe)
# shellcheck disable=SC2086
finger drag $at $((wide / 4)) "${at#* }"
shot wiped
cmp -s compared.ppm wiped.ppm && fail "the line does not follow the finger"
[ "$(place Swipe)" != "$at" ] || fail "the line is still at $at"
touch_control "Bar Compare"

# Returns to the home view, which is unchanged.
touch_control "Bar Home"
look home-again
is "sqrt(($x - ${home[0]})^2 + ($y - ${home[1]})^2) < 0.01 * $wide && ($times / ${home[2]} - 1)^2 < 0.01" || fail "Home leads elsewhere"

# Visitors must not reach expert functions by touch.
grep -q "^Bar Expert	" places && fail "a kiosk offers the expert's panels"
kill -0 $pid 2>/dev/null || fail "the kiosk ended: $(cat says)"

# A kiosk that crashes is restarted; SIGTERM ends it.
rm -f places
pkill -KILL -P $pid
within 20 is_at "Bar Home" || fail "a kiosk that was killed is not started again"
kill $pid
ended() { ! kill -0 $pid 2>/dev/null; }
soon ended || fail "SIGTERM does not end the kiosk"
[ $failed = 0 ] && echo "the visitor has seen it"
exit $failed
