#!/usr/bin/env bash
# Shows a demo scene in Monado's simulated headset, without a compositor's window.
# usage: monado_test.sh VANTAGE PLAYER SOURCE_DIR; exits with 77 if Monado is not installed.
set -euo pipefail
vantage=$1 player=$2 source=$3
runtime=/usr/share/openxr/1/openxr_monado.json
command -v monado-service >/dev/null && [ -e $runtime ] ||
  { echo "skipped: Monado is not installed (Ubuntu 24.04: monado-service, libopenxr1-monado)"; exit 77; }
command -v xvfb-run >/dev/null || { echo "skipped: xvfb-run is not installed"; exit 77; }

work=$(mktemp -d)
service=
finish() {
  [ -z "$service" ] || kill "$service" 2>/dev/null || true
  wait 2>/dev/null || true
  rm -rf "$work"
}
trap finish EXIT
mkdir -m 700 "$work/run"
export XDG_RUNTIME_DIR=$work/run SIMULATED_ENABLE=1 XRT_COMPOSITOR_NULL=1 XR_RUNTIME_JSON=$runtime
"$vantage" synth "$source/data/tiny.toml" -o "$work/scene" >/dev/null
"$vantage" prepare "$work/scene" -o "$work/scene.vantage" --progress none --no-report >/dev/null
monado-service </dev/null >"$work/service.log" 2>&1 &
service=$!
for _ in $(seq 100); do
  [ -e "$work/run/monado_comp_ipc" ] && break
  kill -0 $service 2>/dev/null || { cat "$work/service.log"; echo "skipped: monado-service does not start here"; exit 77; }
  sleep 0.1
done
xvfb-run -a timeout 120 "$player" "$work/scene.vantage" --xr --fresh --frames 60 ||
  { cat "$work/service.log"; echo "FAILED: vantage-player ended with $?"; exit 1; }
