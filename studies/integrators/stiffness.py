#!/usr/bin/env python3
"""From how many stable steps on implicit methods pay: the thick cylinder for longer and longer times.

usage: stiffness.py [PROGRAM]; the table goes to standard output
"""

import os
import sys

import run

ENDS = [0.1, 0.3, 1, 3, 10]
METHODS = ["auto", "cvode_adams", "log_adams", "arkode_erk, dormand_prince_7_4_5"]
TOLERANCE = 1e-4


def main(arguments):
    program = arguments[0] if arguments else os.environ.get("CREEPCONTACT", run.DEFAULT_PROGRAM)
    print("| end, h | stable steps | " + " | ".join(METHODS) + " |")
    print("|---|---" + "|---" * len(METHODS) + "|")
    for end in ENDS:
        model = ("thick_cylinder", [f"time.end={end:g}"])
        _, reference = run.run(program, model, run.REFERENCE, float("inf"))
        euler, _ = run.run(program, model, ["time.integrator=explicit_euler"], float("inf"))
        cells = [f"{end:g}", str(euler["steps"])]
        for method in METHODS:
            overrides = [*(f"time.{setting}" for setting in run.METHODS[method][0]), f"time.tolerance={TOLERANCE:g}"]
            summary, history = run.run(program, model, overrides, float("inf"))
            error = run.largest_difference(history, reference)
            cells.append(f"{summary['elastic_solves']}, {error:.1e}".replace("e-0", "e-"))
        print("| " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
