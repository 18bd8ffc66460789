"""Bolts of decks: what holds them, what acts while they are held, and what is printed at their reference nodes."""

import unittest

from test_import import CUBE, ImportTest

# A bar of two cubes between walls, cut in the middle.
BAR = CUBE.replace("*BOUNDARY\n", "*NODE, NSET=Nall\n9, 0, 0, 2\n10, 1, 0, 2\n11, 1, 1, 2\n12, 0, 1, 2\n*NODE, NSET=Ref\n100, 0, 0, 0\n*ELEMENT, "
                   "TYPE=C3D8, ELSET=Cube\n2, 5, 6, 7, 8, 9, 10, 11, 12\n*NSET, NSET=ends\n1, 2, 3, 4, 9, 10, 11, 12\n"
                   "*SURFACE, NAME=Cut\n1, S2\n*PRE-TENSION SECTION, SURFACE=Cut, NODE=Ref\n0, 0, 1\n*BOUNDARY\nends, 3\n"
                   "9, 1\n12, 1\n9, 2\n10, 2\n").replace("*SOLID", "*CREEP\n1e-9, 3, 0\n*SOLID")
TIGHTENED = "*STEP\n*STATIC\n*CLOAD\nRef, 1, 300.\n{}*END STEP\n"
HELD = "*STEP\n*{}\n0.1, 10.\n*CLOAD, OP=NEW\n*BOUNDARY, FIXED\nRef, 1\n{}*NODE PRINT, NSET=Ref\nU, RF\n*END STEP\n"


def relaxed(stress, modulus):
    return (stress**-2 + 2 * modulus * 1e-9 * 10) ** -0.5  # of s' = -E A s^3


class ImportOfBolts(ImportTest):
    def test_held_in_creep(self):
        self.import_deck("held", BAR + TIGHTENED.format("") + HELD.format("VISCO", ""))
        rows = self.run_imported("held")
        self.expect_close(rows[0]["rf1_node_100"], 300, 1e-8)
        self.expect_close(rows[-1]["rf1_node_100"], relaxed(300, 1e5), 1e-4)
        for row in rows:
            self.expect_close(row["u1_node_100"], 0.006, 1e-8)

    def test_held_while_it_warms_up(self):
        """The modulus halves: so does the force, at the length that 300 has given the bolt before."""
        warm = BAR.replace("1e5, 0.\n", "1e5, 0., 20.\n5e4, 0., 220.\n") + "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nNall, 20.\n"
        self.import_deck("warm", warm + TIGHTENED.format("") + HELD.format("VISCO", "*TEMPERATURE\nNall, 220.\n"))
        rows = self.run_imported("warm")
        self.expect_close(rows[0]["rf1_node_100"], 300, 1e-8)
        self.expect_close(rows[-1]["rf1_node_100"], relaxed(150, 5e4), 1e-4)

    def test_a_deck_without_creep(self):
        """It is tight at the end of the step that tightens it, whatever else acts in this step."""
        pushed = "*CLOAD\n5, 3, {0}\n6, 3, {0}\n7, 3, {0}\n8, 3, {0}\n"
        for name, other, force in (("alone", "", 350), ("with", pushed.format(10), 330)):
            self.import_deck(name, BAR + TIGHTENED.format(other) + HELD.format("STATIC", pushed.format(25)).replace("*CLOAD, OP=NEW\n", "*CLOAD\nRef, 1, 0.\n"))
            rows = self.run_imported(name)
            self.expect_close(rows[1]["rf1_node_100"], 300, 1e-7)
            self.expect_close(abs(rows[-1]["rf1_node_100"] - 300), abs(force - 300), 1e-6)

    def test_other_loads_before_it_is_held(self):
        between = "*STEP\n*STATIC\n*CLOAD\n5, 1, 10.\n*END STEP\n"
        done = self.import_deck("late", BAR + TIGHTENED.format("") + between + HELD.format("STATIC", ""), 2)
        self.assertSays(done.stderr, "late.inp:", "*BOUNDARY: other loads come between the tightening")
        creeping = "*STEP\n*VISCO\n0.1, 1.\n*END STEP\n"
        done = self.import_deck("crept", BAR + TIGHTENED.format("") + creeping + HELD.format("VISCO", ""), 2)
        self.assertSays(done.stderr, "crept.inp:", "*BOUNDARY: the bolt is held after a step that takes time")

    def test_what_is_printed_at_nodes_without_elements(self):
        self.import_deck("force", BAR + TIGHTENED.format("*NODE PRINT, NSET=Ref\nU\n"))
        self.expect_close(self.run_imported("force")[-1]["u1_node_100"], 0.006, 1e-8)
        equation = "*NODE\n100, 0, 0, 5\n*NSET, NSET=top, GENERATE\n5, 8\n*EQUATION\n2\ntop, 3, 1., 100, 3, -1.\n*NSET, NSET=Ref\n100\n"
        done = self.import_deck("other", CUBE + equation + "*STEP\n*STATIC\n*CLOAD\n100, 3, 50.\n*NODE PRINT, NSET=Ref\nU, RF\n*NODE PRINT, NSET=None\nU\n"
                                "*NODE PRINT, NSET=top\nU\n*END STEP\n")
        self.assertSays(done.stdout, "other.inp:", "*NODE PRINT: U of node 100: no probe", "RF of node 100", "there is no node set 'None'")
        self.expect_close(self.run_imported("other")[-1]["uz_node_7"], 0.0005, 1e-8)


if __name__ == "__main__":
    unittest.main()
