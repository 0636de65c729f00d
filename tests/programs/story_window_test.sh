#!/usr/bin/env bash
# A curator's work: an opening view, five notes with pictures, a tour, by mouse and keys alone; then what visitors see of it in the
# window, in a kiosk and in a video.
# usage: story_window_test.sh VANTAGE PLAYER SOURCE_DIR; exits with 77 if no X server is available
set -uo pipefail
source "$(dirname "$0")/window.sh"
under_xvfb 1280x1024 "$@"

vantage=$1 player=$2 source=$3
"$vantage" synth "$source/data/tiny.toml" -o scene >/dev/null && "$vantage" prepare scene -o one.vantage >/dev/null 2>&1 || exit 1
picture=$(find scene -name '*.jpg' | sort | head -1)
[ -n "$picture" ] || picture=$(find scene -name '*.png' | sort | head -1)
start() {
  rm -f places
  "$player" one.vantage --size 900x700 --controls places >says 2>&1 &
  pid=$!
  for _ in $(seq 10); do place "Photo 1" >/dev/null && break; done  # a busy machine takes its time
  find_window
}
quit() { xdotool key ctrl+q; await_exit "Ctrl+Q"; }
there() { frames 3; place "$1" >/dev/null; }
gone() { frames 3; awk -F'\t' -v n="$1" '$1 == n { found = 1 } END { exit found }' places; }
say_of() { python3 -c "import json; s = json.load(open('one.story.json')); print($1)"; }
stands_at() {  # where the camera stands, by a recording; stands_at NUMBER
  xdotool mousemove 450 300; xdotool key r; frames 3; xdotool key r; frames 3
  grep -v '^#' "one-000$1.path" | tail -1
}
near() {  # near "X Y Z ..." X Y Z: within 0.01
  echo "$1" | awk -v x="$2" -v y="$3" -v z="$4" '{ exit !(($1-x)^2 + ($2-y)^2 + ($3-z)^2 < 1e-4) }'
}

# A curator writes the first note and the opening view in the window.
start
for _ in $(seq 12); do xdotool mousemove 450 300 click 5; done  # from farther away, frames are fast in software
frames 5
xdotool key ctrl+e
there "Add a note here" || fail "Ctrl+E does not open the editor"
press "Set the opening view"
opening=$(stands_at 1)
press "Add a note here"
there "Title of the note" || fail "there are no fields for the new note"
press "Title of the note"
xdotool type --delay 40 "Clock tower"; frames 3
press "Text of the note"
xdotool type --delay 40 "Built in 1702"; frames 3
press "Picture file of the note"
xdotool type --delay 40 "$picture"; frames 3
press "Save the story"
[ -f one.story.json ] || { fail "nothing was saved: $(cat says)"; exit 1; }
[ "$(say_of "s['notes'][0]['title'] + '/' + s['notes'][0]['text']")" = "Clock tower/Built in 1702" ] ||
  fail "the note is $(cat one.story.json)"
"$vantage" check one.vantage >checked || fail "the story that was saved is not sound: $(cat checked)"
[ "$(say_of "len(s['notes'][0]['anchor'])")" = 3 ] || fail "the note has no anchor"
eye=$(say_of "'%s %s %s' % tuple(s['opening']['eye'])")
near "$opening" $eye || fail "the opening view was saved at $eye, the camera stands at $opening"

# More notes from elsewhere, and a tour of all.
add_note() {  # add_note TITLE: from farther to the left
  xdotool mousemove 450 300; frames 2; xdotool mousedown 3; frames 2; xdotool mousemove_relative 20 0; frames 3; xdotool mouseup 3; frames 3
  press "Add a note here"
  press "Title of the note"
  xdotool type --delay 40 "$1"; frames 3
  press "Picture file of the note"
  xdotool type --delay 40 "$picture"; frames 3
}
for title in Door Roof Gate Stairs; do add_note $title; done
press "Make a tour of all notes"
press "Save the story"
[ "$(say_of "' '.join(n['title'] for n in s['notes'])")" = "Clock tower Door Roof Gate Stairs" ] || fail "the notes are $(cat one.story.json)"
[ "$(say_of "[t['note'] for t in s['tours'][0]['stops']]")" = "['note-1', 'note-2', 'note-3', 'note-4', 'note-5']" ] || fail "the tour is $(cat one.story.json)"
press "Move up"
press "Save the story"
[ "$(say_of "' '.join(n['title'] for n in s['notes'])")" = "Clock tower Door Roof Stairs Gate" ] || fail "Move up leaves $(cat one.story.json)"
quit

# A visitor opens the package: at the opening view; a click on a note's disc flies to it and opens its card.
start
there "List 2" || fail "the notes are not listed"
near "$(stands_at 2)" $eye || fail "the window does not open at the opening view"
there "Note 2" || fail "the second note has no disc on the surface"
press "Note 2"
sleep 2; frames 5
there "Picture of the note" || fail "the card shows no picture"
second=$(say_of "'%s %s %s' % tuple(s['notes'][1]['view']['eye'])")
near "$(stands_at 3)" $second || fail "a click on a note flies to $(tail -1 one-0003.path), expected $second"
press "Next note"
sleep 2; frames 5
third=$(say_of "'%s %s %s' % tuple(s['notes'][2]['view']['eye'])")
near "$(stands_at 4)" $third || fail "the next note is looked at from $(tail -1 one-0004.path), expected $third"
xdotool key h; sleep 1.5; frames 5
near "$(stands_at 5)" $eye || fail "H flies to $(tail -1 one-0005.path), expected $eye"

# A tour plays, and Esc ends it.
press "Play All notes"
there "Stop All notes" || fail "the tour does not play"
sleep 4; frames 3
there "Picture of the note" || fail "the tour does not show the card where it stays"
xdotool mousemove 450 300; xdotool key Escape
there "Play All notes" || fail "Esc does not end the tour"
xdotool key j
gone "List 1" || fail "J does not hide the notes"
xdotool key j
there "List 1" || fail "J does not show the notes"

# What another program wrote meanwhile is not replaced.
cp one.story.json kept
sed 's/Door/Gate/' kept >one.story.json
xdotool key ctrl+e
press "List 1"
press "Set its view"
press "Save the story"
grep -q Gate one.story.json || fail "a story that was changed by another program was replaced"
quit

# A kiosk shows the notes, and lets nobody edit them.
cp one.story.json kept
rm -f places
"$player" one.vantage --kiosk --fresh --controls places >says 2>&1 &
pid=$!
find_window
there "Note 2" || fail "a kiosk shows no notes"
press "Note 2"
sleep 2; frames 5
there "Picture of the note" || fail "a kiosk opens no card"
xdotool key ctrl+e
there "Save the story" && fail "a kiosk lets the public edit the story"
kill $pid
wait $pid
cmp -s one.story.json kept || fail "a kiosk changed the story"

# A video of the tour begins at its first note, as a picture from that view shows it.
"$player" one.vantage --tour "All notes" --seconds 4 --frame-rate 1 --size 320x240 --holes transparent -o frames >says 2>&1 || fail "no video: $(cat says)"
view=$(say_of "','.join(str(x) for x in [*s['notes'][0]['view']['eye'], *s['notes'][0]['view']['target'], s['notes'][0]['view']['fov']])")
"$player" one.vantage --offscreen --view "$view" --size 320x240 --holes transparent -o picture.png >says 2>&1 || fail "no picture: $(cat says)"
off=$(idiff -a -fail 0.02 -failpercent 1 -warn 1 frames/one-0001.png picture.png 2>&1) || fail "the tour's first frame is not the first note's view: $off"
[ "$(ls frames | wc -l)" -ge 4 ] || fail "the video has $(ls frames | wc -l) frames"

[ $failed = 0 ] && echo "stories are told"
exit $failed
