"""Replays plans that mind heat with Shapely, which shares no code with Kerfway.

    KERFWAY_BLESS=1 cargo test --features png --test it levers_replay     # writes the plans to target/heat
    python tests/oracle/heat.py                                           # replays them

writes `tests/fixtures/heat.json`: for each plan the hash of its moves, the number of waits, and the faults found.
`tests/it/levers_replay.rs` then checks that Kerfway still makes these plans. Times are added up here from the moves: trapezoids for moves with
the beam off, and along cuts a look-ahead in which corners are no limit and arcs are run at v^2 = a r. They have to be those of the plan. From the
end of a cut to the beginning of each cut that is nearer than `distance`, at least `seconds` have to pass.

Needs `pip install shapely`.
"""

import math

import shapely

from judge import contour_lines, elements, judge

# mm: deviation of chords; how far too near lines have to be before they count as near. s: rounding of sums.
CHORD, SLACK, SAME = 0.0005, 2e-3, 1e-6


def ramp(length, top2, start2, end2, accel):
    """Seconds along an element: at most `top2`, from and to given squares of speeds, which can be reached."""
    peak2 = min(top2, 0.5 * (start2 + end2) + accel * length)
    start, peak, end = (math.sqrt(v) for v in (start2, peak2, end2))
    ramps = (2 * peak2 - start2 - end2) / (2 * accel)
    return (2 * peak - start - end) / accel + max(0.0, length - ramps) / peak


def cut_seconds(chain, speed, accel):
    lengths = [(e.length, min(speed**2, accel * e.radius) if e.center else speed**2) for e in chain if e.length > 0]
    v2 = [0.0, *(min(a[1], b[1]) for a, b in zip(lengths, lengths[1:])), 0.0]
    for k, (length, _) in enumerate(lengths):
        v2[k + 1] = min(v2[k + 1], v2[k] + 2 * accel * length)
    for k, (length, _) in reversed(list(enumerate(lengths))):
        v2[k] = min(v2[k], v2[k + 1] + 2 * accel * length)
    return sum(ramp(length, top2, v2[k], v2[k + 1], accel) for k, (length, top2) in enumerate(lengths))


def air_seconds(a, b, rapid):
    """A move from rest to rest: the slower axis determines the time."""
    axes = zip(a, b, rapid["speed"], rapid["accel"])
    return max(ramp(abs(q - p), v**2, 0.0, 0.0, accel) if p != q else 0.0 for p, q, v, accel in axes)


def replay(plan):
    machine = plan["machine"]
    heat = machine["levers"]["heat"]
    beams = contour_lines(plan, CHORD)
    assert machine["travel"] == "per-axis" and machine.get("junction_deviation") is None
    at, now, begins, ended, faults, waits = tuple(machine["home"]), 0.0, 0.0, [], [], 0
    for index, move in enumerate(plan["moves"]):
        if move["kind"] == "air":
            now += air_seconds(at, move["to"], machine["rapid"])
            at, begins = tuple(move["to"]), None
        elif move["kind"] == "wait":
            now, waits = now + move["seconds"], waits + 1
        elif move["kind"] == "pierce":
            begins = now
            now += machine["pierce_time"]
        elif move["kind"] == "cut":
            chain = elements(at, move["path"], CHORD)
            contour = plan["contours"][move["contour"]]
            marks = contour["operation"] == "mark"
            process = machine["mark" if marks else "cut"]
            begins = now if begins is None else begins
            at, now = chain[-1].end, now + cut_seconds(chain, process["speed"], process["accel"])
            now += machine["beam_on_delay"] + machine["beam_off_delay"]
            if not marks:
                near = [(k, end) for k, end in ended if begins < end + heat["seconds"] - SAME]
                for k, end in near:
                    if beams[k].distance(beams[move["contour"]]) < heat["distance"] - SLACK:
                        faults.append(f"move {index} begins contour {move['contour']} {begins - end:.6f} s after contour {k} near it")
                ended.append((move["contour"], now))
            begins = None
        else:
            raise ValueError(move["kind"])
    if abs(now - plan["summary"]["total_time"]) > SAME * (1 + now):
        faults.append(f"the plan takes {now} s, not {plan['summary']['total_time']} s")
    return {"count": waits, "faults": faults}


judge("heat", replay)
