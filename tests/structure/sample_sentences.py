#!/usr/bin/env python3
"""Draws random sentences from all texts in the project: documents, help, messages, labels, comments.

    sample_sentences.py COUNT SEED     run from the root of the repository; prints PLACE: SENTENCE

For reviews of the language, see docs/CONTRIBUTING.md, "Language".
"""
import random
import re
import subprocess
import sys


def sentences(text):
    """Sentences of at least four words; a list item or a table cell counts as one."""
    text = re.sub(r'\s+', ' ', text).strip()
    for s in re.split(r'(?<=[.!?:;])\s+(?=[A-Z`*"(])', text):
        if len(re.findall(r"[A-Za-z']{2,}", s)) >= 4:
            yield s.strip()


def of_document(text):
    text = re.sub(r'^```.*?^```', '', text, flags=re.M | re.S)
    for block in re.split(r'\n\s*\n|\n(?=[-|#] ?)', text):
        if block.startswith(('    ', '<', '![')) or set(block) <= set('|-: \n'):
            continue
        for cell in block.split(' | ') if block.startswith('|') else [block]:
            yield from sentences(cell.strip('|#- \n'))


def of_code(text):
    comments = re.findall(r'(?:^[ \t]*//[/!]?<?.*\n)+', text, flags=re.M) + re.findall(r'\S[ \t]*///<(.*)', text)
    for c in comments:
        yield from sentences(re.sub(r'^[ \t]*//[/!<]*', '', c, flags=re.M))
    for literals in re.findall(r'(?:"(?:[^"\\\n]|\\.)*"\s*)+', re.sub(r'^#include.*', '', text, flags=re.M)):
        joined = ''.join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', literals))
        if '<' not in joined and '--' not in joined[:2]:
            yield from sentences(joined.replace('\\n', ' ').replace('\\"', '"'))


def of_script(text):
    for c in re.findall(r'(?:^[ \t]*#(?!!).*\n)+', text, flags=re.M) + re.findall(r'"""(.*?)"""', text, flags=re.S):
        yield from sentences(re.sub(r'^[ \t]*#', '', c, flags=re.M))


KINDS = {'.md': of_document, '.cpp': of_code, '.h': of_code, '.glsl': of_code, '.frag': of_code, '.vert': of_code,
         '.comp': of_code, '.py': of_script, '.sh': of_script, '.cmake': of_script, '.toml': of_script}

count, seed = int(sys.argv[1]), int(sys.argv[2])
everything = []
for file in sorted(subprocess.run(['git', 'ls-files'], capture_output=True, text=True, check=True).stdout.split('\n')):
    kind = KINDS.get('.' + file.rsplit('.', 1)[-1]) if '.' in file else None
    if kind and not file.startswith(('docs/records/', 'tests/fuzz/corpus')):
        everything += [f'{file}: {s}' for s in kind(open(file, encoding='utf-8', errors='replace').read())]
for line in random.Random(seed).sample(everything, count):
    print(line)
print(f'{count} of {len(everything)} sentences, seed {seed}', file=sys.stderr)
