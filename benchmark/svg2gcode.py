"""Plans by svg2gcode: the contours as SVG, the program that it writes, and the contours in the order of that program.

svg2gcode cuts each path whole. It knows no nesting, so each depth of nesting is a drawing of its own, the deepest first, and the search for
the shortest travel of a drawing begins where the one before ended. Versions before 0.0.19 know no search: they keep the order of the drawing.
"""

import math
import re
import subprocess
import tempfile
from pathlib import Path

from rules import Arc, Contour

NEAR = 0.05  # mm: how far the ends in the program may be from those of the contour; version 0.0.19 ends a closed one up to 0.02 mm away
SECONDS = 120  # how long it may take for one drawing


def xy(point):
    return point.real, point.imag


def outline(contour):
    """The data of an SVG path, with y upwards; an arc in halves, so that a whole turn has two ends."""
    out = ["M%.17g %.17g" % xy(contour.start)]
    for part in contour.parts:
        if isinstance(part, Arc):
            large, sweep = int(part.sweep / 2 > math.pi), int(part.sign > 0)
            out += ["A%.17g %.17g 0 %d %d %.17g %.17g" % (part.radius, part.radius, large, sweep, *xy(to)) for to in (part.at(0.5), part.end)]
        else:
            out.append("L%.17g %.17g" % xy(part.end))
    return "".join(out)


def box(contours):
    """The lower left and upper right corners of a box around contours."""
    points = []
    for contour in contours:
        points.append(contour.start)
        for part in contour.parts:
            points.append(part.end)
            if isinstance(part, Arc):
                points += [part.at(part.nearest(part.center + part.radius * way)) for way in (1, -1, 1j, -1j)]
    return [(least(p.real for p in points), least(p.imag for p in points)) for least in (min, max)]


def drawing(contours):
    """The contours as SVG in mm, with the lower left corner of their box at the lower left of the sheet, where svg2gcode has its origin."""
    (left, low), (right, high) = box(contours)
    width, height = right - left, high - low
    paths = "\n".join(f'<path d="{outline(contour)}"/>' for contour in contours)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width!r}mm" height="{height!r}mm" viewBox="0 0 {width!r} {height!r}" '
        f'fill="none" stroke="black">\n<g transform="matrix(1 0 0 -1 {-left!r} {high!r})">\n{paths}\n</g>\n</svg>\n'
    )


def stretches(program):
    """What a program cuts between two rapid moves: first point, last point, and length, arcs measured along their chords."""
    found, here = [], (0.0, 0.0)
    for line in program.splitlines():
        words = dict(re.findall(r"([GXY])\s*(-?[0-9.]+)", re.sub(r";.*|\(.*?\)", "", line)))
        if "X" not in words and "Y" not in words:
            continue
        to = (float(words.get("X", here[0])), float(words.get("Y", here[1])))
        if float(words.get("G", 1)) == 0:
            found.append([to, to, 0.0])
        elif found:
            found[-1][1:] = [to, found[-1][2] + math.dist(here, to)]
        here = to
    return [tuple(stretch) for stretch in found if stretch[2] > 0]


def visits(contours, program):
    """The contours in the order of a program for their drawing, each with whether it is cut backwards. Refuses a program that does not cut
    each once."""
    left, low = box(contours)[0]
    ends = {}
    square = lambda p: (math.floor(p[0] / NEAR), math.floor(p[1] / NEAR))  # noqa: E731
    for k, contour in enumerate(contours):
        start = xy(contour.start)
        last = start if contour.closed else xy(contour.end)
        for backwards, first, end in ((False, start, last), (True, last, start)):
            ends.setdefault(square(first), []).append((k, backwards, first, end))
    order, uncut = [], set(range(len(contours)))
    for *points, length in stretches(program):
        first, last = ((x + left, y + low) for x, y in points)
        x, y = square(first)
        for k, backwards, a, b in (e for i in (-1, 0, 1) for j in (-1, 0, 1) for e in ends.get((x + i, y + j), ())):
            if k in uncut and max(math.dist(a, first), math.dist(b, last)) <= NEAR and abs(length / contours[k].length - 1) < 0.01:
                uncut.remove(k)
                order.append((k, backwards))
                break
        else:
            raise RuntimeError(f"the program cuts {length:.3f} mm from {first} to {last}, which is no contour that is still uncut")
    if uncut:
        raise RuntimeError(f"the program does not cut {len(uncut)} contours")
    return order


def version(command="svg2gcode"):
    """The name and version of the program, and whether it knows a search."""
    said = [subprocess.run([command, flag], capture_output=True, text=True, check=True).stdout for flag in ("--version", "--help")]
    return said[0].strip(), "--optimize-path-order" in said[1]


def order(instance, depths, command="svg2gcode"):
    """The contours of an instance in the order in which svg2gcode cuts them, each with whether it is cut backwards."""
    contours, done, here = [Contour(c) for c in instance["contours"]], [], tuple(instance["home"])
    searches = version(command)[1]
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "drawing.svg"
        for level in range(max(depths), -1, -1):
            own = [k for k, depth in enumerate(depths) if depth == level]
            layer = [contours[k] for k in own]
            file.write_text(drawing(layer))
            options = ["--tolerance", "0.001"]
            if searches:
                left, low = box(layer)[0]
                options += ["--optimize-path-order", "true", f"--starting-point={here[0] - left!r},{here[1] - low!r}"]
            run = subprocess.run([command, *options, str(file)], capture_output=True, text=True, timeout=SECONDS, check=True)
            for k, backwards in visits(layer, run.stdout):
                here = xy(layer[k].start if layer[k].closed or backwards else layer[k].end)
                done.append((own[k], backwards))
    return done
