"""Decks with a stress before the loads, with masses, and with sets of which some members do not exist."""

import itertools
import math
import unittest

from test_import import CUBE, ImportTest

STEP = "*STEP\n*STATIC\n1., 1.\n{}*EL PRINT, ELSET=Cube\nS\n*NODE PRINT, NSET=Nall\nU\n*END STEP\n"
HELD = "*NSET, NSET=x1\n2, 3, 6, 7\n*BOUNDARY\nx1, 1\n"
EDGES = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))


def two_bricks(stress):
    """Two C3D20R along x, held at x = 0. @param stress  six components at (x, y, z)"""
    nodes, elements = {}, []
    for i in (0.0, 1.0):
        corners = [(i, 0, 0), (i + 1, 0, 0), (i + 1, 1, 0), (i, 1, 0), (i, 0, 1), (i + 1, 0, 1), (i + 1, 1, 1), (i, 1, 1)]
        places = corners + [tuple((a + b) / 2 for a, b in zip(corners[m], corners[n])) for m, n in EDGES]
        elements.append([nodes.setdefault(tuple(map(float, place)), len(nodes) + 1) for place in places])
    deck = "*NODE, NSET=Nall\n" + "".join(f"{n}, {p[0]}, {p[1]}, {p[2]}\n" for p, n in nodes.items())
    deck += "*ELEMENT, TYPE=C3D20R, ELSET=Cube\n"
    for number, element in enumerate(elements, 1):
        deck += f"{number}, " + ", ".join(map(str, element[:12])) + ",\n" + ", ".join(map(str, element[12:])) + "\n"
    deck += "*NSET, NSET=F\n" + ",\n".join(str(n) for p, n in nodes.items() if p[0] == 0)
    deck += "\n*BOUNDARY\nF, 1, 3\n*MATERIAL, NAME=S\n*ELASTIC\n1e5, 0.3\n*SOLID SECTION, ELSET=Cube, MATERIAL=S\n"
    deck += "*INITIAL CONDITIONS, TYPE=STRESS\n"
    at = (0.5 - 0.5 / math.sqrt(3), 0.5 + 0.5 / math.sqrt(3))
    for element in (1, 2):
        for point, (z, y, x) in enumerate(itertools.product(at, repeat=3), 1):
            deck += f"{element}, {point}, " + ", ".join(f"{one:.6f}" for one in stress(x + element - 1, y, z)) + "\n"
    return deck


class ImportOfStress(ImportTest):
    def test_of_a_whole_body(self):
        stress = "*INITIAL CONDITIONS, TYPE=STRESS\nCube, 100.\n"
        self.import_deck("held", CUBE + HELD + stress + STEP.format(""))
        text = (self.directory / "imported/held.toml").read_text()
        self.assertIn("[initial_stress.Cube]", text)
        self.assertIn("xx = 100\n", text)
        self.expect_close(self.run_imported("held")[-1][self.column("xx")], 100, 1e-9)
        self.import_deck("free", CUBE + stress + STEP.format(""))
        rows = self.run_imported("free")
        self.assertAlmostEqual(rows[-1][self.column("xx")], 0, delta=1e-9)
        self.expect_close(rows[-1]["ux_node_7"], -100 / 1e5, 1e-9)

    def column(self, component):
        names = [name for name in self.table("history.csv")[0] if component in name.lower()]
        self.assertTrue(names, list(self.table("history.csv")[0]))
        return names[0]

    def test_of_integration_points(self):
        """Displacements along x of CalculiX 2.20."""
        deck = two_bricks(lambda x, y, z: (100 * (y - 0.5) + 30 * z, 20 * x, 0, 5, 3 * y, 0))
        self.import_deck("points", deck + STEP.format(""))
        self.assertTrue((self.directory / "imported/points_stress_1.csv").exists())
        row = self.run_imported("points")[-1]
        for node, value in ((2, 5.018617e-4), (3, -4.234972e-4), (6, 2.371635e-4), (7, -7.250795e-4)):
            self.expect_close(row[f"ux_node_{node}"], value, 1e-5)

    def test_mistakes(self):
        for lines, *facts in (("1, 1, 10., 0, 0, 0, 0, 0, 0, 0", "9 values"), ("None, 10.", "'None'"), ("Cube, a", "'a'"),
                              ("1, 0, 10., 0, 0, 0, 0, 0", "integration point"),
                              ("1, 2, 10., 0, 0, 0, 0, 0", "element 1", "C3D8R has 1")):
            done = self.import_deck("wrong", CUBE + "*INITIAL CONDITIONS, TYPE=STRESS\n" + lines + "\n" + STEP.format(""), 2)
            self.assertSays(done.stderr, "wrong.inp:", "*INITIAL CONDITIONS: TYPE=STRESS: ", *facts)


class ImportOfMasses(ImportTest):
    MASS = "*ELEMENT, TYPE=MASS, ELSET=M\n" + "".join(f"{10 + n}, {n}\n" for n in (5, 6, 7, 8)) + "*MASS, ELSET=M\n0.5\n"

    def test_weight_and_centrifugal_force(self):
        """Four masses of 0.5 on the top of a cube of area 1: 2 times 9.81 along -z; then 1e3 times their distance from an axis."""
        self.import_deck("weight", CUBE + self.MASS + STEP.format("*DLOAD\nM, GRAV, 9810., 0, 0, -1.\n"))
        self.expect_close(self.run_imported("weight")[-1]["uz_node_7"], -2 * 9810 / 1e5, 1e-9)
        self.import_deck("turning", CUBE + self.MASS + STEP.format("*DLOAD\nM, CENTRIF, 1e3, 0, 0, -3., 1., 0, 0\n"))
        text = (self.directory / "imported/turning.toml").read_text()
        self.assertEqual([text.count(f"values = [0, {force}]") for force in (2000, 500)], [4, 2])  # at z = 1 and y = 1

    def test_add_to_forces_and_are_told_when_idle(self):
        loads = "*CLOAD\n" + "".join(f"{n}, 3, 100.\n" for n in (5, 6, 7, 8)) + "*DLOAD\nM, GRAV, 9810., 0, 0, -1.\n"
        self.import_deck("both", CUBE + self.MASS + STEP.format(loads))
        self.expect_close(self.run_imported("both")[-1]["uz_node_7"], (400 - 2 * 9810) / 1e5, 1e-9)
        done = self.import_deck("idle", CUBE + self.MASS + STEP.format("*DLOAD\nCube, P2, 1.\n"))
        self.assertSays(done.stdout, "left out: ", "idle.inp:", "*MASS: ", "GRAV")

    def test_without_mass(self):
        done = self.import_deck("none", CUBE + self.MASS[:self.MASS.index("*MASS")] + STEP.format(""), 2)
        self.assertSays(done.stderr, "none.inp:", "element 15")


class ImportOfSets(ImportTest):
    def test_members_that_do_not_exist(self):
        deck = CUBE + "*ELSET, ELSET=Some\n1, 4, 5, 6, 7\n*NSET, NSET=Top\n5, 6, 7, 8, 99\n"
        done = self.import_deck("sets", deck + STEP.format("*CLOAD\nTop, 3, 1.\n"))
        self.assertSays(done.stdout, "left out: ", f"sets.inp:{CUBE.count(chr(10)) + 1}: *ELSET: 'Some'", "4 elements", "4, 5, 6, ...")
        self.assertSays(done.stdout, "*NSET: 'Top'", "1 node", "does not exist: 99")

    def test_of_an_instance_do_not_become_those_of_another(self):
        """Element 2 of a part with one element is not the first one of the next instance."""
        part = CUBE[:CUBE.index("*BOUNDARY")]
        material = CUBE[CUBE.index("*MATERIAL"):CUBE.index("*SOLID")]
        parts = ("*PART, NAME=P\n" + part + "*ELSET, ELSET=Wrong\n1, 2\n*SOLID SECTION, ELSET=Cube, MATERIAL=Steel\n*END PART\n"
                 "*ASSEMBLY, NAME=A\n*INSTANCE, NAME=I, PART=P\n*END INSTANCE\n*INSTANCE, NAME=J, PART=P\n5., 0, 0\n*END INSTANCE\n"
                 "*END ASSEMBLY\n")
        supports = "*BOUNDARY\nI.z0, 1, 3\nJ.z0, 1, 3\n"
        done = self.import_deck("parts", parts + material + supports +
                                "*STEP\n*STATIC\n1., 1.\n*DLOAD\nI.Wrong, P2, -100.\n*NODE PRINT, NSET=J.Nall\nU\n*END STEP\n")
        self.assertSays(done.stdout, "left out: ", "'Wrong'", "does not exist: 2")
        row = self.run_imported("parts")[-1]
        self.assertEqual(max(abs(value) for name, value in row.items() if name.startswith("uz")), 0)


if __name__ == "__main__":
    unittest.main()
