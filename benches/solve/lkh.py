"""The program LKH on an instance of GTSPLIB, after the transformation of Noon and Bean, for `npm run bench -- solve large --lkh PROGRAM`.

    lkh.py PROGRAM FILE.gtsp [--seconds 60] [--seed 1]

LKH gets the table of all costs and the parameters that GLKH's script gives it, has that many seconds of the processor after its
preparation, and finishes the trial that it has begun.
The entry nodes are then made optimal for the order of the sets. Prints one line of JSON: the tour in the numbers of the file, its
length, and all seconds of the processor that LKH took. Needs numpy.

LKH is by K. Helsgaun (akira.ruc.dk/~keld/research/LKH-3), for academic and non-commercial use; it is no part of this repository.
"""

import argparse
import json
import resource
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from baselines import best_entries, entered, length, noon_bean, read, visits_every_set

# Seconds of the processor after which LKH is stopped, for each second that it is given: its preparation takes many times as long.
PATIENCE = 15
# What the script runGLKH of GLKH 1.0 sets.
GLKH = {"ASCENT_CANDIDATES": 500, "INITIAL_PERIOD": 1000, "MAX_CANDIDATES": 30}
# The greatest cost times the precision that LKH can work with: half of what it has for costs, so that sums of two fit.
MOST = 2**29


def precision(most):
    """Parts of a unit of costs in LKH's ascent: tenths as in GLKH, or none where costs are large."""
    fitting = [p for p in (10, 1) if most * p <= MOST]
    if not fitting:
        raise SystemExit("The costs of this instance are too large for LKH after the transformation.")
    return fitting[0]


def written(matrix):
    """The asymmetric TSP as a file of TSPLIB."""
    rows = "\n".join(" ".join(map(str, row)) for row in matrix.tolist())
    head = f"NAME: noon-bean\nTYPE: ATSP\nDIMENSION: {len(matrix)}\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: FULL_MATRIX"
    return f"{head}\nEDGE_WEIGHT_SECTION\n{rows}\nEOF\n"


def nodes_of(tour_file):
    """The nodes of a tour file of TSPLIB, from 0."""
    words = tour_file.split("TOUR_SECTION")[1].split()
    return [int(word) - 1 for word in words[: words.index("-1")]]


def solve(program, costs, sets, seconds, seed):
    """The tour that LKH finds, and the seconds of the processor that it took."""
    matrix = noon_bean(costs, sets)
    with tempfile.TemporaryDirectory(prefix="kerfway-lkh-") as folder:
        problem, tour, parameters = (Path(folder) / name for name in ("problem.atsp", "best.tour", "lkh.par"))
        problem.write_text(written(matrix))
        lines = {
            **GLKH, "PROBLEM_FILE": problem, "TOUR_FILE": tour, "RUNS": 1, "SEED": seed, "TIME_LIMIT": seconds, "MAX_TRIALS": 10**6,
            "PRECISION": precision(int(matrix.max())), "TRACE_LEVEL": 0,
        }  # fmt: skip
        parameters.write_text("".join(f"{key} = {value}\n" for key, value in lines.items()))
        most = int(PATIENCE * seconds)
        ran = subprocess.run(
            [program, parameters], stdin=subprocess.DEVNULL, capture_output=True, text=True,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (most, most)),
        )  # fmt: skip
        if ran.returncode == -signal.SIGKILL:
            raise SystemExit(f"{program} was stopped after {most} s of the processor.")
        if ran.returncode != 0 or not tour.exists():
            raise SystemExit(f"{program} found no tour: {(ran.stderr or ran.stdout).strip()[-300:]}")
        order = entered(nodes_of(tour.read_text()), sets)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return best_entries(costs, sets, order), used.ru_utime + used.ru_stime


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("file")
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    costs, sets = read(args.file)
    tour, used = solve(args.program, costs.astype(np.int64), sets, args.seconds, args.seed)
    if not visits_every_set(sets, tour):
        sys.exit("The tour does not visit every set once.")
    row = {"by": "LKH", "seed": args.seed, "seconds": round(used, 1), "value": length(costs, tour), "tour": [node + 1 for node in tour]}
    print(json.dumps(row))


if __name__ == "__main__":
    main()
