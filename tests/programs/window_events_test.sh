#!/usr/bin/env bash
# What the window does with events: taps shorter than a frame, drags, Esc, files and folders in the dialog, recordings, rest.
# usage: window_events_test.sh VANTAGE PLAYER SOURCE_DIR; exits with 77 if no X server is available
set -uo pipefail
source "$(dirname "$0")/window.sh"
under_xvfb 1280x1024 "$@"

vantage=$1 player=$2 source=$3
"$vantage" synth "$source/data/tiny.toml" -o scene >/dev/null && "$vantage" prepare scene -o one.vantage >/dev/null 2>&1 || exit 1
mkdir folder && cp one.vantage folder/two.vantage
start() {  # start FOLDER ARGUMENTS...: the window, with a file of its controls
  local from=$1
  shift
  rm -f "$dir/places"
  (cd "$from" && exec "$player" "$@" --size 900x700 --controls "$dir/places") >says 2>&1 &
  pid=$!
  find_window
}
alive() { sleep 0.3; kill -0 $pid 2>/dev/null || fail "$1 ended the player: $(cat says)"; }
quit() { xdotool key ctrl+q; await_exit "Ctrl+Q"; }
title() { xdotool getwindowname "$window"; }
there() { frames 3; place "$1" >/dev/null; }

# Taps shorter than a frame: all of them act, in order.
start . one.vantage
there "Section Picture" && fail "the sidebar is open at the start"
xdotool mousemove 500 400 click 4
xdotool key --delay 60 F3 F5 F6 F6
frames 4
xdotool key --delay 60 ctrl+c
there "Wiper" && fail "Ctrl+C compares"
xdotool key --delay 60 c c c
there "Wiper" || fail "three taps of C do not show the wiper"
xdotool key --delay 0 Tab c F5
there "Section Picture" && fail "a tap of Tab is lost if two other keys follow within a frame"
there "Wiper" && fail "a tap of C is lost between two other keys within a frame"
xdotool key --delay 0 Tab c F5
there "Section Picture" || fail "a tap of Tab does not open the sidebar again"

# A click quicker than a frame, with the pointer elsewhere by the end of it.
at=$(place "Bar Expert")
# shellcheck disable=SC2086
xdotool mousemove $at mousedown 1 mouseup 1 mousemove 450 200
there "Section Picture" && fail "a click on Expert quicker than a frame is lost"  # F3 has opened the sidebar
# shellcheck disable=SC2086
xdotool mousemove $at mousedown 1 mouseup 1 mousemove 450 200
there "Section Picture" || fail "another click on Expert quicker than a frame is lost"

# Esc closes what is open, and nothing else.
xdotool key Escape; frames 3
there "Wiper" && fail "Esc does not end the comparison"
xdotool key o
there "Cancel" || fail "O does not open the dialog"
xdotool key --delay 0 Escape; frames 1; xdotool key --delay 0 F6; frames 3
there "Cancel" && fail "Esc does not close the dialog"
xdotool key F1; frames 3; xdotool key Escape; frames 3; xdotool key Escape
alive "Esc"
xdotool key --delay 0 o Escape; frames 3
there "Cancel" && fail "O and Esc leave the dialog open"
xdotool key --delay 0 o c F5 Escape; frames 3
there "Cancel" && fail "Esc after other keys does not close the dialog"
there "Wiper" && fail "C acts behind the dialog"

# Dragging: what is dragged follows the pointer, half a turn per width of the window.
step_back
xdotool key r; frames 2
xdotool mousemove 450 200; frames 2
xdotool mousedown 1; frames 2; xdotool mousemove_relative 0 60; frames 3; xdotool mouseup 1; frames 2
sleep 2
xdotool key r; frames 3
ls one-0001.path >/dev/null || fail "no path was recorded"
risen=$(awk '/^[^#]/ { x = $1 - $4; y = $2 - $5; z = $3 - $6; last = atan2(z, sqrt(x * x + y * y)); if (!n++) first = last }
  END { print int((last - first) * 180 / 3.14159265 + 0.5) }' one-0001.path)
[ "$risen" = 12 ] || fail "dragging by 60 of 900 pixels downwards raised the camera by $risen degrees, expected 12"
lines=$(grep -vc '^#' one-0001.path)
[ "$lines" -ge 60 ] || fail "more than two seconds were recorded as $lines positions, expected 30 per second"

# What is let go in motion moves on, unless the user does without inertia.
throw() {  # throw NUMBER: by how many degrees the camera rises when dragged by 240 pixels and let go; records path NUMBER
  xdotool key r; frames 2
  xdotool mousemove 450 200; frames 2
  xdotool mousedown 1; frames 2
  # shellcheck disable=SC2046
  xdotool $(for _ in $(seq 60); do echo mousemove_relative 0 4 sleep 0.02; done) mouseup 1
  sleep 3; xdotool key r; frames 3
  awk '/^[^#]/ { x = $1 - $4; y = $2 - $5; z = $3 - $6; last = atan2(z, sqrt(x * x + y * y)); if (!n++) first = last }
    END { print int((last - first) * 180 / 3.14159265 + 0.5) }' "one-000$1.path"
}
xdotool key h; sleep 1; step_back
risen=$(throw 2)
[ "$risen" -gt 49 ] || fail "a drag let go in motion raised the camera by $risen degrees, expected more than the 48 dragged"
xdotool key h; sleep 1; step_back
press "Inertia"
risen=$(throw 3)
[ "$risen" = 48 ] || fail "without inertia, a drag raised the camera by $risen degrees, expected 48"
press "Inertia"

# A flight ends at the photo's camera, with the pointer over the scene.
stands_at() {  # records where the camera stands to the path number $1
  xdotool key r; frames 3; xdotool key r; frames 3
  grep -v '^#' "one-000$1.path" | tail -1 | sed "s, at=.*,,"
}
xdotool mousemove 450 200
for key in n b n; do xdotool key $key; sleep 1.5; frames 3; done
first=$(stands_at 4)
for key in b n; do xdotool key $key; sleep 1.5; frames 3; done
again=$(stands_at 5)
[ -n "$first" ] && [ "$first" = "$again" ] || fail "flights to the same photo end at $first and at $again"

# Dragging the strip scrolls it, and flies nowhere.
xdotool windowsize --sync "$window" 300 700
frames 5
before=$(place "Photo 3")
# shellcheck disable=SC2046
xdotool mousemove $(place "Photo 2"); frames 2
xdotool mousedown 1; frames 2; xdotool mousemove_relative -- -60 0; frames 3; xdotool mouseup 1; frames 3
after=$(place "Photo 3")
moved=$((${after% *} - ${before% *}))
[ "$moved" -le -56 ] && [ "$moved" -ge -64 ] || fail "dragging the strip by -60 pixels moves it by $moved"
xdotool windowsize --sync "$window" 900 700
frames 5
xdotool mousemove 450 200
again=$(stands_at 6)
[ "$first" = "$again" ] || fail "dragging the strip flies from $first to $again"

# The dialog lists folders first, enters them by a double click, and is used by keys alone as well.
xdotool key o; frames 3
first=$(awk -F'\t' '$1 ~ /\/$/ || $1 ~ /vantage$/ { print $1 }' places | sed -n 2p)
[ "$first" = "folder/" ] || fail "the first folder is '$first'"
at=$(place "folder/") || fail "the folder is not listed"
xdotool mousemove $at; frames 2
xdotool click --repeat 2 --delay 50 1
there "two.vantage" || fail "a double click does not enter a folder"
xdotool key --delay 60 Down Down; frames 3
xdotool key Return; frames 3
[ "$(title)" = "two.vantage - Vantage" ] || fail "Enter does not open what the arrow keys selected: $(title)"
xdotool key o; frames 4
xdotool type --delay 30 nbv; frames 3
xdotool key Return; frames 4
[ "$(title)" = "two.vantage - Vantage" ] || fail "a file that does not exist replaced the package"
alive "a file that does not exist"
quit
remembers panel_status true
remembers expert true
remembers panel_frusta true
remembers panel_radar true

# Without a package: one is dropped on the window, then it is among those opened before.
start_page() {  # start_page [NAME=VALUE...]: the window without a package
  rm -f places
  env "$@" "$player" --size 900x700 --controls "$dir/places" >says 2>&1 &
  pid=$!
  for _ in $(seq 200); do grep -qs "^Open a package" places && break; sleep 0.1; done
  window=$(xdotool search --name Vantage | tail -1)
  xdotool windowfocus "$window"
  sleep 0.3
}
opens() {  # opens NAME: waits until the window shows that package
  for _ in $(seq 100); do [ "$(title)" = "$1 - Vantage" ] && break; sleep 0.1; done
  [ "$(title)" = "$1 - Vantage" ] || fail "expected $1, the window shows $(title)"
}
start_page
cp one.vantage three.vantage
head -c 3000 one.vantage >cut.vantage
/usr/bin/python3 "$source_of_tests/drop_files.py" "$window" cut.vantage || fail "the start page takes no files"
alive "a truncated package on the start page"
/usr/bin/python3 "$source_of_tests/drop_files.py" "$window" three.vantage || fail "the start page takes no files"
opens three.vantage
quit
start_page
press "$dir/three.vantage"
opens three.vantage
quit
start_page
xdotool key o
there "Cancel" || fail "O does not open the dialog on the start page"
xdotool key Escape; frames 3
xdotool key ctrl+q; await_exit "Ctrl+Q on the start page"

# The desktop's own dialog, where there is one.
mkdir bin
printf '#!/bin/sh\necho "%s"\n' "$dir/folder/two.vantage" >bin/zenity && chmod +x bin/zenity
start_page PATH="$dir/bin:$PATH" XDG_CURRENT_DESKTOP=GNOME
xdotool key o
opens two.vantage
quit

# A view from the command line; copied as one, and pasted after the camera has moved.
start . one.vantage --view 1,-9,3,1,0,3,40
stands_now() {  # as stands_at, of the newest path
  xdotool key r; frames 3; xdotool key r; frames 3
  grep -v "^#" "$(ls one-*.path | tail -1)" | tail -1 | sed "s, at=.*,,"
}
given=$(stands_now)
[ "$(echo "$given" | awk '{ print $1, $2, $3, $7 }')" = "1 -9 3 40" ] || fail "--view opens the window at $given"
xdotool key ctrl+c; frames 3
xdotool key n; sleep 1.5; frames 3
[ "$(stands_now)" != "$given" ] || fail "N does not move the camera"
xdotool key ctrl+v; sleep 1.5; frames 3
pasted=$(stands_now)
[ "$pasted" = "$given" ] || fail "pasting the view leads to $pasted, expected $given"
quit

# Where nothing can be written, that is said, and the window stays.
start /proc "$dir/one.vantage"
xdotool key p; frames 3
alive "a screenshot that cannot be written"
xdotool key r; frames 3; xdotool key r
alive "a path that cannot be written"
quit

# At rest nothing is drawn: less than 1 % of a processor, also where tiles do not all fit into the memory.
wakes() {  # the window at rest takes a screenshot when asked to
  rm -f ./*-0001.png
  xdotool windowfocus "$(xdotool search --name Vantage | tail -1)"
  sleep 0.3
  xdotool key p
  for _ in $(seq 50); do [ -e ./*-0001.png ] && break; sleep 0.1; done
  [ -e ./*-0001.png ] || fail "P does nothing at rest"
  kill $pid
  wait $pid 2>/dev/null
}
rests() {
  "$player" "$@" --fresh >says 2>&1 &
  pid=$!
  sleep 1
  local before after seconds=5
  for _ in $(seq 60); do
    kill -0 $pid 2>/dev/null || { fail "$* ended: $(cat says)"; return; }
    before=$(ticks)
    sleep $seconds
    after=$(ticks)
    [ $((after - before)) -le $seconds ] && { wakes; return; }
  done
  kill -9 $pid
  fail "$* never rests: $((after - before)) ticks in $seconds s"
}
rests one.vantage --size 600x420
rests one.vantage --size 900x700 --graphics-memory 110
if [ -n "${VANTAGE_DATASETS:-}" ] && [ -d "$VANTAGE_DATASETS/sceaux-small" ]; then
  "$vantage" prepare "$VANTAGE_DATASETS/sceaux-small" -o sceaux.vantage --no-report >/dev/null 2>&1 || fail "prepare"
  rests sceaux.vantage --size 600x420
fi

[ $failed = 0 ] && echo "events are handled"
exit $failed
