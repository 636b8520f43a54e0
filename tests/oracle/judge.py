"""What the judges of plans share (joints.py, leads.py, chains.py, ...): lines and arcs of a plan for Shapely, and the fixture with what was found."""

import hashlib
import json
import math
from pathlib import Path

import shapely

ROOT = Path(__file__).resolve().parent.parent
# mm: what a part is smaller than drawn.
LESS = 0.005


class Element:
    """A line or an arc, with its ends and its directions of travel there. `chord`: how far its chords may be from it, mm."""

    def __init__(self, start, data, chord):
        self.start, self.chord = tuple(start), chord
        self.end = tuple(data["line"] if "line" in data else data["arc"])
        self.center = tuple(data["center"]) if "arc" in data else None
        if self.center is None:
            self.sweep, self.length = 0.0, math.dist(self.start, self.end)
            return
        a, b = (math.atan2(p[1] - self.center[1], p[0] - self.center[0]) for p in (self.start, self.end))
        turn = (b - a) % (2 * math.pi)
        self.angle, self.radius = a, math.dist(self.start, self.center)
        self.sweep = (turn or 2 * math.pi) if data["ccw"] else turn - 2 * math.pi
        self.length = self.radius * abs(self.sweep)

    def direction(self, at_end):
        if self.center is None:
            return math.atan2(self.end[1] - self.start[1], self.end[0] - self.start[0])
        return self.angle + (self.sweep if at_end else 0.0) + math.copysign(math.pi / 2, self.sweep)

    def points(self):
        if self.center is None:
            return [self.start, self.end]
        step = 2 * math.acos(max(0.0, 1 - self.chord / self.radius)) if self.radius > self.chord else math.pi
        count = max(1, math.ceil(abs(self.sweep) / step))
        at = [self.angle + self.sweep * k / count for k in range(1, count)]
        return [self.start, *((self.center[0] + self.radius * math.cos(a), self.center[1] + self.radius * math.sin(a)) for a in at), self.end]


def elements(start, path, chord):
    out = []
    for data in path:
        out.append(Element(start, data, chord))
        start = out[-1].end
    return out


def line(chain):
    points = [chain[0].start]
    for e in chain:
        points += e.points()[1:]
    return shapely.LineString(points)


def polygon(points):
    p = shapely.Polygon(points)
    return p if p.is_valid else p.buffer(0)


def contour_lines(plan, chord):
    """What the beam follows of each contour that is cut in one go, without leads and overcut, and as if it turned in every corner."""
    at, lines = tuple(plan["machine"]["home"]), {}
    for move in plan["moves"]:
        if move["kind"] in ("air", "pre-cut"):
            at = tuple(move["to"])
        if "path" not in move:
            continue
        chain = elements(at, move["path"], chord)
        at = chain[-1].end
        if move["kind"] != "cut":
            continue
        on, done = [], move.get("lead_in", 0)
        for corner in move.get("corners", []):
            on += chain[done : corner["first"]]
            if corner["kind"] == "round":
                on += elements(on[-1].end, [{"line": corner["at"]}], chord)
            done = corner["first"] + corner["count"]
        on += chain[done : len(chain) - move.get("overcut", 0) - move.get("lead_out", 0)]
        contour = move["contour"] if isinstance(move["contour"], int) else move["contour"][0]
        lines.setdefault(contour, []).extend(on)
    return {contour: line(chain) for contour, chain in lines.items()}


def parts_of(plan, chord):
    """The parts that a plan makes, each a little smaller than drawn: outlines without their holes."""
    outlines = {}
    lines = contour_lines(plan, chord)
    for c in plan["contours"]:
        if "drawn" in c:
            outlines[c["id"]] = line(elements(c["drawn"]["from"], c["drawn"]["path"], chord))
        elif c["closed"] and c["operation"] == "cut" and c["id"] in lines:
            outlines[c["id"]] = lines[c["id"]]
    return shapes_and_parts(outlines)[2]


def shapes_and_parts(outlines):
    """The areas within some outlines, which of them each outline bounds, and the parts, a little smaller than drawn."""
    # Pieces of one shape have the same outline: it counts once.
    shapes, shape_of, known = [], {}, {}
    for k, outline in outlines.items():
        area = polygon(outline.coords) if len(outline.coords) > 3 else None
        if area is None or area.area == 0:
            continue
        shape_of[k] = known.setdefault((area.bounds, round(area.area, 6)), len(shapes))
        if shape_of[k] == len(shapes):
            shapes.append(area)
    # Parts: shapes within an even number of others, less the holes directly within them.
    tree = shapely.STRtree(shapes)
    inner = [s.buffer(-LESS) for s in shapes]
    around = [[j for j in tree.query(p, predicate="within") if j != i and shapes[j].area > shapes[i].area] for i, p in enumerate(inner)]
    holes = {}
    for i, outer in enumerate(around):
        if len(outer) % 2:
            holes.setdefault(min(outer, key=lambda j: shapes[j].area), []).append(shapes[i])
    whole = [shapely.difference(s, shapely.union_all(holes.get(i, []))) for i, s in enumerate(shapes) if len(around[i]) % 2 == 0]
    return shapes, shape_of, [part.buffer(-LESS) for part in whole]


def turned(a, b):
    """The angle between two directions, degrees."""
    return math.degrees(abs((b - a + math.pi) % (2 * math.pi) - math.pi))


def depth_of(plan, contour):
    depth, outer = 0, contour["inside"]
    while outer is not None:
        depth, outer = depth + 1, plan["contours"][outer]["inside"]
    return depth


def judge(name, look):
    """Looks at each plan in target/NAME and writes what was found, with the hash of its moves, to fixtures/NAME.json."""
    found, plans = {}, sorted((ROOT.parent / "target" / name).glob("*.json"))
    if not plans:
        raise SystemExit(f"No plans are in target/{name}. The command that writes them stands at the top of tests/oracle/{name}.py.")
    for file in plans:
        text = file.read_bytes()
        found[file.stem] = {"moves": moves_hash(text), **look(json.loads(text))}
        print(file.stem, {k: v for k, v in found[file.stem].items() if k != "moves"}, flush=True)
    (ROOT / "fixtures" / f"{name}.json").write_text(json.dumps(found, indent=1) + "\n")
    print("faults:", sum(len(f["faults"]) for f in found.values()))


def moves_hash(text):
    """SHA-256 of the moves as they are written."""
    return hashlib.sha256(text.split(b'"moves":[')[1].split(b'],"findings":[')[0]).hexdigest()
