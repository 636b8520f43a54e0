"""The oracle: what ezdxf makes of a DXF file, as polylines in mm.

    python reference.py FILE.dxf... [--unit mm] [--chord 0.001]

prints, for each file, the unit factor, paths, closed and open counts, and length by kind. As a module, `paths_of(doc,
factor)` gives the polylines. Curves are flattened by ezdxf's exact evaluators (never through its Bezier
approximation of arcs, which is off by 0.027 % of the radius), to `chord` mm.

Blocks are walked here, with ezdxf's matrices, rather than by `recursive_decompose`: that one takes polylines apart under
uneven scale and loses entities it cannot transform. Layer 0, frozen and off layers follow AutoCAD:
what lies on layer 0 in a block takes the layer of the INSERT; a frozen INSERT layer hides all of the block, an off
one only what is on it.
"""

import argparse
import math
import sys
from collections import Counter
from dataclasses import dataclass

import ezdxf
from ezdxf import recover
from ezdxf.entities import LWPolyline
from ezdxf.math import Matrix44, Vec3, X_AXIS, Y_AXIS, Z_AXIS

# mm per unit of $INSUNITS.
FACTORS = {1: 25.4, 2: 304.8, 3: 1609344.0, 4: 1.0, 5: 10.0, 6: 1000.0, 7: 1e6, 8: 25.4e-6, 9: 0.0254, 10: 914.4,
           11: 1e-7, 12: 1e-6, 13: 1e-3, 14: 100.0}
NAMES = {"in": 25.4, "ft": 304.8, "mm": 1.0, "cm": 10.0, "m": 1000.0, "yd": 914.4, "mil": 0.0254,
         "microinch": 25.4e-6, "um": 1e-3, "dm": 100.0}


@dataclass
class RefPath:
    """One entity, flattened: points in mm."""

    kind: str
    layer: str
    closed: bool
    points: list

    def length(self):
        p = self.points + self.points[:1] if self.closed else self.points
        return sum(math.dist(a, b) for a, b in zip(p, p[1:]))


def read(path):
    """The document, by the strict reader where that takes the file: recover mode reads UTF-8 layer names wrongly when
    no code page is named, and takes no binary files. By recover mode otherwise."""
    try:
        return ezdxf.readfile(path)
    except ezdxf.DXFStructureError:
        return recover.readfile(path)[0]


def paths_of(doc, factor, chord=0.001):
    """All visible curves of model space as `RefPath`, in the order of the file."""
    return list(_walk(doc, doc.modelspace(), Matrix44(), "0", factor, chord / factor))


def _walk(doc, entities, matrix, outer_layer, factor, chord):
    for e in entities:
        layer = outer_layer if e.dxf.layer == "0" else e.dxf.layer
        table = doc.layers.get(layer) if doc.layers.has_entry(layer) else None
        if e.dxf.get("invisible", 0) or e.dxf.get("paperspace", 0):
            continue
        if table is not None and table.is_frozen():
            continue
        if e.dxftype() == "INSERT":
            block = e.block()
            for one in e.multi_insert() if block is not None else ():
                yield from _walk(doc, block, one.matrix44() * matrix, layer, factor, chord)
            continue
        if table is not None and table.is_off():
            continue
        stretch = max(matrix.transform_direction(axis).magnitude for axis in (X_AXIS, Y_AXIS, Z_AXIS))
        for closed, points in _curves(e, chord / stretch):
            points = matrix.transform_vertices(Vec3(p) for p in points)
            flat = [(p.x * factor, p.y * factor) for p in points]
            closed = closed or (len(flat) > 2 and math.dist(flat[0], flat[-1]) < 1e-6)
            if closed and math.dist(flat[0], flat[-1]) < 1e-6:
                flat.pop()
            yield RefPath(e.dxftype(), layer, closed, flat)


def _curves(e, chord):
    """(closed, points) of each curve of an entity."""
    kind = e.dxftype()
    if kind == "LINE":
        yield False, [e.dxf.start, e.dxf.end]
    elif kind in ("CIRCLE", "ARC"):
        yield kind == "CIRCLE", list(e.flattening(chord))
    elif kind == "ELLIPSE":
        # Not `flattening`, which fails on arcs close to a full turn. 512 points: chords within 1.9e-5 of the axis.
        start, end = e.dxf.start_param, e.dxf.end_param
        # A full turn is written with rounded digits: a sweep of nearly nothing is one.
        sweep = (end - start) % math.tau
        sweep = sweep if sweep > 1e-9 else math.tau
        yield False, list(e.vertices(start + sweep * i / 512 for i in range(513)))
    elif kind == "SPLINE":
        yield False, _spline(e, chord)
    elif kind == "LWPOLYLINE":
        yield e.closed, _chain(e.virtual_entities(), chord)
    elif kind == "POLYLINE":
        if e.is_2d_polyline or e.is_3d_polyline:
            _drop_frame(e)
            yield e.is_closed, _chain(e.virtual_entities(), chord)
    elif kind in ("SOLID", "TRACE"):
        yield True, e.wcs_vertices(close=False)
    elif kind == "3DFACE":
        yield from _face(e)
    elif kind == "HATCH":
        for path in e.paths.paths:
            yield from _boundary(e, path, chord)


def _spline(spline, chord):
    """A spline by ezdxf, except where ezdxf is known to be wrong or refuses: on unclamped knots it evaluates outside
    the domain [u_p, u_n], and it takes no degree above 10. Those are evaluated here by de Boor's recurrence."""
    degree, knots = spline.dxf.degree, list(spline.knots)
    clamped = len(set(knots[: degree + 1])) <= 1 and len(set(knots[-degree - 1:])) <= 1
    if not spline.control_points or (degree <= 10 and clamped):
        return list(spline.flattening(chord, segments=64))
    weights = list(spline.weights) or [1.0] * len(spline.control_points)
    control = [(w * p[0], w * p[1], w) for p, w in zip(spline.control_points, weights)]
    return de_boor(degree, knots, control)


def de_boor(degree, knots, control, steps=400):
    """Points of a rational B-spline over its domain, `steps` in each knot span; `control` is homogeneous."""
    out = []
    for span in range(degree, len(control)):
        lower, upper = knots[span], knots[span + 1]
        if upper <= lower:
            continue
        for i in range(steps + 1):
            u = lower + (upper - lower) * i / steps
            d = [control[span - degree + j] for j in range(degree + 1)]
            for r in range(1, degree + 1):
                for j in range(degree, r - 1, -1):
                    low = knots[span - degree + j]
                    a = (u - low) / (knots[span + 1 + j - r] - low)
                    d[j] = tuple((1 - a) * p + a * q for p, q in zip(d[j - 1], d[j]))
            x, y, w = d[degree]
            out.append((x / w, y / w))
    return out


def _drop_frame(polyline):
    """Takes the control frame (vertex flag 16) out of a spline-fit polyline: it is not part of the curve."""
    if polyline.dxf.flags & 4:
        polyline.vertices[:] = [v for v in polyline.vertices if not v.dxf.flags & 16]


def _chain(entities, chord):
    """The points of entities that follow each other end to end, some of them possibly run backwards."""
    out = []
    pieces = [next(iter(_curves(e, chord)))[1] for e in entities]
    for i, piece in enumerate(pieces):
        near = out[-1] if out else (pieces[1][0] if len(pieces) > 1 else piece[-1])
        if out and math.dist(piece[0], near) > math.dist(piece[-1], near):
            piece = piece[::-1]
        if not out and len(pieces) > 1:
            ends = (pieces[1][0], pieces[1][-1])
            if min(math.dist(piece[0], q) for q in ends) < min(math.dist(piece[-1], q) for q in ends):
                piece = piece[::-1]
        out += piece if not out else piece[1:]
    return out


def _face(face):
    """The visible edges of a 3DFACE: one closed outline when all are, otherwise each run of visible edges."""
    corners = face.wcs_vertices()
    count = len(corners)
    seen = [not face.dxf.invisible_edges >> i & 1 for i in range(4)]
    if count == 3:
        seen = [seen[0], seen[1], seen[3] and seen[2]]
    if all(seen[:count]):
        yield True, corners
        return
    start = next(i for i in range(count) if not seen[i])
    run = []
    for k in range(1, count + 1):
        i = (start + k) % count
        if seen[i]:
            run = run or [corners[i]]
            run.append(corners[(i + 1) % count])
        elif run:
            yield False, run
            run = []


def _boundary(hatch, path, chord):
    """One boundary of a hatch in WCS: a closed polyline, or edges, each of them a curve of its own."""
    ocs, z = hatch.ocs(), hatch.dxf.elevation.z
    if type(path).__name__ == "PolylinePath":
        line = LWPolyline.new(dxfattribs={"extrusion": hatch.dxf.extrusion, "elevation": z, "flags": 1})
        line.set_points(path.vertices, format="xyb")
        yield True, _chain(line.virtual_entities(), chord)
        return
    for edge in path.edges:
        kind = type(edge).__name__
        if kind == "LineEdge":
            piece = [edge.start, edge.end]
        elif kind in ("ArcEdge", "EllipseEdge"):
            piece = edge.construction_tool().flattening(chord)
        else:
            piece = edge.construction_tool().flattening(chord, 16)
        yield False, [ocs.to_wcs((p[0], p[1], z)) for p in piece]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+")
    parser.add_argument("--unit", help="the unit where the file does not say; default mm")
    parser.add_argument("--chord", type=float, default=0.001, help="flattening, mm")
    args = parser.parse_args()
    for name in args.files:
        try:
            doc = read(name)
        except (ezdxf.DXFError, OSError) as error:
            print(f"{name}: {type(error).__name__}: {error}", file=sys.stderr)
            continue
        factor = NAMES[args.unit] if args.unit else FACTORS.get(doc.header.get("$INSUNITS", 0), 1.0)
        paths = paths_of(doc, factor, args.chord)
        lengths = Counter()
        for p in paths:
            lengths[p.kind] += p.length()
        closed = sum(p.closed for p in paths)
        by_kind = ", ".join(f"{k} {v:.3f}" for k, v in sorted(lengths.items()))
        print(f"{name}: factor {factor}, {closed} closed, {len(paths) - closed} open, "
              f"{sum(lengths.values()):.3f} mm ({by_kind})")


if __name__ == "__main__":
    main()
