#!/usr/bin/env bash
# Installs into a temporary prefix and tests the installed files: programs, presets, manual pages, shell completion, desktop
# files. Checks that need a missing program (man, zsh, desktop-file-validate, update-mime-database) are skipped.
# Usage: install_test.sh BUILD_DIR SOURCE_DIR
set -euo pipefail
build=$1 source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix="$work/a prefix"
cmake --install "$build" --prefix "$prefix" >/dev/null
export PATH="$prefix/bin:$PATH" XDG_CACHE_HOME="$work/cache"
mkdir "$work/empty"
cd "$work/empty"

fail() { echo "failed: $*" >&2; exit 1; }
contains() { grep -qF -e "$2" <<<"$1" || fail "$3: expected '$2' in: $1"; }

# Programs run from the prefix and use the files installed there. The source folder contains presets, too, so the test changes
# the installed one to tell them apart.
for program in vantage vantage-player; do
  [ "$(command -v $program)" = "$prefix/bin/$program" ]
  $program --version >/dev/null
done
vantage synth "$source/data/tiny.toml" -o scene 2>/dev/null >/dev/null
vantage prepare scene -o tiny.vantage --preset default --progress none >/dev/null
presets="$prefix/share/vantage/configs"
[ -x "$presets/slurm/submit.sh" ] || fail "submit.sh is not executable"
echo 'sparkle = 1' >"$presets/ci.toml"
message=$(! vantage prepare scene -o other.vantage --preset ci 2>&1)
contains "$message" "$prefix/bin/../share/vantage/configs/ci.toml: sparkle: unknown setting" "the installed preset"
LD_DEBUG=files vantage extract tiny.vantage -o files 2>loaded
grep -q "calling init: $prefix/.*lib/vantage/libvantage_images.so" loaded || fail "the installed library is not loaded"

# Each verb has a manual page, which lists all options of --help.
page() { gzip -dc "$prefix/share/man/man1/$1.1.gz" | sed 's/\\-/-/g; s/\\f[BIR]//g'; }
verbs() { $1 --help | sed -n '/^\(Subcommands\|Verbs\)/,/^$\|^Exit/s/^  \([a-z]\{1,\}\) .*/\1/p'; }
options() { { "$@" --help-all 2>/dev/null || "$@" --help; } | grep -oE '^  (-[a-zA-Z],)?--[a-z-]+' | tr ', ' '\n' | grep .; }
candidates() {  # WORD...: the completions of the last word
  bash --norc -c '
    for file in /usr/share/bash-completion/bash_completion "$0/share/bash-completion/completions/$1"; do
      if [ -f "$file" ]; then source "$file"; fi
    done
    compopt() { :; }
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
    $(complete -p "$1" | sed "s/.*-F \([^ ]*\) .*/\1/")
    printf "%s\n" "${COMPREPLY[@]}"' "$prefix" "$@"
}
expect_documented() {  # COMMAND...
  local text offered option
  text=$(page "$(tr ' ' - <<<"$*")") offered=$(candidates "$@" -)
  for option in $(options "$@"); do
    contains "$text" "$option" "the manual page of $*"
    grep -qx -e "$option" <<<"$offered" || fail "completion of $* does not offer $option"
  done
}
for program in vantage vantage-player; do
  expect_documented $program
  [ "$(verbs $program | wc -l)" -ge 4 ] || fail "--help of $program lists no verbs"
  offered=$(candidates $program '')
  for verb in $(verbs $program); do
    expect_documented $program $verb
    grep -qx $verb <<<"$offered" || fail "completion of $program does not offer $verb"
  done
done
contains "$(page vantage-prepare)" "vantage prepare chapel -o look.vantage --preset preview" "examples"
contains "$(page vantage)" "12 out of memory" "exit codes"
if command -v man >/dev/null; then
  for file in "$prefix"/share/man/man1/*; do
    warnings=$(MANWIDTH=80 man --warnings -l "$file" 2>&1 >/dev/null)
    [ -z "$warnings" ] || fail "${file##*/}: $warnings"
  done
  contains "$(man -l "$prefix/share/man/man1/vantage-thumbnail.1.gz" | col -b)" "--size NUMBER" "vantage-thumbnail(1)"
fi

# Shell completion offers packages, folders, and the values of options, including after "=" and after a comma.
offered() { candidates "$@" | sort | tr '\n' ' '; }
expect_offered() {  # EXPECTED WORD...
  local expected=$1
  shift
  [ "$(offered "$@")" = "$expected" ] || fail "completion of '$*' offers '$(offered "$@")', expected '$expected'"
}
expect_offered 'prepare ' vantage pre
expect_offered 'color full off ' vantage prepare scene --refine ''
expect_offered 'color ' vantage prepare scene --refine = c
expect_offered 'preview ' vantage prepare --preset p
expect_offered 'stream,resident ' vantage-player bench --modes stream,r
expect_offered 'average ' vantage-player tiny.vantage --blend a
expect_offered ' ' vantage prepare --threads ''
expect_offered ' ' vantage-player tiny.vantage --original-colors x
if [ -f /usr/share/bash-completion/bash_completion ]; then
  touch notes.txt tidy.toml
  expect_offered 'tidy.toml tiny.vantage ' vantage-player ti
  expect_offered 'tiny.vantage ' vantage info tin
  expect_offered 'files ' vantage diff fi
fi
if command -v zsh >/dev/null; then
  for file in "$prefix"/share/zsh/vendor-completions/*; do zsh -n "$file"; done
fi

# Desktop files. The thumbnailer is called as file managers call it.
if command -v desktop-file-validate >/dev/null; then
  desktop-file-validate "$prefix/share/applications/vantage-player.desktop"
fi
[ -s "$prefix/share/icons/hicolor/scalable/apps/vantage.svg" ]
grep -qx 'Icon=vantage' "$prefix/share/applications/vantage-player.desktop"
if command -v update-mime-database >/dev/null; then
  update-mime-database "$prefix/share/mime" 2>/dev/null
  grep -qx '50:application/x-vantage:\*.vantage' "$prefix/share/mime/globs2" || fail "no file name of the type"
  grep -aq "VANTAGE" "$prefix/share/mime/magic" || fail "no magic of the type"
fi
[ "$(head -c 8 tiny.vantage)" = VANTAGE ] || fail "packages do not begin with the magic of their type"
cp tiny.vantage "a package of ours.vantage"
: >thumbnail
call=$(sed -n 's/^Exec=//p' "$prefix/share/thumbnailers/vantage.thumbnailer")
call=${call//%i/"'a package of ours.vantage'"} call=${call//%o/thumbnail} call=${call//%s/96}
eval "$call"
[ "$(od -An -tx1 -N8 thumbnail | tr -d ' ')" = 89504e470d0a1a0a ] || fail "the thumbnail is not a PNG"
size=$(od -An -tu1 -j16 -N8 thumbnail | awk '{w = $3 * 256 + $4; h = $7 * 256 + $8; print (w > h ? w : h)}')
[ "$size" = 96 ] || fail "the thumbnail's long side is $size px, expected 96"

# Links from the documents to each other and to pictures point to existing files.
doc="$prefix/share/doc/vantage"
for file in README.md $(cd "$doc" && ls docs/*.md); do
  for link in $(grep -ohE '\]\([^)#:]+\.(md|jpg|svg)' "$doc/$file" | cut -c3-); do
    [ -e "$(dirname "$doc/$file")/$link" ] || fail "$file: the link to $link is dangling"
  done
done
for program in vantage vantage-player; do
  grep -q "MIT License" "$prefix/share/doc/$program/copyright"
done
echo "installed below '$prefix': programs, presets, manual, completion and files for the desktop are in place"
