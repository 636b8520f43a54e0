"""The reference checker of the benchmark of cutting paths, as a command. The rules themselves are in rules.py.

    python3 check.py FOLDER                   every plan of a folder: NAME.json or NAME.json.gz is a plan for the instance NAME, which is one of the
                                              benchmark or the file NAME.instance.json beside it
    python3 check.py INSTANCE PLAN            one plan for an instance in a file
    python3 check.py --instance NAME PLAN     one plan for an instance of the benchmark

Prints a line for each plan: its value, or the name of what is wrong and where. Exit code 0 if every plan is sound, 1 if one is wrong, 2 if
the command is, or if something cannot be checked. README.md defines instances, plans, rules and cost.
"""

import gzip
import hashlib
import io
import json
import os
import re
import sys
import zlib
from pathlib import Path

from rules import NEAR, Contour, Wrong, check, number, point, read

HERE = Path(__file__).resolve().parent
# Bytes of a file, unpacked: the largest plan here has 4 million, and a gzip file of that size can hold a thousand times more.
MOST = 2**26


class Unusable(Exception):
    """A file that is missing or is not what it should be, which is not the fault of a plan."""


def load(path):
    try:
        with open(path, "rb") as file:
            data = file.read(MOST + 1)
    except OSError as error:
        raise Unusable(f"{path} cannot be read: {error.strerror}") from error
    try:
        if str(path).endswith(".gz"):
            data = gzip.GzipFile(fileobj=io.BytesIO(data)).read(MOST + 1)
    except (OSError, EOFError, zlib.error) as error:
        raise Wrong(f"not-a-plan: {path} is not a gzip file: {error}") from error
    if len(data) > MOST:
        raise Wrong(f"not-a-plan: {path} has more than {MOST} bytes")
    return data


def plan_of(path):
    """What is in the file of a plan."""
    try:
        return json.loads(load(path))
    except (ValueError, RecursionError) as error:
        raise Wrong(f"not-a-plan: the file is not JSON: {error}") from error


def instance_in(path):
    """An instance in a file: JSON, or a file of GTSPLIB, NAME.gtsp or NAME.gtsp.gz."""
    try:
        if ".gtsp" in Path(path).suffixes:
            instance = {"gtsplib": load(path).decode()}
            is_whole(instance["gtsplib"])
        else:
            instance = json.loads(load(path))
            agrees(instance)
        return instance
    except (Wrong, KeyError, IndexError, TypeError, ValueError, OverflowError, RecursionError) as error:
        raise Unusable(f"{path} is not an instance: {error!r}") from error


def is_whole(gtsplib):
    """Whether each node of a file of GTSPLIB is in one set and has costs; raises what is missing or wrong."""
    costs, sets = read(gtsplib)
    nodes = sorted(node for members in sets for node in members)
    dimension = re.search(r"^\s*DIMENSION\s*:\s*(\d+)", gtsplib, re.MULTILINE)[1]
    if nodes != list(range(len(nodes))) or len(nodes) != int(dimension) or [] in sets:
        raise ValueError(f"a set is empty, or one of the {dimension} nodes is not in exactly one set")
    for node in nodes:
        for pair in (node, 0), (0, node), (node, node):
            costs(*pair)


def agrees(instance):
    """Whether an instance is one; raises what is missing or wrong."""
    contours, cost = [Contour(c) for c in instance["contours"]], instance["cost"]
    for k, contour in enumerate(contours):
        if contour.length <= 2 * NEAR:
            raise ValueError(f"contour {k} is not longer than {2 * NEAR} mm")
        if type(contour.closed) is not bool:
            raise ValueError(f"contour {k} is closed or not: true or false")
        if contour.closed and abs(contour.end - contour.start) > NEAR:
            raise ValueError(f"contour {k} is closed, and does not end where it begins")
        if contour.inside is not None and (type(contour.inside) is not int or contour.inside not in range(len(contours))):
            raise ValueError(f"contour {k} is inside contour {contour.inside}, which there is not")
    for k, contour in enumerate(contours):
        outer, depth = contour.inside, 0
        while outer is not None:
            outer, depth = contours[outer].inside, depth + 1
            if depth > len(contours):
                raise ValueError(f"contour {k} lies inside itself, or in one that does")
    if instance["track"] not in ("CCP", "TIME", "ECP", "ICP") or cost["unit"] not in ("mm", "s") or type(instance["closed"]) is not bool:
        raise ValueError("a track is CCP, TIME, ECP or ICP, a unit mm or s, and closed true or false")
    point(instance["home"])
    for key in ("pierce", "speed", "acceleration") if cost["unit"] == "s" else ("pierce",):
        if number(cost[key]) < 0 or key != "pierce" and cost[key] == 0:
            raise ValueError(f"{key} is {cost[key]}")


def instance_of(name, beside=None):
    """An instance of the benchmark, and its entry in instances.json; or one in the folder `beside`, with an entry that is empty."""
    entry = next((e for e in json.loads((HERE / "instances.json").read_text())["instances"] if e["name"] == name), None)
    if entry is None:
        own = [beside / f"{name}.instance.json{packed}" for packed in ("", ".gz")] if beside else []
        for file in filter(Path.exists, own):
            return instance_in(file), {}
        raise Wrong(f"not-a-plan: there is no instance named {name}")
    try:
        data = load(HERE / entry["file"])
    except Wrong as error:
        raise Unusable(f"{entry['file']} is not the frozen file: {error}") from error
    if hashlib.sha256(data).hexdigest() != entry["sha256"]:
        raise Unusable(f"{entry['file']} is not the frozen file: its checksum differs")
    return json.loads(data) if entry["track"] != "GTSP" else {"gtsplib": data.decode()}, entry


def say(line):
    """Prints a line at once. A reader that has gone, as after `| head`, changes no verdict."""
    try:
        print(line, flush=True)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def folder(path):
    """Checks every plan of a folder; the exit code."""
    instances = (".instance.json", ".instance.json.gz")
    files = sorted(file for file in path.iterdir() if file.name.endswith((".json", ".json.gz")) and not file.name.endswith(instances))
    if not files:
        raise Unusable(f"there is no plan in {path}: a plan for the instance NAME is named NAME.json or NAME.json.gz")
    code = 0
    for file in files:
        name = file.name.removesuffix(".gz").removesuffix(".json")
        try:
            instance, entry = instance_of(name, path)
            value = check(instance, plan_of(file))
            best = entry.get("best", {}).get("value")
            known = "" if best is None else f"   best known {best:.3f}   {round(100 * (value / best - 1), 3) + 0.0:+.3f} %"
            say(f"{name:24} {value:14.3f}{known}")
        except Wrong as error:
            code = 1
            say(f"{name:24} WRONG  {error}")
        except Unusable as error:
            code = code or 2
            say(f"{name:24} not checked: {error}")
    return code


def main(arguments):
    if len(arguments) == 3 and arguments[0] == "--instance":
        say(f"{check(instance_of(arguments[1])[0], plan_of(arguments[2])):.6f}")
    elif len(arguments) == 2 and not arguments[0].startswith("-"):
        say(f"{check(instance_in(arguments[0]), plan_of(arguments[1])):.6f}")
    elif len(arguments) == 1 and Path(arguments[0]).is_dir():
        return folder(Path(arguments[0]))
    elif len(arguments) == 1 and not arguments[0].startswith("-"):
        raise Unusable(f"{arguments[0]} is not a folder: name a folder of plans, or an instance and a plan")
    else:
        print(__doc__, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    # Names of files may have characters that a terminal or a log has not.
    sys.stdout.reconfigure(errors="backslashreplace")
    try:
        sys.exit(main(sys.argv[1:]))
    except Wrong as error:
        say(f"WRONG  {error}")
        sys.exit(1)
    except Unusable as error:
        print(f"check.py: {error}.", file=sys.stderr)
        sys.exit(2)
