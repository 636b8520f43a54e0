"""Instances of GTSPLIB, by the definitions of TSPLIB95."""

import math


def read(text):
    """Cost between two nodes as a function, and the nodes of each set; nodes count from 0."""
    header, sections, section = {}, {}, None
    for row in text.splitlines():
        row = row.strip()
        if row.rstrip(": ").endswith("_SECTION"):
            section = sections.setdefault(row.rstrip(": "), [])
        elif row and row != "EOF" and section is None:
            key, _, value = row.partition(":")
            header[key.strip()] = value.strip()
        elif row and row != "EOF":
            section.append([float(x) for x in row.split()])
    sets = [[int(x) - 1 for x in row[1:] if x > 0] for row in sections["GTSP_SET_SECTION"]]
    kind, n = header["EDGE_WEIGHT_TYPE"], int(header["DIMENSION"])
    if kind == "EXPLICIT":
        flat = [int(x) for row in sections["EDGE_WEIGHT_SECTION"] for x in row]
        place = {
            "FULL_MATRIX": lambda a, b: a * n + b,
            "LOWER_DIAG_ROW": lambda a, b: max(a, b) * (max(a, b) + 1) // 2 + min(a, b),
            "UPPER_DIAG_ROW": lambda a, b: min(a, b) * (2 * n - min(a, b) + 1) // 2 + abs(a - b),
        }[header["EDGE_WEIGHT_FORMAT"]]
        return lambda a, b: flat[place(a, b)], sets
    at = [row[1:3] for row in sections["NODE_COORD_SECTION"]]
    return lambda a, b: {"EUC_2D": euclidean, "ATT": pseudo, "GEO": geographical}[kind](at[a], at[b]), sets


def euclidean(a, b):
    return int(math.dist(a, b) + 0.5)


def pseudo(a, b):
    return math.ceil(math.dist(a, b) / math.sqrt(10))


def geographical(a, b):
    (la, lo), (lb, mo) = [[3.141592 * (int(x) + 5 * (x - int(x)) / 3) / 180 for x in p] for p in (a, b)]
    q1, q2, q3 = math.cos(lo - mo), math.cos(la - lb), math.cos(la + lb)
    return int(6378.388 * math.acos(0.5 * ((1 + q1) * q2 - (1 - q1) * q3)) + 1)
