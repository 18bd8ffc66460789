#!/usr/bin/env python3
"""Gasket pressure over time by what creeps. usage: report.py RESULTS

RESULTS: the directory of study.toml. Writes pressure.png and pressure.svg there, and prints the tables of README.md.
"""

import csv
import pathlib
import subprocess
import sys

CREEPS = ("none", "bolts", "flanges", "bolts and flanges", "gasket", "all", "gasket, n = 10", "all, n = 10", "gasket, hardens",
          "all, hardens")
OTHERS = ("all, retightened after a day", "all, P_QR = 0.98", "all, P_QR = 0.9", "all, hardens, retightened after a day")
STYLES = {"none": ("#999999", 1), "bolts": ("#56B4E9", 1), "flanges": ("#009E73", 1), "bolts and flanges": ("#CC79A7", 1),
          "gasket": ("#E69F00", 2), "all": ("#D55E00", 1), "gasket, n = 10": ("#0072B2", 2), "all, n = 10": ("#000000", 1),
          "gasket, hardens": ("#8C6D1F", 2), "all, hardens": ("#8C6D1F", 1)}
LIMITS = (("L0.01", 30), ("L0.1", 15))  # MPa


def runs_of(results):
    """Histories by label and temperature, in the order of study.toml."""
    histories = []
    for directory in sorted((results / "runs").glob("run_*")):
        with open(directory / "history.csv", newline="") as file:
            histories.append([{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)])
    keys = [(label, degrees) for label in CREEPS for degrees in (450, 500)] + [(label, 450) for label in OTHERS]
    return dict(zip(keys, histories, strict=True))


def draw(results, runs):
    text = ("set border 3\nset tics nomirror\nset grid linetype 1 linecolor rgb '#d8d8d8'\nset logscale x\nset format x '10^{%T}'\n"
            "set xrange [1:1e5]\nset yrange [0:80]\nset xlabel 'time [h]'\n"
            "set multiplot layout 1,2 margins 0.07,0.78,0.13,0.91 spacing 0.05\n")
    for degrees in (450, 500):
        curves = []
        for number, label in enumerate(CREEPS):
            name = f"$run{number}_{degrees}"
            text += f"{name} << EOD\n" + "".join(f"{row['time']:g} {row['gasket_pressure']:g}\n" for row in runs[label, degrees]
                                                 if row["time"] > 0) + "EOD\n"
            colour, dash = STYLES[label]
            curves.append(f"{name} with lines linewidth 2 dashtype {dash} linecolor rgb '{colour}' "
                          + (f"title '{label}'" if degrees == 450 else "notitle"))
        for name, limit in LIMITS:
            curves.append(f"{limit} with lines linewidth 1 dashtype 3 linecolor rgb '#444444' notitle")
            text += f"set label '{name}' at 1.15,{limit + 1.8} font ',11' textcolor rgb '#444444'\n"
        text += f"set title '{degrees} degC'\n"
        text += ("set ylabel 'gasket pressure [MPa]'\nset key at screen 0.995,0.88 samplen 2 spacing 1.2 title 'what creeps'\n"
                 if degrees == 450 else "unset ylabel\nunset key\n")
        text += "plot " + ", \\\n  ".join(curves) + "\nunset label\n"
    text += "unset multiplot\n"
    for terminal, suffix in (("svg", "svg"), ("pngcairo", "png")):
        target = str(results / f"pressure.{suffix}").replace("'", "''")
        head = f"set terminal {terminal} size 1100,460 font 'sans-serif,13' background '#ffffff'\nset output '{target}'\n"
        subprocess.run(["gnuplot"], input=head + text, text=True, check=True)


def tables(runs):
    print("| what creeps | 450 degC: gasket, MPa | bolt, kN | lost of the bolt force | 500 degC: gasket, MPa | bolt, kN | lost |")
    print("|---|---|---|---|---|---|---|")
    for label in CREEPS:
        cells = []
        for degrees in (450, 500):
            end, elastic = runs[label, degrees][-1], runs["none", degrees][-1]
            cells += [f"{end['gasket_pressure']:.1f}", f"{end['bolt_force'] / 1e3:.1f}",
                      f"{100 * (1 - end['bolt_force'] / elastic['bolt_force']):.0f} %"]
        print(f"| {label} | " + " | ".join(cells) + " |")
    print("\n| at 450 degC | gasket at the end, MPa | bolt, kN |\n|---|---|---|")
    for label in OTHERS:
        end = runs[label, 450][-1]
        print(f"| {label} | {end['gasket_pressure']:.1f} | {end['bolt_force'] / 1e3:.1f} |")


def main(arguments):
    if len(arguments) != 1:
        raise SystemExit(__doc__)
    results = pathlib.Path(arguments[0])
    runs = runs_of(results)
    draw(results, runs)
    tables(runs)


if __name__ == "__main__":
    main(sys.argv[1:])
