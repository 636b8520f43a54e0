"""Reads Ruida files with MeerK40t and records what it found: tests/fixtures/recorded/rdjob.json.

    pip install --no-deps meerk40t==0.9.9100 && pip install numpy
    KERFWAY_PROGRAMS=programs cargo test --features png --test it recorded
    python tests/oracle/rdjob.py programs

Every vertex that MeerK40t reads is compared with the plan: lines end where planned, chords lie on their arc. `off` is the largest distance, mm.
"""

import hashlib
import json
import math
import sys
from pathlib import Path

from meerk40t.ruida.rdjob import abscoord, decode_bytes, parse_commands, parse_power, parse_speed

FIXTURE = Path(__file__).parents[1] / 'fixtures' / 'recorded' / 'rdjob.json'
# How far chords may leave their arc, mm: src/output/rd.rs.
CHORD = 0.005


def read(file: Path) -> list[dict]:
    """The cuts of a file: the vertices in mm, speed in mm/s, largest and least power in per cent."""
    cuts: list[dict] = []
    speed = power = least = None
    for command in parse_commands(decode_bytes(file.read_bytes())):
        if command[0] in (0x88, 0xA8):
            point = [abscoord(command[1:6]) / 1000, abscoord(command[6:11]) / 1000]
            if command[0] == 0x88:
                cuts.append({'points': [point], 'speed': speed, 'power': power, 'least': least})
            else:
                cuts[-1]['points'].append(point)
        elif command[:2] == b'\xc9\x02':
            speed = parse_speed(command[2:7])
        elif command[:2] == b'\xc6\x02':
            power = parse_power(command[2:4])
        elif command[:2] == b'\xc6\x01':
            least = parse_power(command[2:4])
    return cuts


def distance(cut: dict, planned: dict) -> float:
    """Follows both paths and returns the largest distance between them, beyond what chords are allowed."""
    points = iter(cut['points'])
    at = planned['from']
    off = math.dist(next(points), at)
    for element in planned['path']:
        to = element['to']
        if 'center' not in element:
            off = max(off, math.dist(next(points), to))
        else:
            center, sweep = element['center'], element['sweep']
            radius = math.dist(center, to)
            last, turned = at, 0.0
            while True:
                point = next(points)
                off = max(off, abs(math.dist(center, point) - radius))
                middle = [(point[0] + last[0]) / 2, (point[1] + last[1]) / 2]
                off = max(off, radius - math.dist(center, middle) - CHORD)
                turn = math.atan2(point[1] - center[1], point[0] - center[0]) - math.atan2(last[1] - center[1], last[0] - center[0])
                turned += math.remainder(turn, math.tau)
                last = point
                if math.dist(point, to) <= 0.002 and abs(turned - sweep) < 0.3 * abs(sweep) + 0.01:
                    break
            off = max(off, math.dist(last, to))
        at = to
    if next(points, None) is not None:
        raise ValueError('points are left over')
    return off


def main(folder: str) -> None:
    files = {}
    for file in sorted(Path(folder).glob('*.rd')):
        planned = json.loads(Path(f'{file}.json').read_text())['cuts']
        cuts = read(file)
        assert len(cuts) == len(planned), (file.name, len(cuts), len(planned))
        # A power is 14 bits, and MeerK40t divides by 16384 instead of 16383.
        same = all(abs(c['speed'] - p['speed']) < 1e-3 and all(abs(c[w] - p[w]) < 0.02 for w in ('power', 'least')) for c, p in zip(cuts, planned))
        off = max((distance(c, p) for c, p in zip(cuts, planned)), default=0.0)
        files[file.name] = {'sha256': hashlib.sha256(file.read_bytes()).hexdigest(), 'cuts': len(cuts), 'off': round(off, 6), 'settings': same}
    FIXTURE.write_text(json.dumps({'reader': 'MeerK40t 0.9.9100, meerk40t/ruida/rdjob.py', 'files': files}, indent=1) + '\n')
    print(len(files), 'files, at most', max(f['off'] for f in files.values()), 'mm off;', all(f['settings'] for f in files.values()))


if __name__ == '__main__':
    main(*sys.argv[1:])
