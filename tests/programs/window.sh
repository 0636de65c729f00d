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
  export XDG_CONFIG_HOME=$dir/config
}

failed=0
fail() { echo "FAILED: $*"; failed=1; }

# place NAME [share of its width]: waits for a control and prints the position of its center
place() {
  for _ in $(seq 40); do
    if [ -f places ]; then
      awk -F'\t' -v n="$1" '$1 == n && !done { print int($2 + $4 * '"${2:-0.5}"'), int($3 + $5 / 2); done = 1 }' places >at
      [ -s at ] && { cat at; return 0; }
    fi
    sleep 0.1
  done
  return 1
}
frame() { awk -F'\t' '$1 == "frame" { print $2; exit }' places 2>/dev/null; }
frames() {  # frames N: waits until N more frames are drawn
  local from now
  from=$(frame)
  for _ in $(seq 3000); do  # a minute: the processor may be busy with other tests
    now=$(frame)
    [ $((${now:-0} - ${from:-0})) -ge "$1" ] && return
    sleep 0.02
  done
  fail "no frames were drawn"
}
press() {  # press NAME [share of its width]: clicks a control
  local at
  at=$(place "$1" "${2:-0.5}") || { fail "there is no '$1'"; return; }
  # shellcheck disable=SC2086
  xdotool mousemove $at
  frames 2
  xdotool mousedown 1
  frames 2
  xdotool mouseup 1
  frames 3
}

# From far away the model is small, which is fast in software.
step_back() {
  xdotool mousemove 500 400
  for _ in $(seq 40); do xdotool click 5; done
  frames 5
}
key() { xdotool keydown "$1"; frames 2; xdotool keyup "$1"; frames 2; }

# Waits for the window of the player that was started with --controls places, and gives it the keyboard.
find_window() {
  for _ in $(seq 600); do grep -qs "^Photo 1	" places && break; sleep 0.1; done
  place "Photo 1" >/dev/null || { cat says; fail "no window"; exit 1; }
  window=$(xdotool search --name Vantage | tail -1)
  xdotool windowfocus "$window"
  sleep 0.3
}
await_exit() {  # expects the player to exit with code 0; await_exit WHAT: what it was told by
  for _ in $(seq 100); do kill -0 $pid 2>/dev/null || break; sleep 0.1; done
  kill -9 $pid 2>/dev/null && fail "$1 did not quit"
  wait $pid
  [ $? = 0 ] || fail "the player failed: $(cat says)"
}
remembers() { grep -q "\"$1\": $2" config/vantage/player.json || fail "$1 is not remembered as $2"; }
