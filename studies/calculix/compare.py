#!/usr/bin/env python3
"""Decks in CalculiX and in creepcontact: error of one value at the end, and processor time, as tables in Markdown.

usage: studies/calculix/compare.py DECK.inp PLACE COMPONENT [--exact VALUE] [--program PATH]
       studies/calculix/compare.py --all [--program PATH]

The deck has one *VISCO step and prints the displacements of the node PLACE, or, if PLACE is a set, the sum of its reactions. It is
run by `ccx` with smaller and smaller increments (its largest increment is the fourth number of *VISCO) and by `creepcontact import`
and `run` with smaller and smaller tolerances. Errors are those against the exact value if it is given. Otherwise they are those
against the most accurate run of the same program, so that they show the integration in time alone; the difference of the two
most accurate runs is printed below: it is that of the contact (hard, or with a stiffness) and of the elements.

--all runs the decks of this study, whose exact values exact.py computes, and prints one more table: what an accuracy costs.
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
ERRORS = (1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 1e-5)
STUDY = pathlib.Path(__file__).resolve().parent
CASES = (  # deck, place, component, function of exact.py, what
    (STUDY / "decks/thick_cylinder.inp", "1", "x", "thick_cylinder", "thick cylinder, one body"),
    (STUDY / "decks/pressed_blocks.inp", "Top", "z", "pressed_blocks", "pressed blocks, contact"),
    (STUDY.parents[1] / "configs/imported/shrink_fit.inp", "1001", "x", "shrink_fit", "shrink fit, contact"),
)


def timed(arguments, directory):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(arguments, cwd=directory, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, arguments))} failed: {(done.stderr or done.stdout)[-500:]}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def run_ccx(text, part, place, component, directory):
    """Value, increments and processor time with at most this part of the step per increment."""
    def with_largest(match):
        numbers = [float(field) for field in match[2].split(",")[:2]]
        largest = part * numbers[1]
        return f"{match[1]}{min(numbers[0], largest):g}, {numbers[1]:g}, 1e-12, {largest:g}\n"
    deck, n = re.subn(r"(?im)(^\*VISCO[^\n]*\n)([^\n]*)\n", with_largest, text)
    if n != 1:
        raise SystemExit("the deck needs one *VISCO step")
    (directory / "deck.inp").write_text(deck)
    seconds = timed(["ccx", "deck"], directory)
    printed = (directory / "deck.dat").read_text()
    if place.isdigit():
        block = printed.split("displacements")[-1]
        row = next(line.split()[1:] for line in block.splitlines() if line.split()[:1] == [place])
    else:
        row = re.search(rf"(?i).*total force [^\n]* for set {place} [^\n]*\n\s*\n([^\n]*)", printed, re.DOTALL)[1].split()
    increments = sum(line.split()[:1] == ["2"] for line in (directory / "deck.sta").read_text().splitlines())
    return float(row["xyz".index(component)]), increments, seconds


def run_ours(program, name, tolerance, place, component, directory):
    output = directory / f"results_{tolerance:g}"
    seconds = timed([program, "run", f"imported/{name}.toml", "--output", output, "--set", f"time.tolerance={tolerance}",
                     "--set", "output.fields=false", "--threads", "1"], directory)
    column = f"u{component}_node_{place}" if place.isdigit() else f"rf{component}_{place}"
    with open(output / "history.csv", newline="") as file:
        value = float(list(csv.DictReader(file))[-1][column])
    summary = json.loads((output / "summary.json").read_text())
    return value, summary["steps"], seconds


def with_errors(runs, exact):
    """(setting, steps, error or None, seconds) of each run; without an exact value the last one is the reference."""
    reference = runs[-1][1][0] if exact is None else exact
    return [(label, steps, None if exact is None and value == reference else abs(value / reference - 1), seconds)
            for label, (value, steps, seconds) in runs]


def table(title, setting, rows):
    print(f"| {title}: {setting} | steps | error | processor time [s] |\n|---|---|---|---|")
    for label, steps, error, seconds in rows:
        print(f"| {label:g} | {steps} | {'(reference)' if error is None else f'{error:.1e}'} | {seconds:.2f} |")
    print()


def compare(program, deck, place, component, exact, coarse):
    """Both programs on one deck: prints their tables and returns the rows of both."""
    name, text = deck.stem, deck.read_text()
    pick = (lambda all: (*all[:2], all[-2])) if coarse else (lambda all: all)
    with tempfile.TemporaryDirectory() as temporary:
        directory = pathlib.Path(temporary)
        timed([program, "import", deck.absolute(), "--output", "imported"], directory)
        theirs = [(part / 1000, run_ccx(text, part / 1000, place, component, directory)) for part in pick(INCREMENTS)]
        ours = [(tolerance, run_ours(program, name, tolerance, place, component, directory)) for tolerance in pick(TOLERANCES)]
    rows = with_errors(theirs, exact), with_errors(ours, exact)
    table("CalculiX", "largest increment / time", rows[0])
    table("creepcontact", "time.tolerance", rows[1])
    last_of_ccx, last_of_ours = theirs[-1][1][0], ours[-1][1][0]
    print(f"most accurate: {last_of_ccx:.6e} (CalculiX), {last_of_ours:.6e} (creepcontact), difference "
          f"{abs(last_of_ccx / last_of_ours - 1):.1e}")
    return rows


def cheapest(rows, error):
    """The run with the fewest steps that is as accurate as this."""
    return min((row for row in rows if row[2] is not None and row[2] <= error), key=lambda row: row[1], default=None)


def run_all(program, coarse):
    sys.path.insert(0, str(STUDY))
    import exact
    results = []
    for deck, place, component, function, what in CASES:
        value = getattr(exact, function)()
        print(f"### {what}: exact {value:.9g}\n")
        results.append((what, compare(program, deck, place, component, value, coarse)))
        print()
    print("| deck | error below | CalculiX: increments, s | creepcontact: steps, s | ratio of the times |\n|---|---|---|---|---|")
    for what, (theirs, ours) in results:
        for error in ERRORS:
            slow, fast = cheapest(theirs, error), cheapest(ours, error)
            cells = [f"{row[1]}, {row[3]:.2f}" if row else "-" for row in (slow, fast)]
            ratio = f"{slow[3] / fast[3]:.0f}" if slow and fast else "-"
            print(f"| {what} | {error:g} | {cells[0]} | {cells[1]} | {ratio} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("deck", type=pathlib.Path, nargs="?")
    parser.add_argument("place", nargs="?", help="number of a node, or name of a set of nodes")
    parser.add_argument("component", choices="xyz", nargs="?")
    parser.add_argument("--all", action="store_true", help="all decks of this study")
    parser.add_argument("--exact", type=float, help="exact value, which the errors refer to")
    parser.add_argument("--program", default=shutil.which("creepcontact") or "creepcontact")
    parser.add_argument("--coarse", action="store_true", help="the two coarsest runs of each program, and the finest but one")
    arguments = parser.parse_args()
    if shutil.which("ccx") is None:
        raise SystemExit("ccx is not installed: Debian package calculix-ccx")
    program = pathlib.Path(arguments.program).absolute()
    if arguments.all:
        run_all(program, arguments.coarse)
    elif arguments.component is None:
        parser.error("give DECK.inp PLACE COMPONENT, or --all")
    else:
        compare(program, arguments.deck, arguments.place, arguments.component, arguments.exact, arguments.coarse)


if __name__ == "__main__":
    sys.exit(main())
