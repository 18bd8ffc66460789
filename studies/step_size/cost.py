#!/usr/bin/env python3
"""What an error costs with each method, in elastic solves, from tables of studies. usage: cost.py STUDY.csv..."""

import csv
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "integrators"))
from tables import cost_of, unique  # noqa: E402

TARGETS = (1e-2, 1e-3, 1e-4)


def method(row):
    """Its name in the tables of the README."""
    if row["time.integrator"] != "beta_euler":
        return row["time.integrator"]
    inner = "Newton" if row["time.inner"] == "newton" else "fixed point"
    tolerance = row.get("time.inner_tolerance")
    loose = f", gamma = 1, inner {tolerance}" if tolerance else ""
    return f"beta_euler, beta = {row['time.beta']}, {inner}{loose}"


def error(row):
    """The largest of all quantities; none if the run did not end."""
    found = [value for column, value in row.items() if column.startswith("error_")]
    return str(max(map(float, found))) if all(found) else ""


def read_runs(path):
    with open(path, newline="") as file:
        return [{**row, "method": method(row), "error": error(row)} for row in csv.DictReader(file)]


def cost_cell(rows, target):
    cost = cost_of(rows, target, "elastic_solves")
    if cost is None:
        return "gave up"
    return {"<": "≤ ", ">": "> ", "": ""}[cost[0]] + f"{cost[1]:.0f}"


def run_cell(row):
    setting = row.get("time.step_factor") or row.get("time.tolerance") or row["time.step"]
    result = f"{float(row['error']):.1e}, {row['elastic_solves']}" if row["error"] else row["status"]
    return f"{setting}: {result}".replace("e-0", "e-")


def tables(rows):
    lines = ["| method | " + " | ".join(f"{target:.0e}".replace("e-0", "e-") for target in TARGETS) + " |",
             "|---" * (1 + len(TARGETS)) + "|"]
    of_method = {name: [row for row in rows if row["method"] == name] for name in unique(rows, "method")}
    for name, some in of_method.items():
        lines.append(f"| {name} | " + " | ".join(cost_cell(some, target) for target in TARGETS) + " |")
    lines += ["", "| method | step_factor or tolerance: error, elastic solves |", "|---|---|"]
    for name, some in of_method.items():
        lines.append(f"| {name} | " + "; ".join(run_cell(row) for row in some) + " |")
    return "\n".join(lines)


if __name__ == "__main__":
    for path in sys.argv[1:]:
        print(f"### {pathlib.Path(path).parent.name}\n\n{tables(read_runs(path))}\n")
