#!/usr/bin/env bash
# Tests how the window begins, on a small screen: the first picture of a kiosk, files that a file manager opens, recent files.
# Usage: window_start_test.sh VANTAGE PLAYER SOURCE_DIR; exits with 77 if no X server is available
set -uo pipefail
source "$(dirname "$0")/window.sh"
under_xvfb 1024x600 "$@"

vantage=$1 player=$2 source=$3
export XDG_STATE_HOME=$dir/state
"$vantage" synth "$source/data/tiny.toml" -o scene >/dev/null && "$vantage" prepare scene -o one.vantage --no-report >/dev/null 2>&1 || exit 1
head -c 3000 one.vantage >cut.vantage

# The first picture of a kiosk fills the screen. The kiosk waits after it because the pipe for its messages is full.
: >says
mkfifo messages
exec {messages}<>messages
head -c 65536 /dev/zero >&"$messages"
"$player" kiosk one.vantage --no-saved-settings --controls places 2>messages &
pid=$!
within 20 is_at "Bar Home" || fail "the kiosk does not start"
bar() { screenshot "$1" 0 560 1024 40; }
bar first.ppm
[ "$(frame)" = 1 ] || fail "the kiosk does not wait after the first frame"
head -c 65536 <&"$messages" >/dev/null
frames 6
bar later.ppm
alike first.ppm later.ppm || fail "the first picture of the kiosk lacks the bar"
kill $pid
await_exit SIGTERM

# A file manager opens a file without a terminal. If the file is missing or damaged, the window says so on one line.
open_file() {
  rm -f places
  local call
  call=$(sed -n 's/^Exec=//p' "$source/configs/desktop/vantage-player.desktop")
  call=${call/#vantage-player/"'$player'"}
  eval "${call//%f/"'$1'"} --controls places" </dev/null >/dev/null 2>&1 &
  pid=$!
}
for file in none.vantage cut.vantage; do
  open_file "$file"
  place Message >/dev/null || fail "$file, opened by a file manager, shows no message"
  awk -F'\t' '$1 == "Message" { exit $5 > 25 }' places || fail "the message about $file has several lines"
  place "Open a package..." >/dev/null || fail "the message about $file is not on the start page"
  focus
  quit
done

# A file that was opened is kept, with its picture, even if the player is killed.
open_file one.vantage
find_window
kill -KILL $pid
wait $pid 2>/dev/null
start_page
at=$(place "Picture of $dir/one.vantage") || fail "the start page has no picture of the recent package"
# shellcheck disable=SC2086
screenshot recent.ppm $((${at% *} - 30)) $((${at#* } - 30)) 60 60
/usr/bin/python3 -c '
import sys
pixels = open("recent.ppm", "rb").read()[13:]
sys.exit(len({pixels[i:i + 3] for i in range(0, len(pixels), 3)}) < 50)' || fail "the picture of the recent package is empty"
press "$dir/one.vantage"
opens one.vantage
quit

[ $failed = 0 ] && echo "the window starts"
exit $failed
