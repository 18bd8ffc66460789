"""Contacts of decks that are not named pair by pair, or that come and go."""

import re
import unittest

from test_import import CUBE, EXAMPLES, ImportTest, deck_text, position_of_node

INTERACTION = "*SURFACE INTERACTION, NAME=I\n*FRICTION\n0.25\n*SURFACE INTERACTION, NAME=Smooth\n"
EVERYWHERE = INTERACTION + "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n"
PRESSED = "*DLOAD\nAbove, P2, 50.\n"


def block(first, z, number, name, height=1):
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, height), (1, 0, height), (1, 1, height), (0, 1, height)]
    return ("*NODE\n" + "".join(f"{first + i}, {x}, {y}, {z + dz}\n" for i, (x, y, dz) in enumerate(corners)) +
            f"*ELEMENT, TYPE=C3D8, ELSET={name}\n{number}, " + ", ".join(str(first + i) for i in range(8)) +
            f"\n*SOLID SECTION, ELSET={name}, MATERIAL=steel\n*BOUNDARY\n{first}, 1, 2\n{first + 3}, 1\n{first + 1}, 2\n"
            f"{first + 4}, 1, 2\n{first + 7}, 1\n{first + 5}, 2\n")


class ImportOfContacts(ImportTest):
    def blocks(self, between, step, z=1.0):
        """Two cubes on each other: Foot, of the upper one, and Top."""
        return (CUBE + block(10, z, 2, "Above") + "*NSET, NSET=lid, GENERATE\n14, 17\n*SURFACE, NAME=Foot\nAbove, S1\n*SURFACE, NAME=Top\nCube, S2\n"
                f"*SURFACE, NAME=Both\nAbove, S1\nCube, S2\n{between}*STEP\n*STATIC\n1., 1.\n{step}*NODE PRINT, NSET=lid\nU, RF\n*END STEP\n")

    def toml(self, name):
        return (self.directory / f"imported/{name}.toml").read_text()

    def test_all_exterior_surfaces(self):
        done = self.import_deck("all", self.blocks(EVERYWHERE + "*CONTACT PROPERTY ASSIGNMENT\n, , I\n", PRESSED))
        self.assertSays(done.stdout, "found: ", "all.inp:", "*CONTACT INCLUSIONS: contact 'Cube_face-Above_face' of 1 with 1 faces; distance in the mesh 0",
                        "left out: ", "contact of a body with itself")
        self.assertEqual(self.toml("all").count("[[contacts]]"), 1)
        self.assertIn("friction = 0.25", self.toml("all"))
        self.expect_close(self.run_imported("all")[-1]["uz_node_14"], -0.001, 1e-8)

    def test_surfaces_that_are_apart_or_overlap(self):
        """0.01 apart, closed and pressed by 0.002; overlapping by 0.001, which Abaqus takes back without strain."""
        moved = "*BOUNDARY\nlid, 3, 3, {}\n"
        for name, z, displacement in (("apart", 1.01, -0.012), ("overlap", 0.999, -0.002)):
            self.import_deck(name, self.blocks(EVERYWHERE, moved.format(displacement), z))
            self.assertIn(f"gap = {max(z - 1, 0):.3g} ", self.toml(name))
            self.expect_close(self.run_imported(name)[-1]["rfz_lid"], -100, 1e-8)
        self.import_deck("inclined", self.blocks(EVERYWHERE, moved.format(-0.01)).replace("\n10, 0, 0, 1.0\n", "\n10, 0, 0, 1.01\n"))
        self.assertIn('gap = "geometric"', self.toml("inclined"))
        done = self.import_deck("far", self.blocks(EVERYWHERE, moved.format(-0.01), 1.1))
        self.assertSays(done.stdout, "far.inp:", "there is no contact", "*CONTACT PAIR")

    def test_exclusions(self):
        moved = "*BOUNDARY\nlid, 3, 3, -0.002\n"
        for name, line, force in (("pair", "Foot, Top", 0), ("turned", "Top, Foot", 0), ("one", ", Top", 0), ("itself", "Both,", 0),
                                  ("other", "Top,", -100)):
            self.import_deck(name, self.blocks(EVERYWHERE + f"*CONTACT EXCLUSIONS\n{line}\n", moved))
            self.assertAlmostEqual(self.run_imported(name)[-1]["rfz_lid"], force, delta=1e-6)
        named = INTERACTION + "*CONTACT\n*CONTACT INCLUSIONS\nFoot, Top\n*CONTACT EXCLUSIONS\n{}\n"
        done = self.import_deck("named", self.blocks(named.format("Top, Foot"), moved))
        self.assertSays(done.stdout, "*CONTACT INCLUSIONS: the pair of 'Foot' and 'Top', which *CONTACT EXCLUSIONS takes out")
        wide = "*SURFACE, NAME=Wide\nAbove, S1\nAbove, S3\n*CONTACT\n*CONTACT INCLUSIONS\nWide, Top\n*CONTACT EXCLUSIONS\nFoot, Top\n"
        done = self.import_deck("part", self.blocks(wide, moved), 2)
        self.assertSays(done.stderr, "*CONTACT EXCLUSIONS: it takes out a part of the pair of 'Wide' and 'Top'")
        done = self.import_deck("missing", self.blocks(EVERYWHERE + "*CONTACT EXCLUSIONS\nA, Top\nTop, A\n", moved), 2)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertSays(done.stderr, "*CONTACT EXCLUSIONS: there is no surface 'A'")

    def test_inclusions_of_one_surface(self):
        both = INTERACTION + "*CONTACT\n*CONTACT INCLUSIONS\nBoth,\n*CONTACT PROPERTY ASSIGNMENT\n, , I\nFoot, Top, Smooth\n"
        self.import_deck("both", self.blocks(both, PRESSED))
        self.assertNotIn("friction = 0.25", self.toml("both"))  # the last assignment counts
        self.expect_close(self.run_imported("both")[-1]["uz_node_14"], -0.001, 1e-8)
        done = self.import_deck("foot", self.blocks(both.replace("Both,", "Foot,"), "*BOUNDARY\nlid, 3\n"))
        self.assertSays(done.stdout, "foot.inp:", "there is no contact")

    def test_what_is_joined_already(self):
        for name, cards in (("tie", "*TIE, NAME=T\nFoot, Top\n"), ("pair", "*CONTACT PAIR, INTERACTION=I\nFoot, Top\n")):
            done = self.import_deck(name, self.blocks(EVERYWHERE + cards, PRESSED + "*CLOAD\n10, 3, 0.\n"))
            self.assertNotIn("found: ", done.stdout)
            self.assertEqual(self.toml(name).count("[[contacts]]"), 1)

    def test_a_thin_plate_between_two_others(self):
        """The outer ones, 0.01 apart, do not see each other."""
        deck = CUBE + block(10, 1, 2, "Thin", 0.01) + block(20, 1.01, 3, "Above") + EVERYWHERE + (
            "*STEP\n*STATIC\n1., 1.\n" + PRESSED + "*NSET, NSET=lid\n24\n*NODE PRINT, NSET=lid\nU\n*END STEP\n")
        done = self.import_deck("thin", deck)
        self.assertEqual(re.findall("contact '(.*?)'", done.stdout), ["Cube_face-Thin_face", "Thin_face_2-Above_face"])
        self.expect_close(self.run_imported("thin")[-1]["uz_node_24"], -0.001005, 1e-8)

    def test_rings(self):
        """A section: the bore of the outer ring and the inner one, not their ends. Distance 0.01."""
        n = 4
        nodes = "".join(f"{10 * r + i}, {x}, {0.25 * i}\n" for r, x in ((1, 1), (2, 2), (3, 2.01), (4, 3)) for i in range(n + 1))
        element = lambda r, i: f"{10 * r + i}, {10 * r + i}, {10 * r + i + 10}, {10 * r + i + 11}, {10 * r + i + 1}\n"
        deck = ("*NODE, NSET=Nall\n" + nodes + "*ELEMENT, TYPE=CAX4, ELSET=Inner\n" + "".join(element(1, i) for i in range(n)) +
                "*ELEMENT, TYPE=CAX4, ELSET=Outer\n" + "".join(element(3, i) for i in range(n)) + CUBE[CUBE.index("*MATERIAL"):].replace("=Cube", "=Inner") +
                "*SOLID SECTION, ELSET=Outer, MATERIAL=Steel\n*BOUNDARY\nNall, 2\n" + EVERYWHERE +
                "*STEP\n*STATIC\n*DLOAD\nInner, P4, 1000.\n*NODE PRINT, NSET=Nall\nU\n*END STEP\n")
        done = self.import_deck("rings", deck)
        self.assertSays(done.stdout, "contact 'Inner_face-Outer_face' of 4 with 4 faces; distance in the mesh 0.01")
        self.assertEqual(done.stdout.count("found: "), 1)

    def test_pairs_that_come_and_go(self):
        """The lid goes down by 0.001 and by 0.002; the pair is in the model in one of the two steps."""
        pair = "*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I\nFoot, Top\n"
        change = "*MODEL CHANGE, TYPE=CONTACT PAIR, {}\nFoot, Top\n"
        second = "*STEP\n*STATIC\n1., 1.\n{}*BOUNDARY\nlid, 3, 3, -0.002\n*END STEP\n"
        first = "*BOUNDARY\nlid, 3, 3, -0.001\n"
        self.import_deck("comes", self.blocks(pair, change.format("REMOVE") + first) + second.format(change.format("ADD")))
        self.assertIn("*MODEL CHANGE has removed the pair", self.toml("comes"))
        rows = self.run_imported("comes")
        self.assertAlmostEqual(rows[1]["rfz_lid"], 0, delta=1e-8)
        self.expect_close(rows[-1]["rfz_lid"], -100, 1e-8)
        self.import_deck("goes", self.blocks(pair, first) + second.format(change.format("REMOVE")))
        rows = self.run_imported("goes")
        self.expect_close(rows[1]["rfz_lid"], -50, 1e-7)
        self.assertAlmostEqual(rows[-1]["rfz_lid"], 0, delta=1e-8)
        self.import_deck("apart", self.blocks(pair, change.format("REMOVE") + first, 1.0005) + second.format(change.format("ADD")))
        self.expect_close(self.run_imported("apart")[-1]["rfz_lid"], -75, 1e-6)

    def test_changes_that_make_no_model(self):
        pair = "*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I{}\nFoot, Top\n"
        for name, parameters, card, fact in (("feet", "", "*MODEL CHANGE, TYPE=CONTACT PAIR, REMOVE\nFeet, Top\n", "no *CONTACT PAIR of 'FEET' and 'TOP'"),
                                             ("element", "", "*MODEL CHANGE, TYPE=ELEMENT, REMOVE\nAbove\n", "TYPE=ELEMENT"),
                                             ("type", "", "*MODEL CHANGE, REMOVE\nFoot, Top\n", "TYPE is missing"),
                                             ("neither", "", "*MODEL CHANGE, TYPE=CONTACT PAIR\nFoot, Top\n", "either REMOVE or ADD"),
                                             ("tied", ", TIED", "*MODEL CHANGE, TYPE=CONTACT PAIR, REMOVE\nFoot, Top\n", "tied pair")):
            done = self.import_deck(name, self.blocks(pair.format(parameters), card + PRESSED), 2)
            self.assertSays(done.stderr, f"{name}.inp:", fact)
        lost = self.blocks(pair.format(""), "*MODEL CHANGE, TYPE=CONTACT PAIR, REMOVE\nFoot, Top\n" + PRESSED).replace("*SURFACE, NAME=Top", "*SURFACE, NAME=Other")
        done = self.import_deck("lost", lost, 2)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertSays(done.stderr, "there is no surface 'Top'")
        inclined = self.blocks(pair.format(""), "*MODEL CHANGE, TYPE=CONTACT PAIR, REMOVE\nFoot, Top\n*BOUNDARY\nlid, 3\n").replace("\n10, 0, 0, 1.0\n", "\n10, 0, 0, 1.1\n")
        self.assertSays(self.import_deck("inclined", inclined, 2).stderr, "inclined.inp:", "not the same everywhere", "*CLEARANCE")

    @unittest.skipUnless(EXAMPLES.exists(), "needs the Debian package calculix-ccx-test")
    def test_a_removed_pair_of_calculix(self):
        """The deck is computed with large displacements there, up to 8 % of the length of a beam."""
        text = deck_text("contact2")
        self.import_deck("contact2", text)
        rows = self.run_imported("contact2", '[[probes]]\nname = "u"\nquantity = "displacement_y"\nat = {}\n'.format(position_of_node(text, 395)))
        for row, value in zip(rows[1:], (-2.296556e-1, -2.730896e-1, -2.959173e-1), strict=True):
            self.expect_close(row["u"], value, 0.015)


if __name__ == "__main__":
    unittest.main()
