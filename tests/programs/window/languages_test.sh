#!/usr/bin/env bash
# Every text of the window is translated into every language with a catalog. usage: languages_test.sh SOURCE_DIR
set -uo pipefail
source=$1
for tool in xgettext msgcmp msgfmt; do
  command -v $tool >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
texts=$(mktemp -d)
trap 'rm -rf "$texts"' EXIT
"$source/player/interface/languages/extract.sh" "$texts/vantage.pot" || exit 1
failed=0
[ "$(grep -c '^msgid' "$texts/vantage.pot")" -gt 300 ] || { echo "FAILED: too few texts were found"; failed=1; }
for catalog in "$source"/player/interface/languages/*.po; do
  msgfmt --check -o /dev/null "$catalog" || failed=1
  msgcmp "$catalog" "$texts/vantage.pot" || { echo "FAILED: $catalog lacks texts"; failed=1; }
done
exit $failed
