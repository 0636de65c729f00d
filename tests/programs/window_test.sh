#!/usr/bin/env bash
# Uses every control of the window once, with real mouse and key events through the X server, then checks what the player
# did and remembered.
# usage: window_test.sh VANTAGE PLAYER SOURCE_DIR; exits with 77 if no X server is available
set -uo pipefail
source "$(dirname "$0")/window.sh"
under_xvfb 1280x1024 "$@"

vantage=$1 player=$2 source=$3
"$vantage" synth "$source/data/tiny.toml" -o scene >/dev/null && "$vantage" prepare scene -o one.vantage --vertex-coordinates >/dev/null 2>&1 || exit 1
{ sed 's/^seed.*/&\nheight_layer = 1/' "$source/data/tiny.toml"; printf '\n[garden]\nradius = 30.0\nhill = 8.0\n[glass]\nalpha = 0.3\n'; } >garden.toml
"$vantage" synth garden.toml -o garden >/dev/null && cp garden/mesh.ply cloud.ply &&
  "$vantage" prepare garden -o two.vantage --effect surroundings=on --points cloud.ply >/dev/null 2>&1 || exit 1
"$vantage" synth "$source/data/bands.toml" -o bands >/dev/null && "$vantage" prepare bands -o three.vantage >/dev/null 2>&1 || exit 1
head -c 100000 one.vantage >cut.vantage
"$player" one.vantage --size 900x700 --blended 1 --controls places >says 2>&1 &
pid=$!
quit() {  # quits by the menu and expects exit code 0
  kill -0 $pid 2>/dev/null || { cat says; fail "the player has exited early"; }
  press "File"
  xdotool mousemove $(place "Quit")
  frames 2
  xdotool click 1
  await_exit "the menu"
}

find_window
xdotool mousemove 600 20

step_back
press "Bar Expert"
press "Section Picture"
press "Average"
press "Best photo"
press "Lumigraph"
press "Sharpness" 0.6
press "Prefer near" 0.3  # is grayed
press "Average"
press "Prefer near" 0.5
for box in "Consensus" "Fill holes" "Near photos" "Similar rays" "Facing photos" "Occlusion" "Soft borders" "Passers-by" "One ray per photo" \
  "Field of view" "Aim at what is seen" "Freeze weights"; do press "$box"; done
press "Freeze weights"
press "Lumigraph"
press "Choose to"; press "nearest"
press "Per pass" 0.2
press "Angle limit" 0.4
press "Coordinates"; press "per vertex"
press "Photos" 0.5
press "Section Blending"; press "Section Picture"
press "Show"; press "which photo"
press "Show"; press "how many photos"
press "Show"; press "photos"
press "Photo 2"
sleep 1
press "Compare"; press "side by side"
press "Compare"; press "difference"
press "Compare"; press "wiper"
at=$(place "Wiper") || fail "the wiper has no handle"
xdotool mousemove $at; frames 2; xdotool mousedown 1; frames 2; xdotool mousemove_relative 60 0; frames 3; xdotool mouseup 1; frames 2
moved=$(place "Wiper")
[ "${moved%% *}" = $((${at%% *} + 60)) ] || fail "the wiper was dragged by 60 pixels from $at to $moved"
press "Compare"; press "nothing"
press "Two eyes"; press "side by side"
press "Two eyes"; press "above each other"
press "Two eyes"; press "checkerboard"
press "Two eyes"; press "red and cyan glasses"
press "Eyes apart" 0.7
press "Two eyes"; press "off"
step_back
press "View"; press "Cameras in the scene"
press "View"; press "Radar"
press "Radar map" 0.5
press "View"; press "Status"
press "View"; press "Blending"
press "View"; press "Photo strip"
press "View"; press "Larger text"
press "View"; press "Smaller text"
press "View"; press "Home"
sleep 1
step_back
press "Path"; press "Record"
xdotool mousemove 500 400 mousedown 1 mousemove_relative 60 20; frames 3; xdotool mouseup 1
xdotool mousemove 500 400 mousedown 3 mousemove_relative 30 0; frames 3; xdotool mouseup 3
xdotool mousemove 500 400 mousedown 2 mousemove_relative 30 0; frames 3; xdotool mouseup 2
xdotool click 4; frames 3
for k in w a s d q e; do key $k; done
press "Path"; press "Record"
press "Path"; press "Replay"
sleep 1
press "File"; press "Screenshot"
press "Help"; press "Mouse and keys"
key F1
for k in n b c c c c v v v 1 2 3 1 r r t p h BackSpace F2 F3 F4 F5 F6; do key $k; done
press "File"; press "Open..."; press "Cancel"
key o; press "cut.vantage"; press "Open"
sleep 1
[ "$(xdotool getwindowname "$window")" = "one.vantage - Vantage" ] || fail "a truncated package replaced the open one"
key o; press "two.vantage"; press "Open"
sleep 1
[ "$(xdotool getwindowname "$window")" = "two.vantage - Vantage" ] || fail "the other package was not opened"
step_back
press "Surroundings"; press "hidden"  # which is faster
press "Transparency"; press "approximate"
press "Light"; press "normals"
press "Light"; press "lamp at the viewer"
press "On the photos"
press "Light"; press "raking light"
xdotool mousemove 450 200; frames 3; xdotool mousemove 500 300; frames 3
press "Follows pointer"
press "Lamp azimuth" 0.2
press "Lamp height" 0.1
press "Light"; press "the photos' own"
press "Section Picture"
press "Layer"; press "height"
press "Colors"; press "magma"
press "Over photos" 0.5
press "Isolines" 0.3
press "Logarithmic"
press "Lowest" 0.2
press "Whole range"
key F7
press "Points"; press "alone"
press "Point size by"; press "pixels"
press "Point size" 0.4
press "Eye-dome shading" 0.2
press "Million points" 0.1
press "Points"; press "with the model"
key F8
press "Section Picture"
press "Surroundings"; press "dimmed"
key o; press "three.vantage"; press "Open"
sleep 1
[ "$(xdotool getwindowname "$window")" = "three.vantage - Vantage" ] || fail "the package with bands was not opened"
press "Band"; press "infrared: 4 photos"
press "Photo 1"
sleep 1
step_back
press "Second band"; press "visible"
press "Share of the second" 0.25
press "Together"; press "beside each other"
press "Together"; press "divided"
press "Divided at" 0.25
key x; key x
key F9
quit

[ "$(ls one-*.png 2>/dev/null | wc -l)" = 2 ] || fail "expected two screenshots: $(ls)"
[ "$(ls one-*.path 2>/dev/null | wc -l)" -ge 1 ] || fail "no path was recorded: $(ls)"
remembers blend 1
remembers choice 1
remembers surroundings 1
remembers transparency 1
remembers panel_layers false
remembers panel_points false
remembers panel_bands false
remembers band '"infrared"'
remembers other_band '"visible"'
remembers band_how 2
remembers band_share '0\.[2-6]'
remembers band_wiper '0\.[2-6]'
remembers consensus true
remembers fill_holes false
for weight in distance angle angle_mask depth_mask border_mask; do remembers $weight false; done
remembers corrected_directions true
remembers angle_per_photo true
remembers photos_per_pass [2-7]
remembers panel_blending false
remembers expert true
remembers panel_radar false
remembers width 900
# A scene of two objects.
rm -f places
printf '[[object]]\nname = "left"\npackage = "one.vantage"\n[[object]]\nname = "right"\npackage = "one.vantage"\nmove = [9, 0, 0]\n' >church.toml
"$player" church.toml --fresh --size 900x700 --blended 1 --controls places >says 2>&1 &
pid=$!
find_window
step_back
press "Bar Expert"
press "Section Picture"
press "View"; press "Objects"
press "Only right"
press "left"
press "Opacity of right" 0.4
press "Position of right"
press "Move x of right" 0.4
press "Turn z of right" 0.3
press "Scale of right" 0.3
press "Save scene"
press "Remove right"
key F10
[ "$(xdotool getwindowname "$window")" = "one.vantage - Vantage" ] || fail "the first object's package is not named"
quit
grep -q "name = 'right'" scene-0001.toml && grep -q "turn = " scene-0001.toml && grep -q "opacity = " scene-0001.toml && grep -q "package = 'one.vantage'" scene-0001.toml ||
  fail "the scene was not saved as it was: $(cat scene-0001.toml)"
[ $failed = 0 ] && echo "every control works"
exit $failed
