#!/usr/bin/env bash
# Shows a demo scene in Monado's simulated headset, without a compositor window. The tests run without a display, through X11
# with the Khronos validation layer, and across a loss of the runtime.
# Usage: monado_test.sh VANTAGE PLAYER SOURCE_DIR; exits with 77 if Monado is not installed.
set -euo pipefail
vantage=$1 player=$2 source=$3
runtime=/usr/share/openxr/1/openxr_monado.json
command -v monado-service >/dev/null && [ -e $runtime ] ||
  { echo "skipped: Monado is not installed (Ubuntu 24.04: monado-service, libopenxr1-monado)"; exit 77; }
. "$source/tests/programs/window.sh"
under_xvfb 1280x1024 "$@"

fail() {
  tail -n 40 "$dir"/*.log
  echo "FAILED: $1"
  exit 1
}
mkdir -m 700 run
mkfifo stdin  # stdin for the service, which exits when it reads a line
exec 3<>stdin
export XDG_RUNTIME_DIR=$dir/run SIMULATED_ENABLE=1 XRT_COMPOSITOR_NULL=1 XR_RUNTIME_JSON=$runtime
service= running=
trap 'kill $service $running $watcher 2>/dev/null' EXIT
start_service() {
  rm -f run/monado_comp_ipc
  monado-service <&3 >service.log 2>&1 &
  service=$!
  within 10 is_ready_or_gone
  [ -e run/monado_comp_ipc ] || { cat service.log; return 1; }
}
is_ready_or_gone() { [ -e run/monado_comp_ipc ] || ! kill -0 $service 2>/dev/null; }
# The number of different colors on the screen.
colors() {
  screenshot screen.ppm
  tail -c +16 screen.ppm | od -An -v -w3 -tx1 | sort -u | wc -l
}

"$vantage" synth "$source/data/tiny.toml" -o scene >/dev/null 2>&1
"$vantage" prepare scene -o scene.vantage --progress none --no-report >/dev/null
shown=("$player" headset scene.vantage --no-saved-settings --fps 0)
start_service || { echo "skipped: monado-service does not start here"; exit 77; }

env -u DISPLAY timeout 120 "${shown[@]}" --frames 40 >egl.log 2>&1 || fail "without a display, the player ended with $?"
grep -q "^OpenXR: Monado" egl.log || fail "the player did not name the headset"

if ls /usr/share/openxr/1/api_layers/explicit.d/*core_validation* >/dev/null 2>&1; then
  XR_ENABLE_API_LAYERS=XR_APILAYER_LUNARG_core_validation XR_CORE_VALIDATION_EXPORT_TYPE=text \
    timeout 120 "${shown[@]}" --frames 40 >layer.log 2>&1 || fail "with the validation layer, the player ended with $?"
  grep -q "Core Validation" layer.log || fail "the validation layer was not loaded"
  ! grep -q "VUID-" layer.log || fail "the validation layer reported errors"
fi

timeout 120 "${shown[@]}" --frames 200 >player.log 2>&1 &
running=$!
shows_picture() { [ "$(colors)" -ge 300 ]; }
within 30 shows_picture || fail "the mirror shows no picture"
kill -9 $service
wait $service || true
soon grep -q "the OpenXR runtime was lost; waiting for it" player.log || fail "the player did not report the loss of the runtime"
start_service || fail "monado-service does not start again"
wait $running || fail "after the loss of the runtime, the player ended with $?"
