#!/usr/bin/env bash
# Installs what is missing (Debian 12, Ubuntu 24.04) and builds into build/: the two programs and their manual, or the
# targets given (all: also tests and benchmarks). Called by demo.sh and test.sh.
set -euo pipefail
cd "$(dirname "$0")"

packages=(g++ cmake ninja-build pkg-config ca-certificates
  libopencv-core-dev libopencv-imgproc-dev libopencv-imgcodecs-dev libopencv-calib3d-dev libopencv-video-dev libopencv-features2d-dev libceres-dev
  libopenimageio-dev openimageio-tools libopenmesh-dev libassimp-dev libmeshoptimizer-dev
  libcli11-dev libfmt-dev nlohmann-json3-dev libturbojpeg0-dev libjpeg-dev libpng-dev libtiff-dev liblcms2-dev libheif-dev libpugixml-dev libembree-dev libtomlplusplus-dev
  libsquish-dev libzstd-dev gnuplot-nox
  libxxhash-dev libcurl4-openssl-dev libutf8proc-dev libeigen3-dev libepoxy-dev libegl-dev libgl-dev libglfw3-dev libx11-dev libxcb-xinput-dev libimgui-dev libopenxr-dev openxr-layer-corevalidation
  libgl1-mesa-dri libegl-mesa0 libglx-mesa0 libgtest-dev librapidcheck-dev
  fonts-dejavu-core xvfb xauth xserver-xorg-core xserver-xorg-video-dummy xdotool python3-xlib gettext bash-completion desktop-file-utils man-db shared-mime-info)
# Since glibc 2.39, the window's languages need a locale besides C.
grep -q '^ID=ubuntu' /etc/os-release && packages+=(language-pack-en-base)
missing=()
for p in "${packages[@]}"; do
  dpkg-query -W -f='${Status}' "$p" 2>/dev/null | grep -q 'ok installed' || missing+=("$p")
done
if ((${#missing[@]})); then
  sudo=$([ "$(id -u)" = 0 ] || echo sudo)
  echo "installing ${missing[*]}"
  $sudo apt-get update -qq
  DEBIAN_FRONTEND=noninteractive $sudo apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
fi
cmake -S . -B build -G Ninja >/dev/null
(($#)) || set -- vantage vantage-player manual
cmake --build build --target "$@"
