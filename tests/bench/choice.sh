#!/usr/bin/env bash
# How many photos are needed to cover a view: compares the set cover with the choice by normals and the nearest n. Views
# are those of the photos' cameras at a quarter of their size, with the photo itself excluded. Prints the mean share of
# pixels that some other photo could color and the chosen ones leave uncolored.
# usage: choice.sh PLAYER PACKAGE...
player=$1
shift
picture=$(mktemp -d)/view.png
for package in "$@"; do
  photos=$("$player" "$package" --list | awk '{ sub(/\.[^.]*$/, "", $1); print $1 }')
  most=$(echo "$photos" | wc -l)
  for photo in $photos; do
    view() {  # view OPTIONS: photos used, percent colored
      "$player" "$package" --offscreen --photo "$photo" --exclude "$photo" --scale 0.25 --samples 1 -o "$picture" "$@" |
        awk '{ for (i = 2; i <= NF; i++) { if ($i == "photos") p = $(i - 1); if ($i == "colored") c = $(i - 2) } print p, c }'
    }
    echo "all $(view)"
    echo "cover $(view --choose cover --blended 1)"
    for n in 1 2 3; do
      [ "$n" -lt "$most" ] && echo "normals-$n $(view --choose normals --blended "$n")"
    done
    for n in 1 2 3 4 5 6 8 10 12; do
      [ "$n" -lt "$most" ] && echo "nearest-$n $(view --choose nearest --blended "$n")"
    done
  done | awk -v package="$(basename "$package")" '
    $1 == "all" { all = $3 }
    { if (!($1 in n)) names[++count] = $1; n[$1]++; photos[$1] += $2; if (all > 0) left[$1] += (all - $3) / all; }
    END { for (i = 1; i <= count; i++) { k = names[i]; printf "%-22s %-11s %5.2f photos  %7.3f %% left uncolored\n", package, k, photos[k] / n[k], 100 * left[k] / n[k] } }'
done
