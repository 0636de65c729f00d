#!/usr/bin/env python3
"""Runs every command in the README and the guides as it is written there.

    documented_commands.py VANTAGE VANTAGE_PLAYER SOURCE_FOLDER [--all] [PAGE...]     --all: also run slow commands

Commands are the lines of code blocks that run vantage or vantage-player. Each page has a temporary folder, in which its commands
run in order through `bash -c`. Inputs that no command of the page writes are made first. A command must end with exit code 0,
and its outputs must exist. A window is closed by SIGTERM after its first picture, and must not have reported an error. A
turntable's video is interrupted by SIGINT after its first frames. If a block shows the output of the commands before it, these
must print the first words of its lines. There are only two substitutions: https://example.org and https://museum.org are
replaced by a server of this test, and the folders /collection and /scans are replaced by folders of the page.
"""
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

sys.dont_write_bytecode = True  # beside the sources
from code_blocks import blocks, command_of, first_words, pages, words_of
from inputs import Inputs, server

FEWEST = 60  # commands in all pages
DIFFERENT = 10  # exit code of diff
INTERRUPTED = 8
# Commands that take more than a few seconds of processor time on a small scene.
LONG = re.compile(r'vantage-player (video|orthophoto|evaluate|bench|smoothness)|--panorama|--extent|vantage (align|costs)|synth data/demo|inspect demo|data/hard')
ERROR = re.compile(r'(?m)^vantage(-player)?: ')


class Commands:
    def __init__(self, home, programs, source, at_length):
        self.home, self.source, self.at_length = home, source, at_length
        for name, folder, file in zip(('vantage', 'vantage-player'), ('pipeline', 'player'), programs):
            for link in (home / 'bin' / name, home / 'build' / folder / name):
                link.parent.mkdir(parents=True, exist_ok=True)
                link.symlink_to(file)
        self.environment = {name: value for name, value in os.environ.items() if not name.lower().endswith('_proxy')} | {
            'PATH': f'{home}/bin:{os.environ["PATH"]}', 'DISPLAY': '', 'WAYLAND_DISPLAY': '', 'LC_ALL': 'C.UTF-8',
            **{f'XDG_{name}_HOME': f'{home}/{name.lower()}' for name in ('CONFIG', 'CACHE', 'STATE', 'DATA')}}
        self.inputs = Inputs(home, source, self.environment, at_length)
        self.server = server(self.inputs.package)
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        described = subprocess.run([programs[1], '--describe'], capture_output=True, text=True, check=True).stdout
        self.without_window = {verb['name'] for verb in json.loads(described)['verbs']} - {'kiosk', 'headset'}
        self.found = self.ran = self.failed = 0

    def is_window(self, words):
        return words[0].endswith('vantage-player') and (words + [''])[1] not in self.without_window

    def why_not(self, command, words):
        """The reason why a command cannot be run; an empty string if it can."""
        if not self.at_length and LONG.search(command):
            return 'only with --all'
        if 'headset' in words and not (os.environ.get('XR_RUNTIME_JSON') or os.path.exists('/etc/xdg/openxr/1/active_runtime.json')):
            return 'there is no OpenXR runtime'
        if self.is_window(words) and not self.environment['DISPLAY']:
            return 'Xvfb is not installed'
        video = 'video' in words and words[-1].endswith(('.mp4', '.webm'))
        return 'ffmpeg is not installed' if video and not shutil.which('ffmpeg') else ''

    def run(self, command, folder):
        """The exit code and the output."""
        done = subprocess.run(['bash', '-c', command], cwd=folder, env=self.environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        return done.returncode, done.stdout

    def run_video(self, command, folder):
        """The exit code of a video command (0 if it was interrupted while frames were drawn, as intended) and its output."""
        log = self.home / 'log'
        with log.open('w') as out:
            video = subprocess.Popen(['bash', '-c', 'exec ' + command], cwd=folder, env=self.environment, stdin=subprocess.DEVNULL,
                                     stdout=out, stderr=out)
        while video.poll() is None and not re.search(r'frames  [1-9]', log.read_text()):
            time.sleep(0.05)
        interrupted = video.poll() is None
        if interrupted:
            video.send_signal(signal.SIGINT)
        code = video.wait()
        return 0 if interrupted and code == INTERRUPTED else code, log.read_text()

    def run_window(self, command, folder):
        """Closes a window after its first picture. Returns 0, or a description of what went wrong, and the output."""
        log = self.home / 'log'
        with log.open('w') as out:
            window = subprocess.Popen(['bash', '-c', command], cwd=folder, env=self.environment, stdin=subprocess.DEVNULL, stdout=out,
                                      stderr=out, start_new_session=True)
        until = time.monotonic() + 120
        while window.poll() is None and 'first picture after' not in log.read_text() and time.monotonic() < until:
            time.sleep(0.05)
        ended = window.poll()
        if ended is None:
            os.killpg(window.pid, signal.SIGTERM)
            try:
                window.wait(60)
                fault = 0 if 'first picture after' in log.read_text() else 'none, without a picture'
            except subprocess.TimeoutExpired:
                os.killpg(window.pid, signal.SIGKILL)
                fault = 'none, after SIGTERM'
        else:
            fault = f'{ended}, before it was closed'
        return fault or ('0, but an error' if ERROR.search(log.read_text()) else 0), log.read_text()

    def make_folder(self, folder, page):
        folder.mkdir(parents=True)
        (folder / 'data').symlink_to(self.source / 'data')
        (folder / 'build').symlink_to(self.home / 'build')
        if beside := self.inputs.beside.get(page):
            beside(folder)

    def faults(self, command, folder, page):
        """Runs a command; returns its faults and its output."""
        words = words_of(command)
        # verify writes the output of -o only if pictures differ.
        named = {'>', '--junit'} if 'verify' in words else {'>', '--junit', '-o', '--output'}
        written = [after for word, after in zip(words, words[1:]) if word in named]
        try:
            if not folder.exists():
                self.make_folder(folder, page)
            for word in words:
                if word not in written:
                    self.inputs.need(folder / word, word, page)
        except (OSError, subprocess.CalledProcessError, StopIteration) as e:
            return [f'an input cannot be made: {e!r}'], ''
        long_video = 'video' in words and '--turntable' in words
        run = self.run_window if self.is_window(words) else self.run_video if long_video else self.run
        code, said = run(command, folder)
        self.ran += 1
        faults = [] if code == 0 or code == DIFFERENT and 'diff' in words else [f'exit code {code}']
        for file in (folder / name for name in written if not long_video):
            if not file.exists() or not (any(file.iterdir()) if file.is_dir() else file.stat().st_size):
                faults.append(f'{file.name} is missing or empty')
        return faults, said

    def fail(self, place, text):
        self.failed += 1
        print(f'{place}: {text}', flush=True)

    def run_page(self, page):
        folder = self.home / 'pages' / Path(page).stem
        found, ran, said = self.found, self.ran, ''
        for block in blocks(self.source / page):
            commands = [(number, command) for number, line in block if (command := command_of(line))]
            shown = first_words('\n'.join(line for _, line in block))
            absent = set(shown) - set(first_words(said))
            if not commands and 0 < len(absent) < len(set(shown)):
                self.fail(f'{page}:{block[0][0]}', f'shown, but not printed: {" ".join(sorted(absent))}')
            said = '' if commands else said
            for number, command in commands:
                self.found += 1
                run = re.sub(r'https://(example|museum)\.org', f'http://127.0.0.1:{self.server.server_port}', command)
                run = re.sub(r'(?<=\s)/(collection|scans)\b', r'\1', run)
                if why := self.why_not(run, words_of(run)):
                    print(f'{page}:{number}: skipped, {why}: {command}')
                    continue
                start = used()
                faults, printed = self.faults(run, folder, page)
                said += printed
                if '--times' in sys.argv:
                    print(f'{used() - start:6.1f} s  {page}:{number}: {command}', flush=True)
                if faults:
                    self.fail(f'{page}:{number}', f'{", ".join(faults)}: {command}\n    ' + '\n    '.join(printed.splitlines()[-4:]))
        shutil.rmtree(folder, ignore_errors=True)
        if self.found > found:
            print(f'{page}: ran {self.ran - ran} of {self.found - found} commands', flush=True)


def used():
    """The processor time, in seconds, of all programs that have ended."""
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return children.ru_utime + children.ru_stime


def start_xvfb(environment):
    if not shutil.which('Xvfb'):
        return None
    xvfb = subprocess.Popen(['Xvfb', '-displayfd', '1', '-screen', '0', '1920x1080x24', '-nolisten', 'tcp'], stdout=subprocess.PIPE,
                            stderr=subprocess.DEVNULL, text=True)
    environment['DISPLAY'] = ':' + xvfb.stdout.readline().strip()
    return xvfb


def main():
    source = Path(sys.argv[3]).resolve()
    chosen = [argument for argument in sys.argv[4:] if not argument.startswith('--')]
    with tempfile.TemporaryDirectory(prefix='documented-') as home:
        commands = Commands(Path(home), [Path(p).resolve() for p in sys.argv[1:3]], source, '--all' in sys.argv)
        xvfb = start_xvfb(commands.environment)
        try:
            for page in chosen or pages(source):
                commands.run_page(page)
        finally:
            if xvfb:
                xvfb.terminate()
                xvfb.wait()
    print(f'{commands.ran} of {commands.found} commands in {used():.0f} s of processor time, {commands.failed} failed')
    if not chosen and commands.found < FEWEST:
        print(f'{commands.found} commands found, expected at least {FEWEST}')
        return 1
    return 1 if commands.failed else 0 if commands.ran else 77


sys.exit(main())
