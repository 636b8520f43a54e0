"""Cuts plans with micro-joints with Shapely, which shares no code with Kerfway.

    KERFWAY_BLESS=1 cargo test --features png --test it joints::held     # writes the plans to target/joints
    python tests/oracle/joints.py                                        # cuts them

writes `tests/fixtures/joints.json`: for each plan the hash of its moves, how many parts the sheet still holds after all cuts, and the faults
found. `tests/it/joints/held.rs` then checks that Kerfway still makes these plans. A part is held if it is in one piece with the rim of the sheet
after the beam, as wide as the kerf, has passed all cuts. For each joint that a move leaves:

* what stays of it has the width of the rule (within 0.01 mm, as kerfs have round ends and contours are curved);
* it keeps the rule's distance from corners, along the contour;
* nothing else is cut within half its length: no other contour, no lead, no overcut.

Needs `pip install shapely`.
"""

import math

import shapely

from judge import depth_of, elements, judge, line, polygon, turned

# mm: deviation of chords, margin of the sheet around everything that is cut.
CHORD, MARGIN = 0.002, 10.0
CORNER = 10.1


def beams(plan):
    """Everything that is cut, as lines with their contours, and for each contour its elements in order, each with whether it is a joint."""
    at, lines, chains = tuple(plan["machine"]["home"]), [], {}
    for move in plan["moves"]:
        if move["kind"] in ("air", "pre-cut"):
            at = tuple(move["to"])
        if move["kind"] in ("cut", "joint"):
            chain = elements(at, move["path"], CHORD)
            at = chain[-1].end
            ids = move["contour"] if isinstance(move["contour"], list) else [move["contour"]]
            if plan["contours"][ids[0]]["operation"] != "cut":
                continue
            if move["kind"] == "cut":
                lines.append((ids[0], line(chain)))
            last = len(chain) - move.get("overcut", 0) - move.get("lead_out", 0)
            on = chain[move.get("lead_in", 0) : last]
            for k in ids:
                chains.setdefault(k, []).append((move["kind"] == "joint", on))
    return lines, chains


def corners(chain):
    """Arc lengths at which a closed chain of elements turns."""
    at, out = 0.0, []
    for a, b in zip(chain, chain[1:] + chain[:1]):
        at += a.length
        if turned(a.direction(True), b.direction(False)) > CORNER and math.dist(a.end, b.start) < 1e-3:
            out.append(at)
    return out, at


def rule_of(plan, contour):
    side = "hole" if depth_of(plan, contour) % 2 else "outer"
    return next((r for r in plan["machine"].get("joints", {"rules": []})["rules"] if r.get("side", side) == side), None)


def cut(plan):
    kerf = plan["machine"]["kerf_width"]
    lines, chains = beams(plan)
    cuts = [l.buffer(kerf / 2) for _, l in lines]
    if not cuts:
        return {"parts": 0, "held": 0, "told": 0, "joints": 0, "faults": []}
    x0, y0, x1, y1 = shapely.total_bounds(cuts)
    sheet = shapely.box(x0 - MARGIN, y0 - MARGIN, x1 + MARGIN, y1 + MARGIN)
    pieces = list(shapely.get_parts(sheet.difference(shapely.union_all(cuts))))
    rim = next(p for p in pieces if p.intersects(sheet.exterior))
    shapely.prepare(rim)

    # A part is the largest area between its outline and its holes.
    def area(k):
        return polygon([q for _, chain in chains[k] for e in chain for q in e.points()[:-1]])

    parts, held = 0, 0
    closed = lambda k: k in chains and plan["contours"][k]["closed"]  # noqa: E731
    contours = plan["contours"]
    for c in contours:
        k = c["id"]
        if not closed(k) or depth_of(plan, c) % 2:
            continue
        stuff = area(k).buffer(-kerf / 2)
        for hole in (h["id"] for h in contours if h["inside"] == k):
            if closed(hole):
                stuff = stuff.difference(area(hole).buffer(kerf / 2))
        if stuff.area < 1e-6:
            continue
        inside = [p for p in shapely.get_parts(stuff)]
        inside = max(inside, key=lambda p: p.area).representative_point()
        # What is in no piece lies on a line that is cut within the part.
        if not any(p.contains(inside) for p in pieces):
            continue
        parts, held = parts + 1, held + bool(rim.contains(inside))

    faults, joints = [], 0
    tree = shapely.STRtree([l for _, l in lines])
    for k, stretches in chains.items():
        chain = [e for _, s in stretches for e in s]
        turns, whole = corners(chain)
        at = 0.0
        for is_joint, stretch in stretches:
            length = sum(e.length for e in stretch)
            if is_joint:
                joints += 1
                rule = rule_of(plan, plan["contours"][k])
                shape = line(stretch)
                near = [lines[j][1] for j in tree.query(shape.buffer(length))]
                left = shape.difference(shapely.union_all([l.buffer(kerf / 2, quad_segs=32) for l in near])).length
                if abs(left - rule["width"]) > 0.01:
                    faults.append(f"contour {k}: a joint of {left:.4f} mm instead of {rule['width']} mm")
                middle = at + length / 2
                for c in turns:
                    apart = min((c - middle) % whole, (middle - c) % whole)
                    # A gap at the beginning is part of no stretch, so distances across it are at least these.
                    if apart < length / 2 + rule["corner_clearance"] - 2e-3:
                        faults.append(f"contour {k}: a joint {apart - length / 2:.3f} mm from a corner")
                for j in tree.query(shape.buffer(length)):
                    if lines[j][0] != k and lines[j][1].distance(shape) < length / 2 - 2e-3:
                        faults.append(f"contour {k}: a joint {lines[j][1].distance(shape):.3f} mm from contour {lines[j][0]}")
            at += length
    told = sum(f["count"] for f in plan["findings"] if f["code"] == "joint-missing" or (f["code"] == "more" and "joint" in f["message"]))
    return {"parts": parts, "held": held, "told": told, "joints": joints, "faults": faults}


judge("joints", cut)
