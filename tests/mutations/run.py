#!/usr/bin/env python3
"""Applies each patch in this folder to a copy of the sources, builds it, and reports whether a test notices.

    tests/mutations/run.py                   # all, against the default set of tests
    tests/mutations/run.py --full            # against the full set
    tests/mutations/run.py tile-border ...   # some

A patch begins with a sentence that describes the resulting fault and a line "likely: REGEX", which matches the tests that
should notice. These tests run first, and the first failure ends a mutation. The copy of the last commit is in
build-mutations/ and is kept for the next run. Exit codes: 0 all mutations were noticed, 1 some were not, 2 the sources,
a patch or the unchanged tests do not work.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import time

folder = pathlib.Path(__file__).resolve().parent
root = folder.parent.parent


def run(*words, **more):
    return subprocess.run([str(w) for w in words], capture_output=True, text=True, **more)


def stop(message):
    print(f"run.py: {message}", file=sys.stderr)
    sys.exit(2)


def fresh_copy(copy):
    """Checks out the sources of the last commit into `copy`, without the changes of an earlier mutation."""
    steps = [] if (copy / ".git").exists() else [["clone", "--quiet", "--shared", "--no-checkout", root, copy]]
    steps += [["-C", copy, *words] for words in (["fetch", "--quiet", "origin", "HEAD"],
                                                 ["checkout", "--quiet", "--force", "--detach", "FETCH_HEAD"],
                                                 ["clean", "--quiet", "-fd"])]
    for words in steps:
        done = run("git", *words)
        if done.returncode:
            stop(done.stderr.strip())


def build(copy, parallel, full):
    made = run("cmake", "-S", copy, "-B", copy / "build", "-G", "Ninja", "-DBUILD_TESTING=ON")
    if made.returncode == 0:
        made = run("cmake", "--build", copy / "build", "--target", "all" if full else "suite", "--parallel", parallel)
    return made.returncode == 0, made.stdout + made.stderr


def failures(copy, parallel, *choice):
    """The names of the tests that failed. ctest stops at the first failure."""
    environment = dict(os.environ)
    environment.setdefault("VANTAGE_DATASETS", str(root.parent / "shared" / "datasets"))
    tests = run("ctest", "--test-dir", copy / "build", "-j", parallel, "--stop-on-failure", *choice, env=environment)
    if tests.returncode == 0:
        return []
    listed = tests.stdout.rpartition("The following tests FAILED")[2]
    return re.findall(r"\d+ - (\S+) \((?!Not Run|Disabled)", listed) or ["ctest"]


def judge(patch, copy, parallel, full):
    """The test that noticed the mutation, or an empty string."""
    likely = re.search(r"^likely: (.+)$", patch.read_text(), re.MULTILINE).group(1)
    applied = run("git", "-C", copy, "apply", patch)
    if applied.returncode:
        stop(f"{patch.name} does not apply: {applied.stderr.strip()}")
    built, log = build(copy, parallel, full)
    if not built:
        stop(f"{patch.name} does not build:\n{log[-4000:]}")
    chosen = [] if full else ["-LE", "full"]
    for choice in (["-R", likely], ["-E", likely]):
        if failed := failures(copy, parallel, *chosen, *choice):
            return failed[0]
    return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", help="of patches, without .patch; default: all")
    parser.add_argument("--full", action="store_true", help="run the full set of tests")
    parser.add_argument("--copy", type=pathlib.Path, default=root / "build-mutations", help="where to build")
    parser.add_argument("-j", "--parallel", type=int, default=os.cpu_count())
    o = parser.parse_args()
    patches = [folder / f"{n}.patch" for n in o.names] or sorted(folder.glob("*.patch"))
    for patch in patches:
        if not patch.exists():
            stop(f"{patch.name} is not in {folder}")
    missed = 0
    for patch in patches:
        fresh_copy(o.copy)
        start = time.monotonic()
        noticed = judge(patch, o.copy, o.parallel, o.full)
        missed += not noticed
        print(f"{patch.stem:28} {noticed or 'MISSED':50} {(time.monotonic() - start) / 60:5.1f} min", flush=True)
    fresh_copy(o.copy)
    print(f"{len(patches) - missed} of {len(patches)} caught")
    sys.exit(1 if missed else 0)


main()
