#!/usr/bin/env python3
"""Several processes randomly use one collection of packages, and an oracle checks every verdict.

    soak.py --vantage PROGRAM --player PROGRAM FOLDER [--minutes 10] [--workers 3] [--packages 4] [--seed 1]

Each package has its own inputs. The test changes the inputs (photos are exchanged, truncated, repaired, added and removed) and
the package (it is damaged, truncated or deleted). It also runs commands on the package: prepare (with several settings, killed
at a random time, with little memory or with little disk space, and then again without faults), check, check --against, refine,
extract, and the player, which renders a view from a photo's camera. The expected verdict follows from the changes. While one
worker changes a package, others read it; they may see either the old package or the new one.

Prints a line for each wrong verdict and, at the end, the number of operations of each kind, the wrong verdicts, and the largest
amount of memory that a command used in each tenth of the run. The exit code is 1 if any verdict was wrong."""
import argparse
import collections
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

VALID, STALE, DAMAGED, INCOMPLETE, STORAGE, MEMORY = 0, 5, 4, 9, 6, 12  # exit codes


class Package:
    """A package, its inputs, and their state as known to the oracle."""

    def __init__(self, folder, index, template):
        self.scene = os.path.join(folder, 'scene%d' % index)
        shutil.copytree(template, self.scene)
        self.file = os.path.join(folder, 'collection%d.vantage' % index)
        self.photos = sorted(os.listdir(os.path.join(self.scene, 'images')))
        self.good = {p: self.content(p) for p in self.photos}
        self.lock = threading.Lock()
        self.prepared = None  # the inputs of the package, and whether photos were skipped
        self.damaged = False

    def path(self, photo):
        return os.path.join(self.scene, 'images', photo)

    def content(self, photo):
        with open(self.path(photo), 'rb') as f:
            return f.read()

    def inputs(self):
        return tuple(self.content(p) if os.path.exists(self.path(p)) else None for p in self.photos)

    def is_broken(self, photo):
        return os.path.exists(self.path(photo)) and len(self.content(photo)) < 1000

    def broken(self):
        return any(not os.path.exists(self.path(p)) or self.is_broken(p) for p in self.photos)

    def usable(self):
        return sum(os.path.exists(self.path(p)) and not self.is_broken(p) for p in self.photos)


class Soak:
    def __init__(self, o):
        self.o = o
        self.counts = collections.Counter()
        self.wrong = []
        self.memory = collections.defaultdict(int)  # KB by tenth of the run
        self.start = time.time()
        self.mutex = threading.Lock()
        self.log = open(os.path.join(o.folder, 'soak.log'), 'w')

    def tenth(self):
        return min(9, int(10 * (time.time() - self.start) / (60 * self.o.minutes)))

    def run(self, words, limit=120, kill_after=None, resources=()):
        """Returns the exit code (negative: signal; None: killed by the test or hung) and the output.

        `resources`: limits as (kind, bytes).
        """

        def set_limits():
            for kind, most in resources:
                resource.setrlimit(kind, (most, most))
        with tempfile.TemporaryFile('w+') as said:
            p = subprocess.Popen(words, stdout=said, stderr=said, preexec_fn=set_limits if resources else None)
            timer = threading.Timer(kill_after or limit, p.kill)
            timer.start()
            _, status, usage = os.wait4(p.pid, 0)
            timer.cancel()
            said.seek(0)
            text = said.read()
        p.returncode = os.waitstatus_to_exitcode(status)
        with self.mutex:
            self.memory[self.tenth()] = max(self.memory[self.tenth()], usage.ru_maxrss)
        if p.returncode != -signal.SIGKILL:
            return p.returncode, text
        if kill_after is None:
            self.fail('hangs: ' + ' '.join(words))
        return None, text

    def fail(self, text):
        with self.mutex:
            self.wrong.append(text)
        print('WRONG', text, flush=True)

    def expect(self, what, code, text, allowed):
        with self.mutex:
            self.counts[what] += 1
            self.log.write('%s %s\n' % (what, code))
        if code not in allowed:
            self.fail('%s: exit %s, expected %s: %s' % (what, code, sorted(allowed), text.strip()[-300:]))

    # The expected verdict on the package's state.
    def verdict(self, p):
        if not os.path.exists(p.file):
            return {3}
        if p.damaged:
            return {DAMAGED}
        return {INCOMPLETE} if p.prepared[1] else {VALID}

    def verdict_against(self, p):
        if not os.path.exists(p.file) or p.damaged:
            return self.verdict(p)
        inputs, incomplete = p.prepared
        if inputs != p.inputs():
            return {STALE}
        return {INCOMPLETE} if incomplete else {VALID}

    def prepare(self, p, r):
        settings = r.choice([[], [], ['--thumbnail-size', '128'], ['--refine', 'off'], ['--memory', '600M']])
        words = [self.o.vantage, 'prepare', p.scene, '-o', p.file, '--progress', 'none', *settings]
        inputs, broken = p.inputs(), p.broken()
        usual = {INCOMPLETE} if broken else {0}
        trouble = r.choices(['none', 'killed', 'little memory', 'little room'], [7, 2, 1, 1])[0]
        if trouble == 'killed':
            if self.run(words, kill_after=r.uniform(0.02, 0.5))[0] is None:
                self.counts['prepare, killed'] += 1
        elif trouble == 'little memory':
            code, text = self.run(words, resources=[(resource.RLIMIT_AS, r.randrange(135, 300) * 1000000)])
            self.expect('prepare, ' + trouble, code, text, usual | {MEMORY})
        elif trouble == 'little room':
            code, text = self.run(words, resources=[(resource.RLIMIT_FSIZE, r.randrange(20000000))])
            self.expect('prepare, ' + trouble, code, text, usual | {STORAGE})
        # In any case, the next run must succeed.
        code, text = self.run(words)
        self.expect('prepare', code, text, usual)
        if code in (0, INCOMPLETE):
            p.prepared, p.damaged = (inputs, broken), False

    def change(self, p, r):
        photo = r.choice(p.photos)
        kind = r.choice(['exchange', 'exchange', 'truncate', 'remove', 'restore', 'restore'])
        if kind == 'exchange':
            content = p.good[r.choice(p.photos)]
        elif kind == 'truncate':
            content = p.good[photo][:500]
        else:
            content = p.good[photo]
        if kind == 'remove':
            if os.path.exists(p.path(photo)):
                os.remove(p.path(photo))
        else:
            with open(p.path(photo) + '.new', 'wb') as f:
                f.write(content)
            os.replace(p.path(photo) + '.new', p.path(photo))
        if p.usable() < 2:
            for photo in p.photos:
                with open(p.path(photo), 'wb') as f:
                    f.write(p.good[photo])
        self.counts['inputs, ' + kind] += 1

    def harm(self, p, r):
        if not os.path.exists(p.file):
            return
        kind = r.choice(['damage', 'truncate', 'delete'])
        if kind == 'delete':
            os.remove(p.file)
        else:
            # Change a copy, which then replaces the file, because readers may have the file open.
            with open(p.file, 'rb') as f:
                content = bytearray(f.read())
            if kind == 'truncate':
                content = content[:r.randrange(200, len(content) - 1)]
            else:
                at = r.randrange(len(content))
                # Damage a whole page: a single byte could be padding between chunks, which is not part of the package.
                for i in range(at, min(at + 4096, len(content))):
                    content[i] ^= 0x55
            with open(p.file + '.new', 'wb') as f:
                f.write(content)
            os.replace(p.file + '.new', p.file)
            p.damaged = True
        self.counts['package, ' + kind] += 1

    def check(self, p, r):
        code, text = self.run([self.o.vantage, 'check', '--deep', p.file])
        self.expect('check --deep', code, text, self.verdict(p))

    def check_against(self, p, r):
        code, text = self.run([self.o.vantage, 'check', '--deep', '--against', p.scene, p.file])
        self.expect('check --against', code, text, self.verdict_against(p))

    def refine(self, p, r):
        words = [self.o.vantage, 'refine', '--progress', 'none', '--exposure', r.choice(['on', 'off']), p.file]
        code, text = self.run(words)
        self.expect('refine', code, text, {0} if self.verdict(p) <= {VALID, INCOMPLETE} else {3, DAMAGED} | ({0} if p.damaged else set()))
        if code == 0 and p.damaged:  # damaged data was made again, or is still reported
            code, text = self.run([self.o.vantage, 'check', '--deep', p.file])
            self.expect('check --deep after refine', code, text, {0, DAMAGED})
            p.damaged = code == DAMAGED

    def extract(self, p, r):
        folder = p.file + '.extracted'
        code, text = self.run([self.o.vantage, 'extract', p.file, '-o', folder])
        allowed = {3} if not os.path.exists(p.file) else {0, DAMAGED} if p.damaged else {0, INCOMPLETE}
        self.expect('extract', code, text, allowed)
        shutil.rmtree(folder, ignore_errors=True)

    def show(self, p, r):
        picture = '%s.%d.png' % (p.file, threading.get_ident())
        name = os.path.splitext(r.choice(p.photos))[0]
        code, text = self.run([self.o.player, 'render', p.file, '--photo', name, '--scale', '0.5', '-q', '-o', picture])
        allowed = {3} if not os.path.exists(p.file) else {0, 2, 3, DAMAGED} if p.damaged else {0, 2}
        self.expect('show', code, text, allowed)
        if os.path.exists(picture):
            os.remove(picture)

    def read_while_written(self, p):
        """Reads a package that may be changing. Any verdict is allowed, but the commands must not crash or hang."""
        code, text = self.run([self.o.vantage, 'check', '--deep', p.file])
        self.expect('check while it may change', code, text, {0, 3, DAMAGED, INCOMPLETE})
        code, text = self.run([self.o.vantage, 'info', p.file])
        self.expect('info while it may change', code, text, {0, 3, DAMAGED})

    def work(self, seed, packages):
        r = random.Random(seed)
        steps = [(self.prepare, 4), (self.change, 4), (self.harm, 1), (self.check, 2), (self.check_against, 3),
                 (self.refine, 1), (self.extract, 1), (self.show, 1)]
        names, weights = zip(*steps)
        while time.time() < self.start + 60 * self.o.minutes:
            p = r.choice(packages)
            if p.lock.acquire(blocking=False):
                try:
                    r.choices(names, weights)[0](p, r)
                finally:
                    p.lock.release()
            else:
                self.read_while_written(p)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('folder')
    parser.add_argument('--vantage', required=True)
    parser.add_argument('--player', required=True)
    parser.add_argument('--scene', required=True, help='specification of a small synthetic scene, such as data/tiny.toml')
    parser.add_argument('--minutes', type=float, default=10)
    parser.add_argument('--workers', type=int, default=3)
    parser.add_argument('--packages', type=int, default=4)
    parser.add_argument('--seed', type=int, default=1)
    o = parser.parse_args()
    shutil.rmtree(o.folder, ignore_errors=True)
    os.makedirs(o.folder)
    os.environ['XDG_CACHE_HOME'] = os.path.join(o.folder, 'cache')
    template = os.path.join(o.folder, 'template')
    subprocess.run([o.vantage, 'synth', o.scene, '-o', template], check=True, stdout=subprocess.DEVNULL)
    packages = [Package(o.folder, i, template) for i in range(o.packages)]
    soak = Soak(o)
    workers = [threading.Thread(target=soak.work, args=(o.seed + i, packages)) for i in range(o.workers)]
    for w in workers:
        w.start()
    for w in workers:
        w.join()
    for what, n in sorted(soak.counts.items()):
        print('%-28s %6d' % (what, n))
    print('%-28s %6d' % ('operations', sum(soak.counts.values())))
    print('%-28s %6d' % ('wrong verdicts', len(soak.wrong)))
    print('peak memory, MB by tenth      ' + ' '.join('%d' % (soak.memory[t] / 1000) for t in range(10)))
    return 1 if soak.wrong else 0


sys.exit(main())
