"""Other solvers on an instance of GTSPLIB, to compare the search with in the same run of `npm run bench -- solve gtsplib`.

    baselines.py FILE.gtsp [--seconds 10] [--solver elkai ortools pyvrp]

LKH (by elkai, after the transformation of Noon and Bean), OR-tools' routing and PyVRP; the entry nodes are then made optimal for the
order of the sets. Needs `pip install elkai ortools pyvrp numpy`. Prints one line of JSON for each solver: file, solver, length,
seconds, note. elkai has no time limit: its seconds are what it took.
"""

import argparse
import json
import time

import numpy as np


def read(path):
    """The matrix of integer costs and the nodes of each set."""
    header, sections, section = {}, {}, None
    for line in open(path).read().splitlines():
        text = line.strip().rstrip(":").strip()
        if text.endswith("_SECTION"):
            section = sections.setdefault(text, [])
        elif text == "EOF":
            break
        elif section is None and ":" in line:
            key, value = line.split(":", 1)
            header[key.strip()] = value.strip()
        elif text and section is not None:
            section.append(text)
    kind = header["EDGE_WEIGHT_TYPE"]
    if kind == "EXPLICIT":
        numbers = np.array(" ".join(sections["EDGE_WEIGHT_SECTION"]).split(), float).astype(np.int64)
        costs = explicit(int(header["DIMENSION"]), header.get("EDGE_WEIGHT_FORMAT", "FULL_MATRIX"), numbers)
    else:
        costs = planar(kind, np.array([line.split()[1:3] for line in sections["NODE_COORD_SECTION"]], float))
    sets = [[int(x) - 1 for x in line.split()[1:] if x != "-1"] for line in sections["GTSP_SET_SECTION"]]
    return costs, sets


def explicit(n, form, numbers):
    if form == "FULL_MATRIX":
        return numbers.reshape(n, n)
    indices = {"UPPER_DIAG_ROW": np.triu_indices(n), "LOWER_DIAG_ROW": np.tril_indices(n)}
    if form not in indices:
        raise SystemExit(f"The edge weight format {form} is not supported.")
    half = np.zeros((n, n), np.int64)
    half[indices[form]] = numbers
    return half + half.T - np.diag(half.diagonal())


def planar(kind, points):
    """Distances as TSPLIB defines them."""
    apart = points[:, None, :] - points[None, :, :]
    straight = np.hypot(apart[..., 0], apart[..., 1])
    if kind == "EUC_2D":
        return np.floor(straight + 0.5).astype(np.int64)
    if kind == "CEIL_2D":
        return np.ceil(straight).astype(np.int64)
    if kind == "ATT":
        exact = np.sqrt((apart**2).sum(-1) / 10.0)
        rounded = np.rint(exact)
        return np.where(rounded < exact, rounded + 1, rounded).astype(np.int64)
    if kind == "GEO":
        degrees = np.trunc(points)
        radians = 3.141592 * (degrees + 5.0 * (points - degrees) / 3.0) / 180.0
        latitude, longitude = radians[:, 0], radians[:, 1]
        q1 = np.cos(longitude[:, None] - longitude[None, :])
        q2 = np.cos(latitude[:, None] - latitude[None, :])
        q3 = np.cos(latitude[:, None] + latitude[None, :])
        costs = (6378.388 * np.arccos(np.clip(0.5 * ((1 + q1) * q2 - (1 - q1) * q3), -1, 1)) + 1).astype(np.int64)
        np.fill_diagonal(costs, 0)
        return costs
    raise SystemExit(f"The edge weight type {kind} is not supported.")


def length(costs, tour):
    return int(sum(costs[tour[k - 1], tour[k]] for k in range(len(tour))))


def set_of(sets):
    return {node: index for index, nodes in enumerate(sets) for node in nodes}


def visits_every_set(sets, tour):
    of = set_of(sets)
    return sorted(of[node] for node in tour) == list(range(len(sets)))


def best_entries(costs, sets, order):
    """The best node of every set for a cyclic order of the sets, by dynamic programming from each node of the smallest set."""
    start = min(range(len(order)), key=lambda k: len(sets[order[k]]))
    order = order[start:] + order[:start]
    best = (None, None)
    for first in sets[order[0]]:
        nodes, total, back = [first], np.zeros(1), []
        for index in order[1:]:
            ways = total[:, None] + costs[np.ix_(nodes, sets[index])]
            back.append((nodes, ways.argmin(0)))
            nodes, total = sets[index], ways.min(0)
        closed = total + costs[nodes, first]
        last = int(closed.argmin())
        if best[0] is None or closed[last] < best[0]:
            tour, k = [nodes[last]], last
            for before, choice in reversed(back):
                k = int(choice[k])
                tour.append(before[k])
            best = (closed[last], tour[::-1])
    return best[1]


def noon_bean(costs, sets):
    """An asymmetric TSP whose tours walk each set as a ring of cost zero: it is left from before the node where it was entered."""
    costs = costs.copy()
    np.fill_diagonal(costs, 0)
    large = int(costs.max()) * 2 + 1
    after = np.zeros(len(costs), int)
    for nodes in sets:
        for k, node in enumerate(nodes):
            after[node] = nodes[(k + 1) % len(nodes)]
    matrix = costs[after] + large
    for nodes in sets:
        if len(nodes) > 1:
            matrix[np.ix_(nodes, nodes)] = 3 * large
            for node in nodes:
                matrix[node, after[node]] = 0
    np.fill_diagonal(matrix, 0)
    return matrix


def entered(tour, sets):
    """The order in which a tour of all nodes enters the sets."""
    of = set_of(sets)
    # From the first node of a set on, so that the set in which the tour file begins is not split.
    start = next((k for k in range(len(tour)) if of[tour[k]] != of[tour[k - 1]]), 0)
    return list(dict.fromkeys(of[node] for node in tour[start:] + tour[:start]))


def lkh(costs, sets, _seconds):
    import elkai

    tour = elkai.DistanceMatrix(noon_bean(costs, sets).tolist()).solve_tsp(runs=1)[:-1]
    return best_entries(costs, sets, entered(tour, sets)), ""


def single_node_set(sets):
    """The set to begin with: OR-tools and PyVRP need one of a single node."""
    depot = min(range(len(sets)), key=lambda k: len(sets[k]))
    if len(sets[depot]) != 1:
        raise SystemExit("No set has a single node to begin with.")
    return depot


def ortools(costs, sets, seconds):
    from ortools.constraint_solver import pywrapcp, routing_enums_pb2

    depot = single_node_set(sets)
    manager = pywrapcp.RoutingIndexManager(len(costs), 1, sets[depot][0])
    routing = pywrapcp.RoutingModel(manager)
    matrix = costs.copy()
    np.fill_diagonal(matrix, 0)
    routing.SetArcCostEvaluatorOfAllVehicles(routing.RegisterTransitMatrix(matrix.tolist()))
    penalty = int(costs.max()) * 20
    for index, nodes in enumerate(sets):
        if index != depot:
            routing.AddDisjunction([manager.NodeToIndex(node) for node in nodes], penalty, 1)
    parameters = pywrapcp.DefaultRoutingSearchParameters()
    parameters.first_solution_strategy = routing_enums_pb2.FirstSolutionStrategy.PATH_CHEAPEST_ARC
    parameters.local_search_metaheuristic = routing_enums_pb2.LocalSearchMetaheuristic.GUIDED_LOCAL_SEARCH
    parameters.time_limit.FromMilliseconds(int(seconds * 1000))
    solution = routing.SolveWithParameters(parameters)
    if not solution:
        return None, "no solution"
    index, tour = routing.Start(0), []
    while not routing.IsEnd(index):
        tour.append(manager.IndexToNode(index))
        index = solution.Value(routing.NextVar(index))
    return finished(costs, sets, tour)


def pyvrp(costs, sets, seconds):
    import pyvrp
    from pyvrp.stop import MaxRuntime

    depot = single_node_set(sets)
    nodes = sets[depot] + [node for index, own in enumerate(sets) if index != depot for node in own]
    matrix = costs[np.ix_(nodes, nodes)].astype(np.int64)
    np.fill_diagonal(matrix, 0)
    model = pyvrp.Model()
    model.add_depot(model.add_location(0, 0))
    model.add_vehicle_type(1)
    for index, own in enumerate(sets):
        if index != depot:
            group = model.add_client_group(required=True)
            for _ in own:
                model.add_client(model.add_location(0, 0), required=False, group=group)
    data = model.data().replace(distance_matrices=[matrix], duration_matrices=[np.zeros_like(matrix)])
    result = pyvrp.solve(data, stop=MaxRuntime(seconds), seed=1, display=False)
    clients = [stop.idx for route in result.best.routes() for stop in route if getattr(stop, "is_client", lambda: False)()]
    return finished(costs, sets, [nodes[0]] + [nodes[k + 1] for k in clients])


def finished(costs, sets, tour):
    if not visits_every_set(sets, tour):
        return None, "a set was not visited"
    of = set_of(sets)
    return best_entries(costs, sets, [of[node] for node in tour]), ""


SOLVERS = {"elkai": lkh, "ortools": ortools, "pyvrp": pyvrp}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("file")
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("--solver", nargs="*", choices=list(SOLVERS), default=list(SOLVERS))
    args = parser.parse_args()
    costs, sets = read(args.file)
    for solver in args.solver:
        begun = time.time()
        tour, note = SOLVERS[solver](costs, sets, args.seconds)
        row = {"file": args.file, "solver": solver, "length": tour and length(costs, tour), "seconds": round(time.time() - begun, 1)}
        print(json.dumps({**row, "note": note}), flush=True)


if __name__ == "__main__":
    main()
