"""What a quote should say of a drawing, reckoned by ezdxf and Shapely.

    python tests/oracle/quotes.py

writes `tests/fixtures/quotes.json`: for each drawing of `tests/fixtures/dxf-dev` its cut length, box, net area and closed
contours, which `tests/package/quote-oracle.test.mjs` compares with the report of a quote. ezdxf reads and flattens (see
`reference.py`), Shapely unites what lies on top of each other, and the rest is written here: ends that are nearer than
0.05 mm are one, chains of them that close are contours, and what lies in an odd number of contours is material.
No code is shared with Kerfway. Needs `pip install ezdxf shapely`.
"""

import json
import math
from pathlib import Path

import shapely
from reference import FACTORS, NAMES, paths_of, read

FIXTURES = Path(__file__).resolve().parent.parent / "fixtures"
# mm. Chords of curves. The grids on which lines are united: what differs by less lies on top of each other; the coarser one
# finds more of it and roughens curves. How far apart ends may be and still be joined, as is Kerfway's default.
CHORD, GRIDS, JOIN = 0.0005, (0.002, 0.005), 0.05



def united(paths, grid):
    """All lines once, however often they are drawn, whole between places where lines meet."""
    lines = [shapely.LineString([*p.points, p.points[0]] if p.closed else p.points) for p in paths if len(p.points) > 1]
    merged = shapely.line_merge(shapely.union_all(lines, grid_size=grid))
    return [line for line in shapely.get_parts(merged) if line.length > 0]


def rings(lines):
    """Chains of lines that close, where no more than two ends meet."""
    ends, nodes = [], []
    # What begins and ends in one place and is shorter than that place is a crumb.
    lines = [line for line in lines if line.length > 2 * JOIN]
    for k, line in enumerate(lines):
        for place in (line.coords[0], line.coords[-1]):
            node = next((n for n, at in enumerate(nodes) if math.dist(at, place) < JOIN), None)
            if node is None:
                node = len(nodes)
                nodes.append(place)
            ends.append((node, k))
    at = {}
    for node, k in ends:
        at.setdefault(node, []).append(k)
    out, used = [], set()
    for first in range(len(lines)):
        if first in used:
            continue
        used.add(first)
        points = list(lines[first].coords)
        start, node = ends[2 * first][0], ends[2 * first + 1][0]
        while node != start:
            onward = [k for k in at[node] if k not in used]
            if len(at[node]) != 2 or not onward:
                break
            k = onward[0]
            used.add(k)
            there, back = ends[2 * k][0], ends[2 * k + 1][0]
            points += list(lines[k].coords) if there == node else list(lines[k].coords)[::-1]
            node = back if there == node else there
        if node == start and len(at[start]) == 2 and len(points) > 3:
            out.append(shapely.Polygon(points))
    return out


def material(contours):
    """Area of what lies in an odd number of contours."""
    tree = shapely.STRtree(contours)
    area = 0.0
    for k, contour in enumerate(contours):
        inner = contour.representative_point()
        around = [j for j in tree.query(inner) if j != k and contours[j].contains(inner) and contours[j].area > contour.area]
        area += contour.area * (-1) ** len(around)
    return area


def figures(path):
    doc = read(path)
    unit = next((name for name, factor in NAMES.items() if factor == FACTORS.get(doc.header.get("$INSUNITS", 0))), "mm")
    if unit == "m":
        # Files that say metres and mean millimetres; a sheet of 100 m is none.
        unit = "mm"
    paths = paths_of(doc, NAMES[unit], CHORD)
    by_grid = [united(paths, grid) for grid in GRIDS]
    closed = rings(by_grid[0])
    return {
        "units": unit,
        "cut_length": round(min(sum(line.length for line in lines) for lines in by_grid), 4),
        "bounds": [round(float(v), 4) for v in shapely.total_bounds(by_grid[0])],
        "net_area": round(material(closed), 4),
        "closed": len(closed),
    }


def main():
    found = {}
    for path in sorted((FIXTURES / "dxf-dev").glob("*.[dD][xX][fF]")):
        found[path.name] = figures(path)
        print(path.name, found[path.name])
    (FIXTURES / "quotes.json").write_text(json.dumps(found, indent=2) + "\n")


if __name__ == "__main__":
    main()
