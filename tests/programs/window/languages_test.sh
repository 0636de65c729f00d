#!/usr/bin/env bash
# Tests that each text of the window is translated into each language that has a catalog, with the terms that native readers use.
# Usage: languages_test.sh SOURCE_DIR
set -uo pipefail
source=$1
export LC_ALL=C.UTF-8
for tool in xgettext msgcat msgcmp msgfmt; do
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
  ! grep -n '^#~\|^#,.*fuzzy' "$catalog" || { echo "FAILED: $catalog has texts that are fuzzy, or not of the window"; failed=1; }
done
# refuse WHY PATTERN FILE KEYWORD: fails if any text matches a Perl regular expression, and reports those texts
refuse() {
  ! msgcat --no-wrap "$3" | grep -nP "^${4}.*($2)" || { echo "FAILED: $3: $1"; failed=1; }
}
languages=$source/player/interface/languages
refuse "labels that native readers do not write" '"Choose to"|What counts|Of a point|Eyes apart|Opened before|Write the cut|Two eyes' \
  "$texts/vantage.pot" msgid
refuse "words that native readers do not write" 'B(a|ä)nd(s|er|ern)?\b|Experte|Eines Punkts|\bWegs?\b|Stencil|\.\.\.' "$languages/de.po" msgstr
refuse "words that native readers do not write" '\bbandes?\b|Cliquez (un|deux|des|les|le|la)\b|\btables?\b|\bJouer\b|\bFixer\b|\.\.\.' \
  "$languages/fr.po" msgstr
# French requires U+202F before ; ! ? and U+00A0 before : and % and within « », as well as typographic apostrophes.
refuse "no no-break space before a mark" '[^\x{202f}[:punct:]][;!?]|[^\x{a0}[:punct:]]:(?=[ "])|«[^\x{a0}]|[^\x{a0}]»|\d [%]' "$languages/fr.po" msgstr
refuse "a straight apostrophe" "\\w'\\w" "$languages/fr.po" msgstr
exit $failed
