"""Plans of other programs for the instances, written into FOLDER/PROGRAM: `npm run benchmark -- compare FOLDER`.

    nearest    the nearest contour next, deepest nesting first, each from its nearest corner: what most programs do (in this file)
    vpype      its linesort, one layer for each depth of nesting
    svg2gcode  its search for the shortest travel, one drawing for each depth of nesting (svg2gcode.py)
    exact      HiGHS, on small instances of the track ECP without nesting (exact.py)
    lkh        LKH through elkai, after Noon and Bean, on GTSPLIB
    ortools    OR-tools' routing, on GTSPLIB
    pyvrp      PyVRP, on GTSPLIB
    glns       GLNS, on GTSPLIB (glns.py)

A program that is not installed is named, with how to get it, and skipped. Each plan is checked by check.py, and its value printed.
"""

import argparse
import gzip
import importlib.util
import json
import math
import shutil
import statistics
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path += [str(HERE), str(HERE.parent / "benches" / "solve")]
import check  # noqa: E402
import exact  # noqa: E402
import glns  # noqa: E402
import svg2gcode  # noqa: E402


def depths(contours):
    """How many contours lie around each."""
    found = []
    for contour in contours:
        depth, outer = 0, contour["inside"]
        while outer is not None:
            depth, outer = depth + 1, contours[outer]["inside"]
        found.append(depth)
    return found


def corners(contour):
    return [contour["start"]] + [piece.get("line", piece.get("arc")) for piece in contour["path"]][:-1]


def backwards(start, path):
    """The path from its end to its start."""
    ends = [start] + [piece.get("line", piece.get("arc")) for piece in path]
    turned = lambda piece, to: {**piece, "arc": to, "ccw": not piece["ccw"]} if "arc" in piece else {"line": to}  # noqa: E731
    return ends[-1], [turned(piece, to) for piece, to in zip(reversed(path), reversed(ends[:-1]))]


def plan_of(instance, visits):
    """Moves that cut whole contours, each from its corner of that number forwards, or from its end to its start where that is None."""
    moves = []
    for index, corner in visits:
        contour = instance["contours"][index]
        if corner is None:
            start, path = backwards(contour["start"], contour["path"])
        else:
            start, path = corners(contour)[corner], contour["path"][corner:] + contour["path"][:corner]
        moves += [{"kind": "air", "to": start}, {"kind": "pierce"}, {"kind": "cut", "path": path}]
    return moves + ([{"kind": "air", "to": instance["home"]}] if instance["closed"] else [])


def nearest(instance):
    contours, here, visits = instance["contours"], instance["home"], []
    depth = depths(contours)
    for level in range(max(depth), -1, -1):
        # All corners of the level by square, so that ten thousand contours take seconds.
        side = 20.0
        squares, left = {}, {k for k, d in enumerate(depth) if d == level}
        for k in left:
            for c, p in enumerate(corners(contours[k])):
                squares.setdefault((math.floor(p[0] / side), math.floor(p[1] / side)), []).append((p, k, c))
        while left:
            best, ring, at = None, 0, (math.floor(here[0] / side), math.floor(here[1] / side))
            while best is None or best[0] > (ring - 1) * side:
                around = ((at[0] + i, at[1] + j) for i in range(-ring, ring + 1) for j in range(-ring, ring + 1) if max(abs(i), abs(j)) == ring)
                near = [(math.dist(here, p), k, c) for square in around for p, k, c in squares.get(square, ()) if k in left]
                best, ring = min(near + ([best] if best else []), default=None), ring + 1
            _, k, c = best
            left.remove(k)
            visits.append((k, c))
            here = corners(contours[k])[c]
    return plan_of(instance, visits)


def vpype_sorted(instance):
    import vpype
    import vpype_cli

    contours, visits = instance["contours"], []
    depth = depths(contours)
    for level in range(max(depth), -1, -1):
        lines = vpype.LineCollection()
        own = {}
        for k, contour in enumerate(contours):
            if depth[k] == level:
                points = [complex(*p) for p in corners(contour)]
                own.setdefault(points[0], []).append(k)
                lines.append([*points, points[0]] if len(points) > 1 else [points[0], points[0] + 1e-9])
        document = vpype.Document()
        document.add(lines, 1)
        done = vpype_cli.execute("linesort --no-flip", document)
        visits += [(own[line[0]].pop(), 0) for line in done.layers[1]]
    return plan_of(instance, visits)


def by_svg2gcode(instance):
    return plan_of(instance, [(k, None if turned else 0) for k, turned in svg2gcode.order(instance, depths(instance["contours"]))])


def length(instance, moves):
    """Length of the air moves."""
    here, total = instance["home"], 0.0
    for move in moves:
        if move["kind"] != "pierce":
            to = move["to"] if move["kind"] == "air" else move["path"][-1]["line"]
            total, here = total + (math.dist(here, to) if move["kind"] == "air" else 0.0), to
    return total


def tours(solver):
    def solve(instance_file, seconds):
        import baselines

        costs, sets = baselines.read(instance_file)
        tour, note = baselines.SOLVERS[solver](costs, sets, seconds)
        if tour is None:
            raise RuntimeError(note)
        return [int(node) + 1 for node in tour]

    return solve


def importable(*modules):
    return lambda: all(importlib.util.find_spec(module) for module in modules)


# Of each program: what makes a plan for an instance, whether it is installed, and how to get it.
CUTTING = {
    "nearest": (nearest, lambda: True, ""),
    "vpype": (vpype_sorted, importable("vpype"), "pip install vpype"),
    "svg2gcode": (by_svg2gcode, lambda: shutil.which("svg2gcode"), "cargo install svg2gcode-cli, 0.0.19 or later for its search"),
    "exact": (exact.plan, importable("highspy", "networkx", "numpy"), "pip install highspy networkx numpy"),
}
GTSP = {
    "lkh": (tours("elkai"), importable("elkai", "numpy"), "pip install elkai numpy"),
    "ortools": (tours("ortools"), importable("ortools", "numpy"), "pip install ortools numpy"),
    "pyvrp": (tours("pyvrp"), importable("pyvrp", "numpy"), "pip install pyvrp numpy"),
    "glns": (glns.tour, glns.is_installed, "install Julia from julialang.org, then: julia -e 'using Pkg; Pkg.add(\"GLNS\")'"),
}


def plan(name, program, entry, data, args):
    """The plan of a program, or None where it has none for this instance."""
    if entry["track"] == "GTSP":
        unpacked = args.folder / f"{entry['name']}.gtsp"
        unpacked.write_bytes(data)
        try:
            return {"by": name, "tour": program(str(unpacked), args.seconds)}
        finally:
            unpacked.unlink()
    instance = json.loads(data)
    moves = program(instance)
    if moves is None:
        return None
    by = svg2gcode.version()[0] if name == "svg2gcode" else name
    return {"by": by, "moves": moves, **({"bound": length(instance, moves)} if name == "exact" else {})}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", default="")
    parser.add_argument("--by", default="", help="only this program")
    parser.add_argument("--seconds", type=float, default=10)
    args = parser.parse_args()
    everyone = {**CUTTING, **GTSP}
    if args.by and args.by not in everyone:
        sys.exit(f"There is no program {args.by}; the programs are {', '.join(everyone)}.")
    chosen = {name: found for name, found in everyone.items() if args.by in ("", name)}
    missing = {name: how for name, (_, installed, how) in chosen.items() if not installed()}
    for name, how in missing.items():
        print(f"{name}: skipped, because it is not installed; to get it: {how}")
    args.folder.mkdir(parents=True, exist_ok=True)
    above = {}
    entries = json.loads((HERE / "instances.json").read_text())["instances"]
    for entry in (e for e in entries if args.only in e["name"]):
        data = gzip.decompress((HERE / entry["file"]).read_bytes())
        fitting = GTSP if entry["track"] == "GTSP" else CUTTING
        for name in (name for name in chosen if name in fitting and name not in missing):
            try:
                found = plan(name, chosen[name][0], entry, data, args)
            except (RuntimeError, subprocess.SubprocessError) as error:
                print(f"{entry['name']:24} {name:10} no plan: {error}", flush=True)
                continue
            if found is None:
                continue
            out = args.folder / name / f"{entry['name']}.json.gz"
            out.parent.mkdir(parents=True, exist_ok=True)
            out.write_bytes(gzip.compress(json.dumps(found).encode()))
            try:
                value = check.check(check.instance_of(entry["name"])[0], found)
            except check.Wrong as error:
                print(f"{entry['name']:24} {name:10} WRONG  {error}", flush=True)
                continue
            per_cent = 100 * (value / entry["best"]["value"] - 1)
            above.setdefault((entry["track"], name), []).append(per_cent)
            print(f"{entry['name']:24} {name:10} {value:14.3f} {per_cent:+10.3f} % above the best known", flush=True)
    for (track, name), all_of_it in sorted(above.items()):
        print(f"{track:24} {name:10} {statistics.mean(all_of_it):+25.3f} % in the mean of {len(all_of_it)}")


if __name__ == "__main__":
    main()
