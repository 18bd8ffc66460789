"""Runs a file of studies/ with the built program and gives back its table."""

import csv
import math
import os
import pathlib
import subprocess
import tempfile

from waiting import LONGEST

PROGRAM = os.environ["CREEPCONTACT_PROGRAM"]
STUDIES = pathlib.Path(__file__).resolve().parents[2] / "studies"


def run_study(name):
    """The rows of study.csv, as text by column; name: relative to studies/, as "step_size/fast.toml"."""
    with tempfile.TemporaryDirectory() as directory:
        output = pathlib.Path(directory) / "results"
        done = subprocess.run([PROGRAM, "study", str(STUDIES / name), "--output", str(output)], cwd=directory,
                              capture_output=True, text=True, timeout=LONGEST)
        if done.returncode != 0:
            raise AssertionError(f"{name}: exit status {done.returncode}\n{done.stdout}{done.stderr}")
        with open(output / "study.csv", newline="") as file:
            return list(csv.DictReader(file))


def select(rows, **settings):
    """The rows with these settings, in their order; dots in keys are written as two underscores: time__step = 1."""
    keys = {key.replace("__", "."): str(value) for key, value in settings.items()}
    return [row for row in rows if all(row[key] == value for key, value in keys.items())]


def numbers(rows, column):
    return [float(row[column]) for row in rows]


def order(loose, tight, setting, error):
    """Slope of log(error) against the logarithm of a setting, from one row to another."""
    ratio = [float(loose[column]) / float(tight[column]) for column in (error, setting)]
    return math.log(ratio[0]) / math.log(ratio[1])
