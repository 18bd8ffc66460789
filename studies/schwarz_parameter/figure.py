#!/usr/bin/env python3
"""Measured sweeps over the ratio of the moduli, with those of theory. usage: figure.py RESULTS; writes sweeps.svg, .png there."""

import pathlib
import subprocess
import sys

import report
import theory

COLOURS = {"0.5": "#D55E00", "0.4": "#E69F00", "0.3": "#009E73", "0.2": "#0072B2", "0.1": "#CC79A7"}
OTHERS = {("diagonal", "none"): ("diagonal weights", "#000000", 6), ("", "cg"): ("conjugate gradients", "#808080", 4)}


def block(name, points):
    return f"${name} << EOD\n" + "".join(f"{x:g} {y:g}\n" for x, y in points) + "EOD\n"


def script(rows):
    """The figure as gnuplot reads it, data included."""
    data, curves = "", []
    for number, (alpha, colour) in enumerate(COLOURS.items()):
        limit = theory.limit(float(alpha))
        ratios = [limit**(1 - (1 - k / 400)**3) for k in range(400)]  # dense towards the limit
        data += block(f"t{number}", [(ratio, theory.sweeps(float(alpha), ratio)[0]) for ratio in ratios])
        data += block(f"m{number}", measured(rows, alpha, "none"))
        curves.append(f"$t{number} with lines linewidth 1.5 linecolor rgb '{colour}' notitle")
        curves.append(f"$m{number} with points pointtype 7 pointsize 0.8 linecolor rgb '{colour}' "
                      f"title 'alpha = {alpha}, up to {limit:.2f}'")
    for number, ((alpha, acceleration), (title, colour, point)) in enumerate(OTHERS.items()):
        data += block(f"o{number}", measured(rows, alpha, acceleration))
        curves.append(f"$o{number} with points pointtype {point} pointsize 1 linecolor rgb '{colour}' title '{title}'")
    return (data + "set grid linecolor rgb '#d8d8d8'\nset border 3\nset tics nomirror\nset logscale xy\n"
            "set xrange [0.9:1.2e3]\nset yrange [0.8:2e4]\nset key outside right top Left reverse samplen 1\n"
            "set xlabel 'ratio of the moduli'\nset ylabel 'sweeps (points: measured, lines: theory)'\n"
            "plot " + ", \\\n  ".join(curves) + "\n")


def measured(rows, alpha, acceleration):
    return [(float(row["materials.upper.young_modulus"]) / 10, int(row["schwarz_iterations"]) / 2) for row in rows
            if row["contact_solver.alpha"] == alpha and row["contact_solver.acceleration"] == acceleration
            and not row["diverged"]]


def main(arguments):
    if len(arguments) != 1:
        raise SystemExit(__doc__)
    results = pathlib.Path(arguments[0])
    text = script(report.rows_of(results))
    for terminal, suffix in (("svg", "svg"), ("pngcairo", "png")):
        head = f"set terminal {terminal} size 900,460 font 'sans-serif,13' background '#ffffff'\n"
        name = str(results / f"sweeps.{suffix}").replace("'", "''")
        subprocess.run(["gnuplot"], input=f"{head}set output '{name}'\n{text}", text=True, check=True)


if __name__ == "__main__":
    main(sys.argv[1:])
