"""Lines, arcs and contours, as the reference checker (check.py) reads and follows them."""

import json
import math
from bisect import bisect
from itertools import accumulate

NEAR = 1e-3  # mm: how far a plan may be from the geometry of its instance
STEP = 0.5  # mm: lines and arcs are compared with the contour this often, and at least eight times
LARGEST = 1e9  # the largest number in a plan: sums and squares of such numbers are numbers


class Wrong(Exception):
    """A plan that breaks a rule. Its text begins with one of: not-a-plan, not-a-number, no-pierce, off-contour, not-whole, not-an-endpoint,
    cut-twice, not-cut, order, no-return, visited-twice, not-visited, claim."""


def short(value):
    text = repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."


def number(value):
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not -LARGEST <= value <= LARGEST:
        text = "an integer of many digits" if isinstance(value, int) and abs(value) > 10**60 else short(value)
        raise Wrong(f"not-a-number: {text} stands where a number of at most {LARGEST:g} is needed")
    return float(value)


def point(value):
    if not isinstance(value, list) or len(value) != 2:
        raise Wrong(f"not-a-plan: {short(value)} stands where a point [x, y] is needed")
    return number(value[0]), number(value[1])


def pieces(start, path):
    """The lines and arcs of a path."""
    if not isinstance(path, list) or not path:
        raise Wrong("not-a-plan: a cut has no path")
    for piece in path:
        if isinstance(piece, dict) and "line" in piece:
            made = Line(start, point(piece["line"]))
        elif isinstance(piece, dict) and "arc" in piece:
            made = Arc(start, point(piece["arc"]), point(piece.get("center")), piece.get("ccw") is True, len(path) == 1)
        else:
            raise Wrong(f"not-a-plan: {short(piece)} is neither a line nor an arc")
        yield made
        start = made.end


class Line:
    def __init__(self, a, b):
        self.a, self.end, self.length = a, b, math.dist(a, b)

    def at(self, t):
        return self.a[0] + t * (self.end[0] - self.a[0]), self.a[1] + t * (self.end[1] - self.a[1])

    def nearest(self, p):
        along = sum((self.end[i] - self.a[i]) * (p[i] - self.a[i]) for i in (0, 1))
        return min(max(along / self.length**2, 0.0), 1.0) if self.length > 0 else 0.0


class Arc:
    def __init__(self, a, b, center, ccw, alone):
        self.center, self.end, self.radius = center, b, math.dist(center, a)
        if abs(self.radius - math.dist(center, b)) > NEAR:
            raise Wrong(f"off-contour: the ends of an arc around {show(center)} are at different distances from it")
        self.first, self.sign = self.angle(a), 1 if ccw else -1
        sweep = (self.angle(b) - self.first) * self.sign % (2 * math.pi)
        # Ends that are the same point are a whole turn; in a cut of one arc also those that are as near as a plan may be.
        same = alone and max(math.dist(a, b), self.radius * sweep) <= 2 * NEAR
        self.sweep = 2 * math.pi if same or math.dist(a, b) <= 1e-9 or sweep == 0 else sweep
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
        self.length = self.vertices[-1]
        # Stretches from and to a length, in their order and apart by more than twice NEAR.
        self.cuts = []

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
                    passed = [k / n for k in range(n + 1)] + self.corners(here, way, piece.length)
                    if any(math.dist(piece.at(t), self.at(here + way * piece.length * t)) > 2 * NEAR for t in passed):
                        break
                    here += way * piece.length
                else:
                    if self.closed or -NEAR <= here <= self.length + NEAR:
                        return s, here
        return None

    def corners(self, s, way, length):
        """The shares of a stretch at which the lines and arcs of this contour meet."""
        low = s if way > 0 else s - length
        laps = range(math.floor(low / self.length), math.floor((low + length) / self.length) + 1) if self.closed else (0,)
        inside = [v + lap * self.length - low for lap in laps for v in self.vertices if low < v + lap * self.length < low + length]
        return [(d if way > 0 else length - d) / length for d in inside]

    def is_open_at(self, p):
        """Whether what is cut of this contour ends here: no piercing is needed to go on."""
        return any(math.dist(self.at(s), p) <= 2 * NEAR for stretch in self.cuts for s in stretch)

    def stretches(self, s, end):
        """A cut between two lengths; where it runs over the start of a closed contour, its two stretches."""
        low, high = min(s, end), max(s, end)
        if not self.closed:
            return [(max(low, 0.0), min(high, self.length))]
        shift = math.floor(low / self.length) * self.length
        low, high = low - shift, high - shift
        return [(low, min(high, self.length))] + ([(0.0, high - self.length)] if high > self.length else [])

    def cut_before(self, s, end):
        """How much of a cut has been cut before, and where that begins."""
        shared = [(min(b, d) - max(a, c), max(a, c)) for a, b in self.stretches(s, end) for c, d in self.cuts]
        return max(shared, default=(0.0, 0.0))

    def add(self, s, end):
        """Takes a cut."""
        for a, b in self.stretches(s, end):
            joined = [(a, b)] + [c for c in self.cuts if c[0] <= b + 2 * NEAR and a <= c[1] + 2 * NEAR]
            apart = [c for c in self.cuts if c not in joined]
            self.cuts = sorted([*apart, (min(c[0] for c in joined), max(c[1] for c in joined))])

    def is_cut(self):
        """Whether all of it is cut."""
        if len(self.cuts) != 1:
            return self.length <= 2 * NEAR
        begin, end = self.cuts[0]
        left = (begin, self.length - end)
        return sum(left) <= 2 * NEAR if self.closed else max(left) <= 2 * NEAR


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


def show(p):
    return f"({p[0]:.3f}, {p[1]:.3f})"
