"""Decks whose materials have axes: exact answers of little decks, and CalculiX itself."""

import math
import shutil
import subprocess
import unittest

from test_import import CUBE, ImportTest
from waiting import LONGEST

CRYSTAL = """*ELASTIC, TYPE=ENGINEERING CONSTANTS
2e5, 1.5e5, 1.2e5, 0.25, 0.35, 0.3, 4e4, 6e4
5e4, 20
1e5, 1.2e5, 0.9e5, 0.2, 0.3, 0.25, 3e4, 5e4
4e4, 620
*EXPANSION, TYPE=ORTHO, ZERO=20
1e-5, 1.6e-5, -2e-6, 20
1.2e-5, 1.9e-5, -1e-6, 620
"""
FORGING = """*ELASTIC, TYPE=ORTHO
5e5, 1.572e5, 4e5, 1.572e5, 1.572e5, 3e5, 1.262e5, 1.1e5
0.9e5, 294
*EXPANSION, TYPE=ORTHO
1e-5, 1.6e-5, 1.2e-5
"""


def ring_deck(orientation):
    """A quarter of a ring about the line x = 0, y = 0: C3D20R."""
    n = (4, 6, 1)  # along the radius, around, along the axis
    numbers, nodes, elements = {}, [], []
    for k in range(2 * n[2] + 1):
        for j in range(2 * n[1] + 1):
            for i in range(2 * n[0] + 1):
                if (i % 2) + (j % 2) + (k % 2) > 1:
                    continue
                numbers[i, j, k] = len(numbers) + 1
                r, angle = 50 + 50 * i / (2 * n[0]), math.pi / 2 * j / (2 * n[1])
                nodes.append(f"{numbers[i, j, k]}, {r * math.cos(angle):.12g}, {r * math.sin(angle):.12g}, {5.0 * k}")
    corners = ((0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2))
    edges = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))
    places = corners + tuple(tuple((corners[a][d] + corners[b][d]) // 2 for d in range(3)) for a, b in edges)
    bore = []
    for j in range(n[1]):
        for i in range(n[0]):
            own = [str(numbers[2 * i + a, 2 * j + b, c]) for a, b, c in places]
            elements.append(f"{len(elements) + 1}, " + ", ".join(own[:10]) + ",\n" + ", ".join(own[10:]))
            if i == 0:
                bore.append(f"{len(elements)}, P6, 40.")
    sides = {"y0": lambda p: p[1] == 0, "x0": lambda p: p[1] == 2 * n[1], "z0": lambda p: p[2] == 0}
    sets = "".join(f"*NSET, NSET={name}\n" + "".join(f"{number},\n" for place, number in numbers.items() if lies(place))
                   for name, lies in sides.items())
    newline = "\n"
    text = (f"*NODE, NSET=Nall\n{newline.join(nodes)}\n*ELEMENT, TYPE=C3D20R, ELSET=Ring\n{newline.join(elements)}\n{sets}"
            f"*BOUNDARY\nx0, 1\ny0, 2\nz0, 3\n*MATERIAL, NAME=M\n{FORGING}{orientation}"
            "*SOLID SECTION, ELSET=Ring, MATERIAL=M, ORIENTATION=O\n*INITIAL CONDITIONS, TYPE=TEMPERATURE\nNall, 20\n"
            f"*STEP\n*STATIC\n*DLOAD\n{newline.join(bore)}\n*TEMPERATURE\nNall, 220\n*NODE PRINT, NSET=Nall\nU\n*END STEP\n")
    return text, nodes


class ImportOfAxes(ImportTest):
    def test_materials_with_axes(self):
        """Pulled and heated freely along x, axis 1 at 30 degrees to it."""
        deck = CUBE.replace("*ELASTIC\n1e5, 0.\n", CRYSTAL).replace("MATERIAL=Steel\n", "MATERIAL=Steel, ORIENTATION=O\n")
        deck = deck.replace("*BOUNDARY\nx0, 1\ny0, 2\nz0, 3\n", "*BOUNDARY\n1, 1, 3\n2, 2, 3\n4, 3\n")
        deck += ("*ORIENTATION, NAME=O\n1, 0, 0, 0, 1, 0\n3, 30\n*INITIAL CONDITIONS, TYPE=TEMPERATURE\nNall, 20\n"
                 "*STEP\n*STATIC\n*TEMPERATURE\nNall, 320\n*CLOAD\n2, 1, 25\n3, 1, 25\n6, 1, 25\n7, 1, 25\n"
                 "1, 1, -25\n4, 1, -25\n5, 1, -25\n8, 1, -25\n*END STEP\n")
        self.import_deck("crystal", deck)
        row = self.run_imported("crystal", '[[probes]]\nname = "u"\nquantity = "displacement_x"\nat = [1, 0, 0]\n')[-1]
        c, s = math.cos(math.radians(30)), math.sin(math.radians(30))
        pulled = 100 * (c**4 / 1.5e5 + s**4 / 1.35e5 + (1 / 3.5e4 - 2 * 0.225 / 1.5e5) * c * c * s * s)
        heated = 300 * (c * c * 1.1e-5 + s * s * 1.75e-5)
        self.expect_close(row["u"], pulled + heated, 1e-9)

    def test_bodies_by_their_axes(self):
        """Two crystals of one material, and cylindrical axes; isotropic materials have none."""
        second = "*NODE\n9, 2, 0, 0\n10, 2, 1, 0\n11, 2, 0, 1\n12, 2, 1, 1\n*ELEMENT, TYPE=C3D8R, ELSET=Other\n2, 2, 9, 10, 3, 6, 11, 12, 7\n"
        orientations = "*ORIENTATION, NAME=A\n1, 0, 0, 0, 1, 0\n*ORIENTATION, NAME=B, SYSTEM=CYLINDRICAL\n0, -5, 0, 0, -5, 2\n"
        sections = "*SOLID SECTION, ELSET=Cube, MATERIAL=Steel, ORIENTATION=A\n*SOLID SECTION, ELSET=Other, MATERIAL=Steel, ORIENTATION=B\n"
        step = "*STEP\n*STATIC\n*DLOAD\nOther, P4, -1.\n*END STEP\n"
        for material, n_bodies in ((CRYSTAL, 2), ("*ELASTIC\n1e5, 0.\n", 1)):
            with self.subTest(n_bodies):
                deck = CUBE[:CUBE.index("*SOLID")].replace("*ELASTIC\n1e5, 0.\n", material)
                name = f"bodies{n_bodies}"
                self.import_deck(name, deck + second + orientations + sections + step)
                text = (self.directory / "imported" / f"{name}.toml").read_text()
                self.assertEqual(text.count("\nregion = "), n_bodies)
                self.assertEqual("cylindrical = { axis = [0, 0, 2], origin = [0, -5, 0] }" in text, n_bodies == 2)
                self.run_imported(name)

    def test_axes_that_are_not_known(self):
        ortho = CUBE.replace("*ELASTIC\n1e5, 0.\n", CRYSTAL).replace("MATERIAL=Steel\n", "MATERIAL=Steel, ORIENTATION=O\n")
        step = "*STEP\n*STATIC\n*END STEP\n"
        for n, (deck, *facts) in enumerate((
                (ortho, "*SOLID SECTION: ", "*ORIENTATION 'O'"),
                (ortho + "*ORIENTATION, NAME=O, SYSTEM=SPHERICAL\n1, 0, 0, 0, 1, 0\n", "*ORIENTATION: ", "SYSTEM=SPHERICAL"),
                (ortho + "*ORIENTATION, NAME=O\n1, 0, 0, 2, 0, 0\n", "*ORIENTATION: ", "two points"),
                (CUBE.replace("*ELASTIC\n", "*ELASTIC, TYPE=ANISO\n"), "*ELASTIC: ", "ANISO"),
                (CUBE.replace("*ELASTIC\n1e5, 0.\n", "*ELASTIC, TYPE=ORTHO\n1, 2, 1, 0, 0, 1, 1, 1\n1\n"), "*ELASTIC: ", "D1111"),
                (CUBE.replace("*ELASTIC\n1e5, 0.\n", "*ELASTIC, TYPE=ORTHO\n1, 2, 1, 0, 0, 1, 1, 1\n"), "*ELASTIC: ", "nine"),
        )):
            with self.subTest(facts):
                self.assertSays(self.import_deck(f"axes{n}", deck + step, 2).stderr, f"axes{n}.inp:", *facts)

    def test_hill(self):
        """Abaqus: R11, R22, R33, R12, R13, R23. Along axis 1 the strain rate is that of the stress s/R11, times 1/R11."""
        deck = CUBE.replace("*SOLID", "*CREEP, LAW=NORTON\n1e-8, 3., 0.\n*POTENTIAL\n0.8, 1, 1, 1, 1, 1\n*SOLID")
        self.import_deck("hill", deck + "*STEP\n*VISCO\n1., 10.\n*DLOAD\nCube, P4, -10.\n*END STEP\n")
        row = self.run_imported("hill", '[[probes]]\nname = "c"\nquantity = "creep_strain_xx"\nbody = "Cube"\n')[-1]
        self.expect_close(row["c"], 1e-8 * 10**3 * 10 / 0.8**4, 1e-3)


@unittest.skipUnless(shutil.which("ccx"), "needs the Debian package calculix-ccx")
class SideBySideWithCalculix(ImportTest):
    def test_rings_with_axes(self):
        """Displacements of all nodes: elements and integration points are the same."""
        for name, orientation in (("around", "*ORIENTATION, NAME=O, SYSTEM=CYLINDRICAL\n0, 0, 0, 0, 0, 1\n"),
                                  ("across", "*ORIENTATION, NAME=O\n0.6, 0.8, 0, 0, 1, 0\n")):
            with self.subTest(name):
                deck, nodes = ring_deck(orientation)
                self.import_deck(name, deck)
                probes = "".join(f'[[probes]]\nname = "{c}{number}"\nquantity = "displacement_{c}"\nat = [{x}, {y}, {z}]\n'
                                 for number, x, y, z in (line.split(",") for line in nodes[::7]) for c in "xyz")
                row = self.run_imported(name, probes)[-1]
                subprocess.run(["ccx", "-i", name], cwd=self.directory, capture_output=True, timeout=LONGEST, check=True)
                theirs = {}
                for line in (self.directory / f"{name}.dat").read_text().splitlines():
                    fields = line.split()
                    if len(fields) == 4 and fields[0].isdigit():
                        theirs[fields[0]] = [float(field) for field in fields[1:]]
                size = max(abs(value) for u in theirs.values() for value in u)
                for probe, value in row.items():
                    if probe != "time":
                        self.assertAlmostEqual(value, theirs[probe[1:]]["xyz".index(probe[0])], delta=1e-5 * size, msg=probe)


if __name__ == "__main__":
    unittest.main()
