"""Reference checker of the benchmark of cutting paths. It shares nothing with the programs whose plans it checks.

    python3 check.py FOLDER                   every plan of a folder: NAME.json or NAME.json.gz is a plan for the instance NAME
    python3 check.py INSTANCE PLAN            one plan for an instance in a file
    python3 check.py --instance NAME PLAN     one plan for an instance of the benchmark

Prints a line for each plan: its value, or the name of what is wrong and where. Exit code 0 if every plan is sound, 1 if one is wrong, 2 if
the command is, or if there is nothing to check. README.md defines instances, plans, rules and cost; the names of the faults are those of
`Wrong` in contours.py.
"""

import gzip
import hashlib
import json
import math
import sys
import zlib
from pathlib import Path

from contours import NEAR, Arc, Contour, Grid, Wrong, number, pieces, point, short, show  # noqa: F401
from gtsplib import read

HERE = Path(__file__).resolve().parent


class Unusable(Exception):
    """A file that is missing or is not what it should be, which is not the fault of a plan."""


def load(path):
    try:
        data = Path(path).read_bytes()
    except OSError as error:
        raise Unusable(f"{path} cannot be read: {error.strerror}") from error
    try:
        return gzip.decompress(data) if str(path).endswith(".gz") else data
    except (OSError, EOFError, zlib.error) as error:
        raise Wrong(f"not-a-plan: {path} is not a gzip file: {error}") from error


def plan_of(path):
    """What is in the file of a plan."""
    try:
        return json.loads(load(path))
    except (ValueError, RecursionError) as error:
        raise Wrong(f"not-a-plan: the file is not JSON: {error}") from error


def instance_in(path):
    """An instance in a file."""
    try:
        instance = json.loads(load(path))
        if "gtsplib" not in instance:
            [Contour(c) for c in instance["contours"]]
            _ = instance["cost"]["unit"], instance["cost"]["pierce"], instance["track"], instance["closed"], instance["home"]
        return instance
    except (Wrong, KeyError, TypeError, ValueError, RecursionError) as error:
        raise Unusable(f"{path} is not an instance: {error!r}") from error


def air(cost, distance):
    """Cost of an air move: its length, or the seconds of a move that starts and ends at rest."""
    if cost["unit"] == "mm":
        return distance
    speed, acceleration = cost["speed"], cost["acceleration"]
    ramp = speed * speed / acceleration
    return distance / speed + speed / acceleration if distance >= ramp else 2 * math.sqrt(distance / acceleration)


def travelled(cost, way):
    """Cost of the air moves from place to place."""
    return sum(air(cost, math.dist(*ends)) for ends in zip(way, way[1:]))


def cutting(instance, plan):
    """The value of a plan for an instance of the tracks CCP, ECP, ICP and TIME."""
    cost, contours = instance["cost"], [Contour(c) for c in instance["contours"]]
    grid, home = Grid(contours), tuple(instance["home"])
    # Air is measured between places on the contours: a plan may be up to NEAR beside them.
    here, way, value, pierced, when = home, [home], 0.0, False, {}
    if not isinstance(plan, dict) or not isinstance(plan.get("moves"), list):
        raise Wrong("not-a-plan: there is no list of moves")
    for k, move in enumerate(plan["moves"]):
        kind, cut, to = read_move(move, here, k)
        if kind == "air":
            way, pierced = [*way, to], False
        elif kind == "pierce":
            value, pierced = value + cost["pierce"], True
        else:
            found = [(i, *ends) for i in grid.near(here) if (ends := contours[i].follow(here, cut))]
            if not found:
                raise Wrong(f"off-contour: move {k} from {show(here)} to {show(to)} does not follow any one contour")
            # Where contours lie on each other, the one that is not cut yet.
            index, s, end = next((f for f in found if contours[f[0]].cut_before(*f[1:])[0] <= 2 * NEAR), found[0])
            if not pierced and not contours[index].is_open_at(here):
                raise Wrong(f"no-pierce: move {k} cuts at {show(here)}, where nothing was pierced, and no cut of this contour ends")
            value += travelled(cost, [*way[:-1], contours[index].at(s)])
            way = [contours[index].at(end)]
            cover(contours[index], s, end, instance["track"], k)
            if contours[index].is_cut():
                when.setdefault(index, k)
            pierced = False
        here = to
    for index, contour in enumerate(contours):
        if index not in when:
            raise Wrong(f"not-cut: contour {index}, which begins at {show(contour.start)}, is not wholly cut")
        if contour.inside is not None and when.get(contour.inside, len(contours)) < when[index]:
            raise Wrong(
                f"order: contour {index}, which begins at {show(contour.start)}, is finished by move {when[index]}, "
                f"after contour {contour.inside}, inside which it lies"
            )
    if instance["closed"] and math.dist(here, home) > NEAR:
        raise Wrong(f"no-return: the head ends at {show(here)} and not at home, {show(home)}")
    return value + travelled(cost, [*way[:-1], home] if instance["closed"] else way)


def read_move(move, here, k):
    """The kind of a move, the lines and arcs of a cut, and where it ends."""
    kind = move.get("kind") if isinstance(move, dict) else None
    try:
        if kind == "air":
            return kind, None, point(move.get("to"))
        if kind == "cut":
            cut = list(pieces(here, move.get("path")))
            return kind, cut, cut[-1].end
    except Wrong as wrong:
        raise Wrong(f"{wrong}, in move {k} from {show(here)}") from None
    if kind != "pierce":
        raise Wrong(f"not-a-plan: move {k} is of the kind {short(kind)}")
    return kind, None, here


def cover(contour, s, end, track, k):
    """Adds a cut to what is cut of a contour, if the track allows it."""
    length = abs(end - s)
    if length <= 2 * NEAR:
        # Many of them would add up to a contour, or lead along one that is cut already.
        raise Wrong(f"not-a-plan: move {k} at {show(contour.at(s))} is a cut of {length:.4f} mm; a cut is longer than {2 * NEAR} mm")
    if track in ("CCP", "TIME") and abs(length - contour.length) > 2 * NEAR and not contour.cuts:
        raise Wrong(
            f"not-whole: move {k} at {show(contour.at(s))} cuts {length:.3f} mm of a contour of {contour.length:.3f} mm, "
            "which is cut in one go on this track"
        )
    if track == "ECP" and not all(any(math.dist(contour.at(x), contour.at(v)) <= NEAR for v in contour.vertices) for x in (s, end)):
        raise Wrong(
            f"not-an-endpoint: move {k} from {show(contour.at(s))} to {show(contour.at(end))} begins or ends within a line or arc; "
            "on this track only their ends may be used"
        )
    twice, place = contour.cut_before(s, end)
    if length > contour.length + 2 * NEAR:
        twice, place = length - contour.length, s
    if twice > 2 * NEAR:
        raise Wrong(f"cut-twice: move {k} cuts {twice:.3f} mm again at {show(contour.at(place))}")
    contour.add(s, end)


def tour(instance, plan):
    """The value of a tour for an instance of GTSPLIB: the file is read here, by the definitions of TSPLIB95."""
    costs, sets = read(load(HERE / instance["gtsplib"]).decode())
    nodes = plan.get("tour") if isinstance(plan, dict) else None
    if not isinstance(nodes, list):
        raise Wrong("not-a-plan: there is no list of nodes, tour")
    home = {node: index for index, members in enumerate(sets) for node in members}
    seen = [home.get(n - 1) if type(n) is int else None for n in nodes]
    if None in seen:
        raise Wrong(f"not-a-plan: {short(nodes[seen.index(None)])} is not a node of this instance; nodes count from 1")
    if len(set(seen)) < len(seen):
        raise Wrong(f"visited-twice: set {next(s for s in seen if seen.count(s) > 1)} is visited more than once")
    if len(seen) < len(sets):
        raise Wrong(f"not-visited: set {min(set(range(len(sets))) - set(seen))} is not visited")
    return float(sum(costs(a - 1, b - 1) for a, b in zip(nodes, nodes[1:] + nodes[:1])))


def check(instance, plan):
    """The value of a plan; raises Wrong."""
    value = tour(instance, plan) if "gtsplib" in instance else cutting(instance, plan)
    claimed = plan.get("value")
    if claimed is not None and abs(number(claimed) - value) > max(1e-6 * value, NEAR):
        raise Wrong(f"claim: the plan claims {claimed}, and it takes {value:.6f}")
    return value


def instance_of(name):
    entry = next((e for e in json.loads((HERE / "instances.json").read_text())["instances"] if e["name"] == name), None)
    if entry is None:
        raise Wrong(f"not-a-plan: there is no instance named {name}")
    data = load(HERE / entry["file"])
    if hashlib.sha256(data).hexdigest() != entry["sha256"]:
        raise Unusable(f"{entry['file']} is not the frozen file: its checksum differs")
    return json.loads(data) if entry["track"] != "GTSP" else {"gtsplib": entry["file"]}, entry


def folder(path):
    """Checks every plan of a folder; whether all are sound."""
    files = sorted(file for file in path.iterdir() if file.name.endswith((".json", ".json.gz")))
    if not files:
        raise Unusable(f"there is no plan in {path}: a plan for the instance NAME is named NAME.json or NAME.json.gz")
    wrong = 0
    for file in files:
        name = file.name.removesuffix(".gz").removesuffix(".json")
        try:
            instance, entry = instance_of(name)
            value = check(instance, plan_of(file))
            best = entry.get("best", {}).get("value")
            beside = "" if best is None else f"   best known {best:.3f}   {round(100 * (value / best - 1), 3) + 0.0:+.3f} %"
            print(f"{name:24} {value:14.3f}{beside}", flush=True)
        except Wrong as error:
            wrong += 1
            print(f"{name:24} WRONG  {error}", flush=True)
    return wrong == 0


def main(arguments):
    if len(arguments) == 3 and arguments[0] == "--instance":
        print(f"{check(instance_of(arguments[1])[0], plan_of(arguments[2])):.6f}")
    elif len(arguments) == 2 and not arguments[0].startswith("-"):
        print(f"{check(instance_in(arguments[0]), plan_of(arguments[1])):.6f}")
    elif len(arguments) == 1 and Path(arguments[0]).is_dir():
        return 0 if folder(Path(arguments[0])) else 1
    elif len(arguments) == 1 and not arguments[0].startswith("-"):
        raise Unusable(f"{arguments[0]} is not a folder: name a folder of plans, or an instance and a plan")
    else:
        print(__doc__, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except Wrong as error:
        print(f"WRONG  {error}")
        sys.exit(1)
    except Unusable as error:
        print(f"check.py: {error}.", file=sys.stderr)
        sys.exit(2)
