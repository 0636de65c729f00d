#!/usr/bin/env python3
"""Checks the structure of the repository. Usage: check_structure.py SOURCE BUILD/modules.txt

It checks the top-level folders, the files per folder, lines per source and parameters per function, duplicate names, the
modules and their diagram, and whether the mutations apply.
The limits are those of docs/CONTRIBUTING.md."""
import collections
import pathlib
import re
import shutil
import subprocess
import sys

TOP = {"base", "cmake", "configs", "data", "docs", "pipeline", "player", "scene", "shaders", "tests"}
MAX_UNITS, MAX_LINES, MAX_MODULES, MAX_PARAMETERS = 15, 400, 45, 6
SOURCES = {".cpp", ".h"}
PROGRAMS = {"base", "pipeline", "player", "scene"}


def parameters(text):
    """Yields (name, number of parameters) for each function declared or defined; 0 parameters for OpenGL callbacks."""
    text = re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)
    text = re.sub(r'R"\(.*?\)"|"(\\.|[^"\\\n])*"', '""', text, flags=re.S)
    # Match a type and a name at the beginning of a line, followed by parameters, up to the token after the declaration.
    for m in re.finditer(r"^[ \t]*(?:[\w:<>,&*\[\] ]+[&*\s])?([A-Za-z_]\w*)\(", text, flags=re.M):
        depth, angle, commas, at = 1, 0, 0, m.end()
        empty = True
        while at < len(text) and depth:
            c = text[at]
            depth += c in "({["
            depth -= c in ")}]"
            if depth == 1:
                angle += c == "<"
                angle -= c == ">" and text[at - 1] != "-"
                commas += c == "," and angle <= 0
            empty = empty and (c.isspace() or c == ")")
            at += 1
        inside = text[m.end():at - 1]
        declared = re.match(r"\s*(const|noexcept|override|->|\{|;|:(?!:)|= default|= 0)", text[at:])
        typed = empty or re.match(r"\s*(?:const |std::|[A-Za-z_][\w:<>, ]*[ &*]+\w)", inside)
        head = text[m.start():m.start(1)].strip()
        if declared and typed and head and not head.endswith(("=", "return")) and head.split()[0] not in ("return", "throw", "else"):
            yield m.group(1), 0 if empty or "APIENTRY" in head else commas + 1


def faults(source, modules):
    files = [pathlib.Path(f) for f in subprocess.check_output(["git", "-C", source, "ls-files"], text=True).splitlines()]
    files = [f for f in files if (source / f).exists()]
    top = {f.parts[0] for f in files if len(f.parts) > 1 and not f.parts[0].startswith(".")}
    for extra in sorted(top - TOP):
        yield f"{extra}/: a folder at the top that is not one of {', '.join(sorted(TOP))}"
    units, names = collections.defaultdict(set), collections.defaultdict(set)
    for f in files:
        if f.suffix not in SOURCES:
            continue
        units[f.parent].add(f.stem)
        if f.parts[0] in PROGRAMS and f.stem != "main":
            names[f.stem].add(str(f.parent))
        text = (source / f).read_text()
        if (lines := text.count("\n")) > MAX_LINES:
            yield f"{f}: {lines} lines, {MAX_LINES} are the limit"
        if f.parts[0] in PROGRAMS:
            for name, count in parameters(text):
                if count > MAX_PARAMETERS:
                    yield f"{f}: {name} takes {count} parameters, {MAX_PARAMETERS} are the limit"
    for folder, stems in sorted(units.items()):
        if len(stems) > MAX_UNITS:
            yield f"{folder}/: {len(stems)} units, {MAX_UNITS} are the limit"
    for name, folders in sorted(names.items()):
        if len(folders) > 1:
            yield f"{name}: the name of a file in {' and '.join(sorted(folders))}"
    for patch in [f for f in files if f.suffix == ".patch"]:
        if subprocess.run(["git", "-C", source, "apply", "--check", patch], capture_output=True).returncode:
            yield f"{patch}: does not apply"
    ends = collections.Counter(m.split("/")[-1] for m in modules)
    for name, count in ends.items():
        if count > 1:
            yield f"{name}: the name of {count} modules"
    if len(modules) > MAX_MODULES:
        yield f"{len(modules)} modules, {MAX_MODULES} are the limit"


def main():
    source, graph = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    if not (source / ".git").exists() or not shutil.which("git"):
        print("skipped: not a git checkout, or git is not installed")
        return 77
    modules = [line.split(":")[0] for line in graph.read_text().splitlines()]
    found = list(faults(source, modules))
    drawn = graph.with_suffix(".svg")
    subprocess.check_call([sys.executable, source / "docs/draw_modules.py", graph, drawn])
    if drawn.read_text() != (source / "docs/modules.svg").read_text():
        found.append(f"docs/modules.svg is not what the build has: run docs/draw_modules.py {graph}")
    print("\n".join(found) or f"{len(modules)} modules")
    return 1 if found else 0


sys.exit(main())
