#!/usr/bin/env python3
"""When do the events of each run of a study happen? One line per run, as a table in Markdown.

usage: studies/event_times.py STUDY_RESULTS

STUDY_RESULTS is the output directory of `creepcontact study`. ">1e+06" is a run that ends before the event.
"""

import csv
import json
import pathlib
import sys


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    results = pathlib.Path(arguments[0])
    with open(results / "study.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    keys = list(rows[0])[:list(rows[0]).index(next(name for name in rows[0] if name.endswith("_start")))]
    for number, row in enumerate(rows, 1):
        summary = json.loads((results / "runs" / f"run_{number:03}" / "summary.json").read_text(encoding="utf-8"))
        events = summary["events"]
        if number == 1:
            print("| " + " | ".join(keys + list(events)) + " |")
            print("|" + "---|" * (len(keys) + len(events)))
        times = [f">{summary['time_reached']:g}" if time is None else f"{time:.3g}" for time in events.values()]
        print("| " + " | ".join([row[key] for key in keys] + times) + " |")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
