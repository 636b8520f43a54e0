"""Reads LightBurn projects with MeerK40t and records what it found: tests/fixtures/recorded/lbrn2.json.

    pip install --no-deps meerk40t==0.9.9100 && pip install numpy Pillow
    KERFWAY_PROGRAMS=programs cargo test --features png --test it recorded
    python tests/oracle/lbrn2.py programs

Every shape that MeerK40t reads is compared with the plan, in cutting order: elements end where planned, curves lie on their arc. `off` is the largest
distance, mm. LightBurn itself runs on no machine of ours.
"""

import hashlib
import json
import math
import sys
from contextlib import nullcontext
from pathlib import Path

from meerk40t.core.units import UNITS_PER_MM
from meerk40t.extra.lbrn import LbrnLoader

FIXTURE = Path(__file__).parents[1] / 'fixtures' / 'recorded' / 'lbrn2.json'
# Places at which a curve is measured.
PLACES = [k / 8 for k in range(9)]


class Node:
    """What the reader needs of MeerK40t's tree: it adds layers and shapes, and refers from one to the other."""

    def __init__(self, **values):
        self.values, self.children, self.of = values, [], None

    def add(self, **values):
        self.children.append(Node(**values))
        return self.children[-1]

    def add_reference(self, node):
        node.of = self

    def remove_all_children(self):
        self.children.clear()

    def focus(self):
        """The reader ends with the file in view."""


class Elements:
    """Its element service."""

    def __init__(self):
        self.op_branch, self.elem_branch, self.node_lock = Node(), Node(), nullcontext()


def place(p: complex) -> tuple[float, float]:
    return p.real / UNITS_PER_MM, p.imag / UNITS_PER_MM


def read(file: Path) -> list[dict]:
    """The shapes of a project: elements as functions of a share from 0 to 1, in mm, with speed in mm/s and power in per cent."""
    elements = Elements()
    with file.open('rb') as source:
        LbrnLoader.parse(str(file), source, elements)
    shapes = []
    for node in elements.elem_branch.children[0].children:
        if node.values['type'] != 'elem path':
            raise ValueError(node.values['type'])
        geometry = node.values['geometry']
        pieces = [[place(geometry.position(k, t)) for t in PLACES] for k in range(geometry.index)]
        shapes.append({'pieces': pieces, 'speed': node.of.values['speed'], 'power': node.of.values['power'] / 10})
    return shapes


def distance(shape: dict, planned: dict) -> float:
    """Follows both paths and returns the largest distance between them."""
    pieces = iter(shape['pieces'])
    at = planned['from']
    off = 0.0
    for element in planned['path']:
        to = element['to']
        turned = 0.0
        while True:
            piece = next(pieces)
            off = max(off, math.dist(piece[0], at))
            if 'center' not in element:
                break
            center = element['center']
            off = max(off, *(abs(math.dist(center, p) - math.dist(center, to)) for p in piece))
            angles = [math.atan2(p[1] - center[1], p[0] - center[0]) for p in (piece[0], piece[-1])]
            turned += math.remainder(angles[1] - angles[0], math.tau)
            at = piece[-1]
            if abs(turned - element['sweep']) < 0.01 * abs(element['sweep']):
                break
        off = max(off, math.dist(piece[-1], to))
        at = to
    if next(pieces, None) is not None:
        raise ValueError('elements are left over')
    return off


def main(folder: str) -> None:
    files = {}
    for file in sorted(Path(folder).glob('*.lbrn2')):
        planned = json.loads(Path(f'{file}.json').read_text())['cuts']
        shapes = read(file)
        assert len(shapes) == len(planned), (file.name, len(shapes), len(planned))
        same = all(abs(s[w] - p[w]) < 1e-3 for s, p in zip(shapes, planned) for w in ('speed', 'power'))
        off = max((distance(s, p) for s, p in zip(shapes, planned)), default=0.0)
        files[file.name] = {'sha256': hashlib.sha256(file.read_bytes()).hexdigest(), 'cuts': len(shapes), 'off': round(off, 6), 'settings': same}
    FIXTURE.write_text(json.dumps({'reader': 'MeerK40t 0.9.9100, meerk40t/extra/lbrn.py', 'files': files}, indent=1) + '\n')
    print(len(files), 'files, at most', max(f['off'] for f in files.values()), 'mm off;', all(f['settings'] for f in files.values()))


if __name__ == '__main__':
    main(*sys.argv[1:])
