"""Tours by GLNS (S. L. Smith, F. Imeson, 2017, GLNS: An effective large neighborhood search heuristic for the generalized traveling salesman
problem, doi 10.1016/j.cor.2017.05.010), which needs Julia 1.0 or later.

GLNS reads GTSPLIB and writes lines `key : value` into a file; the last one is the tour, with nodes that count from 1. It is started as its
README shows for runs of a given time: many trials, and the time at which it stops. The seconds include the start of Julia.
"""

import math
import subprocess
import tempfile
from pathlib import Path

RUN = "import GLNS; GLNS.solver(ARGS[1]; output=ARGS[2], max_time=parse(Int, ARGS[3]), trials=100000, verbose=0)"


def is_installed(command="julia"):
    """Whether there is a Julia that knows the package."""
    try:
        found = subprocess.run([command, "-e", 'exit(Base.find_package("GLNS") === nothing ? 1 : 0)'], capture_output=True)
    except OSError:
        return False
    return found.returncode == 0


def read_tour(text):
    """The nodes of a tour file, and the cost that GLNS gives it."""
    values = dict([part.strip() for part in line.split(":", 1)] for line in text.splitlines() if ":" in line)
    for key in ("Tour", "Tour Cost"):
        if key not in values:
            raise RuntimeError(f"the tour file of GLNS has no line {key}")
    return [int(node) for node in values["Tour"].strip("[]").split(",")], int(values["Tour Cost"])


def tour(instance_file, seconds, command="julia"):
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "tour.txt"
        run = [command, "-e", RUN, "--", str(instance_file), str(out), str(max(1, math.floor(seconds)))]
        subprocess.run(run, capture_output=True, check=True, timeout=2 * seconds + 120)
        return read_tour(out.read_text())[0]
