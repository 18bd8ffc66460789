"""Decks that compute temperatures: closed forms, steps one after the other, and what is refused."""

import math
import unittest

from test_import import CUBE, EXAMPLES, ImportTest, deck_text, position_of_node

STEADY = "*STEP\n*HEAT TRANSFER, STEADY STATE\n{}*NODE PRINT, NSET=Nall\nNT\n*END STEP\n"
MATERIAL = "*MATERIAL, NAME=M\n*CONDUCTIVITY\n{}\n*SOLID SECTION, ELSET=E, MATERIAL=M\n"


def bar(kind="DC3D8", n=4, length=1.0):
    """A bar along x with a cross-section of 1: its elements are E, its ends the nodes Left and Right."""
    nodes = [f"{4 * i + k + 1}, {length * i / n}, {y}, {z}" for i in range(n + 1) for k, (y, z) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1)))]
    cells = [f"{i + 1}, " + ", ".join(str(4 * i + k) for k in range(1, 9)) for i in range(n)]
    last = 4 * n
    return ("*NODE, NSET=Nall\n" + "\n".join(nodes) + f"\n*ELEMENT, TYPE={kind}, ELSET=E\n" + "\n".join(cells) +
            f"\n*NSET, NSET=Left\n1, 2, 3, 4\n*NSET, NSET=Right\n{last + 1}, {last + 2}, {last + 3}, {last + 4}\n")


def strip(kind, a, b, n=4):
    """A section from x = a to b, one element high, of eight nodes each. Face 4 of the first and 2 of the last are its ends."""
    xs = [a + (b - a) * i / (2 * n) for i in range(2 * n + 1)]
    number = {(i, j): 3 * i + j + 1 for i in range(2 * n + 1) for j in range(3)}
    nodes = [f"{number[i, j]}, {x}, {j / 2}" for i, x in enumerate(xs) for j in range(3) if i % 2 == 0 or j != 1]
    cells = []
    for e in range(n):
        i = 2 * e
        around = [(i, 0), (i + 2, 0), (i + 2, 2), (i, 2), (i + 1, 0), (i + 2, 1), (i + 1, 2), (i, 1)]
        cells.append(f"{e + 1}, " + ", ".join(str(number[place]) for place in around))
    return "*NODE, NSET=Nall\n" + "\n".join(nodes) + f"\n*ELEMENT, TYPE={kind}, ELSET=E\n" + "\n".join(cells) + "\n"


class ImportOfHeat(ImportTest):
    def toml(self, name):
        return (self.directory / "imported" / f"{name}.toml").read_text()

    def temperatures(self, name, deck):
        """Rows of the temperatures that the deck prints."""
        self.import_deck(name, deck)
        return self.run_imported(name)

    def test_films_on_both_sides_of_a_slab(self):
        """L 0.03, k 40, h 1000 at 550 and 200 at 50: faces of 475.925926 and 420.370370."""
        slab = bar(length=0.03) + MATERIAL.format("40.")
        films = ("*FILM\n1, F1, 550., 1000.\n4, F2, 50., 200.\n",
                 "*SURFACE, NAME=In\n1, S1\n*SURFACE, NAME=Out\n4, S2\n|*SFILM\nIn, F, 550., 1000.\nOut, F, 50., 200.\n")
        for number, text in enumerate(films):
            surfaces, _, loads = text.rpartition("|")
            rows = self.temperatures(f"slab{number}", slab + surfaces + STEADY.format(loads))
            self.assertEqual([row["time"] for row in rows], [0])
            self.expect_close(rows[0]["nt_node_1"], 475.925926, 1e-8)
            self.expect_close(rows[0]["nt_node_20"], 420.370370, 1e-8)
        text = self.toml("slab0")
        self.assertIn("alone = true", text)
        self.assertIn("fluid = 550", text)
        self.assertNotIn("young_modulus", text)

    def test_flows_and_sources_in_a_bar(self):
        """Heat of 30 through an end, of 6 per volume in a half, and of 4 times 2 at the nodes: they leave at the other end."""
        deck = (bar() + "*ELSET, ELSET=Half\n3, 4\n" + MATERIAL.format("10.") +
                STEADY.format("*BOUNDARY\nLeft, 11, 11, 20.\n*DFLUX\n4, S2, 30.\nHalf, BF, 6.\n*CFLUX\nRight, 11, 2.\n"))
        row = self.temperatures("flows", deck)[0]
        at_end = 20 + (30 + 8) / 10 + 6 * (0.5 * 0.5 + 0.5 * 0.25) / 10  # the source flows through the left half, and out of its own
        self.expect_close(row["nt_node_17"], at_end, 1e-9)
        text = self.toml("flows")
        self.assertIn('point_flows = [{ on = "Right", value = 2 }]', text)
        self.assertIn('[bodies.Half]', text)

    def test_sums_of_one_step(self):
        """In one step fluxes add up, films and radiation are replaced, as in CalculiX."""
        deck = bar() + MATERIAL.format("10.")
        loads = "*BOUNDARY\nLeft, 11, 11, 0.\n*DFLUX\n4, S2, 30.\n4, S2, 20.\n"
        self.expect_close(self.temperatures("fluxes", deck + STEADY.format(loads))[0]["nt_node_17"], 5, 1e-9)
        loads = "*BOUNDARY\nLeft, 11, 11, 0.\n*FILM\n4, F2, 100., 10.\n*FILM\n4, F2, 60., 10.\n"
        self.expect_close(self.temperatures("films", deck + STEADY.format(loads))[0]["nt_node_17"], 30, 1e-9)

    def test_conductivity_over_the_temperature(self):
        """k = 50 (1 - 6e-4 T) between 500 and 0: 228.110292 in the middle (Kirchhoff)."""
        deck = bar("C3D8", 40) + MATERIAL.format("50., 0.\n20., 1000.") + STEADY.format("*BOUNDARY\nLeft, 11, 11, 500.\nRight, 0, 0, 0.\n")
        self.import_deck("kirchhoff", deck)
        row = self.run_imported("kirchhoff", '[[probes]]\nname = "T"\nquantity = "temperature"\nat = [0.5, 0, 0]\n')[0]
        self.expect_close(row["T"], 228.110292, 1e-4)

    def test_cylinders_of_axisymmetric_elements(self):
        """Films 2000 at 560 inside and 50 at 30 outside, k 30: 537.26346 and 484.73088; and 1000 through nodes of the inside."""
        for kind in ("CAX8", "DCAX8"):
            deck = strip(kind, 0.05, 0.1, 8) + MATERIAL.format("30.")
            row = self.temperatures(kind, deck + STEADY.format("*FILM\n1, F4, 560., 2000.\n8, F2, 30., 50.\n"))[0]
            self.expect_close(row["nt_node_1"], 537.26346, 1e-6)
        # The force, and so the flow, at a node is that of the full circumference.
        deck = strip("CAX8", 0.05, 0.1, 8) + MATERIAL.format("30.") + "*NSET, NSET=Outside\n49, 50, 51\n"
        loads = "*BOUNDARY\nOutside, 11, 11, 0.\n*CFLUX\n1, 11, {0}\n2, 11, {1}\n3, 11, {0}\n".format(1000 / 6, 4000 / 6)
        row = self.temperatures("nodes", deck + STEADY.format(loads))[0]
        self.expect_close(row["nt_node_1"], 1000 * math.log(2) / (2 * math.pi * 30), 1e-4)

    def test_radiation_to_the_surroundings(self):
        """A half plate of 0.02 with a source of 2e6 radiates to 20 C: 697.90788 C at its surface."""
        deck = (bar(length=0.02) + MATERIAL.format("25.") +
                "*PHYSICAL CONSTANTS, ABSOLUTE ZERO=-273.15, STEFAN BOLTZMANN=5.670374e-8\n" +
                STEADY.format("*DFLUX\nE, BF, 2e6\n*RADIATE\n4, R2, 20., 0.8\n"))
        row = self.temperatures("plate", deck)[0]
        self.expect_close(row["nt_node_20"], 697.90788, 1e-7)
        self.assertSays(self.import_deck("units", deck.replace(", STEFAN BOLTZMANN=5.670374e-8", ""), status=2).stderr,
                        "*RADIATE", "STEFAN BOLTZMANN")

    def transient(self, loads, steps, capacity="1000.", density="0.01"):
        """A bar of small resistance: all of it has one temperature."""
        deck = (bar(n=1) + "*MATERIAL, NAME=M\n*CONDUCTIVITY\n1e5\n*SPECIFIC HEAT\n" + capacity + "\n*DENSITY\n" + density +
                "\n*SOLID SECTION, ELSET=E, MATERIAL=M\n*INITIAL CONDITIONS, TYPE=TEMPERATURE\nNall, 20.\n" + loads)
        for length, inside in steps:
            deck += f"*STEP\n*HEAT TRANSFER\n0.01, {length}\n{inside}*NODE PRINT, NSET=Nall\nNT\n*END STEP\n"
        return deck

    def test_steps_follow_each_other(self):
        """A film at 120 for one time constant, 10, then insulated with a flux of 5, which the third step takes away."""
        deck = self.transient("", [(10., "*FILM\n1, F1, 120., 1.\n"), (4., "*FILM, OP=NEW\n*DFLUX\n1, S2, 5.\n"), (2., "*DFLUX, OP=NEW\n")])
        rows = {row["time"]: row["nt_node_1"] for row in self.temperatures("steps", deck)}
        first = 120 - 100 * math.exp(-1)
        for time, expected in ((10, first), (14, first + 2), (16, first + 2)):
            self.assertAlmostEqual(rows[time], expected, delta=0.02)
        self.assertIn("time_unit = 1", self.toml("steps"))

    def test_amplitudes_of_films_and_temperatures(self):
        """Amplitudes of step time and of total time, of the fluid and of the coefficient."""
        amplitudes = "*AMPLITUDE, NAME=A\n0., 0., 2., 1.\n*AMPLITUDE, NAME=T, TIME=TOTAL TIME\n0., 0., 4., 1.\n"
        deck = self.transient(amplitudes, [(2., "*FILM, AMPLITUDE=T, FILM AMPLITUDE=A\n1, F1, 100., 7.\n"), (2., "")])
        self.import_deck("film", deck)
        self.assertIn("coefficient = { t = [0, 2, 4], values = [0, 7, 7] }, fluid = { t = [0, 2, 4], values = [0, 50, 100] }", self.toml("film"))
        deck = self.transient(amplitudes, [(2., "*BOUNDARY, AMPLITUDE=T\nLeft, 11, 11, 200.\n"), (2., "")])
        rows = {row["time"]: row["nt_node_1"] for row in self.temperatures("boundary", deck)}
        self.assertAlmostEqual(rows[2], 100, delta=1e-6)
        self.assertAlmostEqual(rows[4], 200, delta=1e-6)

    def test_a_transient_from_a_steady_state(self):
        deck = self.transient("", [(10., "*FILM\n1, F1, 20., 1.\n")])
        steady = "*STEP\n*HEAT TRANSFER, STEADY STATE\n*FILM\n1, F1, 120., 1.\n*END STEP\n"
        done = self.import_deck("cooling", deck.replace("*STEP", steady + "*STEP", 1))
        self.assertSays(done.stdout, "steady state takes 1e-05 of time")
        rows = self.run_imported("cooling")
        self.assertAlmostEqual(rows[0]["nt_node_1"], 120, delta=1e-3)
        self.assertAlmostEqual(rows[-1]["nt_node_1"], 20 + 100 * math.exp(-1), delta=0.02)

    def test_initial_temperatures_along_a_coordinate(self):
        """An insulated bar whose halves are at 0 and 100 has 50 in the end."""
        deck = (bar() + "*NSET, NSET=Hot\n13, 14, 15, 16, 17, 18, 19, 20\n*NSET, NSET=Warm\n9, 10, 11, 12\n" + MATERIAL.format("10.").replace(
            "*SOLID", "*SPECIFIC HEAT\n1.\n*DENSITY\n1.\n*SOLID") + "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nHot, 100.\nWarm, 50.\n"
            "*STEP\n*HEAT TRANSFER\n0.01, 2.\n*NODE PRINT, NSET=Nall\nNT\n*END STEP\n")
        rows = self.temperatures("halves", deck)
        self.assertEqual([rows[0][f"nt_node_{n}"] for n in (1, 9, 17)], [0, 50, 100])
        self.assertAlmostEqual(rows[-1]["nt_node_1"], 50, delta=0.02)
        odd = deck.replace("Hot, 100.", "Hot, 100.\n1, 3.\n6, 4.")
        self.assertSays(self.import_deck("odd", odd, status=2).stderr, "*INITIAL CONDITIONS", "more than one of x, y and z")

    def test_heat_across_contacts_and_ties(self):
        """Two bars of 1 with k 10 between 300 and 0: in series with 1/h, or without."""
        second = "".join(f"{100 + 4 * i + k}, {1 + i}, {y}, {z}\n" for i in (0, 1) for k, (y, z) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1))))
        model = (bar(n=1) + "*NODE, NSET=Nall\n" + second + "*ELEMENT, TYPE=DC3D8, ELSET=F\n9, " + ", ".join(str(n) for n in range(100, 108)) +
                 "\n*SURFACE, NAME=A\n1, S2\n*SURFACE, NAME=B\n9, S1\n*NSET, NSET=End\n104, 105, 106, 107\n" +
                 MATERIAL.format("10.") + "*SOLID SECTION, ELSET=F, MATERIAL=M\n")
        loads = STEADY.format("*BOUNDARY\nLeft, 11, 11, 300.\nEnd, 11, 11, 0.\n")
        pair = "*SURFACE INTERACTION, NAME=I\n{}*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nB, A\n"
        equal = "*EQUATION\n" + "".join(f"2\n{100 + k}, 11, 1., {5 + k}, 11, -1.\n" for k in range(4))
        for name, joint, expected in (("gap", pair.format("*GAP CONDUCTANCE\n10.\n"), (200, 100)),
                                      ("warm", pair.format("*GAP CONDUCTANCE\n5., 0., 0.\n15., 0., 300.\n"), (200, 100)),
                                      ("none", pair.format(""), (300, 0)), ("tie", "*TIE, NAME=T\nB, A\n", (150, 150)),
                                      ("equal", equal, (150, 150))):
            with self.subTest(name):
                row = self.temperatures(name, model + joint + loads)[0]
                self.assertAlmostEqual(row["nt_node_5"], expected[0], delta=1e-3)
                if "nt_node_100" in row:
                    self.assertAlmostEqual(row["nt_node_100"], expected[1], delta=1e-3)
        self.assertIn('conductance = "insulated"', self.toml("none"))
        apart = equal.replace(" 5, 11", " 1, 11", 1)
        self.assertSays(self.import_deck("apart", model + apart + loads, status=2).stderr, "*EQUATION", "*TIE")

    def test_conductance_over_the_pressure(self):
        """It needs displacements, and stays a function of the pressure."""
        upper = "".join(f"{11 + i}, {x}, {y}, {1 + z}\n" for z in (0, 1) for i, (x, y) in ((4 * z + k, at) for k, at in enumerate(((0, 0), (1, 0), (1, 1), (0, 1)))))
        heat = "*CONDUCTIVITY\n10.\n*SPECIFIC HEAT\n1.\n*DENSITY\n1e-3\n*SOLID"
        deck = (CUBE.replace("*SOLID", heat) + "*NODE\n" + upper + "*ELEMENT, TYPE=C3D8, ELSET=Upper\n2, " + ", ".join(str(n) for n in range(11, 19)) +
                "\n*SOLID SECTION, ELSET=Upper, MATERIAL=Steel\n*BOUNDARY\n11, 1, 2\n14, 1\n12, 2\n*SURFACE, NAME=A\nCube, S2\n*SURFACE, NAME=B\nUpper, S1\n"
                "*SURFACE INTERACTION, NAME=I\n*GAP CONDUCTANCE\n5., 0.\n15., 30.\n*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nB, A\n"
                "*STEP\n*COUPLED TEMPERATURE-DISPLACEMENT\n0.1, 1.\n*BOUNDARY\nz0, 11, 11, 120.\n*DLOAD\nUpper, P2, 30.\n*END STEP\n")
        done = self.import_deck("pressure", deck)
        self.assertSays(done.stdout, "*GAP CONDUCTANCE", "pressure", "'gap'")
        self.assertIn("conductance = { p = [0, 30], values = [5, 15] }", self.toml("pressure"))
        self.assertNotIn("'gap'", self.import_deck("given", deck.replace("*GAP CONDUCTANCE", "*GAP CONDUCTANCE, PRESSURE")).stdout)
        alone = deck.replace("COUPLED TEMPERATURE-DISPLACEMENT", "HEAT TRANSFER")
        self.assertSays(self.import_deck("alone", alone, status=2).stderr, "*GAP CONDUCTANCE", "displacements")

    def test_temperatures_with_displacements(self):
        """A cube that warms up by 100 grows by 1e-5 per degree; a later *STATIC step loads it."""
        cube = CUBE.replace("*SOLID", "*EXPANSION\n1e-5\n*CONDUCTIVITY\n10.\n*SPECIFIC HEAT\n1.\n*DENSITY\n1e-3\n*SOLID")
        cube += "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nNall, 20.\n"
        inside = "*BOUNDARY\nz0, 11, 11, 120.\n*NODE PRINT, NSET=Nall\nU, NT\n*END STEP\n"
        static = "*STEP\n*STATIC\n*DLOAD\nCube, P2, -100.\n*END STEP\n"
        for name, procedure in (("coupled", "*COUPLED TEMPERATURE-DISPLACEMENT\n0.1, 1."), ("heat", "*HEAT TRANSFER\n0.1, 1."),
                                ("steady", "*UNCOUPLED TEMPERATURE-DISPLACEMENT, STEADY STATE")):
            with self.subTest(name):
                self.import_deck(name, cube + "*STEP\n" + procedure + "\n" + inside + static)
                self.assertNotIn("alone", self.toml(name))
                rows = self.run_imported(name)
                at_one = min(rows, key=lambda row: abs(row["time"] - 1))
                self.assertAlmostEqual(at_one["nt_node_7"], 120, delta=1e-2)
                self.assertAlmostEqual(at_one["uz_node_7"], 0.001, delta=1e-7)
                self.assertAlmostEqual(rows[-1]["uz_node_7"], 0.002, delta=1e-7)

    def test_what_is_refused_says_why(self):
        deck = bar() + MATERIAL.format("10.")
        held = "*BOUNDARY\nLeft, 11, 11, 20.\n"

        def refuse(text, *facts):
            self.assertSays(self.import_deck("refused", text, status=2).stderr, *facts)

        refuse(deck + STEADY.format("*RADIATE\n1, R1CR, 20., 0.8\n"), "*RADIATE", "between surfaces (CR)")
        refuse(deck + STEADY.format("*FILM\n1, F1FC, 20., 0.8\n"), "*FILM", "fluid that flows")
        refuse(deck + STEADY.format("*FILM\n1, F1NU\n"), "*FILM", "users")
        refuse(deck + STEADY.format("*FILM\n1, P1, 20., 0.8\n"), "*FILM", "'P1'", "F1 to F6")
        refuse(deck + STEADY.format("*CFLUX\n1, 3, 2.\n"), "*CFLUX", "'3'", "11")
        refuse(deck + STEADY.format("*BOUNDARY\n1, 8, 8, 2.\n"), "*BOUNDARY", "8", "11")
        refuse(deck + STEADY.format(held).replace(", STEADY STATE", "\n0.1, 1."), "*MATERIAL", "*SPECIFIC HEAT")
        refuse(deck.replace("*CONDUCTIVITY\n10.\n", "*DENSITY\n1.\n") + STEADY.format(held), "*MATERIAL", "*CONDUCTIVITY")
        refuse(deck + STEADY.format(held) + STEADY.format("*FILM\n1, F1, 20., 0.8\n"), "*STEP", "a steady state after another one")
        refuse(deck.replace("*SOLID", "*LATENT HEAT\n1., 2., 3.\n*SOLID") + STEADY.format(held), "*LATENT HEAT", "*SPECIFIC HEAT")
        refuse(deck + STEADY.format(held).replace("STEADY STATE", "FREQUENCY"), "*HEAT TRANSFER", "FREQUENCY")
        refuse(self.transient("", [(1., held), (1., "*BOUNDARY, OP=NEW\n")]), "*BOUNDARY", "in some steps only")
        refuse(deck + "*STEP\n*STATIC\n*END STEP\n" + STEADY.format(held), "DC3D8", "no displacements")

    def test_decks_without_steps_of_heat(self):
        """Data of heat do not act there: a line says it."""
        deck = CUBE.replace("*SOLID", "*CONDUCTIVITY\n10.\n*LATENT HEAT\n1., 2., 3.\n*SOLID")
        done = self.import_deck("static", deck + "*STEP\n*STATIC\n*DLOAD\nCube, P2, -1.\n*FILM\nCube, F1, 20., 1.\n*END STEP\n")
        self.assertSays(done.stdout, "*CONDUCTIVITY: it does not act", "*LATENT HEAT: it does not act", "*FILM: it does not act")
        self.assertNotIn("[heat]", self.toml("static"))

    def test_mechanics_that_no_step_computes_is_left_out(self):
        deck = bar("C3D8") + MATERIAL.format("10.").replace("*SOLID", "*ELASTIC\n1e5, 0.3\n*SOLID") + "*BOUNDARY\nLeft, 1, 3\n"
        done = self.import_deck("alone", deck + STEADY.format("*BOUNDARY\nLeft, 11, 11, 20.\n*DLOAD\n1, P1, 3.\n"))
        self.assertSays(done.stdout, "*STEP", "*BOUNDARY, *DLOAD, *ELASTIC")
        for key in ("supports", "loads", "young_modulus"):
            self.assertNotIn(key, self.toml("alone"))


@unittest.skipUnless(EXAMPLES.exists(), "needs the Debian package calculix-ccx-test")
class HeatOfCalculix(ImportTest):
    def test_temperatures(self):
        """Values of the .dat.ref files, at nodes at the end of the last step."""
        for name, node, body, value, relative in (
                ("beamhtbf", 5, "LAST", 217.0, 1e-6),
                ("beamhtbo", 40, None, 68.0, 1e-6),
                ("beamth", 40, None, 59.99717, 1e-4),
                ("dam", 545, None, 6.275709, 1e-5),
                ("oneel20cf", 1, None, -2.4, 1e-6),
                ("oneel20df", 1, None, -2.0, 1e-6),
                ("oneel20fi", 1, None, -2.0, 1e-6),
                ("oneel20rs", 1, None, -2.0, 1e-6),
                ("oneel8ra", 3, None, -0.9507386, 1e-6)):
            with self.subTest(name):
                text = deck_text(name)
                self.import_deck(name, text)
                of_body = f'body = "{body}"\n' if body else ""
                probe = f'[[probes]]\nname = "T"\nquantity = "temperature"\nat = {position_of_node(text, node)}\n'
                self.expect_close(self.run_imported(name, probe + of_body)[-1]["T"], value, relative)


if __name__ == "__main__":
    unittest.main()
