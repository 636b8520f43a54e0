"""Plans of other programs for the instances, written into FOLDER/PROGRAM: `npm run benchmark -- compare FOLDER`.

    nearest    the nearest contour next, deepest nesting first, each from its nearest corner: what most programs do (in this file)
    vpype      its linesort, one layer for each depth of nesting (pip install vpype)
    exact      HiGHS, on small instances of the track ECP without nesting (exact.py; pip install highspy networkx numpy)
    lkh        LKH through elkai, after Noon and Bean, on GTSPLIB (pip install elkai numpy)
    ortools    OR-tools' routing, on GTSPLIB (pip install ortools numpy)
    pyvrp      PyVRP, on GTSPLIB (pip install pyvrp numpy)

A program that is not installed is named and left out.
"""

import argparse
import gzip
import importlib.util
import json
import math
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path += [str(HERE), str(HERE.parent / "benches" / "solve")]
import exact  # noqa: E402


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


def plan_of(instance, visits):
    """Moves that cut whole contours, each from the corner of that number, forwards."""
    moves = []
    for index, corner in visits:
        contour = instance["contours"][index]
        path = contour["path"][corner:] + contour["path"][:corner]
        moves += [{"kind": "air", "to": corners(contour)[corner]}, {"kind": "pierce"}, {"kind": "cut", "path": path}]
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


CUTTING = {"nearest": (nearest, "math"), "vpype": (vpype_sorted, "vpype"), "exact": (exact.plan, "highspy")}
GTSP = {"lkh": (tours("elkai"), "elkai"), "ortools": (tours("ortools"), "ortools"), "pyvrp": (tours("pyvrp"), "pyvrp")}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", default="")
    parser.add_argument("--seconds", type=float, default=10)
    args = parser.parse_args()
    missing = {name: module for name, (_, module) in {**CUTTING, **GTSP}.items() if importlib.util.find_spec(module) is None}
    for name, module in missing.items():
        print(f"{name}: not run; pip install {module}")
    entries = json.loads((HERE / "instances.json").read_text())["instances"]
    for entry in (e for e in entries if args.only in e["name"]):
        data = gzip.decompress((HERE / entry["file"]).read_bytes())
        for name, (program, _) in (GTSP if entry["track"] == "GTSP" else CUTTING).items():
            if name in missing:
                continue
            plan = {"by": name}
            if entry["track"] == "GTSP":
                unpacked = args.folder / f"{entry['name']}.gtsp"
                args.folder.mkdir(parents=True, exist_ok=True)
                unpacked.write_bytes(data)
                plan["tour"] = program(str(unpacked), args.seconds)
                unpacked.unlink()
            else:
                instance = json.loads(data)
                plan["moves"] = program(instance)
                if plan["moves"] is None:
                    continue
                if name == "exact":
                    plan["bound"] = length(instance, plan["moves"])
            out = args.folder / name / f"{entry['name']}.json.gz"
            out.parent.mkdir(parents=True, exist_ok=True)
            out.write_bytes(gzip.compress(json.dumps(plan).encode()))
            print(f"{entry['name']:24} {name}", flush=True)


if __name__ == "__main__":
    main()
