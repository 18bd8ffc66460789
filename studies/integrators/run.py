#!/usr/bin/env python3
"""What an accuracy costs with each integrator: runs of the examples against tight ones. See README.md.

usage: run.py [PROGRAM] [--fast] [--case NAME]... [--method NAME]... [--output DIR]
PROGRAM: else the environment variable CREEPCONTACT, else build/release/bin/creepcontact
"""

import argparse
import csv
import json
import os
import pathlib
import resource
import signal
import subprocess
import tempfile

import tables

ROOT = pathlib.Path(__file__).resolve().parents[2]
DEFAULT_PROGRAM = str(ROOT / "build" / "release" / "bin" / "creepcontact")
CYCLES = "loads.0.pressure={{t={},values={}}}".format([k / 20 for k in range(21)], [200, 100] * 10 + [200])
CASES = {  # configuration and changes; the larger ones on coarse meshes: the counts depend little on the mesh
    "thick_cylinder": ("thick_cylinder", []),
    "thick_cylinder_cycles": ("thick_cylinder", ["time.end=1", CYCLES]),  # the pressure turns 19 times
    "plate_with_hole": ("plate_with_hole", []),
    "shrink_fit": ("shrink_fit", []),
    "shrink_fit_unequal": ("shrink_fit", ["materials.rotor.creep.0.A=1e-13"]),  # 1e4 times that of the wheel
    "ball_on_block": ("ball_on_block", ["mesh.parameters.h=0.5", "time.end=10"]),
    "blade_root": ("blade_root", ["mesh.parameters={n_blade=2,n_disc=2,n_blade_flank=3,n_disc_flank=2,n_width=1}"]),
}
FAST_CASES = {"shrink_fit": ("shrink_fit", ["mesh.order=1", "mesh.parameters.around_shaft=6",
                                            "mesh.parameters.around_disc=5", "time.end=3e3"])}
MOST_SOLVES = 5000  # runs with more are stopped
FAST_MOST_SOLVES = 1000
REFERENCE = ["time.integrator=cvode_bdf", "time.tolerance=1e-8", "contact_solver.tolerance=1e-12"]

TOLERANCES = ("time.tolerance", [1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 1e-6])
# Of the stable step. Fixed-point iterations contract below 1/(2 beta) of it.
EXPLICIT = ("time.step_factor", [1, 0.5, 0.2, 0.1])
IMPLICIT = ("time.step_factor", [0.4, 0.2, 0.1])
TRAPEZOIDAL = ("time.step_factor", [0.8, 0.4, 0.2])
BETA_EULER = ["integrator=beta_euler", "step=adaptive", "inner=newton"]
METHODS = {
    "auto": (["integrator=auto"], TOLERANCES),
    "cvode_bdf": (["integrator=cvode_bdf"], TOLERANCES),
    "cvode_bdf, tangent": (["integrator=cvode_bdf", "linear_solver=tangent"], TOLERANCES),
    "arkode_dirk": (["integrator=arkode_dirk"], TOLERANCES),
    "arkode_dirk, tangent": (["integrator=arkode_dirk", "linear_solver=tangent"], TOLERANCES),
    "cvode_adams": (["integrator=cvode_adams"], TOLERANCES),
    "log_adams": (["integrator=log_adams"], TOLERANCES),
    "arkode_erk": (["integrator=arkode_erk"], TOLERANCES),
    "arkode_erk, dormand_prince_7_4_5": (["integrator=arkode_erk", "table=dormand_prince_7_4_5"], TOLERANCES),
    "explicit_euler, stable": (["integrator=explicit_euler"], EXPLICIT),
    "explicit_euler, adaptive": (["integrator=explicit_euler", "step=adaptive"], TOLERANCES),
    "beta_euler, beta 1, stable": (["integrator=beta_euler", "beta=1"], IMPLICIT),
    "beta_euler, beta 0.5, stable": (["integrator=beta_euler", "beta=0.5"], TRAPEZOIDAL),
    "beta_euler, beta 1, adaptive, newton": ([*BETA_EULER, "beta=1"], TOLERANCES),
    "beta_euler, beta 0.5, adaptive, newton": ([*BETA_EULER, "beta=0.5"], TOLERANCES),
}
FAST_VALUES = {"time.tolerance": [1e-2, 1e-3], "time.step_factor": [0.4, 0.1]}


def read_table(path):
    with open(path, newline="") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def solves_so_far(directory):
    """Of the integration alone: those for the output times are not among the steps."""
    try:
        rows = [line.split(",") for line in (directory / "steps.csv").read_text().splitlines(keepends=True)]
    except FileNotFoundError:
        return 0
    whole = [row for row in rows if row[-1].endswith("\n")]
    column = whole[0].index("elastic_solves") if whole else 0
    return sum(int(row[column]) for row in whole[1:])


def processor_seconds():
    """Of all processes that have ended: what a run takes alone on a machine, however busy this one is."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def run(program, model, overrides, max_solves):
    """What a run came to, and its history: None if it did not end or was stopped beyond max_solves."""
    with tempfile.TemporaryDirectory() as scratch:
        directory, messages = pathlib.Path(scratch) / "out", pathlib.Path(scratch) / "messages"
        configuration, changes = model
        settings = [*changes, *overrides, "output.fields=false"]
        options = [part for setting in settings for part in ("--set", setting)]
        before = processor_seconds()
        with open(messages, "w") as file:
            command = [program, "run", str(ROOT / "configs" / f"{configuration}.toml"), "--quiet", "--threads", "1"]
            process = subprocess.Popen([*command, "--output", str(directory), *options], stdout=file, stderr=file)
        while process.poll() is None:
            try:
                process.wait(timeout=1)
            except subprocess.TimeoutExpired:
                if solves_so_far(directory) > max_solves:
                    process.send_signal(signal.SIGINT)
                    process.wait()
        text = messages.read_text()
        if process.returncode not in (0, 4, 130):
            raise SystemExit(f"{configuration} {' '.join(settings)}: {text}")
        summary = json.loads((directory / "summary.json").read_text())
        summary |= {"elastic_solves": solves_so_far(directory), "changed_method": int(" is left for " in text),
                    "seconds": processor_seconds() - before}
        return summary, read_table(directory / "history.csv") if process.returncode == 0 else None


def largest_difference(history, reference):
    """Over all probes and output times, relative to the largest value of the probe."""
    difference = 0.0
    for name in reference[0]:
        largest = max(abs(row[name]) for row in reference)
        if name != "time" and largest > 0:
            difference = max(difference, *(abs(a[name] - b[name]) / largest for a, b in zip(history, reference)))
    return difference


def measure(program, case, model, method, value, reference, max_solves):
    settings, (key, _) = METHODS[method]
    overrides = [*(f"time.{setting}" for setting in settings), f"{key}={value:g}"]
    summary, history = run(program, model, overrides, max_solves)
    row = {"case": case, "method": method, "setting": key.removeprefix("time."), "value": value,
           "status": "completed", "error": ""}
    row |= {name: summary[name] for name in ("elastic_solves", "factorizations", "steps", "rejected_steps",
                                             "convergence_failures", "changed_method", "seconds")}
    if history and row["elastic_solves"] <= max_solves:
        row["error"] = largest_difference(history, reference)
    else:
        row["status"] = "gave up" if summary["status"] == "failed" else f"> {max_solves}"
    return row


def measure_case(program, case, model, methods, max_solves, fast):
    """Rows of these methods; after a run with too many solves the tighter ones of the method are left out."""
    _, reference = run(program, model, REFERENCE, float("inf"))
    if reference is None:
        raise SystemExit(f"{case}: the reference run gave up")
    for method in methods:
        _, (key, values) = METHODS[method]
        for value in FAST_VALUES[key] if fast else values:
            row = measure(program, case, model, method, value, reference, max_solves)
            print(*(row[name] for name in ("case", "method", "value", "status", "elastic_solves", "error")), flush=True)
            yield row
            if row["status"].startswith(">"):
                break


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", nargs="?", default=os.environ.get("CREEPCONTACT", DEFAULT_PROGRAM))
    parser.add_argument("--fast", action="store_true", help="one small case, two tolerances: seconds")
    parser.add_argument("--case", action="append", choices=CASES, help="these only")
    parser.add_argument("--method", action="append", choices=METHODS, help="these only")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("results/integrators"))
    arguments = parser.parse_args()

    cases = FAST_CASES if arguments.fast else {case: CASES[case] for case in arguments.case or CASES}
    max_solves = FAST_MOST_SOLVES if arguments.fast else MOST_SOLVES
    arguments.output.mkdir(parents=True, exist_ok=True)
    rows = []
    with open(arguments.output / "runs.csv", "w", newline="") as file:
        writer = None
        for case, model in cases.items():
            for row in measure_case(arguments.program, case, model, arguments.method or METHODS, max_solves,
                                    arguments.fast):
                writer = writer or csv.DictWriter(file, row)
                if not rows:
                    writer.writeheader()
                writer.writerow(row)
                file.flush()
                rows.append(row)
    (arguments.output / "tables.md").write_text(tables.tables(rows) + "\n")


if __name__ == "__main__":
    main()
