#!/usr/bin/env bash
# Tests that a kiosk in a separate process shows a story, and that a video of a tour begins at its first note.
# Usage: story_window_test.sh VANTAGE PLAYER SOURCE_DIR; exits with 77 if no X server is available
set -uo pipefail
source "$(dirname "$0")/window.sh"
under_xvfb 1280x1024 "$@"

vantage=$1 player=$2 source=$3
"$vantage" synth "$source/data/tiny.toml" -o scene >/dev/null && "$vantage" prepare scene -o one.vantage >/dev/null 2>&1 || exit 1
cat >one.story.json <<'END'
{"format": "vantage-story-1",
 "notes": [{"id": "a", "title": "Tower", "anchor": [0, 0, 3], "view": {"eye": [1, -9, 3], "target": [1, 0, 3], "fov": 40}},
           {"id": "b", "title": "Door", "anchor": [2, 0, 2], "view": {"eye": [4, -7, 2], "target": [2, 0, 2], "fov": 40}}],
 "tours": [{"id": "all", "title": "All notes", "stops": [{"note": "a"}, {"note": "b"}]}]}
END
"$vantage" check one.vantage >checked || fail "the story is not valid: $(cat checked)"
cp one.story.json kept
start kiosk one.vantage --no-saved-settings
there "Note 2" || fail "a kiosk shows no notes"
press "Note 2"
there "Next note" || fail "a kiosk opens no card"
xdotool key ctrl+e
gone "Save the story" || fail "a kiosk lets the public edit the story"
kill $pid
wait $pid
cmp -s one.story.json kept || fail "a kiosk changed the story"

"$player" video one.vantage --tour "All notes" --seconds 4 --frame-rate 1 --size 320x240 --holes transparent -o frames >says 2>&1 || fail "no video: $(cat says)"
"$player" render one.vantage --view 1,-9,3,1,0,3,40 --size 320x240 --holes transparent -o picture.png >says 2>&1 || fail "no picture: $(cat says)"
off=$(idiff -a -fail 0.02 -failpercent 1 -warn 1 frames/one-0001.png picture.png 2>&1) || fail "the tour's first frame is not the first note's view: $off"
[ "$(ls frames | wc -l)" -ge 4 ] || fail "the video has $(ls frames | wc -l) frames"

[ $failed = 0 ] && echo "stories are told"
exit $failed
