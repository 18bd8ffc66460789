#!/usr/bin/env python3
"""Iterations of a study as a table; a minus where sweeps diverged. usage: report.py RESULTS ROW_KEYS [PROBLEMS]

ROW_KEYS are the settings, with commas between them, whose values head the rows; those of the others head the columns.
PROBLEMS divides the counts (2: two equal problems in a run).
"""

import csv
import pathlib
import sys

MEASURED = {"status", "message", "steps", "elastic_solves", "schwarz_iterations", "wall_seconds",
            "rejected_steps", "convergence_failures"}
GAVE_UP = "Schwarz sweeps did not converge"


def rows_of(results):
    """The rows of study.csv, each with whether its sweeps diverged."""
    with open(results / "study.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    for number, row in enumerate(rows, 1):
        logs = list((results / "runs").glob(f"*{number:0{len(str(len(rows)))}d}/run.log"))
        if len(logs) != 1:
            raise SystemExit(f"{results}: no single run.log of row {number}; make the study anew")
        row["diverged"] = GAVE_UP in logs[0].read_text()
    return rows


def heading(row, keys):
    return ", ".join(row[key] for key in keys if row[key]) or "-"


def table(rows, row_keys, problems):
    others = [key for key in rows[0] if key not in MEASURED | {"diverged", *row_keys} and not key.startswith("error_")]
    columns, lines = {}, {}
    for row in rows:
        column = heading(row, others)
        columns[column] = None
        count = int(row["schwarz_iterations"]) / problems
        lines.setdefault(heading(row, row_keys), {})[column] = "-" if row["diverged"] else f"{count:.0f}"
    text = [f"| {', '.join(row_keys)} | " + " | ".join(columns) + " |", "|---" * (len(columns) + 1) + "|"]
    for name, cells in lines.items():
        text.append(f"| {name} | " + " | ".join(cells.get(column, "") for column in columns) + " |")
    return "\n".join(text)


def main(arguments):
    if len(arguments) not in (2, 3):
        raise SystemExit(__doc__)
    problems = int(arguments[2]) if len(arguments) == 3 else 1
    print(table(rows_of(pathlib.Path(arguments[0])), arguments[1].split(","), problems))


if __name__ == "__main__":
    main(sys.argv[1:])
