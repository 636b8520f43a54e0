"""Makes the fixtures of `tests/oracle_ezdxf.rs`: drawings of every entity kind, and what ezdxf makes of them.

    python tests/oracle/generate.py [--random 24] [--seed 1] [--out FOLDER]

needs `pip install ezdxf numpy`; run from anywhere. To look further, make many in a folder of their own and run
`KERFWAY_ORACLE=FOLDER cargo test --test it oracle_ezdxf`. Directed cases come from `cases.py`, random ones are drawn from a
seeded generator here: every kind at random places, sizes and orientations, in blocks nested up to three deep, in
random versions and units. Each drawing is written beside a `.json` with the reference:

    {"unit": given unit or null, "paths": [{"kind", "layer", "closed", "points": [x0, y0, dx1, dy1, ...]}]}

with points in units of 0.1 um, each but the first as the step from the one before, flattened to 0.001 mm and thinned
within another 0.0005 mm.
"""

import argparse
import json
import math
import random
from pathlib import Path

import ezdxf

import entities as e
from cases import MIRROR, SKEW, TILTED, all_cases
from drawing import Drawing
from reference import FACTORS, NAMES, paths_of, read

OUT = Path(__file__).resolve().parent.parent / "fixtures" / "oracle"
# Points per mm in the reference file.
GRID = 10_000
CHORD = 0.001
THIN = 0.0005
VERSIONS = ["AC1009", "AC1014", "AC1015", "AC1018", "AC1021", "AC1024", "AC1027", "AC1032"]


def random_drawing(index, seed):
    rng = random.Random(f"{seed}/{index}")
    version = rng.choice(VERSIONS)
    unit = rng.choice([1, 4, 4, 4, 5, 14])
    d = Drawing(f"random-{index:02}", version=version, insunits=unit, binary=rng.random() < 0.25,
                eol=rng.choice(["\n", "\r\n"]), layers=[("CUT", 1, 0), ("INNER", 3, 0)])
    scale = 1.0 / FACTORS[unit]
    blocks = []
    for b in range(rng.randint(1, 3)):
        content = [random_entity(rng, version, (0, 0), scale) for _ in range(rng.randint(1, 3))]
        if blocks:
            content.append(random_insert(rng, rng.choice(blocks), (0, 0), scale * 0.5, array=False))
        name = f"BLOCK{b}"
        d.blocks[name] = ((rng.uniform(-5, 5) * scale, rng.uniform(-5, 5) * scale), content)
        blocks.append(name)
    for k in range(rng.randint(4, 7)):
        at = (rng.uniform(0, 400) * scale, rng.uniform(0, 300) * scale)
        if rng.random() < 0.3:
            d.add(random_insert(rng, rng.choice(blocks), at, scale))
        else:
            d.add(random_entity(rng, version, at, scale))
    return d


def random_insert(rng, name, at, unit, array=True):
    s = [rng.choice([1, -1]) * rng.choice([1, 1, rng.uniform(0.4, 2)]) for _ in range(2)]
    many = array and rng.random() < 0.2
    return e.insert(name, at, scale=(s[0], s[1], rng.choice([1, s[0]])), rotation=rng.choice([0, 90, rng.uniform(-180, 180)]),
                    layer=rng.choice(["0", "CUT", "INNER"]), normal=rng.choice([e.UP, e.UP, e.UP, MIRROR, SKEW]),
                    columns=rng.randint(1, 3) if many else 1, rows=2 if many else 1,
                    spacing=(70 * unit, -60 * unit))


def random_entity(rng, version, at, unit):
    """One entity near `at`, 5 to 40 mm large; `unit` is one mm in drawing units."""
    r12 = version == "AC1009"
    kinds = ["line", "circle", "arc", "polyline", "solid"]
    kinds += [] if r12 else ["lwpolyline", "ellipse", "spline", "rational", "fit", "polyline3d"]
    kind = rng.choice(kinds)
    layer = rng.choice(["0", "CUT", "INNER"])
    normal = rng.choice([e.UP, e.UP, e.UP, MIRROR, TILTED])
    size = rng.uniform(5, 40) * unit

    def near():
        return (at[0] + rng.uniform(-1, 1) * size, at[1] + rng.uniform(-1, 1) * size)

    def ring(count):
        turn = rng.uniform(0, math.tau)
        return [(at[0] + size * rng.uniform(0.5, 1) * math.cos(turn + math.tau * i / count),
                 at[1] + size * rng.uniform(0.5, 1) * math.sin(turn + math.tau * i / count)) for i in range(count)]

    def bulged(count):
        return [(x, y, rng.choice([0.0, 0.0, rng.uniform(-1.5, 1.5)])) for x, y in ring(count)]

    if kind == "line":
        return e.line(near(), near(), layer=layer)
    if kind == "circle":
        return e.circle(at, size / 2, layer=layer, normal=normal)
    if kind == "arc":
        return e.arc(at, size / 2, rng.uniform(-90, 360), rng.uniform(0, 400), layer=layer, normal=normal)
    if kind == "lwpolyline":
        return e.lwpolyline(bulged(rng.randint(2, 9)), closed=rng.random() < 0.5, layer=layer, normal=normal)
    if kind == "polyline":
        return e.polyline([(x, y, 0.0, b) for x, y, b in bulged(rng.randint(2, 9))], closed=rng.random() < 0.5,
                          layer=layer, normal=normal)
    if kind == "polyline3d":
        return e.polyline([(x, y, rng.uniform(0, 9) * unit) for x, y in ring(5)], closed=rng.random() < 0.5, flags=8,
                          layer=layer, subclass="AcDb3dPolyline")
    if kind == "solid":
        a, b, c, d = ring(4)
        return e.solid([a, b, d, c], layer=layer, normal=normal)
    if kind == "ellipse":
        turn = rng.uniform(0, math.tau)
        major = (size * math.cos(turn), size * math.sin(turn))
        start, end = (0, math.tau) if rng.random() < 0.3 else (rng.uniform(-3, 6), rng.uniform(-3, 6))
        return e.ellipse(at, major, rng.uniform(0.1, 1), start, end, layer=layer, normal=rng.choice([e.UP, MIRROR]))
    count = rng.randint(4, 9)
    points = [near() for _ in range(count)]
    if kind == "fit":
        return e.spline(3, fit=points, layer=layer)
    degree = rng.randint(2, min(5, count - 1))
    weights = [rng.uniform(0.3, 3) for _ in points] if kind == "rational" else ()
    return e.spline(degree, points, e.clamped_knots(degree, count, step=rng.uniform(0.1, 20)), weights, layer=layer)


def thinned(points):
    """The points without those that lie within THIN of the chord between points that stay."""
    out, start = points[:1], 0
    for end in range(2, len(points)):
        a, b = points[start], points[end]
        length = math.dist(a, b)
        off = [abs((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) / length if length > THIN
               else math.dist(a, p) for p in points[start + 1:end]]
        if max(off) > THIN or length < math.dist(a, points[end - 1]):
            start = end - 1
            out.append(points[start])
    return out + points[-1:] if len(points) > 1 else out


def reference(path, drawing):
    factor = NAMES[drawing.given_unit] if drawing.given_unit else FACTORS[drawing.insunits]
    paths = []
    for p in paths_of(read(path), factor, CHORD):
        grid = [(round(x * GRID), round(y * GRID)) for x, y in thinned(p.points)]
        steps = [c for a, b in zip([(0, 0), *grid], grid) for c in (b[0] - a[0], b[1] - a[1])]
        paths.append({"kind": p.kind, "layer": p.layer, "closed": p.closed, "points": steps})
    return {"unit": drawing.given_unit, "paths": paths}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--random", type=int, default=24, help="how many random drawings")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", type=Path, default=OUT)
    args = parser.parse_args()
    out = args.out
    out.mkdir(parents=True, exist_ok=True)
    for old in [*out.glob("*.dxf"), *out.glob("*.json")]:
        old.unlink()
    drawings = [*all_cases(), *(random_drawing(i, args.seed) for i in range(args.random))]
    count = 0
    for d in drawings:
        path = out / f"{d.name}.dxf"
        path.write_bytes(d.bytes())
        made = reference(path, d)
        count += len(made["paths"])
        (out / f"{d.name}.json").write_text(json.dumps(made, separators=(",", ":"), ensure_ascii=False) + "\n")
    size = sum(f.stat().st_size for f in out.iterdir())
    print(f"{len(drawings)} drawings, {count} paths by ezdxf {ezdxf.__version__}, {size / 1e3:.0f} kB in {out}")


if __name__ == "__main__":
    main()
