"""Parameters and cards of decks that change the answer: taken with the right values, or refused."""

import re
import subprocess
import unittest

from process_case import PROGRAM
from test_import import CUBE, ImportTest
from waiting import LONGEST


class ImportOfCards(ImportTest):
    def blocks(self, between, step):
        """Two cubes on each other: Foot, of the upper one, and Top."""
        above = "*NODE\n" + "".join(f"{n + 10}, {x}, {y}, {z + 1}\n" for n, (x, y, z) in enumerate(
            [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]))
        return (CUBE + above + "*ELEMENT, TYPE=C3D8, ELSET=Above\n2, 10, 11, 12, 13, 14, 15, 16, 17\n*SOLID SECTION, ELSET=Above, MATERIAL=steel\n"
                "*NSET, NSET=lid, GENERATE\n14, 17\n*SURFACE, NAME=Foot\nAbove, S1\n*SURFACE, NAME=Top\nCube, S2\n*BOUNDARY\n10, 1, 2\n13, 1\n11, 2\n"
                f"14, 1, 2\n17, 1\n15, 2\n{between}*STEP\n*STATIC\n1., 1.\n{step}*NODE PRINT, NSET=lid\nU, RF\n*END STEP\n")

    def test_tied_pairs(self):
        pair = "*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I, TIED{}\nFoot, Top\n"
        lifted = "*BOUNDARY\nlid, 3, 3, 0.002\n"
        self.import_deck("tied", self.blocks(pair.format(", ADJUST=0.01"), lifted))
        self.expect_close(self.run_imported("tied")[-1]["rfz_lid"], 100, 1e-8)
        apart = self.blocks(pair.format(", ADJUST=0.01"), lifted)
        apart = re.sub(r"(?m)^(1\d), (\d), (\d), (\d)$", r"\1, \2, \3, \4.5", apart)
        self.assertSays(self.import_deck("apart", apart, 2).stderr, "apart.inp:", "'Foot'", "ADJUST=0.01", "'Top'")

    def test_general_contact_of_named_surfaces(self):
        interaction = "*SURFACE INTERACTION, NAME=I\n*FRICTION\n0.25\n*CONTACT\n"
        pressed = "*DLOAD\nAbove, P2, 50.\n"
        named = "*CONTACT INCLUSIONS\nFoot, Top\n*CONTACT PROPERTY ASSIGNMENT\n, , I\n"
        self.import_deck("named", self.blocks(interaction + named, pressed))
        text = (self.directory / "imported/named.toml").read_text()
        self.assertIn('between = ["Foot", "Top"]', text)
        self.assertIn("friction = 0.25", text)
        self.expect_close(self.run_imported("named")[-1]["uz_node_14"], -0.001, 1e-8)
        self.assertSays(self.import_deck("none", self.blocks(interaction, pressed), 2).stderr, "none.inp:", "*CONTACT: ", "*CONTACT INCLUSIONS")

    def test_surfaces_of_nodes_and_of_faces_with_one_name(self):
        surfaces = ["*SURFACE, NAME=Top\nCube, S2\n", "*SURFACE, NAME=Top, TYPE=NODE\ntop\n"]
        deck = CUBE + "*NSET, NSET=top, GENERATE\n5, 8\n{}*STEP\n*STATIC\n*DSLOAD\nTop, P, -100.\n*NODE PRINT, NSET=top\nU\n*END STEP\n"
        for name, order in (("faces_first", surfaces), ("nodes_first", surfaces[::-1])):
            done = self.import_deck(name, deck.format("".join(order)))
            self.assertSays(done.stdout, "*SURFACE: 'Top'", "the faces are taken")
            self.expect_close(self.run_imported(name)[-1]["uz_node_7"], 0.001, 1e-8)

    def test_pairs_that_repeat(self):
        pair = "*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I\nFoot, Top\nFoot, Top\n*CONTACT PAIR, INTERACTION=I\nTop, Foot\n"
        done = self.import_deck("twice", self.blocks(pair, "*DLOAD\nAbove, P2, 50.\n"))
        self.assertEqual(len(re.findall(r"twice\.inp:\d+: \*CONTACT PAIR: ", done.stdout)), 2, done.stdout)
        other = pair + "*SURFACE INTERACTION, NAME=J\n*CONTACT PAIR, INTERACTION=J\nFoot, Top\n"
        self.assertSays(self.import_deck("other", self.blocks(other, "*DLOAD\nAbove, P2, 50.\n"), 2).stderr, "other.inp:", "*CONTACT PAIR: ", "another")

    def test_adjust_moves_the_nodes_that_it_reaches(self):
        """The foot is inclined: two of its nodes begin 0.01 above, two 0.3."""
        pair = "*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I, ADJUST={}\nFoot, Top\n"
        deck = self.blocks(pair, "*DLOAD\nAbove, P2, 1.\n").replace("\n10, 0, 0, 1\n", "\n10, 0, 0, 1.01\n").replace(
            "\n13, 0, 1, 1\n", "\n13, 0, 1, 1.01\n").replace("\n11, 1, 0, 1\n", "\n11, 1, 0, 1.3\n").replace("\n12, 1, 1, 1\n", "\n12, 1, 1, 1.3\n")
        held = deck.replace("*BOUNDARY\n10", "*BOUNDARY\nlid, 3\n10")
        self.import_deck("moved", held.replace("*DLOAD\nAbove, P2, 1.", "*BOUNDARY\nlid, 3, 3, -0.001").format(0.02))
        self.assertIn('gap = "geometric"            # ADJUST has moved 2 of 4 nodes', (self.directory / "imported/moved.toml").read_text())
        self.assertGreater(-self.run_imported("moved")[-1]["rfz_lid"], 1)  # it touches at once
        self.import_deck("kept", held.replace("*DLOAD\nAbove, P2, 1.", "*BOUNDARY\nlid, 3, 3, -0.001").format(0.001))
        self.assertAlmostEqual(self.run_imported("kept")[-1]["rfz_lid"], 0, delta=1e-6)
        self.import_deck("all", held.format(0.5))
        self.assertIn("gap = 0", (self.directory / "imported/all.toml").read_text())

    def test_loads_of_one_step_add_up(self):
        """As in CalculiX; those of the next step replace them."""
        top = "*NSET, NSET=top, GENERATE\n5, 8\n"
        self.import_deck("added", CUBE + top + "*STEP\n*STATIC\n*CLOAD\ntop, 3, 10.\n*CLOAD\ntop, 3, 15.\n*DLOAD\nCube, P2, -50.\nCube, P2, -50.\n"
                         "*NODE PRINT, NSET=Nall\nU\n*END STEP\n*STEP\n*STATIC\n*CLOAD\ntop, 3, 5.\n*DLOAD\nCube, P2, -30.\n*END STEP\n")
        rows = self.run_imported("added")
        self.expect_close(rows[1]["uz_node_7"], 0.002, 1e-8)
        self.expect_close(rows[2]["uz_node_7"], 0.0005, 1e-8)
        twice = "*AMPLITUDE, NAME=A\n0, 0, 1, 1\n*STEP\n*STATIC\n*CLOAD\ntop, 3, 10.\n*CLOAD, AMPLITUDE=A\ntop, 3, 15.\n*END STEP\n"
        self.assertSays(self.import_deck("twice", CUBE + top + twice, 2).stderr, "twice.inp:", "*CLOAD: ", "two loads")

    def test_ramps_of_steps_and_shifted_amplitudes(self):
        """AMPLITUDE=RAMP and STEP at *STEP count for this step alone."""
        creep = CUBE.replace("*SOLID", "*CREEP\n1e-9, 3, 0\n*SOLID")
        load = "*DLOAD{}\nCube, P2, -{}.\n*NODE PRINT, NSET=Nall\nU\n*END STEP\n"
        self.import_deck("ramp", creep + "*STEP, AMPLITUDE=RAMP\n*VISCO\n1, 10\n" + load.format("", 100) + "*STEP\n*VISCO\n1, 10\n" + load.format("", 200))
        self.assertIn("pressure = { t = [0, 10, 10, 20], values = [0, -100, -200, -200] }", (self.directory / "imported/ramp.toml").read_text())
        strain = 1e-9 * 100**3 * 10 / 4 + 1e-9 * 200**3 * 10
        self.expect_close(self.run_imported("ramp")[-1]["uz_node_7"], 0.002 + strain, 1e-4)
        self.import_deck("step", CUBE + "*STEP, AMPLITUDE=STEP\n*STATIC\n1, 2\n" + load.format("", 100) + "*STEP\n*STATIC\n1, 2\n" + load.format("", 200))
        self.assertIn("values = [-100, -100, -200]", (self.directory / "imported/step.toml").read_text())
        self.import_deck("shifted", CUBE + "*AMPLITUDE, NAME=A, SHIFTX=0.5, SHIFTY=1\n0, 0, 1, 1\n*STEP\n*STATIC\n1, 1\n" + load.format(", AMPLITUDE=A", 100))
        self.expect_close(self.run_imported("shifted")[-1]["uz_node_7"], 0.0015, 1e-8)
        self.import_deck("jump", CUBE + "*AMPLITUDE, NAME=A\n0, 0, 1, 1, 1, 3, 2, 3\n*STEP\n*STATIC\n1, 2\n" + load.format(", AMPLITUDE=A", 100))
        self.assertIn("{ t = [0, 1, 1, 2], values = [0, -100, -300, -300] }", (self.directory / "imported/jump.toml").read_text())

    def test_without_visco_steps_nothing_creeps(self):
        deck = CUBE.replace("*SOLID", "*CREEP\n1e-9, 3, 0\n*SOLID") + "*NSET, NSET=top, GENERATE\n5, 8\n*STEP\n*STATIC\n1., 1000.\n"
        done = self.import_deck("static", deck + "*BOUNDARY\ntop, 3, 3, 0.002\n*EL PRINT, ELSET=Cube\nS\n*END STEP\n")
        self.assertSays(done.stdout, "static.inp:", "*CREEP: ", "*STATIC")
        self.expect_close(self.run_imported("static")[-1]["stress_zz_element_1"], 200, 1e-8)

    def test_a_bolt_held_after_its_force_is_gone(self):
        bar = CUBE.replace("*BOUNDARY\n", "*NODE\n9, 0, 0, 2\n10, 1, 0, 2\n11, 1, 1, 2\n12, 0, 1, 2\n100, 0, 0, 0\n*ELEMENT, "
                           "TYPE=C3D8, ELSET=Cube\n2, 5, 6, 7, 8, 9, 10, 11, 12\n*NSET, NSET=ends\n1, 2, 3, 4, 9, 10, 11, 12\n"
                           "*SURFACE, NAME=Cut\n1, S2\n*PRE-TENSION SECTION, SURFACE=Cut, NODE=100\n0, 0, 1\n*BOUNDARY\nends, 3\n"
                           "9, 1\n12, 1\n9, 2\n10, 2\n").replace("*SOLID", "*CREEP\n1e-9, 3, 0\n*SOLID")
        pulled = "*STEP\n*STATIC\n*CLOAD\n100, 1, 300.\n*END STEP\n*STEP\n*STATIC\n*BOUNDARY, FIXED\n100, 1\n*CLOAD, OP=NEW\n*END STEP\n"
        crept = "*STEP\n*VISCO\n0.1, 10.\n{}*EL PRINT, ELSET=Cube\nS\n*END STEP\n"
        self.import_deck("held", bar + pulled + crept.format(""))
        self.expect_close(self.run_imported("held")[-1]["stress_zz_element_1"], (300**-2 + 2 * 1e5 * 1e-9 * 10) ** -0.5, 1e-4)
        freed = "*BOUNDARY, OP=NEW\nends, 3\nx0, 1\ny0, 2\n"
        self.assertSays(self.import_deck("freed", bar + pulled + crept.format(freed), 2).stderr, "freed.inp:", "*BOUNDARY: ", "OP=NEW", "bolt")

    def test_nodes_on_the_axis_of_their_directions(self):
        turned = "*NSET, NSET=Axis\n1, 5\n*TRANSFORM, NSET=Nall, TYPE=C\n0, 0, 0, 0, 0, 1\n"
        step = "*STEP\n*STATIC\n*DLOAD\nCube, P2, -100.\n{}*NODE PRINT, NSET=Nall\nU\n*END STEP\n"
        free = CUBE.replace("x0, 1\ny0, 2\nz0, 3\n", "z0, 1, 3\n")
        self.import_deck("held", free + turned + step.format(""))
        self.expect_close(self.run_imported("held")[-1]["uz_node_7"], 0.001, 1e-8)
        for name, card in (("support", "*BOUNDARY\n5, 1\n"), ("force", "*CLOAD\n5, 1, 3.\n")):
            done = self.import_deck(name, free + turned + step.format(card), 2)
            self.assertSays(done.stderr, f"{name}.inp:", "*TRANSFORM: ", name, "node 5", "axis")

    def test_what_a_run_would_refuse_is_refused(self):
        step = "*STEP\n*STATIC\n*DLOAD\nCube, P2, -100.\n*END STEP\n"
        for name, deck, fact in (("soft", CUBE.replace("1e5, 0.", "-1e5, 0."), "young_modulus"),
                                 ("loose", CUBE.replace("z0, 3\n", ""), "translation along z")):
            done = self.import_deck(name, deck + step, 2)
            self.assertSays(done.stderr, fact, "--no-check")
            self.assertFalse((self.directory / "imported").exists())
        self.assertIn("(made of " + str(self.directory / "soft.inp") + ":22", self.import_deck("soft", CUBE.replace("1e5, 0.", "-1e5, 0.") + step, 2).stderr)
        done = subprocess.run([PROGRAM, "import", "loose.inp", "--no-check"], cwd=self.directory, capture_output=True, text=True, timeout=LONGEST)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("not checked", done.stdout)
        self.assertTrue((self.directory / "loose.toml").exists())
        self.assertEqual(list(self.directory.glob(".import_*")), [])

    def test_names_that_are_not_ascii(self):
        deck = CUBE.replace("Steel", "St\xe4hl \\").replace("ELSET=Cube", "ELSET=W\xfcrfel").replace("\nCube", "\nW\xfcrfel")
        path = self.directory / "latin.inp"
        path.write_bytes((deck + "*STEP\n*STATIC\n*DLOAD\nW\xfcrfel, P2, -100.\n*NODE PRINT, NSET=Nall\nU\n*END STEP\n").encode("latin-1"))
        done = subprocess.run([PROGRAM, "import", str(path), "--output", str(self.directory / "imported")], capture_output=True, text=True, timeout=LONGEST)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("[bodies.\"W\xfcrfel\"]", (self.directory / "imported/latin.toml").read_text())
        self.expect_close(self.run_imported("latin")[-1]["uz_node_7"], 0.001, 1e-8)

    def test_decks_that_ended_by_a_signal(self):
        nodes = "*NODE\n" + "".join(f"{n}\n" for n in range(1, 13))
        second = "*ELEMENT, TYPE=C3D8\n2, 5, 6, 7, 8, 9, 10, 11, 12\n"
        step = "*STEP\n*STATIC\n*NODE PRINT, NSET=n\nU\n*END STEP\n"
        done = self.import_deck("section", nodes + second + "*NSET, NSET=n\n9\n*MATERIAL, NAME=M\n" + step, 2)
        self.assertSays(done.stderr, "section.inp:14: *ELEMENT: element 2", "*SOLID SECTION")
        done = self.import_deck("material", nodes + second.replace("C3D8", "C3D8, ELSET=E") + "*SOLID SECTION, ELSET=E, MATERIAL=M2\n"
                                "*STEP\n*STATIC\n*DLOAD\nE, GRAV, 9810\n*END STEP\n", 2)
        self.assertSays(done.stderr, "material.inp:", "*SOLID SECTION: ", "'M2'")
        part = "*PART, NAME=P\n*NODE\n{}, 0, 0, 0\n*END PART\n*INSTANCE, NAME=A, PART=P\n*END INSTANCE\n*INSTANCE, NAME=B, PART=P\n*END INSTANCE\n"
        self.assertSays(self.import_deck("numbers", part.format(9007199254740993), 2).stderr, "numbers.inp:", "*NODE: ", "'9007199254740993'")
        for rows in ("1e5, 0., 100.\n9e4, 0., 20.", "1e5, 0., 100.\n9e4, 0., 100."):
            done = self.import_deck("table", CUBE.replace("1e5, 0.", rows) + step.replace("n\nU", "Nall\nU"), 2)
            self.assertSays(done.stderr, "table.inp:", "*ELASTIC: ", "temperatures")


if __name__ == "__main__":
    unittest.main()
