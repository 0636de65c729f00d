#!/usr/bin/env python3
"""Compares the decisions of `vantage prepare` about its four joint effects with independently measured gains.

    outside_gain.py SCENE... --build BUILD --kit KIT [--every 2] [--results FOLDER]

SCENE is a folder made by disturb.py, with scan/ and truth/. The validation gain, its error and the decision come from
preparing the whole scan. For the independent gain, each photo in turn is held out completely, so that only its camera is
known. Its view is rendered once with the effect off and once with it on; the other effects are set as decided. The kit
compares both pictures with the true photo (compare.py computes the PSNR after the best gain per channel, over the pixels
that all variants color). Errors are standard errors of the mean over the photos.

The held-out photo has its true camera, and the others have their cameras from the scan, because a wrong camera for the
held-out photo would hide how pose_refinement affects the others. If pose_refinement was turned on for the whole scan,
prepare decides about it again for the remaining photos; if the decision is then "off", it is forced on. If it was off for the
whole scan, "on" means `--effect pose-refinement=on`.

A decision is right if the effect is on when the independent gain is above 0.05 dB, and off when that gain is below -0.05 dB."""
import argparse
import json
import os
import re
import shutil
import subprocess
import sys

import numpy as np

EFFECTS = ['exposure', 'vignetting', 'pose_refinement', 'transients']
MARGIN = 0.05  # dB


def run(command):
    done = subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        sys.exit('%s: exit %d\n%s' % (' '.join(map(str, command)), done.returncode, done.stderr[-2000:]))
    return done.stdout


class Programs:
    def __init__(self, build, kit):
        self.vantage = os.path.join(build, 'pipeline', 'vantage')
        self.player = os.path.join(build, 'player', 'vantage-player')
        self.compare = os.path.join(kit, 'compare.py')

    def prepare(self, scan, package, cameras=None, choices=None, hold_out=None):
        """Prepares the scan and returns the package's effects by name."""
        command = [self.vantage, 'prepare', '--mesh', scan + '/mesh.ply', '--photos', scan + '/images',
                   '--cameras', cameras or scan + '/sparse', '-o', package, '--no-report', '--progress', 'none']
        if choices:
            command += ['--effect'] + ['%s=%s' % c for c in choices.items()]
        if hold_out:
            command += ['--hold-out', hold_out]
        run(command)
        return {e['name']: e for e in json.loads(run([self.vantage, 'info', '--json', package]))['effects']}

    def render(self, package, name, folder):
        os.makedirs(folder, exist_ok=True)
        run([self.player, 'render', package, '--photo', name, '--scale', '0.5', '--samples', '1', '-q', '-o',
             '%s/%s.png' % (folder, name)])

    def scores(self, truth, folders, name):
        """The PSNR of each folder's picture after the best gain per channel, by label."""
        renders = [x for label, folder in folders.items() for x in ('--renders', label + '=' + folder)]
        out = json.loads(run([sys.executable, self.compare, '--reference', truth, '--names', name, '--scale', '0.5', '--json',
                              *renders]))
        return {label: r['photos'][name]['psnr_gain'] for label, r in out.items()}


def cameras_with_true_one(scene, name, folder):
    """Copies the scan's cameras, but gives one photo its true pose. Returns the folder."""
    def poses(which):
        with open(os.path.join(scene, which, 'sparse', 'images.txt')) as f:
            return [line.rstrip('\n') for line in f if line.strip()]
    os.makedirs(folder, exist_ok=True)
    shutil.copy(os.path.join(scene, 'scan', 'sparse', 'cameras.txt'), folder)
    own = name + '.png'
    with open(os.path.join(folder, 'images.txt'), 'w') as f:
        for given, true in zip(poses('scan'), poses('truth')):
            print(true if true.split()[-1] == own else given, end='\n\n', file=f)
    return folder


def applied(effects, effect):
    """Whether the effect changes anything."""
    return effects[effect]['on'] and not (effect == 'vignetting' and effects[effect]['measured'] == 0)


def gains_of_photo(programs, scene, name, decided, work):
    """The gain of each effect in dB, measured on a held-out photo."""
    shutil.rmtree(work, ignore_errors=True)
    scan, package = os.path.join(scene, 'scan'), os.path.join(work, 'p.vantage')
    cameras = cameras_with_true_one(scene, name, os.path.join(work, 'sparse'))
    registering = ['auto', 'on'] if decided['pose_refinement'] else ['on']  # remaining choices to try

    def prepare(on):
        while True:
            choices = {e: 'on' if on[e] else 'off' for e in EFFECTS}
            if on['pose_refinement']:
                choices['pose_refinement'] = registering[0]
            effects = programs.prepare(scan, package, cameras, choices, name)
            if not on['pose_refinement'] or applied(effects, 'pose_refinement') or len(registering) == 1:
                return effects
            registering.pop(0)

    base, folders = prepare(decided), {'base': os.path.join(work, 'base')}
    programs.render(package, name, folders['base'])
    for effect in ['exposure', 'vignetting', 'transients', 'pose_refinement']:  # pose refinement last: the others keep the cameras
        effects = prepare({**decided, effect: not decided[effect]})
        if applied(effects, effect) != applied(base, effect):
            folders[effect] = os.path.join(work, effect)
            programs.render(package, name, folders[effect])
    score = programs.scores(os.path.join(scene, 'truth'), folders, name)
    return {e: (score['base'] - score[e]) * (1 if decided[e] else -1) if e in score else 0.0 for e in EFFECTS}


def measure(programs, scene, every, work):
    """The validation results of each effect, and its gains on the held-out photos."""
    effects = programs.prepare(os.path.join(scene, 'scan'), os.path.join(work, 'full.vantage'))
    decided = {e: effects[e]['on'] for e in EFFECTS}
    names = sorted(os.path.splitext(f)[0] for f in os.listdir(os.path.join(scene, 'truth', 'images')))[::every]
    gains = {n: gains_of_photo(programs, scene, n, decided, os.path.join(work, 'held_out')) for n in names}
    return {e: {'on': decided[e], 'validated': effects[e].get('validated'), 'evidence': effects[e]['evidence'],
                'outside': {n: gains[n][e] for n in names}} for e in EFFECTS}


def judgment(effect):
    """The validation gain and its error. If a pose refinement was rejected, they are only in
    the evidence, whose last entry is the last attempt."""
    if effect['validated']:
        return '%+.2f ± %.2f dB' % (effect['validated']['gain'], effect['validated']['error'])
    found = re.findall(r'held-out photos (gain|lose) ([0-9.]+) dB \(standard error ([0-9.]+)', effect['evidence'])
    return '%s%s ± %s dB' % ('-' if found[-1][0] == 'lose' else '+', *found[-1][1:]) if found else '—'


def rows(scene, measured):
    for effect in EFFECTS:
        m = measured[effect]
        gains = np.array(list(m['outside'].values()))
        mean, error = gains.mean(), gains.std(ddof=1) / np.sqrt(len(gains))
        right = 'either' if abs(mean) <= MARGIN else 'yes' if m['on'] == (mean > 0) else '**no**'
        yield '| %s | %s | %s | %s | %+.2f ± %.2f dB | %s |' % (
            scene, effect, judgment(m), 'on' if m['on'] else 'off', mean, error, right)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('scenes', nargs='+', metavar='SCENE')
    parser.add_argument('--build', required=True, help='build folder of Vantage')
    parser.add_argument('--kit', required=True, help='folder of the measurement kit')
    parser.add_argument('--every', type=int, default=1, help='hold out only every nth photo')
    parser.add_argument('--results', default='held_out_results',
                        help='folder for one JSON file per scene; those there are not measured again')
    a = parser.parse_args()
    os.makedirs(a.results, exist_ok=True)
    programs, work = Programs(a.build, a.kit), os.path.join(a.results, 'work')
    print("| scene | effect | validation gain | decision | gain from outside | right? |\n|---|---|---|---|---|---|")
    for scene in a.scenes:
        name = os.path.basename(os.path.normpath(scene))
        stored = os.path.join(a.results, name + '.json')
        if not os.path.exists(stored):
            os.makedirs(work, exist_ok=True)
            measured = measure(programs, scene, a.every, work)
            with open(stored, 'w') as f:
                json.dump(measured, f, indent=1)
            shutil.rmtree(work)
        with open(stored) as f:
            print('\n'.join(rows(name, json.load(f))), flush=True)


if __name__ == '__main__':
    main()
