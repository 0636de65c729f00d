#!/usr/bin/env bash
# The window at small, large and portrait sizes, for visitors and for experts: no control is cut off, and none covers another.
# usage: window_sizes_test.sh VANTAGE PLAYER SOURCE_DIR [FOLDER for screenshots]; exits with 77 if no X server is available
set -uo pipefail
source "$(dirname "$0")/window.sh"
under_xvfb 3840x2160 "$@"

vantage=$1 player=$2 source=$3 pictures=${4:-}
"$vantage" synth "$source/data/tiny.toml" -o scene >/dev/null && "$vantage" prepare scene -o one.vantage --no-report >/dev/null 2>&1 || exit 1

# misplaced WIDTH HEIGHT: controls of the bar and the strip's first photos that leave the window or overlap; those of the
# sidebar that are wider than its headers. Below its edge the sidebar scrolls.
misplaced() {
  awk -F'\t' -v w="$1" -v h="$2" '
    function check(name, x, y, wide, high) {
      if (x < -1 || y < -1 || x + wide > w + 1 || y + high > h + 1) print name " is cut off"
      for (i = 0; i < n; ++i)
        if (x < right[i] - 1 && left[i] < x + wide - 1 && y < bottom[i] - 1 && top[i] < y + high - 1) print name " covers " names[i]
      names[n] = name; left[n] = x; right[n] = x + wide; top[n] = y; bottom[n] = y + high; ++n
    }
    $1 == "frame" { next }
    $1 ~ /^Bar / { check($1, $2, $3, $4, $5); next }
    $1 ~ /^Section / { side = $2 + $4; next }
    $1 ~ /^Photo [12]$/ { check($1, $2, $3, $4, $5); next }
    $1 ~ /^(File|View|Path|Help)$/ { check($1, $2, $3, $4, $5); next }
    side && $1 !~ /^Photo / && $2 + $4 > side + 1 { print $1 " is wider than the sidebar" }
  ' places
}

shot() {  # shot FACE WIDTH HEIGHT: looks at the window as it is
  local wrong
  frames 4
  wrong=$(misplaced "$2" "$3")
  [ -z "$wrong" ] || fail "at $2x$3, $1: $wrong"
  [ -z "$pictures" ] || { frames 3; import -window "$window" "$pictures/$1-$2x$3.png"; }
}

start() {  # start OPTIONS...: the window
  rm -f places
  "$player" one.vantage --fresh --size 800x600 --blended 1 --thumbnails --controls places "$@" >says 2>&1 &
  pid=$!
  find_window
}

# On a screen of 2160 lines, text is 1.5 times as large if nothing else is asked for.
start
frames 3
high=$(awk -F'\t' '$1 == "Bar Help" { print int($5) }' places)
[ "${high:-0}" -ge 44 ] || fail "on a screen of 2160 lines, buttons are ${high:-0} pixels high, expected 46"
xdotool key ctrl+q
await_exit "Ctrl+Q"

# Other languages have longer words.
for how in "1 en" "1.5 en" "1 de" "1.5 fr"; do
  read -r scale language <<<"$how"
  start --text-scale "$scale" --language "$language"
  for size in "800 600" "600 1000" "1920 1080" "3840 2160"; do
    [ "$size" != "3840 2160" ] || [ "$how" = "1 en" ] || continue  # the largest has the most room
    # shellcheck disable=SC2086
    xdotool windowsize --sync "$window" $size
    frames 3
    # shellcheck disable=SC2086
    shot "visitor-$scale-$language" $size
    xdotool key --delay 60 Tab
    # shellcheck disable=SC2086
    shot "expert-$scale-$language" $size
    xdotool key --delay 60 Tab
  done
  xdotool key ctrl+q
  await_exit "Ctrl+Q"
done
[ $failed = 0 ] && echo "fits"
exit $failed
