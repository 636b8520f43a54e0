"""Judges skeleton cuts and remainders with Shapely and ezdxf, which share no code with Kerfway.

    KERFWAY_BLESS=1 cargo test --features png --test it skeleton::replay     # writes the plans to target/skeleton
    python tests/oracle/skeleton.py                                          # judges them

writes `tests/fixtures/skeleton.json`: for each plan the hash of its moves and the faults found. `tests/it/skeleton/replay.rs` then checks
that Kerfway still makes these plans.

* Nothing is cut after a skeleton cut but skeleton cuts.
* No skeleton cut meets what is worked, grown by the clearance less the error of the chords, or leaves the sheet.
* Together they are the lines of the grid less what is worked, grown by the clearance, and less the joints: nothing is forgotten.
* The drawing of the remainder is the widest strip that nothing reaches, or the sheet with what was cut out of it.

Needs `pip install shapely ezdxf`.
"""

import io
import math

import ezdxf
import shapely
from ezdxf.path import make_path
from shapely.ops import unary_union

from judge import ROOT, elements, judge, line, polygon

# mm: deviation of chords, what counts as touching, shorter stretches are not cut.
CHORD, TOUCH, SHORTEST = 0.0005, 0.002, 2.0


def outlines(text):
    """The closed polylines of the drawing of a remainder, by layer."""
    out = {}
    for e in ezdxf.read(io.StringIO(text)).modelspace():
        points = [(p.x, p.y) for p in make_path(e).flattening(CHORD)]
        out.setdefault(e.dxf.layer, []).append(polygon(points))
    return out


def drawn_sheet(name):
    """The box of what a sheet of the fixtures has on its layer SHEET."""
    file = ROOT / "fixtures" / "sheets" / name
    if not file.exists():
        return None
    points = [(p.x, p.y) for e in ezdxf.readfile(file).modelspace().query('*[layer=="SHEET"]') for p in make_path(e).flattening(CHORD)]
    return shapely.MultiPoint(points).bounds if points else None


def worked(plan):
    """Ids in the order of cutting with their lines."""
    at, out = tuple(plan["machine"]["home"]), []
    for move in plan["moves"]:
        if move["kind"] in ("air", "pre-cut"):
            at = tuple(move["to"])
        if move["kind"] == "cut":
            chain = elements(at, move["path"], CHORD)
            at = chain[-1].end
            ids = move["contour"] if isinstance(move["contour"], list) else [move["contour"]]
            out.append((ids, line(chain)))
    return out


def look(plan):
    faults = []
    skeleton, kerf = plan["machine"]["skeleton"], plan["machine"].get("kerf_width", 0.0)
    clearance = skeleton["clearance"]
    is_skeleton = {c["id"] for c in plan["contours"] if c.get("skeleton")}
    done = worked(plan)
    cuts = [l for ids, l in done if ids[0] in is_skeleton]
    first = next((k for k, (ids, _) in enumerate(done) if ids[0] in is_skeleton), len(done))
    faults += [f"{ids} after a skeleton cut" for ids, _ in done[first:] if ids[0] not in is_skeleton]

    # Everything that is worked, filled where it bounds an area.
    shapes, outer = [], []
    for ids, l in done[:first]:
        ring = l.coords[0] == l.coords[-1] or math.dist(l.coords[0], l.coords[-1]) < 1e-6
        shapes.append(polygon(l.coords) if ring and len(l.coords) > 3 else l)
        outer += [shapes[-1]] if plan["contours"][ids[0]]["inside"] is None and plan["contours"][ids[0]]["operation"] == "cut" else []
    for c in plan["contours"]:
        # What is cut with a neighbour has the outline of the shape.
        if "drawn" in c and kerf == 0.0 and c["operation"] == "cut":
            shapes.append(polygon(line(elements(c["drawn"]["from"], c["drawn"]["path"], CHORD)).coords))
            outer += [shapes[-1]] if c["inside"] is None else []
    near = shapely.STRtree(shapes)
    x0, y0, x1, y1 = drawn_sheet(plan["input"]["name"]) or plan["machine"]["bed"]
    bed = shapely.box(x0, y0, x1, y1)
    for cut in cuts:
        k = near.nearest(cut)
        if k is not None and cut.distance(shapes[k]) < clearance - TOUCH:
            faults.append(f"{cut.wkt} comes too near to a part")
        if not bed.buffer(TOUCH).contains(cut):
            faults.append(f"{cut.wkt} leaves the sheet")

    left = outlines(plan["remainder"])
    sheet, holes = left["SHEET"], left.get("CUT OUT", [])
    box = unary_union(shapes).bounds
    room, strip = [x0, y0, x1, y1], None
    if skeleton.get("remainder"):
        sides = [(x1 - box[2] - clearance, y1 - y0, (box[2] + clearance, y0, x1, y1)), (y1 - box[3] - clearance, x1 - x0, (x0, box[3] + clearance, x1, y1)),
                 (box[0] - clearance - x0, y1 - y0, (x0, y0, box[0] - clearance, y1)), (box[1] - clearance - y0, x1 - x0, (x0, y0, x1, box[1] - clearance))]
        wide = [s for s in sides if s[0] >= skeleton["remainder"]]
        strip = max(wide, key=lambda s: s[0] * s[1])[2] if wide else None
    if strip:
        if len(sheet) != 1 or holes or not sheet[0].symmetric_difference(shapely.box(*strip)).area < TOUCH * 1000:
            faults.append(f"the remainder is not {strip}")
        side = [strip[0] > x0, strip[1] > y0, strip[2] < x1, strip[3] < y1].index(True)
        room[(2, 3, 0, 1)[side]] = strip[side]
    else:
        wanted = [s for s in outer if s.geom_type == "Polygon"]
        gone = unary_union(holes) if holes else shapely.Polygon()
        if abs(sheet[0].area - bed.area) > TOUCH * bed.length or gone.symmetric_difference(unary_union(wanted)).area > 2 * TOUCH * (1 + sum(w.length for w in wanted)):
            faults.append("the remainder is not the sheet less the parts")

    # The grid again.
    lines = []
    for k, spacing in ((0, skeleton.get("spacing_x")), (1, skeleton.get("spacing_y"))):
        size = room[k + 2] - room[k]
        pieces = math.ceil(size / spacing - 1e-9)
        for n in range(1, pieces):
            at = room[k] + size * n / pieces
            lines.append(shapely.LineString([(at, room[1]), (at, room[3])] if k == 0 else [(room[0], at), (room[2], at)]))
    if strip:
        ends = {0: [(strip[0], y0), (strip[0], y1)], 1: [(x0, strip[1]), (x1, strip[1])], 2: [(strip[2], y0), (strip[2], y1)], 3: [(x0, strip[3]), (x1, strip[3])]}[side]
        lines.append(shapely.LineString(ends))
    # A line at the clearance is not interrupted.
    grown = unary_union([s.buffer(clearance - TOUCH / 2, quad_segs=64) for s in shapes])
    most = skeleton.get("joint_spacing")
    for l in lines:
        own = [c for c in cuts if l.buffer(TOUCH).contains(c)]
        for free in getattr(l.difference(grown), "geoms", [l.difference(grown)]):
            if free.length < SHORTEST - TOUCH:
                continue
            here = sorted((c for c in own if free.buffer(0.1).contains(c)), key=lambda c: l.project(shapely.Point(c.coords[0])))
            gaps = free.length - sum(c.length for c in here)
            joints = max(0, len(here) - 1) * (skeleton["joint_width"] + kerf)
            # Where a line grazes what is grown, the error of the chords is large along the line.
            if abs(gaps - joints) > 0.1 and free.length > SHORTEST + 0.1:
                faults.append(f"{free.wkt} is not cut: {gaps} mm are left, {joints} for joints")
            if most and any(c.length > most + TOUCH for c in here) or not most and len(here) > 1:
                faults.append(f"the joints of {free.wkt} are not as asked for")
    return {"cuts": len(cuts), "strip": strip is not None, "faults": faults}


if __name__ == "__main__":
    judge("skeleton", look)
