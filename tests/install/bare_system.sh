#!/usr/bin/env bash
# Installs the .deb packages in a bare system and tests what a user would use: file type, double-click, manual pages, shell
# completion, thumbnails, removal. Run it manually, as root: it downloads several hundred megabytes. Needs debootstrap.
# Usage: bare_system.sh FOLDER DEB...
#   FOLDER: receives the system, which is kept for the next run, and screenshot.png
#   SUITE (default: bookworm), MIRROR (default: http://deb.debian.org/debian): those of the system on which the packages were built
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
folder=$(realpath -m "$1") suite=${SUITE:-bookworm} mirror=${MIRROR:-http://deb.debian.org/debian}
shift
root=$folder/system
source=$(cd "$here/../.." && pwd)
vantage=${VANTAGE:-$source/build/pipeline/vantage}

if [ ! -e "$root/bootstrapped" ]; then
  mkdir -p "$root"
  components=main
  case $mirror in *ubuntu*) components=main,universe ;; esac
  debootstrap --variant=minbase --components=$components "$suite" "$root" "$mirror" >"$folder/debootstrap.log"
  touch "$root/bootstrapped"
fi
rm -rf "$root/debs" "$root/scan"
mkdir -p "$root/debs"
cp "$@" "$root/debs"
cp "$here/in_bare_system.sh" "$root"
"$vantage" synth "$source/data/tiny.toml" -o "$root/scan" >/dev/null 2>&1

# The namespaces remove all mounts and processes when the script ends.
unshare --mount --pid --fork bash -c '
  mount -t proc proc "$1/proc"
  mkdir -p "$1/dev/pts" "$1/dev/shm"
  mount -t devpts devpts "$1/dev/pts" -o newinstance,ptmxmode=0666
  mount --bind "$1/dev/pts/ptmx" "$1/dev/ptmx"
  mount -t tmpfs tmpfs "$1/dev/shm"
  chroot "$1" bash /in_bare_system.sh' - "$root"
mv "$root/tmp/screenshot.png" "$folder"
echo "the window: $folder/screenshot.png"
