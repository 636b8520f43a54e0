"""Entities as lists of tags. Coordinates are in drawing units, angles in degrees, as DXF has them.

Each maker returns `(kind, subclass tags...)` as a flat list that starts with the `0` tag; `Drawing` strips what R12
does not know (subclass markers).
"""

UP = (0.0, 0.0, 1.0)


def _head(kind, layer, extra=()):
    return [(0, kind), (100, "AcDbEntity"), (8, layer), *extra]


def _point(code, p):
    z = p[2] if len(p) > 2 else 0.0
    return [(code, float(p[0])), (code + 10, float(p[1])), (code + 20, float(z))]


def _extrusion(n):
    return [] if n == UP else [(210, n[0]), (220, n[1]), (230, n[2])]


def line(p, q, layer="0", extra=()):
    return [*_head("LINE", layer, extra), (100, "AcDbLine"), *_point(10, p), *_point(11, q)]


def circle(c, r, layer="0", normal=UP, extra=()):
    return [*_head("CIRCLE", layer, extra), (100, "AcDbCircle"), *_point(10, c), (40, float(r)), *_extrusion(normal)]


def arc(c, r, start, end, layer="0", normal=UP, extra=()):
    return [*_head("ARC", layer, extra), (100, "AcDbCircle"), *_point(10, c), (40, float(r)), *_extrusion(normal),
            (100, "AcDbArc"), (50, float(start)), (51, float(end))]


def lwpolyline(vertices, closed=False, layer="0", normal=UP, elevation=None, width=None, extra=()):
    """`vertices`: (x, y) or (x, y, bulge)."""
    out = [*_head("LWPOLYLINE", layer, extra), (100, "AcDbPolyline"), (90, len(vertices)), (70, int(closed))]
    if width is not None:
        out.append((43, float(width)))
    if elevation is not None:
        out.append((38, float(elevation)))
    for v in vertices:
        out += [(10, float(v[0])), (20, float(v[1]))]
        if len(v) > 2 and v[2]:
            out.append((42, float(v[2])))
    return out + _extrusion(normal)


def polyline(vertices, closed=False, flags=0, layer="0", normal=UP, subclass="AcDb2dPolyline", elevation=0.0):
    """`vertices`: (x, y, z, bulge, vertex flags), the last three optional."""
    vertex_class = {"AcDb2dPolyline": "AcDb2dVertex", "AcDb3dPolyline": "AcDb3dPolylineVertex"}[subclass]
    out = [*_head("POLYLINE", layer), (100, subclass), (66, 1), *_point(10, (0.0, 0.0, elevation)),
           (70, flags | int(closed)), *_extrusion(normal)]
    for v in vertices:
        x, y, z, bulge, vflags = (*v, *(0.0, 0.0, 0.0, 0.0, 0)[len(v):])
        out += [(0, "VERTEX"), (100, "AcDbEntity"), (8, layer), (100, "AcDbVertex"), (100, vertex_class)]
        out += _point(10, (x, y, z))
        if bulge:
            out.append((42, float(bulge)))
        if vflags:
            out.append((70, vflags))
    return out + [(0, "SEQEND"), (100, "AcDbEntity"), (8, layer)]


def ellipse(c, major, ratio, start=0.0, end=6.283185307179586, layer="0", normal=UP, extra=()):
    return [*_head("ELLIPSE", layer, extra), (100, "AcDbEllipse"), *_point(10, c), *_point(11, major),
            *_extrusion(normal), (40, float(ratio)), (41, float(start)), (42, float(end))]


def spline(degree, control=(), knots=(), weights=(), fit=(), flags=8, tangents=None, layer="0", extra=()):
    out = [*_head("SPLINE", layer, extra), (100, "AcDbSpline"), (70, flags | (4 if weights else 0)), (71, degree),
           (72, len(knots)), (73, len(control)), (74, len(fit))]
    if tangents:
        out += _point(12, tangents[0]) + _point(13, tangents[1])
    out += [(40, float(k)) for k in knots] + [(41, float(w)) for w in weights]
    for p in control:
        out += _point(10, p)
    for p in fit:
        out += _point(11, p)
    return out


def clamped_knots(degree, count, start=0.0, step=1.0):
    """Knots of an open spline that starts and ends on its first and last control point."""
    inner = count - degree - 1
    last = start + (inner + 1) * step
    return [start] * (degree + 1) + [start + step * (i + 1) for i in range(inner)] + [last] * (degree + 1)


def solid(corners, layer="0", normal=UP, kind="SOLID"):
    """Corners in the order of the file: the third and fourth change places going round. Three corners repeat the last."""
    p = [*corners, corners[-1]] if len(corners) == 3 else corners
    return [*_head(kind, layer), (100, "AcDbTrace"), *_point(10, p[0]), *_point(11, p[1]), *_point(12, p[2]),
            *_point(13, p[3]), *_extrusion(normal)]


def face3d(corners, hidden_edges=0, layer="0"):
    p = [*corners, corners[-1]] if len(corners) == 3 else corners
    return [*_head("3DFACE", layer), (100, "AcDbFace"), *_point(10, p[0]), *_point(11, p[1]), *_point(12, p[2]),
            *_point(13, p[3]), (70, hidden_edges)]


def hatch(paths, layer="0", normal=UP):
    """`paths`: ("polyline", [(x, y, bulge)...]) or ("edges", [edge tags...])."""
    out = [*_head("HATCH", layer), (100, "AcDbHatch"), *_point(10, (0.0, 0.0, 0.0)), (210, normal[0]), (220, normal[1]),
           (230, normal[2]), (2, "SOLID"), (70, 1), (71, 0), (91, len(paths))]
    for kind, data in paths:
        if kind == "polyline":
            out += [(92, 2 | 1), (72, int(any(len(v) > 2 for v in data))), (73, 1), (93, len(data))]
            for v in data:
                out += [(10, float(v[0])), (20, float(v[1]))]
                if any(len(w) > 2 for w in data):
                    out.append((42, float(v[2]) if len(v) > 2 else 0.0))
        else:
            out += [(92, 1), (93, len(data))]
            for edge in data:
                out += edge
        out.append((97, 0))
    return out + [(75, 0), (76, 1), (98, 0)]


def edge_line(p, q):
    return [(72, 1), (10, float(p[0])), (20, float(p[1])), (11, float(q[0])), (21, float(q[1]))]


def edge_arc(c, r, start, end, ccw=True):
    return [(72, 2), (10, float(c[0])), (20, float(c[1])), (40, float(r)), (50, float(start)), (51, float(end)),
            (73, int(ccw))]


def edge_ellipse(c, major, ratio, start, end, ccw=True):
    return [(72, 3), (10, float(c[0])), (20, float(c[1])), (11, float(major[0])), (21, float(major[1])),
            (40, float(ratio)), (50, float(start)), (51, float(end)), (73, int(ccw))]


def edge_spline(degree, control, knots):
    out = [(72, 4), (94, degree), (73, 0), (74, 0), (95, len(knots)), (96, len(control))]
    out += [(40, float(k)) for k in knots]
    for p in control:
        out += [(10, float(p[0])), (20, float(p[1]))]
    return out + [(97, 0)]


def insert(name, at, scale=(1.0, 1.0, 1.0), rotation=0.0, layer="0", normal=UP, columns=1, rows=1, spacing=(0.0, 0.0),
           extra=()):
    out = [*_head("INSERT", layer, extra), (100, "AcDbBlockReference"), (2, name), *_point(10, at),
           (41, float(scale[0])), (42, float(scale[1])), (43, float(scale[2])), (50, float(rotation))]
    if columns > 1 or rows > 1:
        out += [(70, columns), (71, rows), (44, float(spacing[0])), (45, float(spacing[1]))]
    return out + _extrusion(normal)


def point(p, layer="0"):
    return [*_head("POINT", layer), (100, "AcDbPoint"), *_point(10, p)]


def text(p, words, layer="0"):
    return [*_head("TEXT", layer), (100, "AcDbText"), *_point(10, p), (40, 2.5), (1, words), (100, "AcDbText")]
