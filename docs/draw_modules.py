#!/usr/bin/env python3
"""Draws the modules and their layers from the build's own graph.

usage: draw_modules.py BUILD/modules.txt [OUT.svg]        default: modules.svg beside this script

A module is drawn above the modules that it uses. Arrows join modules within a frame; small letters name the modules used from
lower frames. Arrows that follow from other arrows are not drawn: a module that uses `refine` may also use all modules below
`refine`. The script fails if modules form a cycle, or if a module uses a module from a higher folder."""
import pathlib
import sys

FOLDERS = {"base": 0, "scene": 1, "shaders": 2, "pipeline": 3, "player": 3}
COLORS = {"base": "#e8e8e8", "scene": "#dbe8f5", "shaders": "#dbe8f5", "pipeline": "#e2f0dc", "player": "#fbeedb"}
BOX, HEIGHT, ROW, GAP = 124, 36, 60, 12


def folder(module):
    return module.split("/")[0]


def frame(module):
    return "scene" if folder(module) == "shaders" else folder(module)


def read(path):
    uses = {}
    for line in pathlib.Path(path).read_text().splitlines():
        name, _, used = line.partition(":")
        uses[name] = set(used.split())
    for name, used in uses.items():
        for other in used:
            a, b = folder(name), folder(other)
            if other not in uses or a != b and FOLDERS[b] >= FOLDERS[a]:
                sys.exit(f"{name} uses {other}, which is not below it")
    return uses


def reach(uses):
    """All modules that each module uses, directly or through other modules."""
    done, open_ = {}, set()

    def of(name):
        if name in open_:
            sys.exit(f"modules use each other in a circle: {name}")
        if name not in done:
            open_.add(name)
            done[name] = set().union(uses[name], *(of(other) for other in sorted(uses[name])))
            open_.remove(name)
        return done[name]

    for name in uses:
        of(name)
    return done


def layers(names, uses):
    """Rows of modules, lowest first. Each module is one row above the highest module that it uses."""
    row = {}

    def of(name):
        if name not in row:
            row[name] = max((of(other) + 1 for other in uses[name] if other in names), default=0)
        return row[name]

    for name in names:
        of(name)
    return [sorted(n for n in names if row[n] == r) for r in range(max(row.values()) + 1)]


def place(names, direct, left, bottom, width):
    """Centers of the boxes, in rows upward from `bottom`, and the points where each arrow passes other rows."""
    rows = layers(names, direct)
    row = {n: r for r, ns in enumerate(rows) for n in ns}
    joined = {}  # an item of a row -> items of the adjacent rows that an arrow joins to it
    for n in names:
        for o in sorted(direct[n] & set(names)):
            way = [o] + [(n, o, r) for r in range(row[o] + 1, row[n])] + [n]
            for r, item in enumerate(way[1:-1], row[o] + 1):
                rows[r].append(item)
            for lower, upper in zip(way, way[1:]):
                joined.setdefault(lower, set()).add(upper)
                joined.setdefault(upper, set()).add(lower)
    size = {item: BOX if isinstance(item, str) else 0 for items in rows for item in items}
    x = {}

    def spread(items):
        gap = min(3 * GAP, (width - sum(size[i] for i in items)) / (len(items) + 1))
        at = left + (width - sum(size[i] for i in items) - gap * (len(items) - 1)) / 2
        for item in items:
            x[item] = at + size[item] / 2
            at += size[item] + gap

    for items in rows:
        spread(items)
    for sweep in range(24):
        for items in rows if sweep % 2 else reversed(rows):
            middle = {i: sum(x[o] for o in joined.get(i, ())) / max(1, len(joined.get(i, ()))) or x[i] for i in items}
            items.sort(key=lambda i: (middle[i], str(i)))
            spread(items)
    return {item: (x[item], bottom - r * ROW) for r, items in enumerate(rows) for item in items}


def arrow(points):
    """A smooth line down through the points, vertical next to the boxes of the rows that it passes."""
    x, y = points[0]
    path = f"M{x:g} {y:g}"
    for to, (u, v) in enumerate(points[1:], 2):
        end = v if to == len(points) else v - HEIGHT / 2
        path += f"C{x:g} {(y + end) / 2:g} {u:g} {(y + end) / 2:g} {u:g} {end:g}"
        x, y = u, end
        if to < len(points):
            y += HEIGHT
            path += f"V{y:g}"
    return f'<path d="{path}" fill="none" stroke="#666" stroke-opacity=".7" marker-end="url(#a)"/>'


def draw(uses):
    below = reach(uses)
    direct = {n: {o for o in used if not any(o in below[p] for p in used)} for n, used in uses.items()}
    groups = {f: [n for n in uses if frame(n) == f] for f in ("pipeline", "player", "scene", "base")}
    height = {f: len(layers(names, direct)) * ROW for f, names in groups.items()}
    half = 4 * (BOX + GAP)
    wide, top = 2 * half + 3 * GAP, 30
    programs = top + max(height["pipeline"], height["player"])
    scene = programs + 40 + height["scene"]
    total = scene + 40 + height["base"] + GAP
    regions = {"pipeline": (GAP, top, half, programs - top + GAP), "player": (2 * GAP + half, top, half, programs - top + GAP),
               "scene": (GAP, programs + 36, wide - 2 * GAP, scene - programs - 28),
               "base": (GAP, scene + 36, wide - 2 * GAP, total - scene - 42)}
    at = {}
    for f, (x, y, w, h) in regions.items():
        at |= place(groups[f], direct, x, y + h - GAP - HEIGHT / 2, w)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{wide:g}" height="{total:g}" font-family="sans-serif" font-size="12">',
           '<defs><marker id="a" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
           '<path d="M0 0 8 4 0 8z" fill="#666"/></marker></defs>', '<rect width="100%" height="100%" fill="white"/>']
    titles = {"scene": "scene/ and shaders/"}
    for f, (x, y, w, h) in regions.items():
        out.append(f'<rect x="{x:g}" y="{y:g}" width="{w:g}" height="{h:g}" rx="8" fill="none" stroke="#bbb"/>'
                   f'<text x="{x + 8:g}" y="{y - 5:g}" font-weight="bold">{titles.get(f, f + "/")}</text>')
    for n in sorted(uses):
        for o in sorted(direct[n]):
            if frame(n) != frame(o):
                continue
            (x0, y0), (x1, y1) = at[n], at[o]
            between = sorted((p for k, p in at.items() if k[:2] == (n, o)), key=lambda p: p[1])
            out.append(arrow([(x0, y0 + HEIGHT / 2), *between, (x1, y1 - HEIGHT / 2)]))
    for n in sorted(uses):
        x, y = at[n]
        shared = sorted(o.split("/")[-1] for o in direct[n] if frame(o) != frame(n))
        out.append(f'<rect x="{x - BOX / 2:g}" y="{y - HEIGHT / 2:g}" width="{BOX}" height="{HEIGHT}" rx="4" '
                   f'fill="{COLORS[folder(n)]}" stroke="#888"/>'
                   f'<text x="{x:g}" y="{y + (0 if shared else 5):g}" text-anchor="middle">{n.split("/")[-1]}</text>')
        if shared:
            out.append(f'<text x="{x:g}" y="{y + 13:g}" text-anchor="middle" font-size="8" fill="#555">{", ".join(shared)}</text>')
    return "\n".join(out + ["</svg>", ""])


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    target = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else pathlib.Path(__file__).parent / "modules.svg")
    target.write_text(draw(read(sys.argv[1])))
