#!/usr/bin/env bash
# Tests how the window interacts with the system: several key presses within a frame, the desktop's file dialog, output files,
# read-only folders, idling with little memory.
# Usage: window_events_test.sh VANTAGE PLAYER SOURCE_DIR; exits with 77 if no X server is available
set -uo pipefail
source "$(dirname "$0")/window.sh"
under_xvfb 1280x1024 "$@"

vantage=$1 player=$2 source=$3
"$vantage" synth "$source/data/tiny.toml" -o scene >/dev/null && "$vantage" prepare scene -o one.vantage >/dev/null 2>&1 || exit 1
mkdir folder && cp one.vantage folder/two.vantage

# Taps and clicks that are shorter than a frame are all handled, in order.
start one.vantage --size 900x700
xdotool mousemove 500 400 click 4
xdotool key --delay 0 Tab c F5
there "Section Picture" || fail "a tap of Tab is lost if two other keys follow within a frame"
there "Swipe" || fail "a tap of C is lost between two other keys within a frame"
xdotool key --delay 0 o Escape
gone "Cancel" || fail "O and Esc leave the dialog open"
press "File"
xdotool mousemove $(place "Quit")
frames 2
xdotool click 1
await_exit "the menu"
remembers panel_frusta true

start_page
xdotool key o
there "Cancel" || fail "O does not open the dialog on the start page"
xdotool key Escape; frames 3
quit

# The desktop's own file dialog, if there is one.
mkdir bin
printf '#!/bin/sh\necho "%s"\n' "$dir/folder/two.vantage" >bin/zenity && chmod +x bin/zenity
start_page PATH="$dir/bin:$PATH" XDG_CURRENT_DESKTOP=GNOME
xdotool key o
opens two.vantage
quit

# An orthophoto can be written while the window is in use, and it is identical to the one from the command line.
start one.vantage --no-saved-settings --size 1200x800
key Tab
press "More Surveying"
press "Seen from"; press "front"
press "Write the orthophoto"
key b
within 30 test -s one-orthophoto-0001.pgw
"$player" orthophoto one.vantage --plane front --resolution "$(head -1 one-orthophoto-0001.pgw)" -o expected.png >/dev/null ||
  fail "the command orthophoto failed"
cmp -s one-orthophoto-0001.png expected.png || fail "the window's orthophoto is not that of the command"
quit

# Files are written next to the package, even if the window was opened from a read-only folder.
rm -f places
(cd /proc && exec "$player" "$dir/one.vantage" --size 900x700 --controls "$dir/places") >says 2>&1 &
pid=$!
find_window
xdotool key p
there "Copy path" || fail "no message about a screenshot next to the package"
test -s one-0001.png || fail "no screenshot next to the package"
quit

# At rest, nothing is drawn, even if not all tiles fit into memory. A key press wakes the window.
comes_to_rest() {
  "$player" "$@" --no-saved-settings >says 2>&1 &
  pid=$!
  rests || fail "$* never rests"
  focus
  rm -f ./*-0001.png
  xdotool key p
  soon test -s "${1%.vantage}-0001.png" || fail "P has no effect at rest"
  quit
}
comes_to_rest one.vantage --size 900x700 --graphics-memory 110
if [ -n "${VANTAGE_DATASETS:-}" ] && [ -d "$VANTAGE_DATASETS/sceaux-small" ]; then
  "$vantage" prepare "$VANTAGE_DATASETS/sceaux-small" -o sceaux.vantage --no-report >/dev/null 2>&1 || fail "prepare"
  comes_to_rest sceaux.vantage --size 600x420
fi

[ $failed = 0 ] && echo "events are handled"
exit $failed
