# Functions for tests of the window, to be sourced: real mouse and key events through the X server. Needs xvfb-run and xdotool.

# Runs the calling script again under Xvfb, with a screen of this size, in an empty folder $dir; once there, goes on.
# under_xvfb WIDTHxHEIGHT "$@"
under_xvfb() {
  local screen=$1
  shift
  if [ -z "${VANTAGE_WINDOW_TEST:-}" ]; then
    for tool in xvfb-run xdotool; do
      command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
    done
    export VANTAGE_WINDOW_TEST=$(mktemp -d)
    trap 'rm -rf "$VANTAGE_WINDOW_TEST"' EXIT
    xvfb-run -a -s "-screen 0 ${screen}x24" "$0" "$@"
    exit $?
  fi
  dir=$VANTAGE_WINDOW_TEST
  cd "$dir" || exit 1
  export XDG_CONFIG_HOME=$dir/config LC_ALL=C.UTF-8
}

# The same under Xorg with a touch screen, for finger(). Needs its drivers "dummy" and "inputtest", besides xdotool.
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
  dir=$VANTAGE_WINDOW_TEST
  cd "$dir" || exit 1
  export XDG_CONFIG_HOME=$dir/config LC_ALL=C.UTF-8
  [ -S touch ] && coproc TOUCH { exec python3 "$source_of_tests/touch_device.py" touch "$screen" 2>&1; }
}
source_of_tests=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
has_touch_screen() {
  local modules=/usr/lib/xorg/modules
  [ -x /usr/lib/xorg/Xorg ] && [ -f $modules/input/inputtest_drv.so ] && [ -f $modules/drivers/dummy_drv.so ] &&
    command -v xdotool >/dev/null
}
# start_xorg FOLDER WIDTHxHEIGHT: sets DISPLAY and xorg, its process
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
  /usr/lib/xorg/Xorg -displayfd 3 -config "$folder/xorg.conf" -logfile "$folder/xorg.log" -noreset -nolisten tcp -novtswitch \
    -sharevts 3>"$folder/display" >/dev/null 2>&1 &
  xorg=$!
  for _ in $(seq 100); do
    [ -s "$folder/display" ] && [ -S "$folder/touch" ] && export DISPLAY=:$(cat "$folder/display") && return
    kill -0 $xorg 2>/dev/null || return 1
    sleep 0.1
  done
  kill $xorg
  return 1
}
# finger GESTURE...: of touch_device.py; waits until it is made
finger() {
  local answer
  echo "$*" >&"${TOUCH[1]}"
  read -r -t 60 answer <&"${TOUCH[0]}" && [ "$answer" = done ] || { fail "no finger: ${answer:-}"; exit 1; }
}
# screenshot FILE.ppm [LEFT TOP WIDTH HEIGHT]: with the libraries of the system's Python
screenshot() { /usr/bin/python3 "$source_of_tests/screenshot.py" "$@" || exit 1; }

# soon COMMAND...: runs it until it succeeds, for up to five seconds
soon() {
  for _ in $(seq 50); do
    "$@" && return
    sleep 0.1
  done
  return 1
}

failed=0
fail() { echo "FAILED: $*"; failed=1; }

# place NAME [share of its width]: waits for a control and prints the position of its center
place() {
  for _ in $(seq 150); do
    if [ -f places ]; then
      awk -F'\t' -v n="$1" '$1 == n && !done { print int($2 + $4 * '"${2:-0.5}"'), int($3 + $5 / 2); done = 1 }' places >at
      [ -s at ] && { cat at; return 0; }
    fi
    sleep 0.1
  done
  return 1
}
frame() { awk -F'\t' '$1 == "frame" { print $2; exit }' places 2>/dev/null; }
ticks() { awk '{ print $14 + $15 }' "/proc/$pid/stat"; }  # processor time of the player, in hundredths of a second
frames() {  # frames N: waits until N more frames are drawn
  local from now
  from=$(frame)
  for _ in $(seq 3000); do  # a minute: the processor may be busy with other tests
    now=$(frame)
    [ $((${now:-0} - ${from:-0})) -ge "$1" ] && return
    [ -z "${pid:-}" ] || kill -0 "$pid" 2>/dev/null || { fail "the player has ended: $(cat says)"; exit 1; }
    sleep 0.02
  done
  fail "no frames were drawn"
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

# From far away the model is small, which is fast in software.
step_back() {
  xdotool mousemove 500 400
  xdotool click --repeat 40 --delay 10 5
  frames 5
}
key() { xdotool keydown "$1"; frames 2; xdotool keyup "$1"; frames 2; }

# Waits for the window of the player that was started with --controls places, and gives it the keyboard.
find_window() {
  for _ in $(seq 600); do grep -qs "^Photo 1	" places && break; sleep 0.1; done
  place "Photo 1" >/dev/null || { cat says; fail "no window"; exit 1; }
  focus
}
focus() {  # gives the window the keyboard, and waits until it has it
  window=$(xdotool search --name Vantage | tail -1)
  xdotool windowfocus --sync "$window"
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
  for _ in $(seq 200); do grep -qs "^Open a package" places && break; sleep 0.1; done
  focus
}
title() { xdotool getwindowname "$window"; }
is_titled() { [ "$(title)" = "$1 - Vantage" ]; }
opens() { soon is_titled "$1" || soon is_titled "$1" || fail "expected $1, the window shows $(title)"; }
quit() { xdotool key ctrl+q; await_exit "Ctrl+Q"; }
there() { frames 3; place "$1" >/dev/null; }  # waits for it; see gone
gone() { frames 3; awk -F'\t' -v n="$1" '$1 == n { found = 1 } END { exit found }' places; }
# Whether nothing is drawn at rest: less than 1 % of a processor.
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
await_exit() {  # await_exit WHAT [CODE]: expects the player to exit with this code or 0; WHAT: what it was told by
  for _ in $(seq 100); do kill -0 $pid 2>/dev/null || break; sleep 0.1; done
  kill -9 $pid 2>/dev/null && fail "$1 did not quit"
  wait $pid
  local code=$?
  [ $code = "${2:-0}" ] || fail "the player ended with $code, expected ${2:-0}: $(cat says)"
}
remembers() { grep -q "\"$1\": $2" config/vantage/player.json || fail "$1 is not remembered as $2"; }
