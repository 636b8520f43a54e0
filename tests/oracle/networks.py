"""Writes tests/fixtures/networks.json: 40 seeded sheets of touching and nested parts, and the areas of the faces that Shapely's
`polygonize` finds among their lines. tests/it/sheet/networks.rs reads it.

    pip install shapely && python tests/oracle/networks.py
"""

import json
import math
import random
from pathlib import Path

from shapely import polygonize, unary_union
from shapely.geometry import LineString

# Chords of an arc: the area of a half disc of 10 mm is then right within 1e-4 mm2.
CHORDS = 2048


def rectangle(x, y, w, h):
    return [[x, y, 0], [x + w, y, 0], [x + w, y + h, 0], [x, y + h, 0]]


def circle(x, y, r):
    return [[x - r, y, 1], [x + r, y, 1]]


def sheet(rng):
    """Outlines as vertices with bulges: rows of bricks whose joints do not meet, some with holes, parts in holes, a smaller
    part flush in a corner, or a half disc that a neighbour's outline goes around."""
    outlines = []
    y = 0
    for _ in range(rng.randint(2, 4)):
        height = rng.randrange(30, 60)
        x = rng.choice([0, 7, 13])
        for _ in range(rng.randint(2, 4)):
            width = rng.randrange(30, 70)
            kind = rng.randrange(6)
            if kind == 0:
                # A half disc at the right side, which the brick goes around: they share an arc.
                r = rng.randrange(5, 10)
                middle = y + height / 2
                a, b = [x + width, middle - r], [x + width, middle + r]
                outlines.append([[x, y, 0], [x + width, y, 0], [*a, -1], [*b, 0], [x + width, y + height, 0], [x, y + height, 0]])
                outlines.append([[*a, 0], [*b, 1]])
            else:
                outlines.append(rectangle(x, y, width, height))
            if kind == 1:
                outlines.append(rectangle(x, y, width / 2, height / 3))
            if kind in (2, 3):
                outlines.append(circle(x + width / 2, y + height / 2, 8))
            if kind == 3:
                outlines.append(rectangle(x + width / 2 - 3, y + height / 2 - 2, 6, 4))
            if kind == 4:
                outlines.append(rectangle(x + 5, y + 5, width / 2, height / 2))
            x += width
        y += height
    # A part that touches nothing.
    outlines.append(rectangle(0, y + 10, 40, 20))
    return outlines


def chords(a, b):
    """Points from a to b. Both directions give the same points, so that lines that are the same stay the same."""
    if b[:2] < a[:2]:
        return chords([*b[:2], -a[2]], [*a[:2], 0])[::-1]
    (x0, y0, bulge), (x1, y1, _) = a, b
    if bulge == 0:
        return [(x0, y0), (x1, y1)]
    cx = (x0 + x1) / 2 - (y1 - y0) * (1 / bulge - bulge) / 4
    cy = (y0 + y1) / 2 + (x1 - x0) * (1 / bulge - bulge) / 4
    start, sweep, r = math.atan2(y0 - cy, x0 - cx), 4 * math.atan(bulge), math.hypot(x0 - cx, y0 - cy)
    inner = [start + sweep * k / CHORDS for k in range(1, CHORDS)]
    return [(x0, y0), *((cx + r * math.cos(t), cy + r * math.sin(t)) for t in inner), (x1, y1)]


def faces(outlines):
    sides = [chords(o[k], o[(k + 1) % len(o)]) for o in outlines for k in range(len(o))]
    found = polygonize(list(unary_union([LineString(s) for s in sides]).geoms)).geoms
    return sorted(round(f.area, 3) for f in found)


def main():
    sheets = []
    for seed in range(40):
        outlines = sheet(random.Random(seed))
        sheets.append({"outlines": outlines, "faces": faces(outlines)})
    out = Path(__file__).parent.parent / "fixtures" / "networks.json"
    lines = ",\n".join(json.dumps(s, separators=(",", ":")) for s in sheets)
    out.write_text(f"[\n{lines}\n]\n")
    print(len(sheets), "sheets,", sum(len(s["faces"]) for s in sheets), "faces")


main()
