"""Replays plans near tipped pieces with Shapely, which shares no code with Kerfway.

    KERFWAY_BLESS=1 cargo test --features png --test it tips::replay     # writes the plans to target/tips
    python tests/oracle/tips.py                                          # replays them

writes `tests/fixtures/tips.json`: for each plan the hash of its moves, the contours whose pieces may tip, and the moves with the head down that
cross such a piece while it is free. `tests/it/tips/replay.rs` then checks that Kerfway still makes these plans. A piece is the area within a
closed contour that is cut, as the cuts of the plan run around it; it is free from the last of these cuts on, with those of neighbours that cut
sides of it, and held if the plan leaves a micro-joint on it. Where the machine moves each axis by itself (`per-axis`), a move is followed along the way
of both axes. A move with the head down crosses a piece where it runs over it, but for a stretch at an end that begins over it, or where it
comes nearer to it than nozzle and margin allow and nearer than at both of its ends.

`surely` are the moves that cross by more than a tenth of a millimetre, `maybe` those that cross but for as much.

Needs `pip install shapely`.
"""

import json
import math

import shapely
from shapely import affinity

from judge import depth_of, elements, judge, polygon

# mm: deviation of chords; what decides between surely and maybe; sizes that are the same, as chords make circles smaller.
CHORD, SLACK, SAME = 0.002, 0.1, 0.01
# mm: lines that are nearer are one.
ONE_LINE = 0.1


def extents(shape):
    x0, y0, x1, y1 = shape.bounds
    return x1 - x0, y1 - y0


def tips_up(shape, tips, is_hole):
    width, height = extents(shape)
    if is_hole and max(width, height) <= tips["cross_over"] + SAME:
        return False
    across, along, usual = min(width, height), max(width, height), 50.0
    if "slats" in tips:
        along, across = extents(affinity.rotate(shape, -math.degrees(tips["slats"]["angle"]), origin=(0, 0)))
        usual = tips["slats"]["pitch"]
    drops = tips.get("drops_below", usual)
    below = lambda size, limit: size < limit - SAME  # noqa: E731
    return below(across, tips["tips_below"]) and not (below(across, drops) and below(along, drops))


def pieces(plan):
    """The pieces that may tip: contours, area, and the index of the last cut around it."""
    at, chains, last, held = tuple(plan["machine"]["home"]), {}, {}, set()
    for index, move in enumerate(plan["moves"]):
        if move["kind"] in ("air", "pre-cut"):
            at = tuple(move["to"])
        if move["kind"] in ("cut", "joint"):
            chain = elements(at, move["path"], CHORD)
            at = chain[-1].end
            for k in move["contour"] if isinstance(move["contour"], list) else [move["contour"]]:
                until = len(chain) - move.get("overcut", 0) - move.get("lead_out", 0)
                chains.setdefault(k, []).extend(chain[move.get("lead_in", 0) : until])
                last[k] = index
                if move["kind"] == "joint":
                    held.add(k)
    tips, found, shapes = plan["machine"]["levers"]["tips"], [], {}
    for contour in plan["contours"]:
        k, drawn = contour["id"], contour.get("drawn")
        if k not in chains or contour["operation"] != "cut" or "next_pass" in contour or not (contour["closed"] or drawn):
            continue
        if contour["closed"]:
            key, outline = k, chains[k]
        else:
            # What is left of a shape whose sides are cut with others.
            key, outline = json.dumps(drawn), elements(tuple(drawn["from"]), drawn["path"], CHORD)
        corners = [q for e in outline for q in e.points()[:-1]]
        # What is cut there and back along one line bounds nothing, and is an obstacle all the same.
        shape = polygon(corners) if len(corners) > 2 else shapely.LineString(corners)
        shapes.setdefault(key, [shape, depth_of(plan, contour) % 2 == 1, []])[2].append(k)
    lines = {k: shapely.LineString([q for e in chain for q in e.points()]) for k, chain in chains.items()}
    last_passes = {c["id"] for c in plan["contours"] if c["operation"] == "cut" and "next_pass" not in c}
    for shape, is_hole, contours in shapes.values():
        if not held.intersection(contours) and tips_up(shape, tips, is_hole):
            # What its own cuts leave of its outline is cut by others.
            left = shape.boundary.difference(shapely.union_all([lines[k] for k in contours]).buffer(ONE_LINE))
            others = [k for k in sorted(last_passes.intersection(lines).difference(contours)) if lines[k].distance(left) < ONE_LINE]
            others = [k for k in others if left.intersection(lines[k].buffer(ONE_LINE)).length > 2 * ONE_LINE]
            found.append((contours, shape, max(last[k] for k in contours + others)))
    return found


def gone(length, speed, accel, t):
    """How far an axis has gone after `t` of the seconds that it takes from rest to rest; and these seconds."""
    top = min(speed, math.sqrt(accel * length)) if accel else speed
    ramp = top / accel if accel else 0.0
    seconds = length / top + ramp if length else 0.0
    if t >= seconds:
        return length, seconds
    # Up to the end of the ramp, at full speed, and down the ramp, as seen from the nearer end.
    near = min(t, seconds - t)
    path = 0.5 * accel * near * near if near < ramp else top * (near - 0.5 * ramp)
    return (path if t <= 0.5 * seconds else length - path), seconds


def way_of(machine, start, end):
    """The line along which the head runs, down, without a way point."""
    if machine["travel"] != "per-axis":
        return shapely.LineString([start, end])
    rapid, axes = machine["rapid"], []
    for k in (0, 1):
        accel = rapid["accel"][k] if rapid.get("accel") else None
        axes.append((abs(end[k] - start[k]), rapid["speed"][k], accel, math.copysign(1.0, end[k] - start[k])))
    seconds = max(gone(*axis[:3], 0.0)[1] for axis in axes)
    count = max(2, math.ceil(2 * sum(axis[0] for axis in axes)))
    at = lambda t: [p + axis[3] * gone(*axis[:3], t)[0] for p, axis in zip(start, axes)]  # noqa: E731
    return shapely.LineString([start, *(at(seconds * k / count) for k in range(1, count)), end])


def crosses(move, shape, reach, slack):
    """Whether a move crosses a piece by more than `slack` mm, which may be negative."""
    if move.distance(shape) > reach + SLACK:
        return False
    ends = [shapely.Point(p) for p in (move.coords[0], move.coords[-1])]
    if move.distance(shape) < min(reach - slack, min(e.distance(shape) for e in ends) - slack):
        return True
    within = shape.buffer(-max(slack, 1e-3))
    over = move.intersection(within)
    stretches = [s for s in shapely.get_parts(over) if s.length > 1e-6]
    exempt = lambda s: any(within.covers(e) and s.distance(e) < 1e-6 for e in ends)  # noqa: E731
    return any(not exempt(s) for s in stretches)


def replay(plan):
    tips = plan["machine"]["levers"]["tips"]
    reach, known = tips["nozzle_radius"] + tips["margin"], pieces(plan)
    tree = shapely.STRtree([shape for _, shape, _ in known])
    head, surely, maybe, marked, lifted, around = plan["machine"]["home"], [], [], [], 0, 0
    for index, move in enumerate(plan["moves"]):
        start = head
        if move["kind"] in ("air", "pre-cut"):
            head = move["to"]
        elif move["kind"] in ("cut", "joint"):
            head = elements(tuple(start), move["path"], CHORD)[-1].end
        if move["kind"] != "air" or math.dist(start, head) == 0:
            continue
        lifted += move.get("way") == "lifted"
        around += move.get("way") == "around"
        if move.get("way") == "crosses":
            marked.append(index)
        if move.get("way") == "lifted":
            continue
        way = way_of(plan["machine"], start, head)
        free = [known[j][1] for j in tree.query(shapely.box(*way.bounds).buffer(reach + SLACK)) if known[j][2] < index]
        if any(crosses(way, shape, reach, SLACK) for shape in free):
            surely.append(index)
        # Where each axis moves by itself, a piece beside the way may be said to be crossed, as ramps are not known exactly.
        beside = shapely.box(*way.bounds) if plan["machine"]["travel"] == "per-axis" else None
        if any(crosses(way, shape, reach, -SLACK) or (beside and beside.distance(shape) < reach + SLACK) for shape in free):
            maybe.append(index)
    faults = [f"move {i} crosses a piece and does not say so" for i in surely if i not in marked]
    faults += [f"move {i} says that it crosses a piece" for i in marked if i not in maybe]
    return {"tips": sorted(k for ks, _, _ in known for k in ks), "surely": surely, "lifted": lifted, "way_points": around, "faults": faults}


judge("tips", replay)
