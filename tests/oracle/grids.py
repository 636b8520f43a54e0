"""Seconds that any path through a grid of parts takes besides cutting, at least: what is proven by a solver.

    python tests/oracle/grids.py

writes `tests/fixtures/grids.json` for grids of parts of 20 x 10 mm, the first corner at 100, 100, which
`tests/common_cuts_grids.rs` compares with what is planned. 7 x 7 takes a minute or two; where the solver is out of time, what it
has proven so far stands, which is a bound as well, and is told. Nothing is shared with Kerfway.
Needs `pip install ortools`.

Every plan gives a solution of the model below, of no more seconds; so its optimum is a bound.

- A trail is what is cut between two air moves. At a node b trails begin, e end; p = 1 if one of them is pierced, which only
  the first cut there can be; a arrivals are late: a part around the node has come loose before. Begins that are not
  pierced and late arrivals take a pre-cut each; pre-cuts take a stop in time, free if a trail is pierced or ends there.
  b + e is odd where an odd number of cuts meets. The last arrival of all is late, or at a corner of the grid.
- A part comes loose with the last of its four sides. It *picks* the node where that side ends. At a node where no arrival is
  late and which no trail but one needed for parity touches (a good one), cuts that leave follow one that arrives or are
  the first of all. So when a part comes loose by a side that does not end there, nothing arrives there any more: the part
  that picks a good node is the first of those around it. At most 1 + a parts pick a node; none one with b = 1 and
  p = a = 0, as a stop for its pre-cut would come too late; none a corner of the grid but where a trail ends.
- Air moves lead from ends to begins, but for the first begin and the last end, which lead from and to home. Those from or
  to even nodes count nothing.
"""

import json
import math
from itertools import product
from pathlib import Path

from ortools.sat.python import cp_model

FIXTURE = Path(__file__).resolve().parent.parent / "fixtures" / "grids.json"
SIZES = [(2, 2), (3, 2), (3, 3), (4, 3), (4, 4), (5, 4), (5, 5), (6, 6), (7, 7)]
# The machine `thick` of `tests/support/plates.rs`. S: start of the beam, piercing, pre-cut; mm/s, mm/s^2 of each axis.
START, PIERCE, PRE_CUT, SPEED, ACCEL = 0.3, 1.0, 0.3, 10000 / 6, 9810.0
# Parts of a second that the solver counts in.
UNIT = 10_000


def air(a, b):
    """Seconds of an air move: each axis for itself, from rest to rest."""

    def axis(d):
        return 2 * math.sqrt(d / ACCEL) if d < SPEED**2 / ACCEL else d / SPEED + SPEED / ACCEL

    return max(axis(abs(a[0] - b[0])), axis(abs(a[1] - b[1])))


def kinds(degree):
    """What can happen at a node: seconds, begins, ends, pierced, late arrivals, first begin of all, last end of all."""
    for b, e, p, a, first, last in product(range(degree + 1), range(degree + 1), (0, 1), range(degree + 1), (0, 1), (0, 1)):
        leaving = (degree + b - e) // 2
        if b + e > degree or (b + e) % 2 != degree % 2 or a > degree - leaving:
            continue
        # Where all cuts begin trails one is the first; the first of all is pierced; see above for the last of all.
        if p > b or (0 < b == degree and not p) or first > p or last > e or (last and not a and degree > 2):
            continue
        pre_cuts = b - p + a
        stop = pre_cuts > 0 and p + e - last <= 0
        yield START * (b + stop) + PIERCE * p + PRE_CUT * pre_cuts, b, e, p, a, first, last


class Grid:
    """The model of a grid of m by n parts."""

    def __init__(self, m, n):
        self.model, self.seconds = cp_model.CpModel(), []
        self.parts = list(product(range(m), range(n)))
        self.nodes = list(product(range(m + 1), range(n + 1)))
        self.place = {v: (100 + 20 * v[0], 100 + 10 * v[1]) for v in self.nodes}
        self.degree = {(x, y): 2 + (0 < x < m) + (0 < y < n) for x, y in self.nodes}
        self.begins, self.ends, self.firsts, self.lasts = {}, {}, {}, {}
        self.order(m, n)
        self.picks = {(c, v): self.bool() for c in self.parts for v in self.corners(c)}
        for c in self.parts:
            self.model.add_exactly_one(self.picks[c, v] for v in self.corners(c))
        for v in self.nodes:
            self.node(v)
        self.model.add_exactly_one(x for v in self.nodes for x in self.firsts[v])
        self.model.add_exactly_one(x for v in self.nodes for x in self.lasts[v])
        self.air()
        self.model.minimize(sum(math.floor(s * UNIT + 1e-6) * x for s, x in self.seconds))

    def bool(self):
        return self.model.new_bool_var("")

    @staticmethod
    def corners(c):
        return [(c[0] + i, c[1] + j) for i, j in product((0, 1), (0, 1))]

    def around(self, v):
        return [c for c in product((v[0] - 1, v[0]), (v[1] - 1, v[1])) if c in self.known]

    def order(self, m, n):
        """Which of two parts at a node comes loose first: an order of the four around each."""
        self.known, self.first_of = set(self.parts), {}
        for x, y in product(range(m - 1), range(n - 1)):
            four = list(product((x, x + 1), (y, y + 1)))
            for a, b, c in product(four, four, four):
                if len({a, b, c}) == 3 and a < b and a < c:
                    self.model.add_bool_or(~self.before(a, b), ~self.before(b, c), self.before(a, c))

    def before(self, a, b):
        if a > b:
            return ~self.before(b, a)
        if (a, b) not in self.first_of:
            self.first_of[a, b] = self.bool()
        return self.first_of[a, b]

    def node(self, v):
        degree, odd = self.degree[v], self.degree[v] % 2
        kind, begins, ends, room, bad = [], [], [], [], []
        self.firsts[v], self.lasts[v] = [], []
        for seconds, b, e, p, a, first, last in kinds(degree):
            x = self.bool()
            kind.append(x)
            home = (first + last) * air((0, 0), self.place[v])
            self.seconds.append((seconds + home, x))
            begins.append(b * x)
            ends.append(e * x)
            resumed = odd and (b, e, p, a) == (1, 0, 0, 0)
            room.append((0 if resumed else min(e, 1) if degree == 2 else 1 + a) * x)
            if a or b + e != odd:
                bad.append(x)
            if first:
                self.firsts[v].append(x)
            if last:
                self.lasts[v].append(x)
        self.model.add_exactly_one(kind)
        self.begins[v], self.ends[v] = sum(begins), sum(ends)
        around = self.around(v)
        self.model.add(sum(self.picks[c, v] for c in around) <= sum(room))
        for c, other in product(around, around):
            if c != other:
                self.model.add_bool_or(~self.picks[c, v], self.before(c, other), *bad)

    def air(self):
        odd = [v for v in self.nodes if self.degree[v] % 2]
        even = [v for v in self.nodes if self.degree[v] % 2 == 0]
        most = sum(self.degree.values())
        moves = {(a, b): self.model.new_int_var(0, 3, "") for a, b in product(odd, odd)}
        self.seconds += [(air(self.place[a], self.place[b]), x) for (a, b), x in moves.items()]
        away, back = ({v: self.model.new_int_var(0, 3, "") for v in odd} for _ in range(2))
        between = self.model.new_int_var(0, most, "")
        for v in odd:
            self.model.add(sum(moves[v, w] for w in odd) + away[v] == self.ends[v] - sum(self.lasts[v]))
            self.model.add(sum(moves[w, v] for w in odd) + back[v] == self.begins[v] - sum(self.firsts[v]))
        self.model.add(sum(away.values()) + between == sum(self.begins[v] - sum(self.firsts[v]) for v in even))
        self.model.add(sum(back.values()) + between == sum(self.ends[v] - sum(self.lasts[v]) for v in even))


def main():
    found = []
    for m, n in SIZES:
        solver = cp_model.CpSolver()
        solver.parameters.num_workers, solver.parameters.max_time_in_seconds = 2, 900
        state = solver.status_name(solver.solve(Grid(m, n).model))
        bound = math.floor(solver.best_objective_bound / UNIT * 1000) / 1000
        told = "the least there is" if state == "OPTIMAL" else f"proven so far ({state})"
        print(f"{m} x {n}: {bound} s, {told}, {solver.wall_time:.1f} s")
        found.append({"m": m, "n": n, "seconds": bound})
    FIXTURE.write_text("[\n" + ",\n".join(json.dumps(f) for f in found) + "\n]\n")


if __name__ == "__main__":
    main()
