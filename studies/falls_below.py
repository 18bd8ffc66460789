#!/usr/bin/env python3
"""When does a probe fall below a value? One line per run of a study, as a table in Markdown.

usage: studies/falls_below.py STUDY_RESULTS PROBE VALUE [VALUE...]

STUDY_RESULTS is the output directory of `creepcontact study`. Between two output times the probe is taken as linear over
the logarithm of time. ">1e+06" stands for a run that ends above the value, "0" for one that begins below it.
"""

import csv
import math
import pathlib
import sys


def history(run, probe):
    with open(run / "history.csv", newline="") as file:
        return [(float(row["time"]), float(row[probe])) for row in csv.DictReader(file)]


def falls_below(points, value):
    """Time, or infinity."""
    if points[0][1] < value:
        return 0.0
    for (t, high), (after, low) in zip(points, points[1:]):
        if low < value:
            part = (high - value) / (high - low)
            return after * part if t == 0 else t * (after / t) ** part
    return math.inf


def main(arguments):
    if len(arguments) < 3:
        print(__doc__, file=sys.stderr)
        return 2
    results, probe, values = pathlib.Path(arguments[0]), arguments[1], [float(text) for text in arguments[2:]]
    with open(results / "study.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    keys = list(rows[0])[:list(rows[0]).index(next(name for name in rows[0] if name.endswith("_start")))]
    print("| " + " | ".join(keys + [f"{probe} < {value:g}" for value in values]) + " |")
    print("|" + "---|" * (len(keys) + len(values)))
    for number, row in enumerate(rows, 1):
        points = history(results / "runs" / f"run_{number:03}", probe)
        times = [falls_below(points, value) for value in values]
        cells = [f"{t:.3g}" if t < math.inf else f">{points[-1][0]:g}" for t in times]
        print("| " + " | ".join([row[key] for key in keys] + cells) + " |")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
