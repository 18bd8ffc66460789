"""Temperatures at the nodes of the mesh, from decks and files: a bar that is free along its axis grows by the integral of
alpha (T - T0), and stays straight."""

import csv
import os
import pathlib
import subprocess
import tempfile
import unittest

from study_case import PROGRAM
from waiting import LONGEST

ALPHA, LENGTH, N = 1e-5, 8.0, 4


def column(order):
    """Nodes and elements of N hexahedra one above the other, numbered as in decks."""
    nodes, elements = {}, []
    number = {}

    def node(x, y, z):
        key = (x, y, z)
        if key not in number:
            number[key] = len(number) + 1
            nodes[number[key]] = key
        return number[key]

    h = LENGTH / N
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    for e in range(N):
        low, high = h * e, h * (e + 1)
        cell = [node(x, y, low) for x, y in square] + [node(x, y, high) for x, y in square]
        if order == 2:
            for z in (low, high):
                for (x, y), (u, v) in zip(square, square[1:] + square[:1]):
                    cell.append(node((x + u) / 2, (y + v) / 2, z))
            cell += [node(x, y, (low + high) / 2) for x, y in square]
        elements.append(cell)
    return nodes, elements


def deck(order, temperature, two=False):
    nodes, elements = column(order)
    kind = "C3D20R" if order == 2 else "C3D8"
    text = "*NODE\n" + "".join(f"{n},{x},{y},{z}\n" for n, (x, y, z) in nodes.items())
    text += f"*ELEMENT, TYPE={kind}, ELSET=E\n"
    for e, cell in enumerate(elements, 1):
        words = [str(e), *map(str, cell)]
        text += "\n".join(",".join(words[i:i + 11]) + ("," if i + 11 < len(words) else "") for i in range(0, len(words), 11)) + "\n"

    def nset(name, wanted):
        return f"*NSET, NSET={name}\n" + "".join(f"{n},\n" for n, x in nodes.items() if wanted(x))
    text += nset("NALL", lambda x: True) + nset("X", lambda x: x[0] in (0, 1)) + nset("Y", lambda x: x[1] in (0, 1))
    text += nset("ZS", lambda x: x[2] == 0) + nset("TOP", lambda x: x[2] == LENGTH)
    text += f"*MATERIAL, NAME=M\n*ELASTIC\n200000., 0.\n*EXPANSION, ZERO=0.\n{ALPHA}\n*SOLID SECTION, ELSET=E, MATERIAL=M\n"
    text += "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nNALL, 0.\n*STEP\n*STATIC\n1., 1.\n*BOUNDARY\nX, 1\nY, 2\nZS, 3\n*TEMPERATURE\n"
    text += "".join(f"{n}, {temperature(x[2])}\n" for n, x in nodes.items())
    return text + "*NODE PRINT, NSET=TOP\nU\n*END STEP\n"


class NodalTemperatures(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.directory = pathlib.Path(scratch.name)

    def call(self, *arguments):
        done = subprocess.run([PROGRAM, *arguments], cwd=self.directory, capture_output=True, text=True, timeout=LONGEST,
                              env={**os.environ, "OMP_NUM_THREADS": "1"})
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def growth(self, *settings):
        said = self.call("run", "bar.toml", "--output", "out", *settings)
        with open(self.directory / "out" / "history.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        ends = [float(value) for name, value in rows[-1].items() if name.startswith("uz_")]
        self.assertGreaterEqual(len(ends), 4)
        self.assertLess(max(ends) - min(ends), 1e-9, said)  # it stays straight
        return ends[0], said

    def imported(self, order, temperature):
        for path in self.directory.glob("bar*"):
            path.unlink()
        (self.directory / "bar.inp").write_text(deck(order, temperature))
        self.call("import", "bar.inp")

    def test_of_decks(self):
        h = LENGTH / N
        for order, temperature, expected in (
                (1, lambda z: 25 * z, ALPHA * 25 * LENGTH ** 2 / 2),
                (2, lambda z: 25 * z, ALPHA * 25 * LENGTH ** 2 / 2),
                (2, lambda z: 100 * (z / LENGTH) ** 2, ALPHA * 100 * LENGTH / 3),
                (1, lambda z: 100 * (z / LENGTH) ** 2,
                 ALPHA * 100 / LENGTH ** 2 * sum(h * ((h * i) ** 2 + (h * (i + 1)) ** 2) / 2 for i in range(N)))):
            self.imported(order, temperature)
            found, said = self.growth()
            self.assertAlmostEqual(found, expected, delta=1e-9, msg=f"order {order}: {said}")
            self.assertIn("all nodes", said)

    def test_of_a_subset(self):
        """Corner nodes alone: linear in each element, as CalculiX takes them."""
        self.imported(2, lambda z: 100 * (z / LENGTH) ** 2)
        path = next(self.directory.glob("bar_temperature.csv"))
        lines = path.read_text().splitlines()
        names = lines[0].split(",")
        x, y, z = (names.index(name) for name in ("x", "y", "z"))

        def is_corner(line):
            cells = [float(cell) for cell in line.split(",")]
            return cells[x] in (0, 1) and cells[y] in (0, 1) and cells[z] % (LENGTH / N) == 0
        path.write_text("\n".join([lines[0], *filter(is_corner, lines[1:])]) + "\n")
        found, said = self.growth()
        h = LENGTH / N
        expected = ALPHA * 100 / LENGTH ** 2 * sum(h * ((h * i) ** 2 + (h * (i + 1)) ** 2) / 2 for i in range(N))
        self.assertAlmostEqual(found, expected, delta=1e-9)
        self.assertIn("all corner nodes", said)
        # All but one corner: no longer nodal values, which is told.
        kept = [line for line in filter(is_corner, lines[1:]) if [float(line.split(",")[i]) for i in (x, y, z)] != [1, 1, LENGTH]]
        path.write_text("\n".join([lines[0], *kept]) + "\n")
        self.assertRegex(self.call("run", "bar.toml", "--output", "out"), r"(?m)^warning: temperature: .* \d+ of \d+ corner nodes")


if __name__ == "__main__":
    unittest.main()
