# Functions for tests of the window with real mouse and key events through the X server; this file must be sourced. Needs
# xvfb-run, xdotool and inotifywait. A change is noticed when the player moves a file to the folder, as it does with the file
# `places` in every frame.

# Runs the calling script again under Xvfb, with a screen of this size, in an empty folder $dir. If it already runs under Xvfb,
# only enters $dir.
# under_xvfb WIDTHxHEIGHT "$@"
under_xvfb() {
  local screen=$1
  shift
  if [ -z "${VANTAGE_WINDOW_TEST:-}" ]; then
    for tool in xvfb-run xdotool inotifywait; do
      command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
    done
    export VANTAGE_WINDOW_TEST=$(mktemp -d)
    trap 'rm -rf "$VANTAGE_WINDOW_TEST"' EXIT
    # The display number is derived from the process ID. With -a alone, tests that start at the same time may get the same display.
    xvfb-run -n $((1000 + $$ % 30000)) -a -s "-screen 0 ${screen}x24" "$0" "$@"
    exit $?
  fi
  enter_folder
}

# Does the same under Xorg with a touch screen, for finger(). Also needs the Xorg drivers "dummy" and "inputtest".
# under_touch_screen WIDTHxHEIGHT "$@"
under_touch_screen() {
  screen=$1
  shift
  if [ -z "${VANTAGE_WINDOW_TEST:-}" ]; then
    has_touch_screen || { echo "skipped: Xorg with the drivers dummy and inputtest is not installed"; exit 77; }
    export VANTAGE_WINDOW_TEST=$(mktemp -d)
    start_xorg "$VANTAGE_WINDOW_TEST" "$screen" || { echo "skipped: Xorg does not start"; rm -rf "$VANTAGE_WINDOW_TEST"; exit 77; }
    trap 'kill $xorg; rm -rf "$VANTAGE_WINDOW_TEST"' EXIT
    "$0" "$@"
    exit $?
  fi
  enter_folder
  [ -S touch ] && coproc TOUCH { exec python3 "$source_of_tests/touch_device.py" touch "$screen" 2>&1; }
}
enter_folder() {
  dir=$VANTAGE_WINDOW_TEST
  cd "$dir" || exit 1
  export XDG_CONFIG_HOME=$dir/config LC_ALL=C.UTF-8
  exec {changes}< <(exec inotifywait -m -q -e moved_to --format . . 2>/dev/null)
  watcher=$!
  trap 'kill $watcher' EXIT
}
source_of_tests=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
has_touch_screen() {
  local modules=/usr/lib/xorg/modules
  [ -x /usr/lib/xorg/Xorg ] && [ -f $modules/input/inputtest_drv.so ] && [ -f $modules/drivers/dummy_drv.so ] &&
    command -v xdotool >/dev/null && command -v inotifywait >/dev/null
}
# start_xorg FOLDER WIDTHxHEIGHT: starts Xorg; sets DISPLAY, and xorg to its process ID
start_xorg() {
  local folder=$1 wide=${2%x*} high=${2#*x}
  cat >"$folder/xorg.conf" <<END
Section "ServerFlags"
  Option "AutoAddDevices" "false"
  Option "AutoEnableDevices" "false"
EndSection
Section "Device"
  Identifier "card"
  Driver "dummy"
  VideoRam 256000
EndSection
Section "Monitor"
  Identifier "monitor"
  HorizSync 1-1000
  VertRefresh 1-1000
  Modeline "$2" 108 $wide $((wide + 48)) $((wide + 160)) $((wide + 408)) $high $((high + 1)) $((high + 4)) $((high + 42))
EndSection
Section "Screen"
  Identifier "screen"
  Device "card"
  Monitor "monitor"
  DefaultDepth 24
  SubSection "Display"
    Depth 24
    Modes "$2"
    Virtual $wide $high
  EndSubSection
EndSection
Section "InputDevice"
  Identifier "touch"
  Driver "inputtest"
  Option "SocketPath" "$folder/touch"
  Option "DeviceType" "Touch"
  Option "TouchCount" "10"
EndSection
Section "ServerLayout"
  Identifier "layout"
  Screen "screen"
  InputDevice "touch" "SendCoreEvents"
EndSection
END
  exec {started}< <(exec /usr/lib/xorg/Xorg -displayfd 1 -config "$folder/xorg.conf" -logfile "$folder/xorg.log" -noreset \
    -nolisten tcp -novtswitch -sharevts 2>/dev/null)
  xorg=$!
  local number
  read -r -t 10 -u "$started" number && [ -S "$folder/touch" ] && export DISPLAY=:$number && return
  kill $xorg 2>/dev/null
  return 1
}
# finger GESTURE...: performs a gesture with touch_device.py and waits until it is done
finger() {
  local answer
  echo "$*" >&"${TOUCH[1]}"
  read -r -t 60 answer <&"${TOUCH[0]}" && [ "$answer" = done ] || { fail "no finger: ${answer:-}"; exit 1; }
}
# screenshot FILE.ppm [LEFT TOP WIDTH HEIGHT]: uses the libraries of the system's Python
screenshot() { /usr/bin/python3 "$source_of_tests/screenshot.py" "$@" || exit 1; }

# alike FILE.ppm FILE.ppm: equal, except that a busy processor may draw fewer samples per pixel
alike() {
  /usr/bin/python3 -c '
import sys
a, b = (open(name, "rb").read() for name in sys.argv[1:])
sys.exit(len(a) != len(b) or sum(abs(x - y) for x, y in zip(a, b)) > 2 * len(a))' "$1" "$2"
}

# Waits for up to a second until a file is moved to the folder. Conditions passed to within() must not call this function.
changed() {
  read -r -t 1 -u "$changes" _ || return 0
  while read -r -t 0 -u "$changes"; do read -r -u "$changes" _; done
}
# within SECONDS COMMAND...: repeats a command after each change until it succeeds
within() {
  local end=$((SECONDS + $1))
  shift
  until "$@"; do
    [ $SECONDS -lt $end ] || return 1
    changed
  done
}
soon() { within 6 "$@"; }

failed=0
fail() { echo "FAILED: $*"; failed=1; }

# place NAME [FRACTION]: waits for a control and prints the position of its center, or of the point at this fraction of its width
place() { within 15 is_at "$@" && echo "$center"; }
is_at() {  # sets center
  center=$(awk -F'\t' -v n="$1" -v share="${2:-0.5}" '$1 == n { print int($2 + $4 * share), int($3 + $5 / 2); exit }' places 2>/dev/null)
  [ -n "$center" ]
}
frame() { awk -F'\t' '$1 == "frame" { print $2; exit }' places 2>/dev/null; }
ticks() { awk '{ print $14 + $15 }' "/proc/$pid/stat"; }  # processor time of the player, in hundredths of a second
frames() {  # frames N: waits until N more frames are drawn
  local to=$(($(frame) + $1))
  within 60 has_drawn "$to" || fail "no frames were drawn"  # a minute: the processor may be busy with other tests
}
has_drawn() {
  local now
  now=$(frame)
  [ "${now:-0}" -ge "$1" ] && return
  [ -z "${pid:-}" ] || kill -0 "$pid" 2>/dev/null || { fail "the player has ended: $(cat says)"; exit 1; }
  return 1
}
press() {  # press NAME [share of its width]: clicks a control
  local at
  at=$(place "$1" "${2:-0.5}") || { fail "there is no '$1'"; return; }
  # shellcheck disable=SC2086
  xdotool mousemove $at
  frames 1
  xdotool mousedown 1
  frames 2
  xdotool mouseup 1
  frames 3
}

# From far away, the model is small, and software rendering is fast.
step_back() {
  xdotool mousemove 500 400
  xdotool click --repeat 40 --delay 10 5
  frames 5
}
key() { xdotool keydown "$1"; frames 2; xdotool keyup "$1"; frames 2; }

# Waits for the window of the player that was started with --controls places, and gives it keyboard focus.
find_window() {
  within 60 is_at "Photo 1" || { cat says; fail "no window"; exit 1; }
  focus
}
focus() {  # gives the window the keyboard, and waits until it has it
  window=$(xdotool search --name Vantage | tail -1)
  timeout 20 xdotool windowfocus --sync "$window" || fail "the window does not get the keyboard"
}
start() {  # start ARGUMENTS...: the window, with a file of its controls
  rm -f places
  "$player" "$@" --controls places >says 2>&1 &
  pid=$!
  find_window
}
start_page() {  # start_page [NAME=VALUE...]: the window without a package
  rm -f places
  env "$@" "$player" --size 900x700 --controls places >says 2>&1 &
  pid=$!
  within 20 is_at "Open a package..."
  focus
}
title() { xdotool getwindowname "$window"; }
is_titled() { [ "$(title)" = "$1 - Vantage" ]; }
opens() { soon is_titled "$1" || soon is_titled "$1" || fail "expected $1, the window shows $(title)"; }
quit() { xdotool key ctrl+q; await_exit "Ctrl+Q"; }
there() { frames 3; place "$1" >/dev/null; }  # waits for it; see gone
gone() { frames 3; awk -F'\t' -v n="$1" '$1 == n { found = 1 } END { exit found }' places; }
# Whether nothing is drawn at rest: less than 1 % of one processor core.
rests() {
  local before seconds=2
  for _ in $(seq 60); do
    before=$(ticks)
    sleep $seconds
    kill -0 $pid 2>/dev/null || { fail "the player ended: $(cat says)"; return; }
    [ $(($(ticks) - before)) -gt $seconds ] || return 0
  done
  return 1
}
await_exit() {  # await_exit WHAT [CODE]: expects the player to exit with this code or 0; WHAT: the input that ends it
  local code
  timeout 10 tail --pid=$pid -s 0.05 -f /dev/null || { kill -9 $pid; fail "$1 did not quit"; return; }
  wait $pid
  code=$?
  [ $code = "${2:-0}" ] || fail "the player ended with $code, expected ${2:-0}: $(cat says)"
}
remembers() { grep -q "\"$1\": $2" config/vantage/player.json || fail "$1 is not remembered as $2"; }
