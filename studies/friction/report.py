#!/usr/bin/env python3
"""Tables and figures of the blade root against friction. usage: report.py RESULTS; writes pressure.* and stick.* there.

RESULTS: the directory of study.toml. Prints two tables in Markdown.
"""

import csv
import pathlib
import re
import struct
import subprocess
import sys
import zlib

BETWEEN_FLANKS = 284     # radius between the two flanks [mm]
AT_LIMIT = 0.999         # of mu times the pressure: the shear traction of a point that slips
COLOURS = ("#000000", "#56B4E9", "#0072B2", "#009E73", "#E69F00", "#D55E00", "#CC79A7")
FORMATS = {"Float64": "d", "Int32": "i", "Int64": "q", "UInt8": "B"}


def runs_of(results):
    """[(mu, history, directory)], history as numbers by column."""
    with open(results / "study.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    runs = []
    for number, row in enumerate(rows, 1):
        (directory,) = (results / "runs").glob(f"*{number:03d}")
        with open(directory / "history.csv", newline="") as file:
            history = [{key: float(value) for key, value in line.items()} for line in csv.DictReader(file)]
        runs.append((float(row["contacts[0].friction"]), history, directory))
    return runs


def arrays(path):
    """The compressed arrays of a .vtu file by name, without units."""
    content = path.read_bytes()
    head, data = content.split(b"<AppendedData", 1)
    data = data[data.index(b"_") + 1:]
    result = {}
    for kind, name, rest, offset in re.findall(
            r'<DataArray type="(\w+)" Name="([^"]*)"([^>]*)format="appended" offset="(\d+)"', head.decode()):
        at = int(offset)
        (n_blocks,) = struct.unpack_from("<Q", data, at)
        sizes = struct.unpack_from(f"<{n_blocks}Q", data, at + 24)
        at += 24 + 8 * n_blocks
        raw = b""
        for size in sizes:
            raw += zlib.decompress(data[at:at + size])
            at += size
        values = struct.unpack(f"<{len(raw) // struct.calcsize(FORMATS[kind])}{FORMATS[kind]}", raw)
        width = re.search(r'NumberOfComponents="(\d+)"', rest)
        n = int(width[1]) if width else 1
        result[name.split(" [")[0]] = values if n == 1 else [values[k:k + n] for k in range(0, len(values), n)]
    return result


def sticking(path, mu):
    """Shares of the lower and of the upper flank that stick."""
    values = arrays(path)
    points = next(values[name] for name in values if name.lower().startswith("points"))
    shares = []
    for lower in (True, False):
        flank = sorted((x[1], shear, pressure) for x, shear, pressure
                       in zip(points, values["contact_shear"], values["contact_pressure"])
                       if (x[1] < BETWEEN_FLANKS) == lower)
        stuck = sum(b[0] - a[0] for a, b in zip(flank, flank[1:])
                    if a[1] + b[1] < AT_LIMIT * mu * (a[2] + b[2]))
        shares.append(stuck / (flank[-1][0] - flank[0][0]))
    return shares


def draw(results, name, text, size):
    for terminal, suffix in (("svg", "svg"), ("pngcairo", "png")):
        head = f"set terminal {terminal} size {size} font 'sans-serif,13' background '#ffffff'\n"
        target = str(results / f"{name}.{suffix}").replace("'", "''")
        style = "set grid linetype 1 linecolor rgb '#d8d8d8'\nset border 3\nset tics nomirror\n"
        subprocess.run(["gnuplot"], input=f"{head}{style}set output '{target}'\n{text}", text=True, check=True)


def pressures(runs):
    data, curves = "", []
    for flank, colour, where in ((1, "#0072B2", "lower"), (2, "#D55E00", "upper")):
        for row, fill, when in ((0, 6, "start"), (-1, 7, "100 000 h")):
            label = f"p{flank}{'s' if row == 0 else 'e'}"
            data += f"${label} << EOD\n" + "".join(
                f"{mu:g} {history[row][f'pressure_{flank}']:g}\n" for mu, history, _ in runs) + "EOD\n"
            curves.append(f"${label} with linespoints linewidth 1.5 dashtype {2 if row == 0 else 1} pointtype {fill} "
                          f"linecolor rgb '{colour}' title '{where} flank, {when}'")
    return (data + "set xrange [0:0.62]\nset yrange [0:160]\nset key bottom left Left reverse\n"
            "set xlabel 'coefficient of friction'\nset ylabel 'mean pressure [MPa]'\nplot " + ", \\\n  ".join(curves) + "\n")


def sticks(runs, shares):
    data, panels = "", []
    for number, (mu, history, _) in enumerate(runs):
        data += f"$s{number} << EOD\n" + "".join(
            f"{line['time']:g} {100 * share[0]:g} {100 * share[1]:g}\n"
            for line, share in zip(history, shares[mu]) if line["time"] > 0) + "EOD\n"
    for flank, where in ((1, "lower flank"), (2, "upper flank")):
        curves = [f"$s{number} using 1:{flank + 1} with lines linewidth 2 linecolor rgb '{COLOURS[number]}' "
                  f"title 'mu = {mu:g}'" for number, (mu, _, _) in enumerate(runs) if max(map(max, shares[mu])) > 0]
        panels.append(f"set title '{where}'\nplot " + ", \\\n  ".join(curves) + "\n")
    return (data + "set logscale x\nset format x '10^{%T}'\nset xrange [1:1e5]\nset yrange [0:100]\nset xlabel 'time [h]'\n"
            "set ylabel 'part of the flank that sticks [%]'\nset multiplot layout 1,2\nset key top left Left reverse\n"
            + "unset key\n".join(panels) + "unset multiplot\n")


def share_of_lower(line):
    return 100 * line["force_1"] / (line["force_1"] + line["force_2"])


def row(name, cells):
    return f"| {name} | " + " | ".join(cells) + " |"


def table(runs, last):
    """At the start (last = False) or at the end."""
    lines = [history[-1 if last else 0] for _, history, _ in runs]
    parts = [("mean pressure, lower flank, MPa", [f"{line['pressure_1']:.1f}" for line in lines]),
             ("mean pressure, upper flank, MPa", [f"{line['pressure_2']:.1f}" for line in lines]),
             ("share of the lower flank, %", [f"{share_of_lower(line):.1f}" for line in lines]),
             ("largest slip, lower flank, um", [f"{1e3 * line['slip_1']:.1f}" for line in lines]),
             ("largest slip, upper flank, um", [f"{1e3 * line['slip_2']:.1f}" for line in lines]),
             ("stress in the disc's lower fillet, MPa", [f"{line['groove_mises']:.0f}" for line in lines]),
             ("radial displacement of the root, mm", [f"{line['root_displacement']:.3f}" for line in lines])]
    if last:
        parts.append(("creep strain in the disc's lower fillet, %", [f"{100 * line['groove_creep']:.2f}" for line in lines]))
    head = [row("mu", [f"{mu:g}" for mu, _, _ in runs]), "|---" * (len(runs) + 1) + "|"]
    return "\n".join(head + [row(name, cells) for name, cells in parts])


def main(arguments):
    if len(arguments) != 1:
        raise SystemExit(__doc__)
    results = pathlib.Path(arguments[0])
    runs = runs_of(results)
    shares = {mu: [sticking(path, mu) for path in sorted((directory / "contact").glob("*.vtu"))]
              for mu, _, directory in runs if mu > 0}
    shares[0.0] = [(0.0, 0.0)] * len(runs[0][1])
    draw(results, "pressure", pressures(runs), "640,440")
    draw(results, "stick", sticks(runs, shares), "960,420")
    print(f"At the start:\n\n{table(runs, False)}\n\nAfter 100 000 h:\n\n{table(runs, True)}")


if __name__ == "__main__":
    main(sys.argv[1:])
