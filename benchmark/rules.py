"""The rules of the benchmark of cutting paths, which README.md has in words: `check` says what a plan costs, or raises what is wrong.

It shares nothing with the programs whose plans it checks. A point is a complex number, x + iy, so that abs(p - q) is the distance of two
points. A place on a path is the length along it. Lengths are in mm.
"""

import cmath
import math
import re
from bisect import bisect
from itertools import accumulate

NEAR = 1e-3  # how far a plan may be from the geometry of its instance
LARGEST = 1e9  # the largest number in a plan: sums and squares of such numbers are numbers
SIDE = 5.0  # contours are found by squares of this side that they pass, so that a cut is compared with few of them


class Wrong(Exception):
    """A plan that breaks a rule. Its text begins with the name of the fault, which is one of those that README.md lists."""


def check(instance, plan):
    """The value of a plan for an instance; raises Wrong. An instance of GTSPLIB has the text of its file as `gtsplib`."""
    value = tour(instance, plan) if "gtsplib" in instance else cutting(instance, plan)
    claimed = plan.get("value")
    if claimed is not None and abs(number(claimed) - value) > max(1e-6 * value, NEAR):
        raise Wrong(f"claim: the plan claims {claimed}, and it takes {value:.6f}")
    return value


def cutting(instance, plan):
    """The value of a plan for an instance of the tracks CCP, ECP, ICP and TIME."""
    if not isinstance(plan, dict) or not isinstance(plan.get("moves"), list):
        raise Wrong("not-a-plan: there is no list of moves")
    cost, home, contours = instance["cost"], point(instance["home"]), [Contour(c) for c in instance["contours"]]
    near = finder(contours)
    # The way through the air since the last cut, which is measured from contour to contour: a plan may be a little beside them.
    here, way, value, pierced = home, [home], 0.0, False
    for k, move in enumerate(plan["moves"]):
        try:
            kind = move.get("kind") if isinstance(move, dict) else None
            if kind == "air":
                here, pierced = point(move.get("to")), False
                way.append(here)
            elif kind == "pierce":
                value, pierced = value + cost["pierce"], True
            elif kind == "cut":
                path = Path(here, move.get("path"))
                contour, begin, end = cut(path, near(here), instance["track"], pierced)
                value += travelled(cost, [way[0], *way[1:-1], contour.at(begin)])
                here, way, pierced = path.end, [contour.at(end)], False
                contour.finished = math.inf if contour.left else k
            else:
                raise Wrong(f"not-a-plan: {short(kind)} is no kind of move")
        except Wrong as wrong:
            name, text = str(wrong).split(": ", 1)
            raise Wrong(f"{name}: move {k} from {show(here)}: {text}") from None
    for k, contour in enumerate(contours):
        if contour.left:
            raise Wrong(f"not-cut: contour {k} is not cut from {show(contour.at(contour.left[0][0]))} on")
        if contour.inside is not None and contours[contour.inside].finished < contour.finished:
            raise Wrong(f"order: contour {k} at {show(contour.start)} is finished after contour {contour.inside}, in which it lies")
    if instance["closed"] and abs(here - home) > NEAR:
        raise Wrong(f"no-return: the head ends at {show(here)} and not at home, {show(home)}")
    return value + travelled(cost, [way[0], *way[1:-1], home] if instance["closed"] else way)


def travelled(cost, way):
    """The cost of air moves from point to point: their length, or the seconds of moves that start and end at rest."""
    lengths = [abs(b - a) for a, b in zip(way, way[1:])]
    if cost["unit"] == "mm":
        return sum(lengths)
    v, a = cost["speed"], cost["acceleration"]
    return sum(d / v + v / a if d >= v * v / a else 2 * math.sqrt(d / a) for d in lengths)


def cut(path, contours, track, pierced):
    """Cuts one of some contours along a path: the contour, and the places where the cut begins and ends."""
    faults = []
    for contour in contours:
        for begin, end in contour.follow(path):
            try:
                return contour, *stretch(contour, begin, end, track, pierced)
            except Wrong as wrong:
                # Where contours lie on each other, it may be a cut of another one.
                faults.append(wrong)
    raise min(faults, key=lambda fault: "cut-twice" in str(fault), default=Wrong("off-contour: no contour leads along all of this cut"))


def stretch(contour, begin, end, track, pierced):
    """Cuts a contour from place to place, if the rules allow it, and says between which places exactly."""
    length = abs(end - begin)
    # A cut that begins or ends a little beside a place where it may do so is taken to be there, so that nothing is gained by it.
    ends = contour.ends()
    marks = contour.vertices if track == "ECP" else ends if contour.closed else ends | {0.0, contour.length}
    exact = []
    for place in (begin, end):
        off = contour.off(place, [*marks, *exact])
        exact.append(place - off if abs(off) <= 2 * NEAR else place)
    if not pierced and contour.left and all(abs(contour.at(place) - contour.at(exact[0])) > NEAR for place in ends):
        raise Wrong("no-pierce: nothing was pierced here, and no cut of this contour ends here")
    shorter = min(length, abs(exact[1] - exact[0]))
    if shorter <= 2 * NEAR:
        # Many of them would add up to a contour, or lead along one that is cut already.
        raise Wrong(f"not-a-plan: this is a cut of {shorter:.4f} mm; a cut is longer than {2 * NEAR} mm")
    if track in ("CCP", "TIME") and not contour.begun and abs(length - contour.length) > 2 * NEAR:
        raise Wrong(f"not-whole: {length:.3f} mm of a contour of {contour.length:.3f} mm are cut, which this track cuts in one go")
    if track == "ECP" and any(abs(contour.off(place, contour.vertices)) > NEAR for place in (begin, end)):
        raise Wrong("not-an-endpoint: the cut begins or ends within a line or arc, and on this track only their ends may be used")
    contour.take(min(exact), max(exact))
    return exact


class Line:
    def __init__(self, start, end):
        self.start, self.end, self.length = start, end, abs(end - start)

    def at(self, share):
        return self.start + share * (self.end - self.start)

    def nearest(self, p):
        """The share of the line that ends where it is nearest to a point."""
        along = ((p - self.start) * (self.end - self.start).conjugate()).real
        return min(max(along / (self.length**2 or 1.0), 0.0), 1.0)


class Arc:
    def __init__(self, start, end, center, ccw, alone):
        self.center, self.spoke, self.end, self.radius = center, start - center, end, abs(start - center)
        if abs(self.radius - abs(end - center)) > NEAR:
            raise Wrong(f"off-contour: the ends of an arc around {show(center)} are at different distances from it")
        self.sign = 1 if ccw else -1
        sweep = self.sign * cmath.phase((end - center) * self.spoke.conjugate()) % (2 * math.pi)
        # Ends that are the same point are a whole turn; in a cut of one arc also those that are as near as a plan may be.
        same = max(abs(end - start), self.radius * sweep) <= (2 * NEAR if alone else 1e-9)
        self.sweep = 2 * math.pi if same or sweep == 0 else sweep
        self.length = self.radius * self.sweep

    def at(self, share):
        return self.center + self.spoke * cmath.rect(1, self.sign * self.sweep * share)

    def nearest(self, p):
        """The share of the arc that ends where it is nearest to a point."""
        beyond = self.sign * cmath.phase((p - self.center) * (self.at(0.5) - self.center).conjugate())
        return min(max(0.5 + beyond / self.sweep, 0.0), 1.0)


class Path:
    """Lines and arcs, each from where the one before ends."""

    def __init__(self, start, path, closed=False):
        if not isinstance(path, list) or not path:
            raise Wrong("not-a-plan: a cut has no path")
        self.start, self.end, self.closed, self.parts = start, start, closed, []
        for piece in path:
            if isinstance(piece, dict) and "line" in piece:
                part = Line(self.end, point(piece["line"]))
            elif isinstance(piece, dict) and "arc" in piece:
                part = Arc(self.end, point(piece["arc"]), point(piece.get("center")), piece.get("ccw") is True, len(path) == 1)
            else:
                raise Wrong(f"not-a-plan: {short(piece)} is neither a line nor an arc")
            self.parts.append(part)
            self.end = part.end
        # The places where lines and arcs begin and end.
        self.vertices = list(accumulate((part.length for part in self.parts), initial=0.0))
        self.length = self.vertices[-1]

    def at(self, place):
        place = place % self.length if self.closed else place
        k = min(max(bisect(self.vertices, place) - 1, 0), len(self.parts) - 1)
        return self.parts[k].at((place - self.vertices[k]) / (self.parts[k].length or 1.0))


class Contour(Path):
    """A contour of an instance. Places that are a `lap` apart are the same. `left` are the stretches that are not cut yet, from place to
    place, where one over the start of a closed contour ends beyond its length; `finished` is the move that cut the last of it."""

    def __init__(self, data):
        super().__init__(point(data["start"]), data["path"], data["closed"])
        self.inside, self.lap = data["inside"], self.length if self.closed else math.inf
        self.left, self.begun, self.finished = [(0.0, self.length)], False, math.inf

    def follow(self, cut):
        """The stretches along which a cut follows this contour, each from the place where it begins to the one where it ends."""
        places = [vertex + part.nearest(cut.start) * part.length for vertex, part in zip(self.vertices, self.parts)]
        for distance, begin in sorted((abs(self.at(place) - cut.start), place) for place in (0.0, *places, self.length)):
            for way in (1, -1) if distance <= NEAR else ():
                end = begin + way * cut.length
                # Between two stops, both are a line or an arc: if these agree at nine places, they agree everywhere.
                met = ((v - begin) * way % self.lap for v in self.vertices)
                stops = sorted({round(x, 6) for x in (*cut.vertices, *met) if x <= cut.length})
                passed = (a + (b - a) * k / 8 for a, b in zip(stops, stops[1:]) for k in range(9))
                last = end if self.closed else min(max(end, 0.0), self.length)
                if abs(end - last) <= 2 * NEAR and all(abs(cut.at(x) - self.at(begin + way * x)) <= 2 * NEAR for x in passed):
                    yield begin, last

    def off(self, place, marks):
        """How far a place is beyond the nearest of some others."""
        return min((math.remainder(place - mark, self.lap) for mark in marks), key=abs, default=math.inf)

    def ends(self):
        """The places where what is cut ends."""
        found = {place for ends in self.left for place in ends}
        return found if self.closed and self.begun else found ^ {0.0, self.length}

    def take(self, low, high):
        """Takes a stretch from what is left."""
        if self.closed and not self.begun:
            self.left = [(low, low + self.length)]
        for k, (a, b) in enumerate(self.left):
            first = a + (low - a + NEAR) % self.lap - NEAR
            last = first + high - low
            if last <= b + NEAR:
                self.left[k : k + 1] = [(c, d) for c, d in ((a, first), (last, b)) if d - c > 2 * NEAR]
                self.begun = True
                return
        raise Wrong("cut-twice: a part of this cut is cut already")


def finder(contours):
    """A function that lists the contours which may pass a point."""
    squares = {}
    for contour in contours:
        steps = math.ceil(2 * contour.length / SIDE)
        for k in range(steps + 1):
            p = contour.at(contour.length * k / steps) / SIDE
            squares.setdefault((math.floor(p.real), math.floor(p.imag)), {})[contour] = None

    def near(p):
        x, y = math.floor(p.real / SIDE), math.floor(p.imag / SIDE)
        return dict.fromkeys(c for i in (-1, 0, 1) for j in (-1, 0, 1) for c in squares.get((x + i, y + j), ()))

    return near


def short(value):
    # Lists may be nested deeper than Python can print.
    return "a list" if isinstance(value, list) else "an object" if isinstance(value, dict) else ascii(value)[:60]


def show(p):
    return f"({p.real:.3f}, {p.imag:.3f})"


def number(value):
    if type(value) not in (int, float) or not -LARGEST <= value <= LARGEST:
        raise Wrong(f"not-a-number: {short(value)} stands where a number of at most {LARGEST:g} is needed")
    return value


def point(value):
    if not isinstance(value, list) or len(value) != 2:
        raise Wrong(f"not-a-plan: {short(value)} stands where a point [x, y] is needed")
    return complex(number(value[0]), number(value[1]))


def tour(instance, plan):
    """The value of a tour for an instance of GTSPLIB."""
    costs, sets = read(instance["gtsplib"])
    nodes = plan.get("tour") if isinstance(plan, dict) else None
    if not isinstance(nodes, list):
        raise Wrong("not-a-plan: there is no list of nodes, tour")
    home = {node: index for index, members in enumerate(sets) for node in members}
    seen = [home.get(n - 1) if type(n) is int else None for n in nodes]
    if None in seen:
        raise Wrong(f"not-a-plan: {short(nodes[seen.index(None)])} is not a node of this instance; nodes count from 1")
    if len(set(seen)) < len(seen):
        raise Wrong(f"visited-twice: set {max(set(seen), key=seen.count)} is visited more than once")
    if len(seen) < len(sets):
        raise Wrong(f"not-visited: set {min(set(range(len(sets))) - set(seen))} is not visited")
    return float(sum(costs(a - 1, b - 1) for a, b in zip(nodes, nodes[1:] + nodes[:1])))


def read(text):
    """The cost between two nodes as a function, and the nodes of each set, by the definitions of TSPLIB95; nodes count from 0."""
    head, *rest = re.split(r"^\s*(\w+_SECTION)\b[\s:]*", re.split(r"^\s*EOF", text, flags=re.MULTILINE)[0], flags=re.MULTILINE)
    header = dict(re.findall(r"^\s*(\w+)[ \t]*:[ \t]*(\S+)", head, re.MULTILINE))
    words = {name: body.split() for name, body in zip(rest[::2], rest[1::2])}
    # A set is its number, its nodes and -1, in one line or in several.
    sets = [[int(x) - 1 for x in row.split()[1:]] for row in f"{' '.join(words['GTSP_SET_SECTION'])} ".split(" -1 ")[:-1]]
    flat = [int(float(x)) for x in words.get("EDGE_WEIGHT_SECTION", [])]
    at = {int(node) - 1: (number(float(x)), number(float(y))) for node, x, y in zip(*[iter(words.get("NODE_COORD_SECTION", []))] * 3)}
    kind, n = header["EDGE_WEIGHT_TYPE"], int(header["DIMENSION"])
    costs = {
        "EUC_2D": lambda a, b: int(math.dist(at[a], at[b]) + 0.5),
        "ATT": lambda a, b: math.ceil(math.dist(at[a], at[b]) / math.sqrt(10)),
        "GEO": lambda a, b: geographical(at[a], at[b]),
        "FULL_MATRIX": lambda a, b: flat[a * n + b],
        "LOWER_DIAG_ROW": lambda a, b: flat[max(a, b) * (max(a, b) + 1) // 2 + min(a, b)],
        "UPPER_DIAG_ROW": lambda a, b: flat[min(a, b) * (2 * n - min(a, b) + 1) // 2 + abs(a - b)],
    }
    return costs[header["EDGE_WEIGHT_FORMAT"] if kind == "EXPLICIT" else kind], sets


def geographical(a, b):
    (la, lo), (lb, mo) = [[3.141592 * (int(x) + 5 * (x - int(x)) / 3) / 180 for x in p] for p in (a, b)]
    q1, q2, q3 = math.cos(lo - mo), math.cos(la - lb), math.cos(la + lb)
    return int(6378.388 * math.acos(min(0.5 * ((1 + q1) * q2 - (1 - q1) * q3), 1.0)) + 1)
