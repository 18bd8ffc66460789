#!/usr/bin/env python3
"""A deck in CalculiX and in creepcontact: error of a displacement at the end, and processor time, as tables in Markdown.

usage: studies/calculix/compare.py DECK.inp NODE COMPONENT [--program PATH]

The deck has one *VISCO step and prints the displacements of NODE. It is run by `ccx` with smaller and smaller increments (its
largest increment is the fourth number of *VISCO) and by `creepcontact import` and `run` with smaller and smaller tolerances. Errors are
those against the most accurate run of the same program, so that they show the integration in time alone. The difference of the two
most accurate runs is printed below: it is that of the contact (hard, or with a stiffness) and of the elements.
"""

import argparse
import csv
import json
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile

INCREMENTS = (300, 100, 30, 10, 3, 1)  # of the time of the *VISCO step, in thousandths
TOLERANCES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8)


def timed(arguments, directory):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(arguments, cwd=directory, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, arguments))} failed: {(done.stderr or done.stdout)[-500:]}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def run_ccx(text, part, node, component, directory):
    """Displacement, increments and processor time with at most this part of the step per increment."""
    def with_largest(match):
        numbers = [float(field) for field in match[2].split(",")[:2]]
        largest = part * numbers[1]
        return f"{match[1]}{min(numbers[0], largest):g}, {numbers[1]:g}, 1e-12, {largest:g}\n"
    deck, n = re.subn(r"(?im)(^\*VISCO[^\n]*\n)([^\n]*)\n", with_largest, text)
    if n != 1:
        raise SystemExit("the deck needs one *VISCO step")
    (directory / "deck.inp").write_text(deck)
    seconds = timed(["ccx", "deck"], directory)
    block = (directory / "deck.dat").read_text().split("displacements")[-1]
    row = next(line.split() for line in block.splitlines() if line.split()[:1] == [str(node)])
    increments = sum(line.split()[:1] == ["2"] for line in (directory / "deck.sta").read_text().splitlines())
    return float(row[1 + "xyz".index(component)]), increments, seconds


def run_ours(program, name, tolerance, node, component, directory):
    output = directory / f"results_{tolerance:g}"
    seconds = timed([program, "run", f"imported/{name}.toml", "--output", output, "--set", f"time.tolerance={tolerance}",
                     "--set", "output.fields=false", "--threads", "1"], directory)
    with open(output / "history.csv", newline="") as file:
        value = float(list(csv.DictReader(file))[-1][f"u{component}_node_{node}"])
    summary = json.loads((output / "summary.json").read_text())
    return value, summary["steps"], seconds


def table(title, setting, runs):
    print(f"| {title}: {setting} | steps | error | processor time [s] |\n|---|---|---|---|")
    best = runs[-1][1][0]
    for label, (value, steps, seconds) in runs:
        error = "(reference)" if value == best else f"{abs(value / best - 1):.1e}"
        print(f"| {label:g} | {steps} | {error} | {seconds:.2f} |")
    print()
    return best


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("deck", type=pathlib.Path)
    parser.add_argument("node", type=int)
    parser.add_argument("component", choices="xyz")
    parser.add_argument("--program", default=shutil.which("creepcontact") or "creepcontact")
    parser.add_argument("--coarse", action="store_true", help="the two coarsest runs of each program, and the finest")
    arguments = parser.parse_args()
    if shutil.which("ccx") is None:
        raise SystemExit("ccx is not installed: Debian package calculix-ccx")
    program = pathlib.Path(arguments.program).absolute()
    name, text = arguments.deck.stem, arguments.deck.read_text()
    pick = (lambda all: (*all[:2], all[-2])) if arguments.coarse else (lambda all: all)
    with tempfile.TemporaryDirectory() as temporary:
        directory = pathlib.Path(temporary)
        timed([program, "import", arguments.deck.absolute(), "--output", "imported"], directory)
        theirs = [(part / 1000, run_ccx(text, part / 1000, arguments.node, arguments.component, directory))
                  for part in pick(INCREMENTS)]
        ours = [(tolerance, run_ours(program, name, tolerance, arguments.node, arguments.component, directory))
                for tolerance in pick(TOLERANCES)]
    last_of_ccx = table("CalculiX", "largest increment / time", theirs)
    last_of_ours = table("creepcontact", "time.tolerance", ours)
    print(f"most accurate: {last_of_ccx:.6e} (CalculiX), {last_of_ours:.6e} (creepcontact), difference "
          f"{abs(last_of_ccx / last_of_ours - 1):.1e}")


if __name__ == "__main__":
    sys.exit(main())
