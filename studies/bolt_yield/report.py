#!/usr/bin/env python3
"""The tightening curve of a bolt beyond its yield stress, and its force over time. usage: report.py RESULTS

RESULTS: the directory of study.toml. Writes force.png and force.svg there, and prints what a hand can work out next to the runs.
"""

import csv
import math
import pathlib
import subprocess
import sys

PITCH, GRIP, SHANK, HEAD, HOLE, SLEEVE = 2, 80, 14.1, 24, 17, 44        # mm; diameters
COLD, HOT = 211e3, 175e3                                                # MPa
YIELD, HOT_YIELD, HARDENING = 640, 430, 2000
CREEP, EXPONENT = 9.1e-26, 8
AREA = math.pi * SHANK**2 / 4
YIELDING = GRIP - SHANK     # length of the shank: half a diameter below each head hardly yields
COLOURS = ("#56B4E9", "#0072B2", "#009E73", "#E69F00", "#D55E00")


class ByHand:
    """VDI 2230: a shank with half a diameter for each head, and a cone of pressure that reaches the surface of the sleeve."""

    tangent = 0.362 + 0.032 * math.log(GRIP / HEAD / 2) + 0.153 * math.log(SLEEVE / HEAD)
    bolt = (GRIP + SHANK) / (COLD * AREA)
    cone = 2 / (HOLE * tangent) * math.log((HEAD + HOLE) * (SLEEVE - HOLE) / ((HEAD - HOLE) * (SLEEVE + HOLE)))
    plates = (cone + 4 / (SLEEVE**2 - HOLE**2) * (GRIP - (SLEEVE - HEAD) / tangent)) / (COLD * math.pi)
    compliance = bolt + plates
    slope = PITCH / 360 / compliance
    force_at_yield = YIELD * AREA
    angle_at_yield = force_at_yield / slope
    plastic = compliance + YIELDING / (HARDENING * AREA)
    slope_beyond = PITCH / 360 / plastic

    @classmethod
    def force(cls, angle):
        return min(cls.slope * angle, cls.force_at_yield + cls.slope_beyond * (angle - cls.angle_at_yield))

    @classmethod
    def hot(cls, angle):
        """The strain of the shank and the deflection stay while yield stress and Young's modulus fall."""
        compliance = cls.compliance * COLD / HOT
        travel = PITCH * angle / 360
        flow = (travel / compliance / AREA - HOT_YIELD) / (YIELDING / compliance / AREA + HARDENING)
        return (travel - YIELDING * max(flow, 0)) / compliance

    @classmethod
    def after(cls, force, hours):
        modulus = GRIP / (AREA * cls.compliance * COLD / HOT)
        return AREA * ((force / AREA)**(1 - EXPONENT) + (EXPONENT - 1) * CREEP * modulus * hours)**(1 / (1 - EXPONENT))


def runs_of(results):
    """[(angle, history)]"""
    runs = []
    for directory in sorted((results / "runs").glob("run_*")):
        with open(directory / "history.csv", newline="") as file:
            rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
        runs.append((round(rows[-1]["turn"]), rows))
    return runs


def at(rows, time):
    return next(row for row in rows if row["time"] == time)


def draw(results, runs):
    angle, longest = runs[-1]
    curve = "".join(f"{row['turn']:g} {row['bolt_force'] / 1e3:g}\n" for row in longest if row["time"] <= 0.05)
    knee = ByHand.angle_at_yield
    hand = "".join(f"{x:g} {ByHand.force(x) / 1e3:g}\n" for x in (0, knee, angle))
    text = (f"$curve << EOD\n{curve}EOD\n$hand << EOD\n{hand}EOD\n"
            "set border 3\nset tics nomirror\nset grid linetype 1 linecolor rgb '#d8d8d8'\nset yrange [0:120]\n"
            "set multiplot layout 1,2\nset title 'Tightening at 20 degC'\nset xlabel 'angle of the nut [deg]'\n"
            "set ylabel 'bolt force [kN]'\nset xrange [0:100]\nset key bottom right\n"
            "plot $curve with linespoints linewidth 1.5 pointtype 7 pointsize 0.6 linecolor rgb '#0072B2' title 'computed', \\\n"
            "  $hand with lines linewidth 1.5 dashtype 2 linecolor rgb '#000000' title 'by hand (VDI 2230)'\n")
    curves = []
    for number, (angle, rows) in enumerate(runs):
        text += f"$t{number} << EOD\n" + "".join(f"{row['time']:g} {row['bolt_force'] / 1e3:g}\n" for row in rows
                                               if row["time"] >= 0.1) + "EOD\n"
        curves.append(f"$t{number} with lines linewidth 2 linecolor rgb '{COLOURS[number]}' title '{angle} deg'")
    text += ("set title 'Start-up to 500 degC in 8 h, then relaxation'\nset xlabel 'time [h]'\nset logscale x\n"
             "set format x '10^{%T}'\nset xrange [0.1:1e5]\nset key top right invert\nplot " + ", \\\n  ".join(curves) + "\nunset multiplot\n")
    for terminal, suffix in (("svg", "svg"), ("pngcairo", "png")):
        target = str(results / f"force.{suffix}").replace("'", "''")
        head = f"set terminal {terminal} size 1000,440 font 'sans-serif,13' background '#ffffff'\nset output '{target}'\n"
        subprocess.run(["gnuplot"], input=head + text, text=True, check=True)


def tables(runs):
    longest = runs[-1][1]
    turned = {round(row["turn"]): row["bolt_force"] for row in longest if row["time"] <= 0.05}
    hand = ByHand
    print(f"compliances by hand: bolt {hand.bolt:.3g}, plates {hand.plates:.3g} mm/N; tangent of the cone {hand.tangent:.3f}")
    print("| | by hand | computed |\n|---|---|---|")
    slope = turned[30] / 30
    print(f"| slope below yield, kN/deg | {hand.slope / 1e3:.2f} | {slope / 1e3:.2f} |")
    print(f"| yield at, kN | {hand.force_at_yield / 1e3:.1f} | {turned[65] / 1e3:.1f} at 65 deg |")
    print(f"| yield at, deg | {hand.angle_at_yield:.1f} | {hand.force_at_yield / slope:.1f} |")
    print(f"| slope beyond, kN/deg | {hand.slope_beyond / 1e3:.4f} | "
          f"{(turned[75] - turned[70]) / 5e3:.4f} at 70 to 75 deg, {(turned[100] - turned[95]) / 5e3:.4f} at 95 to 100 deg |")
    rows = dict(runs)[75]
    for name, computed, by_hand in (
            ("75 deg: force", at(rows, 0.05), hand.force(75)), ("after start-up", at(rows, 8), hand.hot(75)),
            ("after 1000 h", at(rows, 1000), hand.after(hand.hot(75), 992)),
            ("after 1e5 h", at(rows, 1e5), hand.after(hand.hot(75), 1e5 - 8))):
        print(f"| {name}, kN | {by_hand / 1e3:.1f} | {computed['bolt_force'] / 1e3:.1f} |")
    flow = (PITCH * 75 / 360 / hand.compliance - hand.force(75)) * hand.compliance / YIELDING
    print(f"| 75 deg: plastic strain of the shank, % | {100 * flow:.3f} | {100 * at(rows, 0.05)['flow']:.3f} |")
    times = (0.1, 8, 100, 1000, 1e4, 1e5)
    print("\n| turn, deg | " + " | ".join(f"{time:g} h" for time in times) + " | mean, largest plastic strain, % |")
    print("|---" * (len(times) + 2) + "|")
    for angle, rows in runs:
        cells = [f"{at(rows, time)['bolt_force'] / 1e3:.1f}" for time in times]
        print(f"| {angle} | " + " | ".join(cells) + f" | {100 * rows[-1]['flow']:.2f}, {100 * rows[-1]['largest_flow']:.2f} |")


def main(arguments):
    if len(arguments) != 1:
        raise SystemExit(__doc__)
    results = pathlib.Path(arguments[0])
    runs = runs_of(results)
    draw(results, runs)
    tables(runs)


if __name__ == "__main__":
    main(sys.argv[1:])
