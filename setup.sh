#!/usr/bin/env bash
# Installs missing packages (Debian 12, Ubuntu 24.04) and builds in build/. Without arguments, as demo.sh
# calls it, builds the two programs and their manual. test.sh passes a target: suite (the default set of
# tests) or all (which includes the benchmarks).
set -euo pipefail
cd "$(dirname "$0")"

packages=(g++ cmake ninja-build pkg-config ca-certificates gettext
  libopencv-core-dev libopencv-imgproc-dev libopencv-video-dev libopencv-features2d-dev libceres-dev
  libopenimageio-dev openimageio-tools libopenmesh-dev libassimp-dev libmeshoptimizer-dev libembree-dev libeigen3-dev
  libturbojpeg0-dev libjpeg-dev libpng-dev libtiff-dev liblcms2-dev libheif-dev
  libcli11-dev libfmt-dev nlohmann-json3-dev libpugixml-dev libtomlplusplus-dev libzstd-dev libxxhash-dev
  libcurl4-openssl-dev libutf8proc-dev
  libepoxy-dev libegl-dev libgl-dev libglfw3-dev libx11-dev libxcb-xinput-dev libimgui-dev libqrencode-dev libopenxr-dev
  libgl1-mesa-dri libegl-mesa0 libglx-mesa0 fonts-dejavu-core ffmpeg)
# Since glibc 2.39, the window can change its language only if a locale other than C is installed.
grep -q '^ID=ubuntu' /etc/os-release && packages+=(language-pack-en-base)
tests=OFF targets=(vantage vantage-player manual)
# Tests stay enabled if they were enabled before.
grep -qs '^BUILD_TESTING:BOOL=ON' build/CMakeCache.txt && tests=ON
if (($#)); then
  tests=ON targets=("$@")
  packages+=(libgtest-dev libgmock-dev librapidcheck-dev libopencv-calib3d-dev libopencv-imgcodecs-dev libsquish-dev gnuplot-nox
    xvfb xauth xserver-xorg-core xserver-xorg-video-dummy xdotool inotify-tools python3-xlib python3-jsonschema openxr-layer-corevalidation
    bash-completion desktop-file-utils man-db shared-mime-info)
fi
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
cmake -S . -B build -G Ninja -DBUILD_TESTING="$tests" >/dev/null
# Ninja's default number of jobs, two more than there are cores, takes 5 % longer on two cores.
cmake --build build --parallel "$(nproc)" --target "${targets[@]}"
