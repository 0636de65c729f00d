#!/usr/bin/env bash
# The part of bare_system.sh that runs inside the system.
set -euo pipefail
export DEBIAN_FRONTEND=noninteractive LANG=C.UTF-8
step() { echo "== $*"; }
fail() { echo "failed: $*" >&2; exit 1; }

step "install"
apt-get update -qq
apt-get install -y -qq /debs/*.deb >/tmp/install.log 2>&1 || { tail -n 20 /tmp/install.log; exit 1; }
# Programs that every desktop has, and tools for inspecting the desktop.
apt-get install -y -qq xdg-utils desktop-file-utils man-db bash-completion xvfb xauth xdotool scrot >/tmp/tools.log 2>&1
dpkg-query -W vantage vantage-player
id visitor >/dev/null 2>&1 || useradd --create-home --shell /bin/bash visitor
cp -r /scan /home/visitor
chown -R visitor /home/visitor/scan
as_visitor() { su - visitor -c "$1"; }

step "prepare"
as_visitor 'vantage prepare scan -o chapel.vantage --progress none' | tail -n 3

step "file type"
type=$(as_visitor 'xdg-mime query filetype chapel.vantage')
[ "$type" = application/x-vantage ] || fail "the file type is '$type'"
as_visitor 'cp chapel.vantage chapel; xdg-mime query filetype chapel' | grep -qx application/x-vantage ||
  fail "the file type is not known by its first bytes"
[ "$(as_visitor "xdg-mime query default $type")" = vantage-player.desktop ] || fail "nothing opens $type"

step "double click"
# The window has a title before its first picture.
cat >/home/visitor/open.sh <<'OPEN'
xdg-open chapel.vantage 2>said &
for _ in $(seq 120); do
  sleep 1
  if grep -q 'first picture' said; then drawn=yes; break; fi
done
[ "${drawn:-}" ] || { cat said; exit 1; }
xdotool search --name '^chapel.vantage - Vantage$' >/dev/null || exit 1
sleep 5
scrot -o /tmp/screenshot.png
xdotool key --clearmodifiers ctrl+q
wait
cat said
OPEN
as_visitor 'xvfb-run -a -s "-screen 0 1280x720x24" bash open.sh' || fail "xdg-open shows no window"
# A screenshot of a photographed object compresses poorly; an empty window compresses to about 10 kB.
[ "$(stat -c %s /tmp/screenshot.png)" -gt 50000 ] || fail "the window shows nothing, see /tmp/screenshot.png"

step "manual"
for page in vantage 'vantage prepare' vantage-player vantage-player-bench; do
  as_visitor "MANWIDTH=80 man $page" | col -b >/tmp/page
  grep -q '^SYNOPSIS' /tmp/page || fail "no manual page: $page"
  echo "man $page: $(wc -l </tmp/page) lines"
done
as_visitor 'man -k vantage' | grep -c '^vantage' | sed 's/$/ pages found by man -k/'

step "completion"
echo '. /usr/share/bash-completion/bash_completion' >/home/visitor/rc
(sleep 2; printf 'vantage thumb\tcha\t -o typed.png --si\t64\n'; sleep 2; printf 'exit\n') |
  as_visitor 'TERM=dumb script -qec "bash --rcfile rc -i" /dev/null' >/tmp/typed || true
[ -s /home/visitor/typed.png ] || { cat /tmp/typed; fail "completion of a typed command"; }
grep -a 'vantage thumbnail' /tmp/typed | head -n 1

step "thumbnail"
call=$(sed -n 's/^Exec=//p' /usr/share/thumbnailers/vantage.thumbnailer)
call=${call//%i/chapel.vantage} call=${call//%o/shown.png} call=${call//%s/128}
as_visitor "time $call" 2>&1 | grep real
as_visitor 'file shown.png 2>/dev/null || od -An -c -N4 shown.png'

step "removal"
apt-get purge -y -qq vantage vantage-player >/dev/null 2>&1
left=$(find / -xdev \( -path /proc -o -path /home -o -path /tmp -o -path /debs -o -path /var \) -prune -o -iname '*vantage*' -print)
[ -z "$left" ] || fail "left after removal: $left"
echo "nothing is left"
