#!/usr/bin/env python3
"""How many contact iterations each method needs. usage: run.py [PROGRAM]; the table goes to standard output."""

import csv
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
CONFIG = ROOT / "configs" / "shrink_fit.toml"

# The interference dwindles from one side to the other, so that part of the fit opens.
COMMON = ["contacts.0.gap='0.0015*(x - 40)'", "time.end=1", "time.output=[1]", "output.fields=false", "mesh.order=1",
          "materials.rotor.creep.0.A=0", "materials.wheel.creep.0.A=0"]
METHODS = {
    "cg": ["acceleration=cg"],
    "none": ["acceleration=none"],
    "aitken": ["acceleration=aitken"],
    "anderson": ["acceleration=anderson"],
    "none, 1/2": ["acceleration=none", "alpha=0.5"],
    "anderson, 1/2": ["acceleration=anderson", "alpha=0.5"],
    "none, 1/2, damping 1/2": ["acceleration=none", "alpha=0.5", "damping=0.5"],
}
RATIOS = [1e-3, 1e-1, 1.0, 10.0, 1e3]
MESHES = {  # elements around the shaft and the disc; the disc carries the multipliers
    "slave coarser": (12, 9),
    "alike": (12, 12),
    "slave finer": (9, 12),
    "slave coarser, finer meshes": (48, 36),
}


def run(program, overrides):
    """Mean iterations of the contact problems that need any; a dash where another method had to take over."""
    with tempfile.TemporaryDirectory() as directory:
        log = pathlib.Path(directory) / "iterations.csv"
        options = [part for override in overrides for part in ("--set", override)]
        done = subprocess.run([program, "run", str(CONFIG), "--quiet", "--threads", "1", "--output", directory,
                               "--log-contact", str(log), *options], capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit(f"{' '.join(overrides)}: {done.stderr}")
        with open(log, newline="") as file:
            problems = [row["contact_solve"] for row in csv.DictReader(file)]
    if "take over" in done.stderr or "takes over" in done.stderr:
        return "-"
    return f"{len(problems) / len(set(problems)):.0f}"


def main(arguments):
    program = arguments[0] if arguments else str(ROOT / "build" / "release" / "bin" / "creepcontact")
    print("| mesh | E slave / E master | " + " | ".join(METHODS) + " |")
    print("|---|---" + "|---" * len(METHODS) + "|")
    for mesh, (shaft, disc) in MESHES.items():
        for ratio in RATIOS:
            model = [*COMMON, f"mesh.parameters.around_shaft={shaft}", f"mesh.parameters.around_disc={disc}",
                     "contacts.0.slave=disc_bore", f"materials.wheel.young_modulus={1.75e5 * ratio}"]
            cells = [run(program, model + [f"contact_solver.{setting}" for setting in settings])
                     for settings in METHODS.values()]
            print(f"| {mesh} | {ratio:g} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
