"""Runs programs through LinuxCNC's interpreter and records what it found: tests/fixtures/recorded/rs274.json.

    apt-get download linuxcnc-uspace libboost-python1.74.0     # Debian 12
    for f in *.deb; do dpkg -x "$f" linuxcnc; done
    KERFWAY_PROGRAMS=programs cargo test --features png --test it recorded
    python tests/oracle/rs274.py linuxcnc programs

`rs274` ends with 0 for a program that it accepts, and prints the canonical commands that it makes of it.
"""

import hashlib
import json
import os
import re
import subprocess
import sys
from pathlib import Path

FIXTURE = Path(__file__).parents[1] / 'fixtures' / 'recorded' / 'rs274.json'


def run(binary: Path, program: Path) -> dict:
    libraries = [binary.parents[1] / 'lib', binary.parents[1] / 'lib' / 'x86_64-linux-gnu']
    environment = {**os.environ, 'LD_LIBRARY_PATH': ':'.join(map(str, libraries))}
    table = program.parent / 'empty.tbl'
    table.touch()
    done = subprocess.run([binary, '-t', table, '-g', program], env=environment, capture_output=True, text=True)
    dwells = [float(s) for s in re.findall(r'DWELL\(([\d.]+)\)', done.stdout)]
    count = {name: len(re.findall(rf'\b{name}\(', done.stdout)) for name in ('STRAIGHT_TRAVERSE', 'STRAIGHT_FEED', 'ARC_FEED')}
    if done.returncode != 0:
        print(program.name, done.stderr[-400:], done.stdout[-400:], file=sys.stderr)
    return {'sha256': hashlib.sha256(program.read_bytes()).hexdigest(), 'exit': done.returncode, 'dwell': round(sum(dwells), 6), **count}


def main(unpacked: str, programs: str) -> None:
    [binary] = Path(unpacked).rglob('bin/rs274')
    runs = {p.name: run(binary, p) for p in sorted(Path(programs).glob('*.ngc'))}
    FIXTURE.write_text(json.dumps({'interpreter': 'LinuxCNC rs274, Debian 12 package linuxcnc-uspace 2.9.0~pre1', 'programs': runs}, indent=1) + '\n')
    print(len(runs), 'programs,', sum(r['exit'] != 0 for r in runs.values()), 'refused')


if __name__ == '__main__':
    main(*sys.argv[1:])
