#!/usr/bin/env python3
"""Friction on the same mesh by CalculiX: the strip of friction_strip_test.cpp, pressed and then pulled at its end.

usage: calculix_strip.py DIRECTORY      needs ccx (Debian package calculix-ccx)

Writes the deck into the directory, runs it and prints the mean displacement of the end. One step with amplitudes: in a
second step CalculiX 2.20 lets a pressure that goes on grow anew when a load is added.
"""
import subprocess
import sys
from pathlib import Path

LENGTH, THICKNESS, PRESSURE, FRICTION = 2, 0.05, 1, 0.3
STRESS = 0.7*LENGTH*FRICTION*PRESSURE/THICKNESS  # of the end at last
STIFFNESS = 1e6  # of the contact, normal and tangential, per area
COLUMNS, ROWS = 64, 2
CORNERS = ((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1))


def region(first, low, high):
    """Nodes {(i, j): (number, x, y)} and elements {number: nodes} of a body between these heights."""
    nodes = {(i, j): (first + j*(2*COLUMNS + 1) + i, LENGTH*i/(2*COLUMNS), low + (high - low)*j/(2*ROWS))
             for j in range(2*ROWS + 1) for i in range(2*COLUMNS + 1) if not (i % 2 and j % 2)}
    elements = {first + j*COLUMNS + i: [nodes[2*i + a, 2*j + b][0] for a, b in CORNERS]
                for j in range(ROWS) for i in range(COLUMNS)}
    return nodes, elements


def deck():
    strip = 100001
    bodies = {"base": region(1, -0.3, 0), "strip": region(strip, 0, THICKNESS)}
    lines = ["*NODE", *(f"{k}, {x:.12g}, {y:.12g}, 0" for nodes, _ in bodies.values() for k, x, y in nodes.values())]
    for name, (_, elements) in bodies.items():
        lines += [f"*ELEMENT, TYPE=CPE8, ELSET={name}", *(", ".join(map(str, [k, *e])) for k, e in elements.items())]
    sets = {"low": [bodies["base"][0][i, 0] for i in range(2*COLUMNS + 1)],
            "left": [bodies["strip"][0][0, j] for j in range(2*ROWS + 1)],
            "end": [bodies["strip"][0][2*COLUMNS, j] for j in range(2*ROWS + 1)]}
    for name, nodes in sets.items():
        lines += [f"*NSET, NSET={name}", *(f"{node[0]}," for node in nodes)]
    lines += ["*SURFACE, NAME=slave", *(f"{strip + i}, S1" for i in range(COLUMNS))]
    lines += ["*SURFACE, NAME=master", *(f"{1 + (ROWS - 1)*COLUMNS + i}, S3" for i in range(COLUMNS))]
    for name, modulus, poisson in (("base", 1e6, 0.3), ("strip", 1000, 0)):
        lines += [f"*MATERIAL, NAME={name}", "*ELASTIC", f"{modulus}, {poisson}",
                  f"*SOLID SECTION, ELSET={name}, MATERIAL={name}", "1."]
    lines += ["*SURFACE INTERACTION, NAME=touch", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{STIFFNESS}",
              "*FRICTION", f"{FRICTION}, {STIFFNESS}", "*CONTACT PAIR, INTERACTION=touch, TYPE=SURFACE TO SURFACE",
              "slave, master", "*BOUNDARY", "low, 1, 2", "left, 1, 1",
              "*AMPLITUDE, NAME=press", "0, 0, 1, 1, 2, 1", "*AMPLITUDE, NAME=pull", "0, 0, 1, 0, 2, 1",
              "*STEP, INC=1000", "*CONTROLS, PARAMETERS=FIELD", "1e-6, 1e-4", "*STATIC", "0.125, 2, 1e-6, 0.125",
              "*DLOAD, AMPLITUDE=press", *(f"{strip + (ROWS - 1)*COLUMNS + i}, P3, {PRESSURE}" for i in range(COLUMNS)),
              "*DLOAD, AMPLITUDE=pull", *(f"{strip + (j + 1)*COLUMNS - 1}, P2, {-STRESS}" for j in range(ROWS)),
              "*NODE PRINT, NSET=end, FREQUENCY=2", "U", "*END STEP"]
    return "\n".join(lines) + "\n"


def ends(text):
    """Displacements of the nodes of the end, by time."""
    found, time = {}, None
    for words in map(str.split, text.splitlines()):
        if "time" in words:
            time = float(words[-1])
        elif len(words) == 4:
            found.setdefault(time, []).append(float(words[1]))
    return found


if __name__ == "__main__":
    directory = Path(sys.argv[1])
    (directory / "strip.inp").write_text(deck())
    subprocess.run(["ccx", "strip"], cwd=directory, check=True, stdout=subprocess.DEVNULL)
    for t, u in ends((directory / "strip.dat").read_text()).items():
        print(f"{t:g}  {(u[0] + 4*u[1] + 2*u[2] + 4*u[3] + u[4])/12:.6e}")
