#!/usr/bin/env python3
"""Markdown tables of the runs that run.py has made. usage: tables.py RUNS.csv..."""

import csv
import math
import sys

TARGETS = (1e-3, 1e-4)


def read_runs(paths):
    rows = []
    for path in paths:
        with open(path, newline="") as file:
            rows += csv.DictReader(file)
    return rows


def unique(rows, key):
    return list(dict.fromkeys(row[key] for row in rows))


def select(rows, case, method):
    """From loose to tight, as they were run."""
    return [row for row in rows if (row["case"], row["method"]) == (case, method)]


def cost_of(rows, target, column):
    """What an error of the target costs, interpolated between logarithms, as (sign, number); None: no run ended.

    Only errors that all tighter runs keep count, so that no lucky run makes a method look cheap.
    """
    completed = [row for row in rows if row["status"] == "completed"]
    first = len(completed)
    while first > 0 and float(completed[first - 1]["error"]) <= target:
        first -= 1
    if first == len(completed):
        return (">", max(float(row[column]) for row in rows)) if completed or limited(rows) else None
    cost = [float(row[column]) for row in completed]
    enough = min(cost[first:])
    if first == 0:
        return "<", enough
    loose, tight = (float(completed[i]["error"]) for i in (first - 1, first))
    share = math.log(loose / target) / math.log(loose / max(tight, 1e-16))
    low, high = (max(cost[i], 1e-16) for i in (first - 1, first))
    return "", min(low * (high / low) ** share, enough)


def limited(rows):
    return any(row["status"].startswith(">") for row in rows)


def rounded(value):
    digits = 2 if value >= 10 else 1
    return f"{round(value, digits - 1 - math.floor(math.log10(value))):g}" if value > 0 else "0"


def sign_text(sign):
    return {"<": "≤ ", ">": "> ", "": ""}[sign]


def solves_cell(rows, target):
    if not rows:
        return ""
    cost = cost_of(rows, target, "elastic_solves")
    if cost is None:
        return "gave up"
    sign, solves = cost
    text = sign_text(sign) + f"{solves:.0f}"
    if sign == ">":
        limits = [row["status"] for row in rows if row["status"].startswith(">")]
        return limits[0] if limits else text
    if "tangent" in rows[0]["method"]:
        text += f" + {cost_of(rows, target, 'factorizations')[1]:.0f}"
    return text


def seconds_cell(rows, target):
    cost = cost_of(rows, target, "seconds") if rows else None
    return sign_text(cost[0]) + rounded(cost[1]) if cost and cost[0] != ">" else "-"


def method_by_case(rows, cell):
    """Lines of a table whose cells have a number for each target."""
    cases = unique(rows, "case")
    lines = ["| | " + " | ".join(cases) + " |", "|---" * (1 + len(cases)) + "|"]
    for method in unique(rows, "method"):
        cells = []
        for case in cases:
            texts = unique([{"text": cell(select(rows, case, method), target)} for target in TARGETS], "text")
            cells.append("; ".join(texts))  # what is alike for all targets stands once
        lines.append(f"| {method} | " + " | ".join(cells) + " |")
    return lines


def run_cell(row):
    if row["status"] != "completed":
        return row["status"]
    changed = " *" if int(row["changed_method"]) else ""
    return f"{float(row['error']):.1e}, {row['elastic_solves']}{changed}".replace("e-0", "e-")


def runs_of_case(rows, case):
    """Error and elastic solves of all runs: a table for each kind of setting."""
    lines = []
    of_case = [row for row in rows if row["case"] == case]
    for setting in unique(of_case, "setting"):
        some = [row for row in of_case if row["setting"] == setting]
        values = sorted({float(row["value"]) for row in some}, reverse=True)
        lines += [f"| {setting} | " + " | ".join(f"{value:g}" for value in values) + " |",
                  "|---" * (1 + len(values)) + "|"]
        for method in unique(some, "method"):
            found = {float(row["value"]): run_cell(row) for row in select(some, case, method)}
            lines.append(f"| {method} | " + " | ".join(found.get(value, "") for value in values) + " |")
        lines.append("")
    return lines


def tables(rows):
    lines = ["## Elastic solves (+ factorisations) for an error of 1e-3; 1e-4", "", *method_by_case(rows, solves_cell), "",
             "## Processor seconds for an error of 1e-3; 1e-4", "", *method_by_case(rows, seconds_cell), ""]
    for case in unique(rows, "case"):
        lines += [f"## {case}: error, elastic solves of every run", "", *runs_of_case(rows, case)]
    return "\n".join(lines)


if __name__ == "__main__":
    print(tables(read_runs(sys.argv[1:])))
