"""Decks with *SPRING and with pressures over overclosures: closed forms, and CalculiX' own example."""

import unittest

import plastic_decks
from test_import import CUBE, ImportTest, deck_text

ABOVE = ("*NODE\n" + "".join(f"{n + 10}, {x}, {y}, {z + 1}\n" for n, (x, y, z) in enumerate(
    [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)])) +
         "*ELEMENT, TYPE=C3D8, ELSET=Above\n2, 10, 11, 12, 13, 14, 15, 16, 17\n*SOLID SECTION, ELSET=Above, MATERIAL=Steel\n"
         "*BOUNDARY\n10, 1, 2\n13, 1\n11, 2\n")
SIDES = "*BOUNDARY\n14, 1, 2\n17, 1\n15, 2\n"
STEP = "*STEP\n*STATIC\n*DLOAD\nAbove, P2, {}\n*END STEP\n"
TOP = '[[probes]]\nname = "u"\nquantity = "displacement_z"\nat = [1, 1, 2]\nbody = "Above"\n'


class ImportOfSprings(ImportTest):
    def test_pressure_over_overclosure(self):
        """Two cubes of 1e5 with a layer between them: 0.001 of their own, and the closure at 50."""
        contact = ("*SURFACE, NAME=Foot\nAbove, S1\n*SURFACE, NAME=Top\nCube, S2\n*CONTACT PAIR, INTERACTION=soft layer\nFoot, Top\n"
                   "*SURFACE INTERACTION, NAME=soft layer\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR\n{}\n")
        deck = CUBE + ABOVE + contact + STEP.format("50.")
        self.import_deck("layer", deck.format("0., 0.\n40., 0.001\n100., 0.0014"))
        self.assertIn('gasket = "soft_layer"', (self.directory / "imported/layer.toml").read_text())
        self.expect_close(self.run_imported("layer", TOP)[-1]["u"], -0.001 - 0.001 - 0.0004 * 10 / 60, 1e-8)
        for rows, fact in (("0., 0.\n40., 0.001\n40., 0.002", "increase"), ("1., 0.\n40., 0.001", "pressure 0"),
                           ("0., 0., 20.\n40., 0.001, 20.\n0., 0., 120.\n20., 0.001, 120.", "temperature")):
            self.assertSays(self.import_deck("wrong", deck.format(rows), 2).stderr, "wrong.inp:", "*SURFACE BEHAVIOR", fact)

    def test_springs_between_two_bodies(self):
        """Four springs carry the upper cube: a pressure of 50 on an area of 1."""
        nodes = list(zip((5, 6, 7, 8), (10, 11, 12, 13)))
        lines = "".join(f"{20 + i}, {a}, {b}\n" for i, (a, b) in enumerate(nodes))
        springs = "*ELEMENT, TYPE=SPRING2, ELSET=Springs\n" + lines + "*SPRING, ELSET=Springs{}\n"
        deck = CUBE + ABOVE + SIDES + springs + STEP.format("50.")
        self.import_deck("linear", deck.format("\n3, 3\n1000."))
        self.expect_close(self.run_imported("linear", TOP)[-1]["u"], -0.001 - 50 / 4000, 1e-8)
        done = self.import_deck("curve", deck.format(", NONLINEAR\n3, 3\n-20., -0.02\n-10., -0.004\n10., 0.004"))
        self.assertSays(done.stdout, "*SPRING", "last slopes")
        self.expect_close(self.run_imported("curve", TOP)[-1]["u"], -0.001 - (0.004 + 0.016 * 2.5 / 10), 1e-8)

    def test_springs_to_the_ground(self):
        text = CUBE.replace("z0, 3\n", "") + "*NODE\n90, 0, 0, -1\n*BOUNDARY\n90, 1, 3\n"
        one = "*ELEMENT, TYPE=SPRING1, ELSET=S1\n" + "".join(f"{20 + n}, {n}\n" for n in (2, 3, 4)) + "*SPRING, ELSET=S1\n3\n1000.\n"
        along = "*ELEMENT, TYPE=SPRINGA, ELSET=SA\n30, 90, 1\n*SPRING, ELSET=SA\n\n1000.\n"
        self.import_deck("ground", text + one + along + "*STEP\n*STATIC\n*DLOAD\nCube, P2, 50.\n*NODE PRINT, NSET=Nall\nU\n*END STEP\n")
        self.expect_close(self.run_imported("ground")[-1]["uz_node_7"], -0.0005 - 50 / 4000, 1e-8)

    def test_what_is_not_possible(self):
        element = "*ELEMENT, TYPE=SPRING2, ELSET=S\n20, 1, 2\n"
        step = "*STEP\n*STATIC\n*END STEP\n"
        for text, *facts in (("", "stiffness", "element 20"), ("*SPRING, ELSET=S\n1, 2\n10.\n", "two different directions"),
                             ("*SPRING, ELSET=S\n1, 1\n-10.\n", "above 0"), ("*SPRING, ELSET=T\n1, 1\n10.\n", "'T'"),
                             ("*SPRING, ELSET=S\n4, 4\n10.\n", "1, 2 or 3")):
            with self.subTest(text):
                self.assertSays(self.import_deck("wrong", CUBE + element + text + step, 2).stderr, "wrong.inp:", *facts)

    def test_a_layer_pressed_askew_as_calculix_has_it(self):
        """Displacements of CalculiX 2.20, node to surface, on meshes that do not match: within 1 % of the largest."""
        text = plastic_decks.blocks()[0].replace("PRESSURE-OVERCLOSURE=LINEAR\n1e7, 1., 1e-3\n", "PRESSURE-OVERCLOSURE=TABULAR\n"
                                                 "0., 0.\n20., 0.005\n200., 0.01\n2000., 0.03\n").replace("*PLASTIC\n200, 0\n300, 0.01\n", "")
        self.import_deck("askew", text)
        path = self.directory / "imported/askew.toml"
        path.write_text(path.read_text().split("[[probes]]")[0])
        of_calculix = {139: ((5, 6.25), (-6.0143e-3, -6.0143e-3)), 201: ((1.25, 9.375), (-1.047897e-2, -7.509595e-3)),
                       240: ((5 / 3, 11.25), (-2.418806e-2, -1.876287e-2)), 260: ((5 / 3, 13.75), (-2.812045e-2, -1.989603e-2))}
        rows = self.run_imported("askew", "".join(
            f'[[probes]]\nname = "u{n}"\nquantity = "displacement_y"\nat = [{x}, {y}, 0]\nbody = "{"Lower" if y < 10 else "Upper"}"\n'
            for n, ((x, y), _) in of_calculix.items()))
        for n, (_, values) in of_calculix.items():
            for time, value in zip((1, 2), values):
                row = next(row for row in rows if row["time"] == time)
                self.assertAlmostEqual(row[f"u{n}"], value, delta=0.01 * 0.042)

    def test_example_of_calculix(self):
        """A square held by one spring of 10, which a force of 1.999 draws."""
        text = deck_text("spring4")
        text = text[:text.index("*STEP", text.index("*STEP") + 1)]
        self.import_deck("spring4", text)
        probes = "".join(f'[[probes]]\nname = "u{n}"\nquantity = "displacement_x"\nat = [{x}, {y}, 0]\nbody = "EMASSA"\n'
                         for n, x, y in ((2, 1, 0), (4, 1.2, -0.1), (8, 1.2, 0)))
        row = self.run_imported("spring4", probes)[-1]
        # The strain of this one element beside a point support depends on its quadrature.
        for node, value, within in ((2, 0.1999, 1e-9), (4, 0.1999385, 1e-4), (8, 0.1999445, 1e-4)):
            self.expect_close(row[f"u{node}"], value, within)


if __name__ == "__main__":
    unittest.main()
