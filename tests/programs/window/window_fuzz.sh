#!/usr/bin/env bash
# Sends random events to the window in all its states. The events are keys, clicks, drags, wheel turns, touches, dropped files,
# and changes of size and focus. The window must not exit, hang or report an OpenGL error, and must come to rest afterward.
# Usage: window_fuzz.sh VANTAGE PLAYER SOURCE_DIR [EVENTS [SEED]]; exits with 77 if no X server is available
set -uo pipefail
source "$(dirname "$0")/window.sh"
has_touch_screen && under_touch_screen 1280x1024 "$@" || under_xvfb 1280x1024 "$@"  # without fingers

vantage=$1 player=$2 source=$3 events=${4:-300} seed=${5:-1}
export VANTAGE_DEBUG_GL=1
"$vantage" synth "$source/data/tiny.toml" -o scene >/dev/null && "$vantage" prepare scene -o one.vantage >/dev/null 2>&1 || exit 1

printf 'no package' >junk.vantage
head -c 5000 one.vantage >cut.vantage
printf '[[object]]\npackage = "one.vantage"\n' >scene.toml
dropped=(one.vantage junk.vantage cut.vantage scene.toml missing.vantage scene)

# random_events N SEED: prints commands for xdotool. Ctrl+Q and O are skipped: one closes the window, the other opens a dialog.
random_events() {
  awk -v n="$1" -v seed="$2" -v window="$window" 'BEGIN {
    srand(seed)
    keys = split("a b c d e h m n p q r s t v w x 1 2 3 Tab Tab Escape Escape BackSpace Return F1 F2 F3 F4 F5 F6 F7 F8 F9 F10 F12 " \
                 "ctrl+plus ctrl+minus ctrl+c alt+x shift+w Left Up space Delete", key, " ")
    for (i = 0; i < n; ++i) {
      x = int(rand() * 900); y = int(rand() * 700); kind = rand()
      if (kind < 0.4) print "key --delay " int(rand() * 30) " " key[1 + int(rand() * keys)]
      else if (kind < 0.6) print "mousemove " x " " y "\nclick " 1 + int(rand() * 3)
      else if (kind < 0.75) print "mousemove " x " " y "\nmousedown 1\nmousemove " int(rand() * 900) " " int(rand() * 700) "\nmouseup 1"
      else if (kind < 0.9) print "mousemove " x " " y "\nclick " 4 + int(rand() * 4)
      else if (kind < 0.93) print "windowsize " window " " 200 + int(rand() * 1000) " " 150 + int(rand() * 800)
      else if (kind < 0.95) print "windowfocus " window
      else print "sleep " rand() * 0.05
    }
  }'
}

"$player" one.vantage --no-saved-settings --size 900x700 >says 2>&1 &
pid=$!
soon grep -q "first picture" says
focus
for ((done = 0; done < events; done += 100)); do
  random_events 100 $((seed * 1000 + done)) >commands
  [ -z "${TOUCH_PID:-}" ] || echo "random $((seed * 1000 + done)) 60" >&"${TOUCH[1]}"
  timeout 120 xdotool commands >/dev/null 2>&1 || fail "events $done to $((done + 100)) of seed $seed were not taken"
  [ -z "${TOUCH_PID:-}" ] || { read -r -t 60 answer <&"${TOUCH[0]}" && [ "$answer" = done ]; } || fail "no fingers after event $done of seed $seed"
  /usr/bin/python3 "$source_of_tests/drop_files.py" "$window" "${dropped[$(((seed + done / 100) % ${#dropped[@]}))]}" ||
    fail "no files are accepted after event $done of seed $seed"
  kill -0 $pid 2>/dev/null || { fail "the player ended after event $done of seed $seed: $(tail -3 says)"; exit 1; }
done

# The window must still respond and come to rest.
xdotool windowsize "$window" 500 400 windowfocus "$window"
for k in Escape Escape Escape; do xdotool key --delay 60 $k; done
before=$(ls one-*.png 2>/dev/null | wc -l)
xdotool key --delay 60 p
one_more() { [ "$(ls one-*.png 2>/dev/null | wc -l)" = $((before + 1)) ]; }
within 10 one_more || fail "a tap of P after $events events was lost"
rests || fail "the window does not come to rest after $events events"
xdotool key --delay 60 ctrl+q
await_exit "Ctrl+Q"
[ $failed = 0 ] && echo "$events events were survived"
exit $failed
