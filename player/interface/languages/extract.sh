#!/usr/bin/env bash
# Writes the texts of the window as a template for the catalogs. usage: extract.sh FILE.pot
# After texts have changed: extract.sh new.pot; msgmerge --update player/interface/languages/de.po new.pot; translate the entries that are fuzzy or empty.
set -euo pipefail
cd "$(dirname "$0")/../../.."
keywords=(tr tr_in:1c,2 tr_count:1,2 marked MARKED_IN:1c,2 shown_name explain button checkbox radio slider combo:1 choice:1 choice:2 icon_button number text
  menu_item menu toggle share_slider:2)
xgettext --language=C++ --from-code=UTF-8 --sort-by-file --no-wrap --add-comments=Translators --package-name=Vantage \
  --keyword "${keywords[@]/#/--keyword=}" --output="$1" $(find player base/text -name '*.cpp' -o -name '*.h' | sort | grep -v 'remembered.cpp\|player/options/\|player/verbs/')
