"""Finds the code blocks in the README and the guides, and the commands in them."""
import re
import shlex

# A line that runs one of the programs, possibly after other commands, with environment variables, or as a step of a workflow.
COMMAND = re.compile(r'(?:^|&& |; |\| )(?:\w+=\S* )*(?:build/(?:pipeline|player)/)?vantage(?:-player)?(?: |$)')


def pages(source):
    """README.md and the guides. Measurements and checks are excluded, because they are run by hand and take hours."""
    by_hand = {'accuracy-and-cost.md', 'measurements.md', 'checks.md'}
    return ['README.md', *sorted(f'docs/{p.name}' for p in source.glob('docs/*.md') if p.name not in by_hand)]


def blocks(file):
    """The code blocks in a page, fenced or indented, as lists of (line number, text). Blocks are divided at empty lines."""
    found, block, fenced = [], [], False
    for number, line in enumerate(file.read_text().splitlines(), 1):
        fence = line.lstrip().startswith('```')
        fenced ^= fence
        if fence or not line.strip() or not (fenced or line.startswith('    ')):
            found, block = found + [block], []
        elif block and block[-1][1].endswith('\\'):
            block[-1] = (block[-1][0], block[-1][1][:-1] + line.strip())
        else:
            block.append((number, line if fenced else line[4:]))
    return [b for b in found + [block] if b]


def command_of(line):
    """The command in a line of a block, without its comment; None if the line has no command."""
    line = re.sub(r'^\s*(- run: )?', '', line)
    return re.sub(r'\s+# .*', '', line).strip() if COMMAND.search(line) else None


def words_of(command):
    """The words of a command, starting with the program."""
    words = shlex.split(command)
    return words[next(i for i, word in enumerate(words) if word.split('/')[-1] in ('vantage', 'vantage-player')):]


def first_words(text):
    """The first words of the lines that are not indented."""
    return [line.split()[0] for line in text.splitlines() if line[:1].strip()]


def block_after(file, text):
    """The block in a page whose first line contains the text. Such a block may show the content of a file."""
    return next('\n'.join(line for _, line in b) for b in blocks(file) if text in b[0][1])


def comment_after(file, text):
    """The comment on the line that contains the text, in any block."""
    return next(line.split('# ', 1)[1] for b in blocks(file) for _, line in b if text in line)
