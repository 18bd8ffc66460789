#!/usr/bin/env python3
"""Bree's diagram from two studies. usage: report.py RESULTS TUBE_RESULTS

RESULTS, TUBE_RESULTS: the directories of study.toml and tube_study.toml. Writes diagram.png and diagram.svg into the first, and
prints the strain per cycle against Bree's formulas, as a table in Markdown, and the runs on another side of his boundaries.
"""

import csv
import math
import pathlib
import subprocess
import sys

YIELD_STRAIN = 300 / 2e5
BOUNDARY, DASHED = "linewidth 2 linecolor rgb '#000000'", "linewidth 1.5 dashtype 2 linecolor rgb '#808080'"
DEPTH = (1 - 1 / 3**0.5) / 2 / 40   # of the integration points next to a surface, in thicknesses of the wall
NOTHING = 1e-3              # change per cycle, in yield strains, that counts as none
TABLE = ((0.9, 0.75), (0.7, 1.25), (0.6, 1.75), (0.5, 2.25), (0.4, 2.75), (0.3, 3.75), (0.3, 4.75), (0.6, 3.75), (0.9, 4.75),
         (0.2, 2.75), (0.2, 4.75), (0.0, 3.75))
KINDS = (("elastic", 6, "#808080"), ("shakedown", 7, "#0072B2"),
         ("reverse plasticity", 9, "#E69F00"), ("ratcheting", 5, "#D55E00"))


def bree(x, y):
    """The kind that Bree's formulas give, and the changes per cycle of strain and of accumulated plastic strain next to a surface,
    in yield strains. The latter is only given where the strain does not grow."""
    if x + y <= 1:
        return "elastic", 0, 0
    if y <= 2 and x + y / 4 <= 1:
        return "shakedown", 0, 0
    if y > 2 and x * y <= 1:
        return "reverse plasticity", 0, max(0, 2 * (y * (1 - 2 * DEPTH) - 2))
    return "ratcheting", 2 * (x * y - 1) if y * (1 - x) >= 1 else 2 * y * (1 - 2 * math.sqrt(max(1 - x, 0) / y)), None


class Run:
    """One run: x, y, and what its last cycle changes, in yield strains."""

    def __init__(self, directory, x, y):
        with open(directory / "history.csv", newline="") as file:
            rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
        before, last = [next(row for row in rows if row["time"] == time) for time in (11, 12)]
        self.x, self.y = x, y
        self.growth, self.flow = ((last[name] - before[name]) / YIELD_STRAIN for name in ("strain", "flow"))
        self.axial = (last["axial_strain"] - before["axial_strain"]) / YIELD_STRAIN if "axial_strain" in last else 0
        if last["flow"] == 0:
            self.kind = "elastic"
        elif max(abs(self.growth), abs(self.axial)) > NOTHING:
            self.kind = "ratcheting"
        else:
            self.kind = "reverse plasticity" if self.flow > NOTHING else "shakedown"


def runs_of(results, key, scale):
    """X is the column `key` over `scale`."""
    with open(results / "study.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    runs = []
    for number, row in enumerate(rows, 1):
        if row["status"] != "completed":
            print(f"run {number}: {row['status']}, {row['message']}", file=sys.stderr)
            continue
        (directory,) = (results / "runs").glob(f"*{number:03d}")
        x, y = float(row[key]) / scale, 1e5 * float(row["materials.steel.thermal_expansion"])
        runs.append(Run(directory, round(x, 6), round(y, 6)))
    return runs


def mean_of_layers(y, phi, layers=2000):
    """Mean over the wall of (hoop + axial)/2 and (hoop - axial)/2 that the layers carry, in yield stresses."""
    sums, differences = 0, 0
    for layer in range(layers):
        amplitude = y * (layer + 0.5) / layers / 2      # of the heat, equal in both directions
        if amplitude >= 1:
            break
        sums += max(math.cos(phi) - amplitude, 0)
        differences += min(math.sin(phi)**2, 1 - amplitude**2)**0.5 / math.sqrt(3)
    return sums / layers, differences / layers


def tube_boundary(y, axial=0.5):
    """The largest X that does not ratchet; axial: axial over hoop stress of the pressure. In every layer a constant stress is
    sought that stays within the yield condition of von Mises with that of the heat, as Bree did with one direction of stress;
    layers in reverse plasticity carry none. All layers have the same angle in that condition, which this ratio determines."""
    low, high = 0, math.pi / 2
    for _ in range(40):
        phi = (low + high) / 2
        total, difference = mean_of_layers(y, phi)
        low, high = (phi, high) if total * (1 - axial) > difference * (1 + axial) else (low, phi)
    return total + difference


def tube_elastic(x):
    """The largest Y of the elastic tube: von Mises with X + Y and X/2 + Y."""
    return math.sqrt(max(1 - 3 * x * x / 16, 0)) - 3 * x / 4


def curves(name, lines, style):
    """Data and parts of the plot command for some lines."""
    data, parts = "", []
    for number, points in enumerate(lines):
        data += f"${name}_{number} << EOD\n" + "".join(f"{x:g} {y:g}\n" for x, y in points) + "EOD\n"
        parts.append(f"${name}_{number} with lines {style} notitle")
    return data, parts


BREE_LINES = [[(0, 1), (1, 0)], [(1, 0), (0.5, 2)] + [(1 / y, y) for y in (2 + 0.05 * i for i in range(61))], [(0, 2), (0.5, 2)]]
TUBE_LINES = [[(x, tube_elastic(x)) for x in (2 / math.sqrt(3) * i / 40 for i in range(41))],
              [(tube_boundary(y), y) for y in (0.1 * i for i in range(51))], [(0, 2), (tube_boundary(2), 2)]]


def panel(name, title, runs, sets):
    """The plot of one study: boundaries as lines, the runs as markers."""
    data, parts = "", []
    for number, one in enumerate(sets):
        block, more = curves(f"{name}{number}", *one)
        data, parts = data + block, parts + more
    for number, (kind, point, colour) in enumerate(KINDS):
        block = "".join(f"{run.x:g} {run.y:g}\n" for run in runs if run.kind == kind)
        data += f"${name}_run{number} << EOD\n{block}EOD\n"
        parts.append(f"${name}_run{number} with points pointtype {point} pointsize 1.1 linewidth 1.5 linecolor rgb '{colour}' "
                     "notitle")
    return data + f"set title '{title}'\nplot " + ", \\\n  ".join(parts) + "\n"


def legend():
    """One for both plots, below them."""
    lines = ((0.08, BOUNDARY, "boundaries: Bree (1967); right: as he did, with both stresses"), (0.70, DASHED, "Bree (1967)"))
    text = ""
    for x, style, label in lines:
        text += (f"set arrow from screen {x},0.085 to screen {x + 0.04},0.085 nohead {style}\n"
                 f"set label '{label}' at screen {x + 0.05},0.085\n")
    for x, (label, point, colour) in zip((0.08, 0.24, 0.44, 0.70), KINDS):
        text += (f"set label '{label}' at screen {x + 0.03},0.035 point pointtype {point} pointsize 1.1 linewidth 1.5 "
                 f"linecolor rgb '{colour}' offset 1.5,0\n")
    return text


def draw(results, strip, tube):
    text = ("set border 3\nset tics nomirror\nset xtics 0.2\nset ytics 1\nset xrange [-0.03:1.2]\nset yrange [0:5]\nunset key\n"
            "set xlabel 'X = hoop stress of the pressure / yield stress'\n"
            "set ylabel 'Y = thermal stress at the surfaces / yield stress'\nset multiplot layout 1,2\nset bmargin 8\n"
            + legend() + panel("a", "Strip: stress along the circumference only", strip, [(BREE_LINES, BOUNDARY)])
            + "unset label\nunset arrow\n"
            + panel("b", "Closed tube: stress along the axis too", tube, [(BREE_LINES, DASHED), (TUBE_LINES, BOUNDARY)])
            + "unset multiplot\n")
    for terminal, suffix in (("svg", "svg"), ("pngcairo", "png")):
        target = str(results / f"diagram.{suffix}").replace("'", "''")
        head = f"set terminal {terminal} size 1040,640 font 'sans-serif,13' background '#ffffff'\nset output '{target}'\n"
        subprocess.run(["gnuplot"], input=head + text, text=True, check=True)


def table(runs):
    found = {(run.x, run.y): run for run in runs}
    lines = ["| X | Y | kind | growth, Bree | growth, computed | plastic strain, Bree | computed |", "|---|---|---|---|---|---|---|"]
    for point in TABLE:
        run, (kind, growth, flow) = found[point], bree(*point)
        cells = [f"{point[0]:g}", f"{point[1]:g}", kind, f"{growth:.4f}", f"{run.growth:.4f}".replace("-0.0000", "0.0000"),
                 *(("-", "-") if flow is None else (f"{flow:.2f}", f"{run.flow:.2f}"))]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def tube_kind(x, y):
    """The kind by the boundaries of the tube."""
    if y <= tube_elastic(x):
        return "elastic"
    if x > tube_boundary(y):
        return "ratcheting"
    return "shakedown" if y <= 2 else "reverse plasticity"


def print_others(name, runs, kind_of):
    print(f"\n{name}: {len(runs)} runs, of which are not what the boundaries say:")
    for run in runs:
        if run.kind != kind_of(run.x, run.y):
            print(f"  X = {run.x:g}, Y = {run.y:g}: {run.kind}, not {kind_of(run.x, run.y)}")


def main(arguments):
    if len(arguments) != 2:
        raise SystemExit(__doc__)
    results, tube_results = map(pathlib.Path, arguments)
    strip = runs_of(results, "generalized_plane_strain.force", 6)
    tube = runs_of(tube_results, "loads[0].pressure", 15)
    draw(results, strip, tube)
    print(table(strip))
    growths = [(abs(run.growth / bree(run.x, run.y)[1] - 1), run) for run in strip if run.kind == "ratcheting"]
    error, worst = max(growths, key=lambda one: one[0])
    print(f"\nlargest relative error of the growth: {error:.1e}, at X = {worst.x:g}, Y = {worst.y:g}")
    print_others("strip", strip, lambda x, y: bree(x, y)[0])
    print_others("tube", tube, tube_kind)
    print_others("tube, Bree's boundaries", tube, lambda x, y: bree(x, y)[0])
    print("\n| Y | largest X without ratcheting, Bree | closed tube | open tube |\n|---|---|---|---|")
    for y in (0, 0.5, 1, 1.5, 2, 3, 4, 5):
        uniaxial = 1 - y / 4 if y <= 2 else 1 / y
        print(f"| {y:g} | {uniaxial:.3f} | {tube_boundary(y):.3f} | {tube_boundary(y, axial=0):.3f} |")


if __name__ == "__main__":
    main(sys.argv[1:])
