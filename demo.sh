#!/usr/bin/env bash
# Runs setup.sh, generates the demo scene, prepares and checks its package, and shows the package in a window.
# Without a display, the script renders pictures instead.
set -euo pipefail
cd "$(dirname "$0")"
./setup.sh
vantage=build/pipeline/vantage player=build/player/vantage-player
[ -f demo-scene/mesh.ply ] && [ ! data/demo.toml -nt demo-scene/mesh.ply ] || "$vantage" synth data/demo.toml -o demo-scene
"$vantage" prepare demo-scene -o demo.vantage
"$vantage" check --deep --against demo-scene demo.vantage
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  exec "$player" demo.vantage "$@"
fi
"$player" render demo.vantage --photo 0004,0011 --blend best -o demo-out/photos
"$player" render demo.vantage --path data/demo.path --size 1280x720 --holes shade -o demo-out/between
echo "no display: the pictures are in demo-out/"
