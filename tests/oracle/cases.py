"""The directed cases: each entity kind, each oddity, small and by name."""

import math

import entities as e
from drawing import Drawing

MIRROR = (0.0, 0.0, -1.0)
TILTED = (0.0, 0.6, 0.8)
SKEW = tuple(c / math.sqrt(14.0) for c in (1.0, 2.0, 3.0))
STAR = [(0, 0), (10, 4), (20, 0), (16, 10), (20, 20), (10, 16), (0, 20), (4, 10)]


def _shifted(points, dx, dy):
    return [(p[0] + dx, p[1] + dy, *p[2:]) for p in points]


def plain():
    """Lines, circles and arcs, with angles past a full turn and below zero."""
    d = Drawing("plain")
    d.add(e.line((0, 0), (30, 10)), e.line((5.5, 20, 7), (-12.25, 31, 3)), e.circle((60, 20), 12.5))
    for i, (a, b) in enumerate([(0, 90), (350, 10), (270, 90), (-45, 45), (90, 450.5), (10, 9)]):
        d.add(e.arc((30 * i, 80), 10 + i, a, b))
    return d


def bulges():
    """LWPOLYLINE with bulges of every size, also on the closing vertex, with width and elevation."""
    d = Drawing("lwpolyline-bulges")
    d.add(e.lwpolyline([(0, 0, 0.5), (20, 0, -0.5), (20, 20, 1.0), (0, 20, -0.25)], closed=True))
    d.add(e.lwpolyline([(40, 0, 0.2), (60, 0), (60, 20, 3.0), (45, 20, 0.7)]))
    d.add(e.lwpolyline([(80, 10, 1), (100, 10, 1)], closed=True, width=0.5))
    d.add(e.lwpolyline([(120, 0, 1e-7), (150, 0, 12.0), (150, 20)], elevation=5.0))
    d.add(e.lwpolyline(_shifted(STAR, 0, 60), closed=True), e.lwpolyline(_shifted(STAR, 30, 60)))
    d.add(e.lwpolyline([(60, 60), (80, 60), (80, 80), (60, 60)]))
    return d


def old_polylines(version):
    """POLYLINE: bulges, curve-fit and spline-fit (frame vertices are no part of the curve), in three dimensions."""
    d = Drawing(f"polyline-{version}", version=version)
    d.add(e.polyline([(0, 0, 0, 0.5), (20, 0, 0, -0.5), (20, 20, 0, 0.8), (0, 20, 0, -0.25)], closed=True))
    d.add(e.polyline([(40, 0, 0, 0.2), (60, 0), (60, 20, 0, 1.5), (45, 20)]))
    frame = [(80, 0), (95, 30), (120, -10), (140, 15)]
    d.add(e.polyline([(p[0], p[1], 0, 0, 16) for p in frame]
                     + [(x, y, 0, 0, 8) for x, y in bezier(frame, 12)], flags=4))
    d.add(e.polyline([(0, 50, 0, 0.3, 0), (15, 58, 0, 0.3, 1), (30, 50, 0, -0.2, 0), (45, 44, 0, -0.2, 1), (60, 50)],
                     flags=2))
    d.add(e.polyline([(80, 50, 1), (100, 60, 5), (90, 75, 9)], closed=True, flags=8, subclass="AcDb3dPolyline"))
    d.add(e.polyline([(120, 50, 4), (140, 60, 8), (130, 75, -2)], flags=8, subclass="AcDb3dPolyline"))
    return d


def bezier(frame, count):
    """Points of the cubic Bezier curve of four control points."""
    out = []
    for i in range(count + 1):
        t = i / count
        w = ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3)
        out.append(tuple(sum(wi * p[k] for wi, p in zip(w, frame)) for k in (0, 1)))
    return out


def ellipses():
    """Full and partial ellipses, turned, thin, round, mirrored by extrusion, tilted."""
    d = Drawing("ellipses", version="AC1021")
    d.add(e.ellipse((0, 0), (20, 0), 0.5), e.ellipse((50, 0), (12, 16), 0.3), e.ellipse((100, 0), (0, 15), 1.0))
    d.add(e.ellipse((0, 50), (20, 0), 0.4, 0.3, 2.9), e.ellipse((50, 50), (10, 10), 0.6, 5.0, 1.2))
    d.add(e.ellipse((100, 50), (18, -4), 0.7, -1.0, 1.0), e.ellipse((0, 100), (20, 5), 0.5, 0.2, 4.0, normal=MIRROR))
    d.add(e.ellipse((60, 100, 4), (20, 0, 0), 0.5, 0.2, 4.0, normal=TILTED))
    d.add(e.ellipse((100, 100), (25, 0), 0.02), e.ellipse((160, 100), (25, 3), 0.05, 0.1, 3.0))
    return d


def splines():
    """B-splines with control points: open, rational, periodic, closed, kinked, straight, of degree 1 to 11."""
    d = Drawing("splines", version="AC1018")
    wave = [(0, 0), (10, 25), (25, -10), (40, 30), (55, 5), (70, 15)]
    for i, degree in enumerate((1, 2, 3, 4, 5)):
        d.add(e.spline(degree, _shifted(wave, 0, 60 * i), e.clamped_knots(degree, 6)))
    # Rational: a quarter circle, and uneven weights.
    d.add(e.spline(2, [(120, 0), (120, 20), (100, 20)], e.clamped_knots(2, 3), [1, math.sqrt(0.5), 1]))
    d.add(e.spline(3, _shifted(wave, 100, 60), e.clamped_knots(3, 6), [1, 5, 0.3, 2, 1, 4]))
    # A full circle in four rational quarters: double knots.
    w = math.sqrt(0.5)
    ring = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)]
    d.add(e.spline(2, [(140 + 15 * x, 150 + 15 * y) for x, y in ring], [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4],
                   [1, w, 1, w, 1, w, 1, w, 1], flags=9))
    # Periodic and unclamped.
    loop = [(120, 220), (150, 210), (160, 240), (130, 255), (105, 240)]
    d.add(e.spline(3, loop + loop[:3], list(range(-3, 9)), flags=11))
    # A kink: an inner knot of multiplicity three.
    d.add(e.spline(3, [(200, 0), (210, 20), (220, -20), (230, 15), (240, -30), (250, 20), (260, 0)],
                   [0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2]))
    # A straight one, a cusp, high degrees, knots that start elsewhere and run unevenly.
    d.add(e.spline(3, [(200, 50), (215, 50), (230, 50), (260, 50)], e.clamped_knots(3, 4)))
    d.add(e.spline(3, [(200, 70), (240, 110), (200, 110), (240, 70)], e.clamped_knots(3, 4)))
    zigzag = [(200 + 8 * i, 140 + (20 if i % 2 else -12)) for i in range(12)]
    d.add(e.spline(7, zigzag, e.clamped_knots(7, 12)), e.spline(11, _shifted(zigzag, 0, 50), e.clamped_knots(11, 12)))
    d.add(e.spline(3, _shifted(wave, 200, 240), [5.5, 5.5, 5.5, 5.5, 5.9, 9.25, 30, 30, 30, 30]))
    return d


def hairpin():
    """A curve that turns back on itself within a micrometre (a cusp but for rounding): no loop of its own may be
    made of it."""
    d = Drawing("spline-hairpin")
    control = [(76.3581956437, 299.61006169), (36.2397488197, 298.35825226),
               (76.6147050052, 278.919063305), (39.6344543594, 296.365642796),
               (54.1925584128, 305.863158234), (31.3042252849, 283.569719207),
               (35.4671230422, 299.06449089), (32.7473397262, 291.230432688),
               (31.123914058, 292.116166519)]
    weights = [1.84116284088, 2.79817849631, 2.86384268952, 2.51739971862, 0.391520308654,
               1.14616582299, 2.95077205494, 0.345935333628, 0.49145163262]
    step = 17.8275125602
    d.add(e.spline(5, control, e.clamped_knots(5, 9, step=step), weights))
    return d


def fit_splines():
    """Splines given by fit points only, with and without end tangents."""
    d = Drawing("splines-fit", version="AC1024")
    d.add(e.spline(3, fit=[(0, 0), (10, 15), (30, 5), (45, 25), (50, 0)]))
    d.add(e.spline(3, fit=[(0, 50), (20, 70), (45, 55)], tangents=((1, 0), (0, -1))))
    d.add(e.spline(3, fit=[(80, 0), (100, 10)]))
    d.add(e.spline(3, fit=[(80, 50), (95, 75), (120, 60), (105, 40), (80, 50)]))
    return d


def filled():
    """SOLID, TRACE, 3DFACE with hidden edges, HATCH boundaries of every edge kind."""
    d = Drawing("filled", version="AC1027")
    d.add(e.solid([(0, 0), (20, 0), (0, 10), (20, 12)]), e.solid([(30, 0), (50, 0), (40, 15)]))
    d.add(e.solid([(60, 0), (80, 5), (62, 10), (85, 18)], kind="TRACE"))
    d.add(e.solid([(100, 0), (120, 0), (100, 10), (120, 12)], normal=MIRROR))
    d.add(e.face3d([(0, 40, 1), (20, 40, 2), (22, 55, 3), (3, 52, 4)]), e.face3d([(30, 40), (50, 40), (40, 55)]))
    return d


def hatches():
    """HATCH boundaries: polyline with bulges, lines, arcs and ellipse arcs both ways round, splines."""
    d = Drawing("hatches", version="AC1027")
    d.add(e.hatch([("polyline", [(0, 0, 0.4), (30, 0, 0), (30, 20, -0.3), (0, 20, 0)])]))
    d.add(e.hatch([("edges", [e.edge_line((50, 0), (80, 0)), e.edge_arc((80, 10), 10, 270, 90),
                              e.edge_line((80, 20), (50, 20)), e.edge_line((50, 20), (50, 0))])]))
    d.add(e.hatch([("edges", [e.edge_line((110, 0), (130, 0)), e.edge_line((130, 0), (130, 20)),
                              e.edge_arc((120, 20), 10, 180, 360, ccw=False), e.edge_line((110, 20), (110, 0))])]))
    d.add(e.hatch([("edges", [e.edge_ellipse((30, 60), (20, 0), 0.5, 0, 180), e.edge_line((10, 60), (50, 60))])]))
    d.add(e.hatch([("edges", [e.edge_spline(3, [(70, 50), (80, 75), (100, 75), (110, 50)], e.clamped_knots(3, 4)),
                              e.edge_line((110, 50), (70, 50))])]))
    d.add(e.hatch([("polyline", [(120, 50), (160, 50), (160, 80), (120, 80)]),
                   ("polyline", [(130, 60, 1), (140, 60, 1)])]))
    d.add(e.hatch([("polyline", [(180, 50, 0.5), (200, 50, 0), (200, 80, 0)])], normal=MIRROR))
    return d


def extrusions(normal, name):
    """Everything that lives in object coordinates, seen from below or aslant."""
    d = Drawing(f"ocs-{name}")
    d.add(e.circle((20, 20, 3), 8, normal=normal), e.arc((50, 20, 3), 10, 20, 140, normal=normal))
    d.add(e.lwpolyline([(0, 50, 0.5), (30, 50), (30, 70, -0.4), (0, 75)], closed=True, normal=normal, elevation=4.0))
    d.add(e.polyline([(50, 50, 0, 0.3), (80, 50), (75, 75, 0, 1.2)], normal=normal, elevation=-2.0))
    d.add(e.solid([(0, 100, 2), (20, 100, 2), (0, 110, 2), (22, 113, 2)], normal=normal))
    d.add(e.line((60, 100, 1), (90, 115, 2), extra=[(210, normal[0]), (220, normal[1]), (230, normal[2])]))
    d.blocks["PART"] = ((2, 1), [e.lwpolyline([(0, 0), (15, 0, 0.6), (15, 8), (0, 8)], closed=True),
                                 e.arc((5, 4), 2, 30, 200), e.ellipse((10, 20), (6, 2), 0.4, 0.5, 4.0)])
    d.add(e.insert("PART", (20, 150, 3), rotation=30, normal=normal))
    d.add(e.insert("PART", (70, 150, 3), scale=(1.5, -0.5, 2), rotation=-75, normal=normal))
    return d


def inserts():
    """Blocks: base points, turned, mirrored, unevenly scaled, nested, in arrays, layer 0 taking the insert's layer."""
    d = Drawing("inserts", version="AC1018", layers=[("A", 1, 0), ("B", 3, 0)])
    bracket = [e.lwpolyline([(0, 0), (20, 0, 0.5), (20, 10), (0, 10)], closed=True), e.circle((6, 5), 2.5),
               e.arc((14, 5), 3, 20, 250, layer="A"), e.line((2, 2), (9, 3), layer="B"),
               e.spline(3, [(0, 14), (6, 20), (12, 10), (18, 16)], e.clamped_knots(3, 4)),
               e.ellipse((10, 25), (8, 2), 0.5, 0.4, 5.0), e.polyline([(0, 32), (9, 30, 0, 0.8), (18, 34)])]
    d.blocks["BRACKET"] = ((3, 2), bracket)
    d.blocks["PAIR"] = ((0, 0), [e.insert("BRACKET", (0, 0)), e.insert("BRACKET", (35, 0), scale=(-1, 1, 1), layer="A")])
    d.blocks["NEST"] = ((5, 5), [e.insert("PAIR", (0, 0), scale=(1, 2, 1), rotation=20),
                                 e.insert("PAIR", (0, 90), scale=(0.5, -0.5, 0.5)), e.circle((80, 40), 9)])
    d.add(e.insert("BRACKET", (0, 0)), e.insert("BRACKET", (60, 0), rotation=40, layer="A"))
    d.add(e.insert("BRACKET", (120, 0), scale=(-1, 1, 1)), e.insert("BRACKET", (160, 0), scale=(1.3, -0.7, 1), rotation=15))
    d.add(e.insert("BRACKET", (240, 0), scale=(-2, -2, -2)), e.insert("BRACKET", (300, 0), scale=(2.5, 1, 1)))
    d.add(e.insert("PAIR", (0, 100), rotation=-30, layer="B"), e.insert("NEST", (120, 120), scale=(0.8, 1.1, 1), rotation=10))
    d.add(e.insert("BRACKET", (0, 320), scale=(0.5, 0.5, 0.5), columns=3, rows=2, spacing=(25, 30)))
    d.add(e.insert("BRACKET", (150, 320), scale=(1, -1, 1), rotation=30, columns=2, rows=2, spacing=(30, -45), layer="A"))
    return d


def hidden():
    """Paper space, invisible entities, frozen and off layers, also through blocks: only what is seen is cut."""
    d = Drawing("hidden", layers=[("FROZEN", 1, 1), ("OFF", -2, 0), ("LOCKED", 3, 4), ("SHOWN", 4, 0)])
    square = [(0, 0), (10, 0), (10, 10), (0, 10)]
    for i, layer in enumerate(("FROZEN", "OFF", "LOCKED", "SHOWN", "UNLISTED")):
        d.add(e.lwpolyline(_shifted(square, 20 * i, 0), closed=True, layer=layer))
    d.add(e.circle((5, 30), 4, extra=[(67, 1)]), e.circle((25, 30), 4, extra=[(60, 1)]))
    d.add(e.circle((45, 30), 4, extra=[(67, 0)]), e.circle((65, 30), 4, extra=[(60, 0)]))
    d.blocks["MIXED"] = ((0, 0), [e.circle((0, 0), 3), e.circle((8, 0), 3, layer="SHOWN"),
                                  e.circle((16, 0), 3, layer="OFF"), e.circle((24, 0), 3, layer="FROZEN"),
                                  e.circle((32, 0), 3, extra=[(60, 1)])])
    for i, layer in enumerate(("0", "SHOWN", "OFF", "FROZEN")):
        d.add(e.insert("MIXED", (5, 50 + 10 * i), layer=layer))
    d.add(e.insert("MIXED", (5, 100), extra=[(60, 1)]))
    return d


def units(code, scale):
    """A part of the same size in every unit of $INSUNITS."""
    d = Drawing(f"units-{code}", insunits=code)
    s = 1.0 / scale
    d.add(e.lwpolyline([(0, 0), (80 * s, 0, 0.3), (80 * s, 50 * s), (0, 50 * s)], closed=True))
    d.add(e.circle((20 * s, 25 * s), 8 * s), e.arc((50 * s, 25 * s), 10 * s, 30, 300))
    d.add(e.ellipse((65 * s, 40 * s), (5 * s, 2 * s), 0.5), e.line((10 * s, 5 * s), (70 * s, 5 * s)))
    return d


def far():
    """Small shapes far from the origin, and large ones."""
    d = Drawing("far-and-large")
    d.add(e.circle((183000.5, 532000.25), 1.5), e.arc((183010, 532000), 4, 10, 200))
    d.add(e.lwpolyline([(183000, 532010, 0.4), (183010, 532010), (183010, 532020, 1)], closed=True))
    d.add(e.ellipse((183030, 532000), (6, 2), 0.5), e.circle((183500, 532500), 400))
    return d


def odd_files():
    """The same small drawing laid out in every way a file may be: versions, line ends, encodings, binary."""
    out = []
    for version, eol, codepage, encoding, binary in [
        ("AC1009", "\r\n", "ANSI_1252", "cp1252", False), ("AC1009", "\n", None, "cp1252", True),
        ("AC1014", "\n", "ANSI_1251", "cp1251", False), ("AC1015", "\r\n", "ANSI_1252", "cp1252", True),
        ("AC1018", "\n", "ANSI_936", "gbk", False), ("AC1021", "\n", None, "utf-8", False),
        ("AC1024", "\r\n", None, "utf-8", True), ("AC1027", "\n", None, "utf-8", False),
        ("AC1032", "\r\n", None, "utf-8", True),
    ]:
        layer = {"cp1252": "Schnitt-außen", "cp1251": "Резка", "gbk": "切割"}.get(encoding, "Découpe切割")
        d = Drawing(f"file-{version}{'-binary' if binary else ''}", version=version, eol=eol, codepage=codepage,
                    encoding=encoding, binary=binary, insunits=None if version == "AC1009" else 4,
                    layers=[(layer, 5, 0)], given_unit="mm" if version == "AC1009" else None)
        d.blocks["B1"] = ((1, 1), [e.circle((3, 3), 2), e.line((0, 0), (6, 1))])
        d.add(e.line((0, 0), (30, 12), layer=layer), e.circle((50, 10), 7), e.arc((80, 10), 9, 200, 20, layer=layer))
        d.add(e.polyline([(0, 40), (20, 40, 0, 0.5), (20, 60)], closed=True), e.insert("B1", (50, 50), rotation=25))
        if version != "AC1009":
            d.add(e.lwpolyline([(80, 40, -0.4), (100, 40), (90, 60)], closed=True, layer=layer))
            d.add(e.spline(3, [(0, 80), (10, 100), (30, 70), (40, 90)], e.clamped_knots(3, 4)))
        d.add(e.text((0, 120), layer), e.point((3, 3)))
        out.append(d)
    return out


def all_cases():
    out = [plain(), bulges(), old_polylines("AC1009"), old_polylines("AC1015"), ellipses(), splines(), hairpin(), fit_splines(),
           filled(), hatches(), inserts(), hidden(), far()]
    out += [extrusions(n, name) for n, name in ((MIRROR, "below"), (TILTED, "tilted"), (SKEW, "skew"))]
    # mm per unit, by $INSUNITS code.
    sizes = {1: 25.4, 2: 304.8, 4: 1.0, 5: 10.0, 6: 1000.0, 8: 25.4e-6, 9: 0.0254, 10: 914.4, 13: 0.001, 14: 100.0}
    out += [units(code, mm) for code, mm in sizes.items()]
    return out + odd_files()
