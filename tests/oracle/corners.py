"""Replays plans whose corners are cut in loops or rounded with Shapely, which shares no code with Kerfway.

    KERFWAY_BLESS=1 cargo test --features png --test it levers_replay     # writes the plans to target/corners
    python tests/oracle/corners.py                                        # replays them

writes `tests/fixtures/corners.json`: for each plan the hash of its moves, the number of loops and of rounded corners (`others`), and the faults
found. `tests/it/levers_replay.rs` then checks that Kerfway still makes these plans. For each corner:

* a loop lies in no part, less 5 micrometres (parts: outlines without their holes), and keeps the clearance from every other cut;
* a loop begins and ends in its corner and runs straight through it, both times, within 0.1 degrees;
* an arc touches both sides, is no farther from the corner than the deviation, and its radius is no larger than asked.

Needs `pip install shapely`.
"""

import math

import shapely

from judge import contour_lines, elements, judge, line, parts_of, turned

# mm: deviation of chords; what a place may be off.
CHORD, SAME = 0.0005, 2e-3


def replay(plan):
    lever = plan["machine"]["levers"]["corners"]
    beams, parts = contour_lines(plan, CHORD), parts_of(plan, CHORD)
    part_tree = shapely.STRtree(parts)
    ids = [k for k in beams if plan["contours"][k]["operation"] == "cut"]
    tree = shapely.STRtree([beams[k] for k in ids])
    faults, loops, rounded, length, deviation = [], 0, 0, 0.0, 0.0
    at = tuple(plan["machine"]["home"])
    for index, move in enumerate(plan["moves"]):
        if move["kind"] in ("air", "pre-cut"):
            at = tuple(move["to"])
        if move["kind"] != "cut":
            continue
        chain = elements(at, move["path"], CHORD)
        at = chain[-1].end
        for corner in move.get("corners", []):
            first, last = corner["first"], corner["first"] + corner["count"]
            own, around = chain[first:last], chain[first - 1 : last + 1]
            say = lambda what: faults.append(f"move {index}, corner {corner['at']}: {what}")  # noqa: B023, E731
            if any(turned(a.direction(True), b.direction(False)) > 0.1 for a, b in zip(around, around[1:])):
                say("is not run straight on")
            if corner["kind"] == "round":
                rounded += 1
                off = math.dist(corner["at"], own[0].center) - own[0].radius
                deviation = max(deviation, off)
                if len(own) != 1 or off > lever["deviation"] + 1e-6 or own[0].radius > lever["round_radius"] + 1e-6:
                    say("is rounded by more than is allowed")
                continue
            loops, length = loops + 1, length + sum(e.length for e in own)
            if max(math.dist(own[0].start, corner["at"]), math.dist(own[-1].end, corner["at"])) > 1e-6:
                say("is not where its loop begins and ends")
            shape = line(own)
            for j in part_tree.query(shape):
                if shape.intersection(parts[j]).length > 0:
                    say("has a loop that cuts into a part")
            for j in tree.query(shape.buffer(lever["clearance"])):
                if ids[j] != move["contour"] and shape.distance(beams[ids[j]]) < lever["clearance"] - SAME:
                    say(f"has a loop {shape.distance(beams[ids[j]]):.4f} mm from contour {ids[j]}")
    summary = plan["summary"]
    says = [summary.get(k, 0) for k in ("loops", "rounded_corners", "loop_length", "corner_deviation")]
    if says[:2] != [loops, rounded] or abs(says[2] - length) > 1e-6 or abs(says[3] - deviation) > 1e-6:
        faults.append(f"the plan says {says}, its moves {loops}, {rounded}, {length}, {deviation}")
    return {"count": loops, "others": rounded, "faults": faults}


judge("corners", replay)
