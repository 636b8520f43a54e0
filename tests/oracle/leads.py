"""Replays plans with leads with Shapely, which shares no code with Kerfway.

    KERFWAY_BLESS=1 cargo test --features png --test it leads::replay     # writes the plans to target/leads
    python tests/oracle/leads.py                                          # replays them

writes `tests/fixtures/leads.json`: for each plan the hash of its moves and the faults found. `tests/it/leads/replay.rs` then checks that
Kerfway still makes these plans. For each cut with leads:

* no lead, place of piercing or overcut lies in a part, less 5 micrometres (parts: outlines without their holes);
* leads keep the clearance from every other cut (less the error of the chords, 2 micrometres);
* a lead begins in no void, that is in nothing that was cut out before (the order of the plan is followed);
* arcs are tangent to what they join; the overcut repeats the beginning of the contour and has its length.

Needs `pip install shapely`.
"""

import math

import shapely

from judge import LESS, depth_of, elements, judge, line, shapes_and_parts, turned

# mm: deviation of chords, radius of the place of piercing.
CHORD, PIERCE = 0.0005, 0.05


def cuts(plan):
    """The contours in the order of cutting: id, lead-in, contour, overcut, lead-out. Pauses divide no cut."""
    at, all_cuts, goes_on = tuple(plan["machine"]["home"]), [], False
    for move in plan["moves"]:
        if move["kind"] == "air" or move["kind"] == "pre-cut":
            at = tuple(move["to"])
        if move["kind"] == "cut":
            chain = elements(at, move["path"], CHORD)
            at = chain[-1].end
            n, i, o, q = len(chain), move.get("lead_in", 0), move.get("overcut", 0), move.get("lead_out", 0)
            parts = [chain[:i], chain[i : n - o - q], chain[n - o - q : n - q], chain[n - q :]]
            if goes_on:
                all_cuts[-1][1] = [a + b for a, b in zip(all_cuts[-1][1], parts)]
            else:
                ids = move["contour"] if isinstance(move["contour"], list) else [move["contour"]]
                all_cuts.append([ids, parts])
        goes_on = move["kind"] == "macro"
    return all_cuts


def rule_of(plan, contour, box):
    side = "hole" if contour["depth"] % 2 else "outer"
    extent = max(box[2] - box[0], box[3] - box[1])
    for rule in plan["machine"]["leads"]["rules"]:
        if rule.get("side", side) == side and extent < rule.get("diameter_below", math.inf) and contour["length"] < rule.get("perimeter_below", math.inf):
            return rule
    return None


def replay(plan):
    clearance, kerf = plan["machine"]["leads"]["clearance"], plan["machine"].get("kerf_width", 0.0)
    contours = plan["contours"]
    for c in contours:
        c["depth"] = depth_of(plan, c)
    done = cuts(plan)
    # What the beam follows, and the outlines of what is made.
    beams, outlines = {}, {}
    for ids, (_, on, _, _) in done:
        beams[ids[0]] = line(on)
    for c in contours:
        if "drawn" in c:
            outlines[c["id"]] = line(elements(c["drawn"]["from"], c["drawn"]["path"], CHORD))
        elif c["closed"] and c["operation"] == "cut" and c["id"] in beams:
            outlines[c["id"]] = beams[c["id"]]
    shapes, shape_of, parts = shapes_and_parts(outlines)
    last = {shape_of[ids[0]]: ids[0] for ids, _ in done if ids[0] in shape_of}
    part_tree = shapely.STRtree(parts)
    cut_ids = [k for k in beams if contours[k]["operation"] == "cut"]
    cut_tree = shapely.STRtree([beams[k] for k in cut_ids])

    faults, tangent, overcut_error, with_lead, voids = [], 0.0, 0.0, 0, []
    void_tree, void_count = None, 0
    for ids, (lead_in, on, again, lead_out) in done:
        k = ids[0]
        c = contours[k]
        whole = beams[k]
        say = lambda what: faults.append(f"contour {k}: {what}")  # noqa: B023, E731
        with_lead += bool(lead_in)
        for lead, other in ((lead_in, on[0]), (lead_out, (again or on)[-1])):
            if not lead:
                continue
            shape = line(lead)
            tip = shapely.Point(lead[0].start if lead is lead_in else lead[-1].end)
            chain = [*lead, other] if lead is lead_in else [other, *lead]
            for a, b in zip(chain, chain[1:]):
                if (a is not other and a.center) or (b is not other and b.center):
                    tangent = max(tangent, turned(a.direction(True), b.direction(False)))
            for j in part_tree.query(shape):
                if shape.intersection(parts[j]).length > 0:
                    say("a lead lies in a part")
            for j in part_tree.query(tip.buffer(PIERCE)):
                if tip.buffer(PIERCE).intersects(parts[j]):
                    say("the place of piercing touches a part")
            for j in cut_tree.query(shape.buffer(clearance)):
                if cut_ids[j] != k and shape.distance(beams[cut_ids[j]]) < clearance - 2e-3:
                    say(f"a lead is {shape.distance(beams[cut_ids[j]]):.4f} mm from contour {cut_ids[j]}")
            if len(voids) > 2 * void_count + 50:
                void_tree, void_count = shapely.STRtree(voids), len(voids)
            late = voids[void_count:] + ([voids[j] for j in void_tree.query(tip)] if void_tree else [])
            if any(v.contains(tip) for v in late):
                say("a lead begins or ends in a void")
        if c["closed"] and c["operation"] == "cut":
            rule = rule_of(plan, c, whole.bounds)
            wanted = rule["overcut"] if rule else 0.0
            wanted = max(-0.5 * c["length"], min(0.5 * c["length"], wanted))
            if (lead_in or lead_out or again) and len(ids) == 1:
                found = sum(e.length for e in again) or sum(e.length for e in on) - c["length"]
                overcut_error = max(overcut_error, abs(found - wanted))
            if again:
                path, repeat = line(on), line(again)
                if max(path.distance(shapely.Point(p)) for p in repeat.coords) > 2e-3:
                    say("the overcut leaves the contour")
        if last.get(shape_of.get(k)) == k:
            voids.append(shapes[shape_of[k]].buffer(-LESS))
    closed = [c for c in contours if c["closed"] and c["operation"] == "cut"]
    told = sum(f["count"] for f in plan["findings"] if f["code"] == "lead-missing" or (f["code"] == "more" and "no lead" in f["message"]))
    return {"closed": len(closed), "with_lead": with_lead, "told": told, "faults": faults, "tangent": round(tangent, 9), "overcut": round(overcut_error, 9)}


judge("leads", replay)
