"""Decks with gasket elements: two cubes of 1e5 with a gasket of 0.1 between them, in closed form."""

import shutil
import unittest

from test_import import CUBE, ImportTest

CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
UPPER = ("*NODE\n" + "".join(f"{10 + 4 * k + i}, {x}, {y}, {z + 1.1 + k}\n" for k in (0, 1) for i, (x, y, z) in enumerate(CORNERS)) +
         "*ELEMENT, TYPE=C3D8, ELSET=Upper\n2, 10, 11, 12, 13, 14, 15, 16, 17\n*SOLID SECTION, ELSET=Upper, MATERIAL=Steel\n"
         "*BOUNDARY\n10, 1, 2\n13, 1\n11, 2\n")
BETWEEN = "*ELEMENT, TYPE=GK3D8, ELSET=Gasket\n50, 5, 6, 7, 8, 10, 11, 12, 13\n"
OWN_NODES = "*NODE\n" + "".join(f"{60 + i}, {x}, {y}, 1\n{70 + i}, {x}, {y}, 1.1\n" for i, (x, y, _) in enumerate(CORNERS))
APART = OWN_NODES + "*ELEMENT, TYPE=GK3D8N, ELSET=Gasket\n50, 60, 61, 62, 63, 70, 71, 72, 73\n"
FACES = "*SURFACE, NAME=Floor\nCube, S2\n*SURFACE, NAME=Roof\nUpper, S1\n"
SIDES = FACES + "*SURFACE, NAME=Below\nGasket, SNEG\n*SURFACE, NAME=Above\nGasket, SPOS\n"
SECTION = "*GASKET SECTION, ELSET=Gasket, BEHAVIOR=graphite\n"
LOADING = "0., 0.\n10., .01\n30., .02\n50., .04\n100., .12\n"
BEHAVIOR = "*GASKET BEHAVIOR, NAME=graphite\n*GASKET THICKNESS BEHAVIOR, TYPE=ELASTIC-PLASTIC\n" + LOADING
UNLOADING = "*GASKET THICKNESS BEHAVIOR, DIRECTION=UNLOADING\n0., .09, .09\n100., .12, .09\n"
STEP = "*STEP\n*STATIC\n*DLOAD\nUpper, P2, {}\n*END STEP\n"
TOP = '[[probes]]\nname = "u"\nquantity = "displacement_z"\nat = [1, 1, 2.1]\nbody = "Upper"\n'


class ImportOfGaskets(ImportTest):
    def closures(self, deck, *pressures):
        """Closures at the ends of the steps with these pressures."""
        shutil.rmtree(self.directory / "imported", ignore_errors=True)
        done = self.import_deck("gasket", deck + "".join(STEP.format(p) for p in pressures))
        rows = {row["time"]: row["u"] for row in self.run_imported("gasket", TOP)}
        return done, [-rows[i + 1] - 2 * p / 1e5 for i, p in enumerate(pressures)]

    def expect(self, deck, expected, *pressures):
        done, found = self.closures(deck, *pressures)
        for value, wanted in zip(found, expected):
            self.assertAlmostEqual(value, wanted, delta=1e-8)
        return done

    def test_loading_and_unloading(self):
        """Unloading from 0.04 lies a fifth of the way from the onset of yield, 0.02, to the curve that is given."""
        back = 0.006 + (2 / 3) / (19 / 15) * 0.034
        done = self.expect(CUBE + UPPER + BETWEEN + SECTION + BEHAVIOR + UNLOADING, (0.04, back, 0.04, 0.12), 50., 20., 50., 100.)
        self.assertSays(done.stdout, "*GASKET SECTION", "slide along the gasket")
        text = (self.directory / "imported/gasket.toml").read_text()
        self.assertIn("[gaskets.graphite]", text)
        self.assertIn("thickness = 0.1", text)

    def test_damage_returns_to_the_thickness_at_the_start(self):
        damage = "*GASKET THICKNESS BEHAVIOR, TYPE=DAMAGE, DIRECTION=UNLOADING\n20., .1, .12\n100., .12, .12\n"
        deck = CUBE + UPPER + BETWEEN + SECTION + BEHAVIOR.replace("ELASTIC-PLASTIC", "DAMAGE") + damage
        self.expect(deck, (0.12, 0.05), 100., 10.)

    def test_gaskets_held_by_ties_and_contacts(self):
        behavior = SECTION + BEHAVIOR + UNLOADING
        friction = "*SURFACE INTERACTION, NAME=rough\n*FRICTION\n0.3\n"
        pair = "*CONTACT PAIR, INTERACTION=rough\nAbove, Roof\n"
        nodes = "*SURFACE, NAME=Below, TYPE=NODE\n60\n61\n62\n63\n*NSET, NSET=above\n70, 71, 72, 73\n*SURFACE, NAME=Above, TYPE=NODE\nabove\n"
        for what, joints in (("ties", SIDES + "*TIE, NAME=a\nBelow, Floor\n*TIE, NAME=b\nRoof, Above\n"),
                             ("one card", SIDES + "*TIE, NAME=a\nBelow, Floor\nAbove, Roof\n"),
                             ("nodes", FACES + nodes + "*TIE, NAME=a\nBelow, Floor\n*TIE, NAME=b\nAbove, Roof\n"),
                             ("contact", SIDES + "*TIE, NAME=a\nBelow, Floor\n" + friction + pair)):
            with self.subTest(what):
                done = self.expect(CUBE + UPPER + APART + joints + behavior + "*BOUNDARY\n60, 1, 2\n", (0.04, 0.12), 50., 100.)
                self.assertSays(done.stdout, "supports of nodes of the gasket")
                self.assertEqual("friction = 0.3" in (self.directory / "imported/gasket.toml").read_text(), what == "contact")

    def test_thickness_gap_and_temperature(self):
        """The gap closes first; the void and the gap do not expand: 1e-3 x 0.07 x 100 of closure more."""
        section = SECTION + ", 0.01, 0.02\n"
        self.expect(CUBE + UPPER + BETWEEN + section + BEHAVIOR + UNLOADING, (0.05,), 50.)
        heated = BEHAVIOR + UNLOADING + "*EXPANSION\n1e-3,\n*NSET, NSET=All, GENERATE\n1, 17\n*INITIAL CONDITIONS, TYPE=TEMPERATURE\nAll, 20.\n"
        deck = CUBE + UPPER + BETWEEN + section + heated
        self.import_deck("heated", deck + STEP.format(50.).replace("*END", "*TEMPERATURE\nAll, 120.\n*END"))
        row = self.run_imported("heated", TOP)[-1]
        self.assertAlmostEqual(-row["u"] - 0.001, 0.05 - 0.007, delta=1e-8)
        self.assertIn("thickness = 0.07", (self.directory / "imported/heated.toml").read_text())

    def test_curves_over_the_temperature(self):
        soft = "0., 0., 120.\n5., .01, 120.\n15., .02, 120.\n25., .04, 120.\n50., .12, 120.\n"
        loading = LOADING.replace("\n", ", 20.\n")
        behavior = "*GASKET BEHAVIOR, NAME=graphite\n*GASKET THICKNESS BEHAVIOR\n" + loading + soft + \
            "*GASKET THICKNESS BEHAVIOR, DIRECTION=UNLOADING\n0., .09, .09, 20.\n100., .12, .09, 20.\n0., .09, .09, 120.\n50., .12, .09, 120.\n" \
            "*NSET, NSET=All, GENERATE\n1, 17\n*INITIAL CONDITIONS, TYPE=TEMPERATURE\nAll, 70.\n"
        # Halfway between the curves 37.5 belongs to 0.04.
        self.expect(CUBE + UPPER + BETWEEN + SECTION + behavior, (0.04,), 37.5)

    def test_creep_of_a_gasket(self):
        """1e-6 p^2 per time and thickness 0.1 at 50."""
        deck = CUBE + UPPER + BETWEEN + SECTION + BEHAVIOR + UNLOADING + "*CREEP\n1e-6, 2., 0.\n"
        self.import_deck("gasket", deck + STEP.format(50.) + STEP.format(50.).replace("*STATIC", "*VISCO, CETOL=1e-4\n0.1, 1."))
        row = self.run_imported("gasket", TOP)[-1]
        self.assertAlmostEqual(-row["u"] - 0.001, 0.04 + 0.1 * 1e-6 * 50**2, delta=1e-7)

    def test_parts_and_rings(self):
        """An axisymmetric gasket in a part, its nodes those of both bodies."""
        part = ("*PART, NAME=P\n*NODE\n1, 10, 0\n2, 11, 0\n3, 11, 1\n4, 10, 1\n5, 10, 1.1\n6, 11, 1.1\n7, 11, 2.1\n8, 10, 2.1\n"
                "*ELEMENT, TYPE=CAX4, ELSET=Lower\n1, 1, 2, 3, 4\n*ELEMENT, TYPE=CAX4, ELSET=Upper\n2, 5, 6, 7, 8\n"
                "*ELEMENT, TYPE=GKAX4N, ELSET=Gasket\n3, 4, 3, 6, 5\n*SOLID SECTION, ELSET=Lower, MATERIAL=Steel\n"
                "*SOLID SECTION, ELSET=Upper, MATERIAL=Steel\n" + SECTION + "*END PART\n"
                "*ASSEMBLY, NAME=A\n*INSTANCE, NAME=I, PART=P\n*END INSTANCE\n*END ASSEMBLY\n*MATERIAL, NAME=Steel\n*ELASTIC\n1e5, 0.\n")
        deck = part + BEHAVIOR + UNLOADING + "*NSET, NSET=foot, INSTANCE=I\n1, 2\n*ELSET, ELSET=roof, INSTANCE=I\n2\n*BOUNDARY\nfoot, 2\n"
        self.import_deck("ring", deck + "*STEP\n*STATIC\n*DLOAD\nroof, P3, 50.\n*END STEP\n")
        row = self.run_imported("ring", '[[probes]]\nname = "u"\nquantity = "displacement_y"\nat = [11, 2.1, 0]\n')[-1]
        self.assertAlmostEqual(-row["u"], 0.041, delta=1e-7)

    def test_what_is_not_possible(self):
        body = CUBE + UPPER
        good = SECTION + BEHAVIOR + UNLOADING
        both = SIDES + "*TIE, NAME=a\nBelow, Floor\n*TIE, NAME=b\nAbove, Roof\n"
        wide = body.replace("1, 1, 1\n", "2, 2, 1\n").replace("6, 1, 0, 1\n", "6, 2, 0, 1\n").replace("8, 0, 1, 1\n", "8, 0, 2, 1\n") + APART + both
        wide = wide.replace("11, 1, 0, 1.1", "11, 2, 0, 1.1").replace("12, 1, 1, 1.1", "12, 2, 2, 1.1").replace("13, 0, 1, 1.1", "13, 0, 2, 1.1")
        for deck, *facts in ((body + BETWEEN + SECTION + BEHAVIOR, "*GASKET THICKNESS BEHAVIOR", "UNLOADING", "decides the pressure"),
                             (body + BETWEEN, "element 50", "*GASKET SECTION"),
                             (body + APART + good, "no body lies below", "SNEG"),
                             (body + BETWEEN + SECTION, "no *GASKET BEHAVIOR 'GRAPHITE'"),
                             (body + BETWEEN + SECTION.replace("BEHAVIOR", "MATERIAL") + BEHAVIOR, "MATERIAL", "*GASKET BEHAVIOR is"),
                             (body + BETWEEN + good.replace("ELASTIC-PLASTIC", "ELASTIC-PLASTIC, VARIABLE=FORCE"), "VARIABLE", "STRESS"),
                             (body + BETWEEN + good.replace("50., .04", "30., .04"), "increase"),
                             (body + BETWEEN + SECTION + ", .06, .05\n" + BEHAVIOR + UNLOADING, "void", "not positive"),
                             (body + OWN_NODES + "*ELEMENT, TYPE=GK3D8, ELSET=Gasket\n50, 60, 61, 62, 63, 70, 71, 72\n" + good, "7 of its 8 nodes"),
                             (wide + good, "the area 1", "4", "press where it is not"),
                             (body + BETWEEN.replace("50, 5,", "50, 99,") + good, "node 99")):
            with self.subTest(facts[0]):
                self.assertSays(self.import_deck("wrong", deck + STEP.format(50.), 2).stderr, "wrong.inp:", *facts)


if __name__ == "__main__":
    unittest.main()
