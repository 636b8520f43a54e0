"""Seconds that any path through a grid of parts takes besides cutting, at least: what is proven by a solver.

    python tests/oracle/grids.py

writes `tests/fixtures/grids.json` for grids of parts of 20 x 10 mm, the first corner at 100, 100, which
`tests/common_cuts_grids.rs` compares with what is planned. Small ones take seconds, 7 x 7 half a minute; that of 10 x 10,
case by case, took 42 minutes on two cores. Nothing is shared with Kerfway. Needs `pip install ortools`.

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
- So a part that picks one of its eastern nodes is before its eastern neighbour, if both nodes between them are good; which
  picks neither of them then, but one of its own eastern ones. Likewise to the north. (It follows from the rest, and tells
  the solver what it would be long in finding: rows and columns of parts all pick the same side, but for few.)
- Air moves lead from ends to begins, but for the first begin and the last end, which lead from and to home. Those from or
  to even nodes count nothing.

Large grids: is there a plan of less than so many seconds? As begins are as many as ends, a begin may be charged half of
what begin and end take together, and an end the other half: each node then takes a least, the first and the last a bit more,
and every kind of node some *excess* over that. What all excesses may come to is known from the bound by hand (which is that
of `tests/common_cuts_grids.rs`): if that is less than two of them, all nodes but one are of kinds without. Each such kind
on each side of the grid is a case for the solver, and without any, each side where the last trail ends; a case that it
does not settle in some minutes is one for each node of the side.
"""

import json
import math
from itertools import product
from multiprocessing import Pool
from pathlib import Path

from ortools.sat.python import cp_model

FIXTURE = Path(__file__).resolve().parent.parent / "fixtures" / "grids.json"
SIZES = [(2, 2), (3, 2), (3, 3), (4, 3), (4, 4), (5, 4), (5, 5), (6, 6), (7, 7)]
# And of which it is shown that no path takes less than so many seconds.
LARGE = [(10, 10, 19.465)]
# The machine `thick` of `tests/testkit/plates.rs`. S: start of the beam, piercing, pre-cut; mm/s, mm/s^2 of each axis.
START, PIERCE, PRE_CUT, SPEED, ACCEL = 0.3, 1.0, 0.3, 10000 / 6, 9810.0
# Parts of a second that the solver counts in.
UNIT = 10_000
# Seconds after which a case is taken apart: most of a side take less.
PATIENCE = 400


def air(a, b):
    """Seconds of an air move: each axis for itself, from rest to rest."""

    def axis(d):
        return 2 * math.sqrt(d / ACCEL) if d < SPEED**2 / ACCEL else d / SPEED + SPEED / ACCEL

    return max(axis(abs(a[0] - b[0])), axis(abs(a[1] - b[1])))


def kinds(degree):
    """What can happen at a node: begins, ends, pierced, late arrivals, first begin of all, last end of all; its seconds."""
    for kind in product(range(degree + 1), range(degree + 1), (0, 1), range(degree + 1), (0, 1), (0, 1)):
        b, e, p, a, first, last = kind
        leaving = (degree + b - e) // 2
        if b + e > degree or (b + e) % 2 != degree % 2 or a > degree - leaving:
            continue
        # Where all cuts begin trails one is the first; the first of all is pierced; see above for the last of all.
        if p > b or (0 < b == degree and not p) or first > p or last > e or (last and not a and degree > 2):
            continue
        pre_cuts = b - p + a
        stop = pre_cuts > 0 and p + e - last <= 0
        yield kind, START * (b + stop) + PIERCE * p + PRE_CUT * pre_cuts


# What an end is charged of a trail: half of what it takes to begin one with a pre-cut and the stop for it.
HALF = (2 * START + PRE_CUT) / 2
# What the first and the last take more: a piercing, a late arrival.
FIRST, LAST = PIERCE - PRE_CUT - START, PRE_CUT + START


def excess(degree, kind, seconds):
    """What a kind of node takes more than the least."""
    b, e, _, _, first, last = kind
    over = seconds + HALF * (e - b) - HALF * (degree % 2) - FIRST * first - LAST * last
    assert over > -1e-9, (degree, kind)
    return round(over, 6)


def by_hand(m, n):
    """Seconds of a plan without any excess, and of its air moves, at least."""
    frame = [(x, y) for x, y in product(range(m + 1), range(n + 1)) if (0 < x < m) != (0 < y < n)]
    odd = [(20 * x, 10 * y) for x, y in frame]
    halves = [min(air(v, w) for w in odd if v != w) / 2 for v in odd]
    home = min(air((0, 0), (100 + 20 * x, 100 + 10 * y)) for x, y in product(range(m + 1), range(n + 1)))
    return HALF * len(odd) + FIRST + LAST, sum(halves) - 2 * max(halves) + 2 * home


class Grid:
    """The model of a grid of m by n parts; with a case, of plans of that case only."""

    def __init__(self, m, n, case=None):
        self.model, self.seconds = cp_model.CpModel(), []
        self.parts = list(product(range(m), range(n)))
        self.nodes = list(product(range(m + 1), range(n + 1)))
        self.place = {v: (100 + 20 * v[0], 100 + 10 * v[1]) for v in self.nodes}
        self.degree = {(x, y): 2 + (0 < x < m) + (0 < y < n) for x, y in self.nodes}
        self.begins, self.ends, self.firsts, self.lasts, self.bad = {}, {}, {}, {}, {}
        self.case, self.special, self.own = case, [], []
        self.order(m, n)
        self.picks = {(c, v): self.bool() for c in self.parts for v in self.corners(c)}
        for c in self.parts:
            self.model.add_exactly_one(self.picks[c, v] for v in self.corners(c))
        for v in self.nodes:
            self.node(v)
        self.passes_on()
        if case:
            self.model.add_exactly_one(self.special)
            # It follows from the rest, and is what the solver needs to begin with.
            over = excess(*case[0], dict(kinds(case[0][0]))[case[0][1]]) if case[0] else 0.0
            self.model.add(sum(round(10 * s) * x for s, x in self.own) == round(10 * (by_hand(m, n)[0] + over)))
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
        for (b, e, p, a, first, last), seconds in kinds(degree):
            here = self.case and self.is_case(v, (b, e, p, a, first, last), seconds)
            if here is False:
                continue
            x = self.bool()
            if here == "special":
                self.special.append(x)
            kind.append(x)
            home = (first + last) * air((0, 0), self.place[v])
            self.seconds.append((seconds + home, x))
            self.own.append((seconds, x))
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
        self.bad[v] = bad
        self.begins[v], self.ends[v] = sum(begins), sum(ends)
        around = self.around(v)
        self.model.add(sum(self.picks[c, v] for c in around) <= sum(room))
        for c, other in product(around, around):
            if c != other:
                self.model.add_bool_or(~self.picks[c, v], self.before(c, other), *bad)

    def is_case(self, v, kind, seconds):
        """Whether a node may be of a kind; "special" if that is the one of the case. What the sum of all rules out on the
        frame is left in: without it the solver takes longer."""
        special, where = self.case
        around = self.degree[v], kind
        if kind[-1] == 1 if special is None else around == special:
            return "special" if v in where else False
        return self.degree[v] == 3 or not excess(*around, seconds)

    def passes_on(self):
        """East and north go on from part to part."""
        for way in ((1, 0), (0, 1)):
            far = {c: self.bool() for c in self.parts}
            for c in self.parts:
                nodes = [v for v in self.corners(c) if v[0] * way[0] + v[1] * way[1] > c[0] * way[0] + c[1] * way[1]]
                self.model.add(sum(self.picks[c, v] for v in nodes) == far[c])
                after = (c[0] + way[0], c[1] + way[1])
                if after in self.known:
                    self.model.add_bool_or(~far[c], far[after], *self.bad[nodes[0]], *self.bad[nodes[1]])

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


def cases(m, n, limit):
    """All that a plan of less than so many seconds can be: without any excess, or with one node that has some."""
    least = limit - sum(by_hand(m, n))
    over = {(d, kind): excess(d, kind, s) for d in (2, 3, 4) for kind, s in kinds(d)}
    some = {x for x in over.values() if x}
    assert 2 * min(some) >= least, "two nodes may have an excess"
    special = [k for k, x in over.items() if 0 < x < least]
    assert [k for k, x in over.items() if k[0] == 4 and x < least] == [(4, (0,) * 6)], "all that differs is on the frame"
    bottom, top = ([(x, y) for x in range(m + 1)] for y in (0, n))
    left, right = ([(x, y) for y in range(1, n)] for x in (0, m))
    return [(m, n, limit, case) for case in product([None, *special], (bottom, left, right, top))]


def settled(case):
    """Whether there is a plan of less than so many seconds in a case; `None` if that takes too long."""
    m, n, limit, (special, nodes) = case
    grid = Grid(m, n, (special, nodes))
    # Each of them was rounded down, so a plan of less than the limit is one of these.
    grid.model.add(sum(math.floor(s * UNIT + 1e-6) * x for s, x in grid.seconds) <= round(limit * UNIT))
    solver = cp_model.CpSolver()
    solver.parameters.num_workers = 1
    if len(nodes) > 1:
        solver.parameters.max_time_in_seconds = PATIENCE
    state = solver.status_name(solver.solve(grid.model))
    print(f"{m} x {n} in less than {limit} s, {special} in {nodes}: {state}, {solver.wall_time:.0f} s", flush=True)
    return {"INFEASIBLE": False, "UNKNOWN": None}.get(state, True)


def refuted(m, n, limit, pool):
    """Whether there is no plan of less than so many seconds."""
    wide = cases(m, n, limit)
    found = pool.map(settled, wide, chunksize=1)
    narrow = [(m, n, limit, (k, [v])) for (_, _, _, (k, nodes)), is_so in zip(wide, found) if is_so is None for v in nodes]
    return not any(found) and not any(pool.map(settled, narrow, chunksize=1))


def small(m, n):
    """The least there is."""
    solver = cp_model.CpSolver()
    solver.parameters.num_workers, solver.parameters.max_time_in_seconds = 2, 900
    state = solver.status_name(solver.solve(Grid(m, n).model))
    bound = math.floor(solver.best_objective_bound / UNIT * 1000) / 1000
    told = "the least there is" if state == "OPTIMAL" else f"proven so far ({state})"
    print(f"{m} x {n}: {bound} s, {told}, {solver.wall_time:.1f} s", flush=True)
    return bound


def main():
    found = [(m, n, small(m, n)) for m, n in SIZES]
    with Pool(2) as pool:
        # The cases of a small grid tell the same as all at once.
        m, n, least = found[SIZES.index((5, 5))]
        assert refuted(m, n, least, pool) and not refuted(m, n, least + 0.01, pool)
        found += [(m, n, limit) for m, n, limit in LARGE if refuted(m, n, limit, pool)]
    lines = (json.dumps({"m": m, "n": n, "seconds": s}) for m, n, s in found)
    FIXTURE.write_text("[\n" + ",\n".join(lines) + "\n]\n")


if __name__ == "__main__":
    main()
