#!/usr/bin/env bash
# Runs a session in a real window, with real mouse and key events through the X server, to test behavior that needs such a window.
# The effects of controls, keys and gestures are tested without a window (tests/window).
# Usage: window_session_test.sh VANTAGE PLAYER SOURCE_DIR; exits with 77 if no X server is available
set -uo pipefail
source "$(dirname "$0")/window.sh"
under_xvfb 3840x2160 "$@"

vantage=$1 player=$2 source=$3
"$vantage" synth "$source/data/tiny.toml" -o scene >/dev/null && "$vantage" prepare scene -o one.vantage --no-report >/dev/null 2>&1 || exit 1
cp one.vantage two.vantage
head -c 3000 one.vantage >cut.vantage
picture() { screenshot "$1" 400 100 400 300; }  # a part of the picture beside the sidebar, as on the screen
at_rest() { awk -F'\t' '$1 == "frame" { exit $3 != "rests" }' places; }
settled() {  # settled FILE.ppm: the picture, once it is final
  frames 3
  within 60 at_rest || fail "the picture $1 never settles"
  picture "$1"
}

# On the start page, a damaged package that is dropped is refused, and a valid one is shown.
start_page
/usr/bin/python3 "$source_of_tests/drop_files.py" "$window" cut.vantage || fail "the start page does not accept files"
frames 3
kill -0 $pid || fail "a truncated package ends the player: $(cat says)"
high=$(awk -F'\t' '$1 == "Open a package..." { print int($5) }' places)
[ "${high:-0}" -ge 25 ] || fail "on a screen of 2160 lines, buttons are ${high:-0} pixels high, expected 1.5 times 18"
/usr/bin/python3 "$source_of_tests/drop_files.py" "$window" one.vantage || fail "the start page does not accept files"
opens one.vantage
find_window
place "Photo 5" >/dev/null || fail "the strip does not show the photos"

# Dragging orbits the model: the picture changes, and it stays when the button is released.
key ctrl+minus; key ctrl+minus; key h  # as on a standard screen
settled before.ppm
xdotool mousemove 600 250; frames 2
xdotool mousedown 1; frames 2; xdotool mousemove_relative 80 30; frames 3; xdotool mouseup 1
settled after.ppm
alike before.ppm after.ppm && fail "dragging changes nothing"
key h
soon_settled() { settled home.ppm; alike home.ppm before.ppm; }
soon soon_settled || fail "H does not return to the first picture"

# A click that is shorter than a frame counts even if the pointer is elsewhere at the end of the frame. A setting changes the
# picture.
# shellcheck disable=SC2046
xdotool mousemove $(place "Bar Expert") mousedown 1 mouseup 1 mousemove 600 250
there "Section Picture" || fail "a click on Expert quicker than a frame is lost"
settled photos.ppm
press "Show"; press "which photo"
settled colors.ppm
alike photos.ppm colors.ppm && fail "false colors change nothing"
there "Legend" || fail "false colors have no legend"
key ctrl+z
gone "Legend" || fail "Ctrl+Z does not undo a setting"
key ctrl+shift+z
there "Legend" || fail "Ctrl+Shift+Z does not redo it"
key ctrl+z
xdotool mousemove 600 250  # away from tooltips
settled again-photos.ppm
alike photos.ppm again-photos.ppm || fail "the photos are not shown again as they were"

# Screenshots show only the model, and the picture does not show through the help.
key F4  # the strip would cover the help
settled strip.ppm
key p
soon test -s one-0001.png || fail "P writes no screenshot"
there "Copy path" || fail "no message leads to the screenshot"
key Escape
gone Message || fail "Esc does not close the message"
xdotool mousemove 600 250
help() {  # help FILE.ppm: its pixels, without its rounded corners, and no message over it
  for _ in 1 2 3; do soon gone Message && break; done
  # shellcheck disable=SC2046
  screenshot "$1" $(awk -F'\t' '$1 == "Mouse, fingers and keys" { print int($2) + 8, int($3) + 8, int($4) - 16, int($5) - 16 }' places)
}
key F1
help help.ppm
key p
soon test -s one-0002.png || fail "P writes no second screenshot"
cmp -s one-0001.png one-0002.png || fail "a screenshot shows the help"
key n; frames 6
help help-after.ppm
alike help.ppm help-after.ppm || fail "the picture shines through the help"
key F1
key F4

# The interface follows the window's size and can cover the screen.
timeout 20 xdotool windowsize --sync "$window" 1200 800
frames 3
at=$(place "Bar Expert")
[ "${at%% *}" -gt 1050 ] && [ "${at##* }" -gt 740 ] || fail "at 1200x800, Expert is at $at"
key F11
soon_wide() { at=$(place "Bar Expert"); [ "${at%% *}" -gt 3000 ]; }
soon soon_wide || fail "F11 does not fill the screen: Expert is at $at"
key F11
soon_small() { at=$(place "Bar Expert"); [ "${at%% *}" -lt 1200 ]; }
soon soon_small || fail "F11 does not leave full screen: Expert is at $at"

# A package is dropped on the window and added to the scene; others are opened through the dialog. A truncated package does not
# replace the open one.
/usr/bin/python3 "$source_of_tests/drop_files.py" "$window" two.vantage || fail "the window does not accept files"
there "Add to the scene" || fail "no question about a dropped package"
press "Add to the scene"
place "Only two" >/dev/null || { fail "the dropped package was not added"; cut -f 1 places | tr '\n' ' '; }
key o; press "cut.vantage"; press "Open"
place "Message" >/dev/null || fail "no error about a truncated package"
[ "$(title)" = "one.vantage - Vantage" ] || fail "a truncated package replaced the open one: $(title)"
key o; press "two.vantage"; press "Open"
opens two.vantage
press "Bar Help"
quit
remembers expert true
remembers more_objects true
remembers width 1200
grep -q "$dir/one.vantage" config/vantage/player.json || fail "the package is not among the recent ones"

# The package can be opened again by its name on the start page.
start_page
press "$dir/one.vantage"
opens one.vantage
quit

# Damage is reported and sets the exit code.
/usr/bin/python3 - <<'END'
data = bytearray(open("two.vantage", "rb").read())
starts = [-1]
while (at := data.find(b"\xff\xd8\xff", starts[-1] + 1)) >= 0:
    starts.append(at)
for at in starts[-10:]:  # color tiles, after the thumbnails of five photos
    data[at + 2000 : at + 2002] = bytes(2)
open("two.vantage", "wb").write(data)
END
start two.vantage --no-saved-settings --size 900x700
place "Message" >/dev/null || fail "damage is not reported: $(cat says)"  # it disappears after some seconds
xdotool key ctrl+q
await_exit "Ctrl+Q" 4

[ $failed = 0 ] && echo "the session passed"
exit $failed
