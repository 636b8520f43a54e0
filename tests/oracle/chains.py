"""Replays plans with chains with Shapely, which shares no code with Kerfway.

    KERFWAY_BLESS=1 cargo test --features png --test it levers_replay     # writes the plans to target/chains
    python tests/oracle/chains.py                                         # replays them

writes `tests/fixtures/chains.json`: for each plan the hash of its moves, the number of chains, how many of them begin on a kerf (`others`), and the
faults found. `tests/it/levers_replay.rs` then checks that Kerfway still makes these plans. For each chain:

* it lies in no part, less 5 micrometres (parts: outlines without their holes);
* it keeps the clearance from every cut but the two that it joins (less the error of the chords, 2 micrometres);
* it is no longer than the reach, begins where the cut before it ends, on the kerf of a contour that was cut earlier, or, at the edge of the sheet, outside
  of all cuts, and ends where the next one begins.

Needs `pip install shapely`.
"""

import math

import shapely

from judge import contour_lines, elements, judge, parts_of

# mm: deviation of chords; what a place may be off.
CHORD, SAME = 0.0005, 2e-3


def replay(plan):
    lever = plan["machine"]["levers"]["chains"]
    beams, parts = contour_lines(plan, CHORD), parts_of(plan, CHORD)
    part_tree = shapely.STRtree(parts)
    ids = [k for k in beams if plan["contours"][k]["operation"] == "cut"]
    tree = shapely.STRtree([beams[k] for k in ids])
    everything = shapely.box(*shapely.union_all([beams[k] for k in ids]).bounds)
    faults, count, edges = [], 0, 0
    at, before, after_cut, done = tuple(plan["machine"]["home"]), None, False, []
    for index, move in enumerate(plan["moves"]):
        if move["kind"] == "chain":
            chain = elements(at, move["path"], CHORD)
            start, end, follows = chain[0].start, chain[-1].end, plan["moves"][index + 1]
            shape = shapely.LineString([start, end])
            say = lambda what: faults.append(f"move {index}: {what}")  # noqa: B023, E731
            count, edges = count + 1, edges + (not after_cut)
            if len(chain) != 1 or chain[0].center or shape.length > lever["reach"] + SAME:
                say("is not straight, or too long")
            from_edge = not after_cut and not everything.covers(shapely.Point(start))
            kerfs = [k for k in done if k != follows.get("contour") and beams[k].distance(shapely.Point(start)) <= SAME]
            begins = before if after_cut else next(iter(kerfs), None)
            if follows["kind"] != "cut" or (not from_edge and (begins is None or follows["contour"] == begins)):
                say("does not join two cuts")
                continue
            if math.dist(end, elements(end, follows["path"], CHORD)[0].start) > SAME:
                say("does not end where the next cut begins")
            if not after_cut and not lever.get("edge_starts"):
                say("begins on a kerf, which the machine does not")
            for j in part_tree.query(shape):
                if shape.intersection(parts[j]).length > 0:
                    say("cuts into a part")
            for j in tree.query(shape.buffer(lever["clearance"])):
                if ids[j] not in (begins, follows["contour"]) and shape.distance(beams[ids[j]]) < lever["clearance"] - SAME:
                    say(f"is {shape.distance(beams[ids[j]]):.4f} mm from contour {ids[j]}")
            at = end
        if move["kind"] == "cut":
            at, before = elements(at, move["path"], CHORD)[-1].end, move["contour"]
            done.append(before)
        if move["kind"] in ("air", "pre-cut"):
            at = tuple(move["to"])
        after_cut = move["kind"] == "cut"
    return {"count": count, "others": edges, "faults": faults}


judge("chains", replay)
