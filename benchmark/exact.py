"""Exact plans for small instances of the track ECP without nesting: the rural postman problem, by HiGHS.

Every side of a contour is cut once, air moves join them, and the whole is one closed walk through home: an even number of ends at each
point, and no part of it apart from the rest. Parts that are apart are found in each solution and forbidden in the next.
Needs `pip install highspy networkx numpy`.
"""

import math

INFINITY = 1e30


def plan(instance):
    """The moves of a shortest plan, or None if the instance is not of this kind."""
    contours = instance["contours"]
    if instance["track"] != "ECP" or any(c["inside"] is not None for c in contours) or len(contours) > 60:
        return None
    points, owner = [tuple(instance["home"])], [0]
    for k, contour in enumerate(contours, 1):
        corners = [contour["start"]] + [piece["line"] for piece in contour["path"]][:-1]
        points += [tuple(p) for p in corners]
        owner += [k] * len(corners)
    return moves(contours, points, owner, postman(points, owner))


def postman(points, owner):
    """Air moves of a shortest closed walk as pairs of points, one for each time it is used."""
    import highspy
    import networkx as nx
    import numpy as np

    pairs = [(i, j) for i in range(len(points)) for j in range(i + 1, len(points)) if owner[i] != owner[j]]
    solver = highspy.Highs()
    solver.setOptionValue("output_flag", False)
    solver.setOptionValue("mip_rel_gap", 1e-9)
    for k, (i, j) in enumerate(pairs):
        solver.addVar(0, 2)
        solver.changeColCost(k, math.dist(points[i], points[j]))
        solver.changeColIntegrality(k, highspy.HighsVarType.kInteger)
    at = {}
    for k, pair in enumerate(pairs):
        for i in pair:
            at.setdefault(i, []).append(k)
    for extra, ks in enumerate(at.values(), len(pairs)):
        solver.addVar(0, len(ks))
        solver.changeColIntegrality(extra, highspy.HighsVarType.kInteger)
        solver.addRow(0, 0, len(ks) + 1, np.array(ks + [extra]), np.array([1.0] * len(ks) + [-2.0]))

    def joined(group):
        ks = [k for k, (i, j) in enumerate(pairs) if (owner[i] in group) != (owner[j] in group)]
        solver.addRow(2, INFINITY, len(ks), np.array(ks), np.ones(len(ks)))

    for k in set(owner):
        joined({k})
    while True:
        solver.run()
        used = [round(x) for x in solver.getSolution().col_value[: len(pairs)]]
        graph = nx.Graph()
        graph.add_nodes_from(set(owner))
        graph.add_edges_from((owner[i], owner[j]) for (i, j), n in zip(pairs, used) if n)
        apart = list(nx.connected_components(graph))
        if len(apart) == 1:
            return [pair for pair, n in zip(pairs, used) for _ in range(n)]
        for group in apart:
            joined(group)


def moves(contours, points, owner, air):
    """A walk from home that uses every side and every air move once, as moves."""
    import networkx as nx

    graph = nx.MultiGraph()
    graph.add_edges_from((i, j, {"air": True}) for i, j in air)
    first = 1
    for contour in contours:
        n = len(contour["path"])
        graph.add_edges_from((first + k, first + (k + 1) % n, {"air": False}) for k in range(n))
        first += n
    found, reached = [], set()
    for i, j, key in nx.eulerian_circuit(graph, source=0, keys=True):
        if graph.edges[i, j, key]["air"]:
            found.append({"kind": "air", "to": list(points[j])})
            continue
        if found and found[-1]["kind"] == "cut" and found[-1]["side"] == (owner[i], way(graph, i, j)):
            found[-1]["path"].append({"line": list(points[j])})
        else:
            found += [] if i in reached else [{"kind": "pierce"}]
            found.append({"kind": "cut", "side": (owner[i], way(graph, i, j)), "path": [{"line": list(points[j])}]})
        reached |= {i, j}
    return [{key: value for key, value in move.items() if key != "side"} for move in found]


def way(graph, i, j):
    """Whether a side is walked forwards. The last side of a contour goes back to its first point."""
    return j == i + 1 or i - j > 1
