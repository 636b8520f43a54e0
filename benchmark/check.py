"""Reference checker of the benchmark of cutting paths. It shares nothing with the programs whose plans it checks.

    python3 check.py FOLDER                   every plan of a folder: NAME.json or NAME.json.gz is a plan for the instance NAME
    python3 check.py INSTANCE PLAN            one plan for an instance in a file
    python3 check.py --instance NAME PLAN     one plan for an instance of the benchmark

Prints a line for each plan: its value, or the name of what is wrong and where. Exit code 0 if every plan is sound, 1 if one is wrong, 2 if
the command is. README.md defines instances, plans, rules and cost; the names of the faults are those of `Wrong` below.
"""

import gzip
import hashlib
import json
import math
import sys
from bisect import bisect
from itertools import accumulate
from pathlib import Path

from gtsplib import read

HERE = Path(__file__).resolve().parent
NEAR = 1e-3  # mm: how far a plan may be from the geometry of its instance
STEP = 0.5  # mm: lines and arcs are compared with the contour this often, and at least eight times


class Wrong(Exception):
    """A plan that breaks a rule. Its text begins with one of: not-a-plan, not-a-number, no-pierce, off-contour, not-whole, not-an-endpoint,
    cut-twice, not-cut, order, no-return, visited-twice, not-visited, claim."""


def load(path):
    data = Path(path).read_bytes()
    return gzip.decompress(data) if str(path).endswith(".gz") else data


def number(value):
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise Wrong(f"not-a-number: {value!r} stands where a number is needed")
    return float(value)


def point(value):
    if not isinstance(value, list) or len(value) != 2:
        raise Wrong(f"not-a-plan: {value!r} stands where a point [x, y] is needed")
    return number(value[0]), number(value[1])


def pieces(start, path):
    """The lines and arcs of a path."""
    if not isinstance(path, list) or not path:
        raise Wrong("not-a-plan: a cut has no path")
    for piece in path:
        if "line" in piece:
            yield Line(start, point(piece["line"]))
        elif "arc" in piece:
            yield Arc(start, point(piece["arc"]), point(piece["center"]), piece.get("ccw") is True)
        else:
            raise Wrong(f"not-a-plan: {json.dumps(piece)} is neither a line nor an arc")
        start = point(piece.get("line", piece.get("arc")))


class Line:
    def __init__(self, a, b):
        self.a, self.end, self.length = a, b, math.dist(a, b)

    def at(self, t):
        return self.a[0] + t * (self.end[0] - self.a[0]), self.a[1] + t * (self.end[1] - self.a[1])

    def nearest(self, p):
        along = sum((self.end[i] - self.a[i]) * (p[i] - self.a[i]) for i in (0, 1))
        return min(max(along / self.length**2, 0.0), 1.0) if self.length > 0 else 0.0


class Arc:
    def __init__(self, a, b, center, ccw):
        self.center, self.end, self.radius = center, b, math.dist(center, a)
        if abs(self.radius - math.dist(center, b)) > NEAR:
            raise Wrong(f"off-contour: the ends of an arc around {show(center)} are at different distances from it")
        self.first, self.sign = self.angle(a), 1 if ccw else -1
        sweep = (self.angle(b) - self.first) * self.sign % (2 * math.pi)
        # Ends that are the same point are a whole turn.
        self.sweep = 2 * math.pi if math.dist(a, b) <= 1e-9 or sweep == 0 else sweep
        self.length = self.radius * self.sweep

    def angle(self, p):
        return math.atan2(p[1] - self.center[1], p[0] - self.center[0])

    def at(self, t):
        angle = self.first + self.sign * self.sweep * t
        return self.center[0] + self.radius * math.cos(angle), self.center[1] + self.radius * math.sin(angle)

    def nearest(self, p):
        turned = (self.angle(p) - self.first) * self.sign % (2 * math.pi)
        if turned <= self.sweep:
            return turned / self.sweep
        return 1.0 if turned - self.sweep < 2 * math.pi - turned else 0.0


class Contour:
    """A contour by the length along it, and the stretches that are cut."""

    def __init__(self, data):
        self.start, self.closed, self.inside = point(data["start"]), data["closed"], data["inside"]
        self.parts = list(pieces(self.start, data["path"]))
        self.vertices = list(accumulate((part.length for part in self.parts), initial=0.0))
        self.length, self.cuts = self.vertices[-1], []

    def at(self, s):
        s = s % self.length if self.closed else min(max(s, 0.0), self.length)
        k = min(bisect(self.vertices, s), len(self.parts)) - 1
        part = self.parts[k]
        return part.at(min((s - self.vertices[k]) / part.length, 1.0) if part.length > 0 else 0.0)

    def places(self, p):
        """Lengths along the contour at which it passes within NEAR of a point."""
        for begin, part in zip(self.vertices, self.parts):
            t = part.nearest(p)
            if math.dist(part.at(t), p) <= NEAR:
                yield begin + t * part.length

    def follow(self, start, cut):
        """Where a cut begins and ends along the contour, or None if it leaves the contour."""
        for s in self.places(start):
            for way in (1, -1):
                here = s
                for piece in cut:
                    n = max(8, math.ceil(piece.length / STEP))
                    if any(math.dist(piece.at(k / n), self.at(here + way * piece.length * k / n)) > 2 * NEAR for k in range(n + 1)):
                        break
                    here += way * piece.length
                else:
                    if self.closed or -NEAR <= here <= self.length + NEAR:
                        return s, here
        return None

    def is_open_at(self, p):
        """Whether an earlier cut of this contour begins or ends here: no piercing is needed to go on."""
        return any(math.dist(self.at(s), p) <= 2 * NEAR for stretch in self.cuts for s in stretch)


class Grid:
    """Contours by the squares their boundaries pass, so that a cut is compared with few of them."""

    SIDE = 5.0

    def __init__(self, contours):
        self.squares = {}
        for index, contour in enumerate(contours):
            steps = math.ceil(contour.length / self.SIDE * 2) + 1
            for k in range(steps + 1):
                self.squares.setdefault(self.square(contour.at(contour.length * k / steps)), set()).add(index)

    def square(self, p):
        return math.floor(p[0] / self.SIDE), math.floor(p[1] / self.SIDE)

    def near(self, p):
        x, y = self.square(p)
        return sorted(set().union(*(self.squares.get((x + i, y + j), ()) for i in (-1, 0, 1) for j in (-1, 0, 1))))


def air(cost, distance):
    """Cost of an air move: its length, or the seconds of a move that starts and ends at rest."""
    if cost["unit"] == "mm":
        return distance
    speed, acceleration = cost["speed"], cost["acceleration"]
    ramp = speed * speed / acceleration
    return distance / speed + speed / acceleration if distance >= ramp else 2 * math.sqrt(distance / acceleration)


def cutting(instance, plan):
    """The value of a plan for an instance of the tracks CCP, ECP, ICP and TIME."""
    cost, contours = instance["cost"], [Contour(c) for c in instance["contours"]]
    grid, home = Grid(contours), tuple(instance["home"])
    here, value, pierced, finished = home, 0.0, False, []
    if not isinstance(plan, dict) or not isinstance(plan.get("moves"), list):
        raise Wrong("not-a-plan: there is no list of moves")
    for k, move in enumerate(plan["moves"]):
        kind = move.get("kind") if isinstance(move, dict) else None
        if kind == "air":
            to = point(move["to"])
            value, pierced = value + air(cost, math.dist(here, to)), False
        elif kind == "pierce":
            to, value, pierced = here, value + cost["pierce"], True
        elif kind == "cut":
            path = list(pieces(here, move.get("path")))
            to = path[-1].end
            index, s, end = next(((i, *found) for i in grid.near(here) if (found := contours[i].follow(here, path))), (None, 0, 0))
            if index is None:
                raise Wrong(f"off-contour: move {k} from {show(here)} to {show(to)} does not follow any one contour")
            if not pierced and not contours[index].is_open_at(here):
                raise Wrong(f"no-pierce: move {k} cuts at {show(here)}, where nothing was pierced or cut before")
            if covered(contours[index], s, end, instance["track"], k):
                finished.append(index)
        else:
            raise Wrong(f"not-a-plan: move {k} is of the kind {kind!r}")
        here = to
    when = {contour: k for k, contour in enumerate(finished)}
    for index, contour in enumerate(contours):
        if index not in when:
            raise Wrong(f"not-cut: contour {index}, which begins at {show(contour.start)}, is not wholly cut")
        if contour.inside is not None and when.get(contour.inside, len(contours)) < when[index]:
            raise Wrong(f"order: contour {index} is finished after contour {contour.inside}, inside which it lies")
    if instance["closed"] and math.dist(here, home) > NEAR:
        raise Wrong(f"no-return: the head ends at {show(here)} and not at home, {show(home)}")
    return value


def covered(contour, s, end, track, k):
    """Adds a stretch to what is cut of a contour, and says whether all of it is cut now."""
    length = abs(end - s)
    if track in ("CCP", "TIME") and abs(length - contour.length) > 2 * NEAR and not contour.cuts:
        raise Wrong(f"not-whole: move {k} cuts {length:.3f} mm of a contour of {contour.length:.3f} mm, which is cut in one go on this track")
    if track == "ECP" and not all(any(math.dist(contour.at(x), contour.at(v)) <= NEAR for v in contour.vertices) for x in (s, end)):
        raise Wrong(f"not-an-endpoint: move {k} begins or ends within a line or arc; on this track only their ends may be used")
    low, high = min(s, end), max(s, end)
    shift = math.floor(low / contour.length) * contour.length if contour.closed else 0.0
    low, high = low - shift, high - shift
    wrapped = [(low, min(high, contour.length))] + ([(0.0, high - contour.length)] if high > contour.length else [])
    for a, b in wrapped:
        twice = max((min(b, d) - max(a, c) for c, d in contour.cuts), default=0.0)
        if twice > 2 * NEAR or length > contour.length + 2 * NEAR:
            raise Wrong(f"cut-twice: move {k} cuts {max(twice, length - contour.length):.3f} mm again at {show(contour.at(a))}")
    contour.cuts += wrapped
    return sum(b - a for a, b in contour.cuts) >= contour.length - 2 * NEAR * len(contour.cuts)


def show(p):
    return f"({p[0]:.3f}, {p[1]:.3f})"


def tour(instance, plan):
    """The value of a tour for an instance of GTSPLIB: the file is read here, by the definitions of TSPLIB95."""
    costs, sets = read(load(HERE / instance["gtsplib"]).decode())
    nodes = plan.get("tour") if isinstance(plan, dict) else None
    if not isinstance(nodes, list):
        raise Wrong("not-a-plan: there is no list of nodes, tour")
    home = {node: index for index, members in enumerate(sets) for node in members}
    seen = [home.get(n - 1) if isinstance(n, int) else None for n in nodes]
    if None in seen:
        raise Wrong(f"not-a-plan: {nodes[seen.index(None)]!r} is not a node of this instance; nodes count from 1")
    if len(set(seen)) < len(seen):
        raise Wrong(f"visited-twice: set {next(s for s in seen if seen.count(s) > 1)} is visited more than once")
    if len(seen) < len(sets):
        raise Wrong(f"not-visited: set {min(set(range(len(sets))) - set(seen))} is not visited")
    return float(sum(costs(a - 1, b - 1) for a, b in zip(nodes, nodes[1:] + nodes[:1])))


def check(instance, plan):
    """The value of a plan; raises Wrong."""
    value = tour(instance, plan) if "gtsplib" in instance else cutting(instance, plan)
    claimed = plan.get("value")
    if claimed is not None and abs(number(claimed) - value) > max(1e-6 * value, NEAR):
        raise Wrong(f"claim: the plan claims {claimed}, and it takes {value:.6f}")
    return value


def instance_of(name):
    entry = next((e for e in json.loads((HERE / "instances.json").read_text())["instances"] if e["name"] == name), None)
    if entry is None:
        raise Wrong(f"not-a-plan: there is no instance named {name}")
    data = load(HERE / entry["file"])
    if hashlib.sha256(data).hexdigest() != entry["sha256"]:
        raise ValueError(f"{entry['file']} is not the frozen file: its checksum differs")
    return json.loads(data) if entry["track"] != "GTSP" else {"gtsplib": entry["file"]}, entry


def main(arguments):
    if len(arguments) == 3 and arguments[0] == "--instance":
        print(f"{check(instance_of(arguments[1])[0], json.loads(load(arguments[2]))):.6f}")
        return 0
    if len(arguments) == 2:
        print(f"{check(json.loads(load(arguments[0])), json.loads(load(arguments[1]))):.6f}")
        return 0
    if len(arguments) != 1 or not Path(arguments[0]).is_dir():
        print(__doc__, file=sys.stderr)
        return 2
    wrong = 0
    for file in sorted(Path(arguments[0]).glob("*.json*")):
        name = file.name.removesuffix(".gz").removesuffix(".json")
        try:
            instance, entry = instance_of(name)
            value = check(instance, json.loads(load(file)))
            best = entry.get("best", {}).get("value")
            beside = "" if best is None else f"   best known {best:.3f}   {100 * (value / best - 1):+.3f} %"
            print(f"{name:24} {value:14.3f}{beside}")
        except (Wrong, json.JSONDecodeError, KeyError, TypeError) as error:
            wrong += 1
            print(f"{name:24} WRONG  {error if isinstance(error, Wrong) else f'not-a-plan: {error!r}'}")
    return 1 if wrong else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except Wrong as error:
        print(f"WRONG  {error}")
        sys.exit(1)
