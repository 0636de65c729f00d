#!/usr/bin/env python3
"""Tests all verbs of both programs, as listed by --describe. Each must support --help, --version, -q and --json, return the
expected exit codes, and report errors in one line. Results printed by --json must match docs/results.schema.json.

    walk_verbs.py VANTAGE VANTAGE_PLAYER SOURCE_FOLDER [--quick] [--table]

--quick: only run each verb once with --json and with two errors; --table: print a table of the runs
"""
import json
import os
import re
import subprocess
import sys
import tempfile

import jsonschema

PROGRAMS = dict(zip(('vantage', 'vantage-player'), map(os.path.abspath, sys.argv[1:3])))
SOURCE = os.path.abspath(sys.argv[3])
QUICK = '--quick' in sys.argv
SCHEMA = json.load(open(os.path.join(SOURCE, 'docs/results.schema.json')))

# For each verb, the arguments of a successful run in a folder with the scene and its package. Each run replaces the files of
# the previous run. None means that the verb shows a window until it is closed.
SUCCEEDS = {
    'vantage synth': 'tiny.toml -o scene',
    'vantage inspect': 'scene',
    'vantage align': 'scene -o aligned.toml',
    'vantage prepare': 'scene -o p.vantage',
    'vantage merge': 'one.shard two.shard -o merged.vantage',
    'vantage refine': 'p.vantage --effect exposure=off -o refined.vantage',
    'vantage repack': 'p.vantage -o repacked.vantage',
    'vantage info': 'p.vantage',
    'vantage check': 'p.vantage --deep',
    'vantage diff': 'p.vantage p.vantage',
    'vantage extract': 'p.vantage -o files --photo 0001',
    'vantage thumbnail': 'p.vantage -o small.png',
    'vantage costs': f'{SOURCE}/configs/costs.json -o costs',
    'vantage-player kiosk': None,
    'vantage-player headset': None,
    'vantage-player render': 'p.vantage --photo 0001 -o picture.png',
    'vantage-player video': 'p.vantage --turntable --seconds 0.1 --size 64x48 -o frames',
    'vantage-player orthophoto': 'p.vantage --resolution 0.2 -o plan.tif',
    'vantage-player list': 'p.vantage',
    'vantage-player evaluate': 'p.vantage --photo 0001 --level 1 -o evaluation',
    'vantage-player verify': 'p.vantage --golden golden --size 64x48 --update',
    'vantage-player bench': 'p.vantage --paths still --modes resident --path-frames 2 --size 64x48 -o flights',
    'vantage-player smoothness': 'p.vantage --step 30 --size 64x48 -o steps',
}
# The tiny scene has too few features for align, so align reports an error.
ENDS_WITH = {'vantage align': 13}
# Arguments that name a missing file, for verbs that also need other arguments.
MISSING = {
    'vantage synth': 'none.toml -o none',
    'vantage inspect': 'none',
    'vantage align': 'none -o none.toml',
    'vantage prepare': 'none -o none.vantage',
    'vantage merge': 'none.shard -o none.vantage',
    'vantage diff': 'none.vantage p.vantage',
    'vantage costs': 'none -o none',
    'vantage-player orthophoto': 'none.vantage --resolution 1 -o none.png',
    'vantage-player verify': 'none.vantage --golden golden',
}

faults = []


def expect(holds, command, what):
    if not holds:
        faults.append(f'{command}: {what}')


def run(command, arguments):
    program, *verb = command.split()
    done = subprocess.run([PROGRAMS[program], *verb, *arguments], capture_output=True, text=True, timeout=300,
                          env=os.environ | {'DISPLAY': '', 'WAYLAND_DISPLAY': '', 'XDG_CACHE_HOME': os.getcwd()})
    return done.returncode, done.stdout, done.stderr


def results(command, code, text):
    """The JSON object, validated against the schema; an empty object if it is invalid."""
    try:
        out = json.loads(text)
        jsonschema.Draft202012Validator(SCHEMA).validate(out)
    except (ValueError, jsonschema.ValidationError) as e:
        expect(False, command, f'--json: {str(e).splitlines()[0]}: {text[:200]}')
        return {}
    expect(out['command'] == command and out['exit_code'] == code, command, f'--json: {out["command"]}, {code}')
    return out


def fails(command, arguments, codes, word):
    """Expects one line that contains the word, and the same exit code with and without --json. Returns the exit code."""
    code, out, err = run(command, arguments)
    lines = [line for line in err.splitlines() if line]
    one_line = len(lines) == 1 and lines[0].startswith(command.split()[0] + ': ') and word in lines[0]
    expect(code in codes and (one_line or word in out), command, f'{arguments}: {code} {lines}')
    if QUICK:
        return code
    code_json, text, _ = run(command, [*arguments, '--json'])
    said = results(command, code_json, text)
    expect(code_json == code, command, f'{arguments}: {code}, with --json {code_json}')
    expect('error' in said or 'packages' in said or not SUCCEEDS[command], command, f'{arguments}: --json does not say what is wrong')
    return code


def succeeds(command, arguments):
    """Expects text by default, no output with -q, and JSON with --json. Returns the exit code."""
    if command == 'vantage merge':
        for name, i in (('one', 1), ('two', 2)):
            run('vantage prepare', ['scene', '-o', f'{name}.shard', '--shard', f'{i}/2'])
    wanted = ENDS_WITH.get(command, 0)
    if not QUICK:
        code, out, err = run(command, arguments)
        expect(code == wanted and out, command, f'{code}, printed {out[:80]!r} {err[-200:]!r}')
        code, out, err = run(command, [*arguments, '-q'])
        expect(code == wanted and not out and bool(err) == bool(wanted), command, f'-q: {code}, printed {out + err!r}')
    code, out, err = run(command, [*arguments, '--json'])
    expect(bool(results(command, code, out).get('error')) == bool(wanted), command, f'--json: {out[:200]}')
    return code


def describes_itself(command):
    """Tests --version and --help of one verb."""
    code, version, _ = run(command, ['--version'])
    expect(code == 0 and version.startswith(command.split()[0] + ' '), command, f'--version: {code} {version}')
    code, text, _ = run(command, ['--help'])
    expect(code == 0 and text.splitlines() and f'Usage: {command}' in text, command, '--help')
    program, verb = command.split()
    expect(run(program, ['help', verb])[1] == text, command, f'differs from {program} help {verb}')


def walk(command):
    """Tests one verb; returns its row of the table."""
    if not QUICK:
        describes_itself(command)
    row = [f'`{command}`', 'not tried' if QUICK else 'yes']
    shown = SUCCEEDS[command] is None
    row.append('a window' if shown else str(succeeds(command, SUCCEEDS[command].split())))
    row.append(str(fails(command, ['--sparkle'], [2], '--sparkle')))
    row.append(str(fails(command, MISSING.get(command, 'none.vantage -o none.png' if '-o' in (SUCCEEDS[command] or '')
                                              else 'none.vantage').split(), [3], 'none')))
    return row


def options_say_why():
    """Tests the messages for options that cannot have an effect."""
    _, out, _ = run('vantage prepare', ['scene', '-o', 'p.vantage', '--explain'])
    expect('is current' in out and 'explain' in out, 'vantage prepare', f'--explain of a current package: {out}')
    open('church.toml', 'w').close()
    code, _, err = run('vantage align', ['church.toml', '-o', 'a.toml'])
    expect(code == 2 and 'found a scene file' in err, 'vantage align', f'of a scene file: {code} {err}')
    code, _, err = run('vantage-player evaluate', ['p.vantage', '--show', 'coverage'])
    expect(code == 2 and 'no option --show' in err, 'vantage-player evaluate', f'scores false colors: {code} {err}')
    expect('scene file' not in run('vantage align', ['--help'])[1].split('Options')[0], 'vantage align', '--help')


def main():
    commands = []
    for program, file in PROGRAMS.items():
        described = json.loads(subprocess.run([file, '--describe'], capture_output=True, text=True, check=True).stdout)
        commands += [f'{program} {verb["name"]}' for verb in described['verbs']]
    expect(set(commands) == set(SUCCEEDS), 'verbs', sorted(set(commands) ^ set(SUCCEEDS)))
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        with open(f'{SOURCE}/data/tiny.toml') as spec, open('tiny.toml', 'w') as quick:
            quick.write(re.sub('samples = .*', 'samples = 1', spec.read()))
        first = ('vantage synth', 'vantage prepare')
        rows = {c: walk(c) for c in sorted(commands, key=lambda c: first.index(c) if c in first else len(first))}
        options_say_why()
        os.chdir('/')
    if '--table' in sys.argv:
        print('| command | `--help`, `--version` | works, `-q`, `--json` | unknown option | missing file |\n|---|---|---|---|---|')
        for c in commands:
            print('| ' + ' | '.join(rows[c]) + ' |')
    for fault in faults:
        print(fault, file=sys.stderr)
    return bool(faults)


sys.exit(main())
