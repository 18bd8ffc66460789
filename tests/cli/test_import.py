"""Decks of CalculiX and Abaqus become runs: exact answers of little decks, and values of CalculiX' own examples."""

import collections
import gzip
import math
import os
import pathlib
import re
import subprocess
import unittest

from process_case import PROGRAM
from test_runs import RunTest
from waiting import LONGEST

EXAMPLES = pathlib.Path("/usr/share/doc/calculix-ccx-test/examples/test")

CUBE = """*NODE, NSET=Nall
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
*ELEMENT, TYPE=C3D8R, ELSET=Cube
1, 1, 2, 3, 4, 5, 6, 7, 8
*NSET, NSET=x0
1, 4, 5, 8
*NSET, NSET=y0
1, 2, 5, 6
*NSET, NSET=z0
1, 2, 3, 4
*BOUNDARY
x0, 1
y0, 2
z0, 3
*MATERIAL, NAME=Steel
*ELASTIC
1e5, 0.
*SOLID SECTION, ELSET=Cube, MATERIAL=Steel
"""


def deck_text(name):
    path = EXAMPLES / f"{name}.inp"
    if path.exists():
        return path.read_text(errors="replace")
    return gzip.decompress((EXAMPLES / f"{name}.inp.gz").read_bytes()).decode(errors="replace")


def position_of_node(text, number):
    nodes = re.findall(r"(?ims)^\*node\s*(?:,[^\n]*)?\n(.*?)(?=^\*[^*])", text)
    line = next(line for block in nodes for line in block.splitlines() if line.split(",")[0].strip() == str(number))
    return [float(field) for field in (line.split(",") + ["0"])[1:4]]


class ImportTest(RunTest):
    def import_deck(self, name, text, status=0):
        deck = self.directory / f"{name}.inp"
        deck.write_text(text)
        done = subprocess.run([PROGRAM, "import", str(deck), "--output", str(self.directory / "imported")],
                              capture_output=True, text=True, timeout=LONGEST)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def run_imported(self, name, probes=""):
        path = self.directory / "imported" / f"{name}.toml"
        text = path.read_text()
        if probes:
            path.write_text(text[:(text + "\n[[probes]]").index("\n[[probes]]") + 1] + probes)
        done = subprocess.run([PROGRAM, "run", str(path), "--output", str(self.output)], cwd=self.directory,
                              capture_output=True, text=True, timeout=LONGEST)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.table("history.csv")

    def expect_close(self, value, reference, relative):
        self.assertAlmostEqual(value, reference, delta=relative * abs(reference))


class Import(ImportTest):
    def test_creep_in_visco_steps_alone(self):
        """100 MPa, then 200 MPa at once, which creep at 1e-6 q^2 for one unit of time."""
        done = self.import_deck("creep", CUBE.replace("*SOLID", "*CREEP\n1e-6, 2, 0\n*SOLID") +
                                "*STEP\n*STATIC\n*DLOAD\nCube, P2, -100.\n*END STEP\n"
                                "*STEP\n*VISCO, CETOL=1e-4\n0.1, 1.\n*DLOAD\nCube, P2, -200.\n"
                                "*NODE PRINT, NSET=Nall\nU\n*END STEP\n")
        self.assertEqual(done.stdout.splitlines(), [str(self.directory / "imported" / f"creep.{end}") for end in ("toml", "msh")])
        rows = self.run_imported("creep")
        self.assertEqual([row["time"] for row in rows], [0, 1])
        self.expect_close(rows[0]["uz_node_7"], 0.002, 1e-9)  # after the jump
        self.expect_close(rows[1]["uz_node_7"], 0.002 + 0.04, 1e-6)

    def test_time_of_a_hardening_law_includes_static_steps(self):
        self.import_deck("hardening", CUBE.replace("*SOLID", "*CREEP\n1e-6, 2, 1.\n*SOLID") +
                         "*STEP\n*STATIC\n*DLOAD\nCube, P2, -100.\n*END STEP\n*STEP\n*VISCO\n0.1, 2.\n"
                         "*NODE PRINT, NSET=Nall\nU\n*END STEP\n")
        # integral of 0.01 t from 1 to 3
        self.expect_close(self.run_imported("hardening")[-1]["uz_node_7"], 0.001 + 0.01 * (9 - 1) / 2, 1e-5)

    def test_loads_ramp_and_follow_amplitudes(self):
        self.import_deck("ramps", CUBE + "*AMPLITUDE, NAME=A, TIME=TOTAL TIME\n0, 0, 4, 2\n*STEP\n*STATIC\n1., 2.\n"
                         "*DLOAD\nCube, P2, -100.\n*CLOAD, AMPLITUDE=A\n6, 1, 10.\n*NODE PRINT, NSET=Nall\nU\n*END STEP\n"
                         "*STEP\n*STATIC\n1., 2.\n*DLOAD, OP=NEW\n*END STEP\n")
        text = (self.directory / "imported" / "ramps.toml").read_text()
        self.assertIn("pressure = { t = [0, 2, 4], values = [0, -100, 0] }", text)
        self.assertIn("force = [{ t = [0, 2, 4], values = [0, 10, 20] }, 0, 0]", text)
        rows = self.run_imported("ramps")
        self.assertEqual([row["time"] for row in rows], [0, 2, 4])
        self.assertAlmostEqual(sum(rows[1][f"uz_node_{n}"] for n in (5, 6, 7, 8)) / 4, 0.001, delta=1e-9)
        self.assertAlmostEqual(sum(rows[2][f"uz_node_{n}"] for n in (5, 6, 7, 8)) / 4, 0, delta=1e-9)

    def test_thermal_expansion_from_the_initial_temperature(self):
        """alpha(T)(T - ZERO) of the present temperature less that of the initial one."""
        self.import_deck("warm", CUBE.replace("*SOLID", "*EXPANSION, ZERO=20.\n1e-5, 0.\n3e-5, 200.\n*SOLID") +
                         "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nNall, 100.\n*STEP\n*STATIC\n*END STEP\n*STEP\n*STATIC\n"
                         "*TEMPERATURE\nNall, 200.\n*NODE PRINT, NSET=Nall\nU\n*END STEP\n")
        rows = self.run_imported("warm")
        self.assertAlmostEqual(rows[1]["ux_node_7"], 0, delta=1e-12)
        self.expect_close(rows[2]["ux_node_7"], 3e-5 * 180 - 2e-5 * 80, 1e-6)

    def test_initial_temperatures_that_differ_from_node_to_node(self):
        """All of it at 100 at the end: strains of the differences, a gradient along z."""
        deck = CUBE.replace("*SOLID", "*EXPANSION, ZERO=20.\n1e-5\n*SOLID") + (
            "*NSET, NSET=top, GENERATE\n5, 8\n*INITIAL CONDITIONS, TYPE=TEMPERATURE\nz0, 20.\ntop, 60.\n*STEP\n*STATIC\n*TEMPERATURE\n"
            "Nall, 100.\n*NODE PRINT, NSET=Nall\nU\n*END STEP\n")
        self.import_deck("initial", deck)
        row = self.run_imported("initial")[-1]
        self.expect_close(row["uz_node_7"], 60e-5, 0.2)  # of the mean difference, 80 to 40; the cube bends
        self.assertIn("# Differences from the initial", (self.directory / "imported/initial.toml").read_text())
        varying = deck.replace("1e-5\n*SOLID", "1e-5, 0\n2e-5, 100\n*SOLID")
        self.assertSays(self.import_deck("varying", varying, 2).stderr, "varying.inp:", "'Steel'", "initial temperatures")

    def test_temperatures_that_differ_from_node_to_node(self):
        self.import_deck("gradient", CUBE.replace("*SOLID", "*EXPANSION\n1e-5\n*SOLID") +
                         "*NSET, NSET=top, GENERATE\n5, 8\n*STEP\n*STATIC\n*TEMPERATURE\ntop, 100.\n"
                         "*NODE PRINT, NSET=Nall\nU\n*END STEP\n")
        self.assertTrue((self.directory / "imported" / "gradient_temperature.csv").exists())
        probe = '[[probes]]\nname = "T"\nquantity = "temperature"\nbody = "Cube"\nreduce = "max"\n'
        rows = self.run_imported("gradient", probe)
        self.assertAlmostEqual(rows[0]["T"], 0)
        self.expect_close(rows[1]["T"], 50 * (1 + 3**-0.5), 1e-9)  # at the integration points

    def test_contact_with_friction_and_ties(self):
        """A second cube on the first one, pressed; its nodes do not match by number, but in place."""
        above = "*NODE\n" + "".join(f"{n + 10}, {x}, {y}, {z + 1}\n" for n, (x, y, z) in enumerate(
            [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]))
        text = (CUBE + above + "*ELEMENT, TYPE=C3D8, ELSET=Above\n2, 10, 11, 12, 13, 14, 15, 16, 17\n"
                "*SOLID SECTION, ELSET=Above, MATERIAL=steel\n*NSET, NSET=foot\n10, 11, 12, 13\n"
                "*SURFACE, NAME=Foot, TYPE=NODE\nfoot\n*SURFACE, NAME=Top\nCube, S2\n"
                "*BOUNDARY\n10, 1, 2\n13, 1\n{}*STEP\n*STATIC\n*DLOAD\nAbove, P2, 50.\n*END STEP\n")
        contact = "*CONTACT PAIR, INTERACTION=I\nFoot, Top\n*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE={}\n1e7,\n*FRICTION\n0.2, 1e6\n"
        probe = '[[probes]]\nname = "u"\nquantity = "displacement_z"\nat = [1, 1, 2]\nbody = "Above"\n'
        hard = self.import_deck("linear", text.format(contact.format("LINEAR")))
        self.assertSays(hard.stdout, "*SURFACE BEHAVIOR: LINEAR: ")
        self.assertIn("friction = 0.2", (self.directory / "imported" / "linear.toml").read_text())
        self.expect_close(self.run_imported("linear", probe)[-1]["u"], -0.001, 1e-8)
        loaded = text.replace("*DLOAD", "*CLOAD\n10, 3, 0.\n*DLOAD")  # a force on a slave node: it stays one of its own
        self.import_deck("tie", loaded.format("*TIE, NAME=T, POSITION TOLERANCE=0.1\nFoot, Top\n"))
        self.assertIn('type = "tied"', (self.directory / "imported" / "tie.toml").read_text())
        self.expect_close(self.run_imported("tie", probe)[-1]["u"], -0.001, 1e-8)

    def test_creep_laws_of_abaqus(self):
        """100 at once for four units of time: in closed form."""
        for law, line, strain in (("TIME", "1e-6, 2, -0.5", 1e-6 * 100**2 * 4**0.5 / 0.5),
                                  ("STRAIN", "1e-6, 2, -0.5", 1e-6 * 100**2 * 4**0.5 / 0.5),
                                  ("HYPERB", "1e-4, 0.01, 3, 0, 8.3", 4 * 1e-4 * math.sinh(1) ** 3)):
            self.import_deck(law, CUBE.replace("*SOLID", f"*CREEP, LAW={law}\n{line}\n*SOLID") + "*STEP\n*VISCO\n1, 4\n*DLOAD\n"
                             "Cube, P2, -100.\n*NODE PRINT, NSET=Nall\nU\n*END STEP\n")
            self.expect_close(self.run_imported(law)[-1]["uz_node_7"], 0.001 + strain, 1e-4)

    def test_pressure_on_surfaces(self):
        self.import_deck("dsload", CUBE + "*SURFACE, NAME=Top\nCube, S2\n*STEP\n*STATIC\n*DSLOAD\nTop, P, -100.\n"
                         "*NODE PRINT, NSET=Nall\nU, RF\n*EL PRINT, ELSET=Cube\nS\n*END STEP\n")
        row = self.run_imported("dsload")[-1]
        self.expect_close(row["uz_node_7"], 0.001, 1e-8)
        self.expect_close(row["rfz_Nall"], -100, 1e-8)
        self.expect_close(row["stress_zz_element_1"], 100, 1e-8)

    def test_equations_with_a_reference_node(self):
        """Force and displacement of a node without elements, which the four nodes at the top follow."""
        equations = "*NODE\n100, 0, 0, 5\n*NSET, NSET=top, GENERATE\n5, 8\n*EQUATION\n2\ntop, 3, 1., 100, 3, -1.\n"
        step = "*STEP\n*STATIC\n{}*NODE PRINT, NSET=Nall\nU\n*END STEP\n"
        self.import_deck("force", CUBE + equations + step.format("*CLOAD\n100, 3, 50.\n"))
        self.expect_close(self.run_imported("force")[-1]["uz_node_7"], 0.0005, 1e-8)
        self.import_deck("motion", CUBE + equations + step.format("*BOUNDARY\n100, 3, 3, 0.002\n"))
        row = self.run_imported("motion")[-1]
        for node in (5, 6, 7, 8):
            self.expect_close(row[f"uz_node_{node}"], 0.002, 1e-10)
        self.import_deck("plane", CUBE + "*NSET, NSET=top, GENERATE\n5, 8\n*MPC\nPLANE, top\n" +
                         step.format("*CLOAD\n7, 3, 100.\n"))
        row = self.run_imported("plane")[-1]
        self.assertAlmostEqual(row["uz_node_5"] + row["uz_node_7"], row["uz_node_6"] + row["uz_node_8"], delta=1e-12)
        self.assertGreater(row["uz_node_7"], 2 * abs(row["uz_node_6"]))

    def test_contradicting_equations(self):
        done = self.import_deck("contradiction", CUBE + "*NODE\n100, 0, 0, 5\n*EQUATION\n2\n1, 3, 1., 100, 3, -1.\n*STEP\n*STATIC\n"
                         "*BOUNDARY\n100, 3, 3, 0.1\n*DLOAD\nCube, P2, 1.\n*END STEP\n", 2)
        self.assertSays(done.stderr, "equations[0]: ", "t = 1", "0.1", "contradiction.inp:28: *EQUATION")

    def test_turned_directions(self):
        """Twisting by tangential forces about the diagonal; the inclined support of a corner."""
        transform = "*NSET, NSET=turned\n7\n*TRANSFORM, NSET=turned, TYPE={}\n{}\n"
        step = "*STEP\n*STATIC\n{}*NODE PRINT, NSET=Nall\nU\n*END STEP\n"
        self.import_deck("cylindrical", CUBE + transform.format("C", "0, 0, 0, 0, 0, 1") + step.format("*CLOAD\n7, 1, 10.\n"))
        self.assertIn("force = [{ t = [0, 1], values = [0, 7.0710678", (self.directory / "imported/cylindrical.toml").read_text())
        row = self.run_imported("cylindrical")[-1]
        self.expect_close(row["ux_node_7"], row["uy_node_7"], 1e-9)
        for kind, points in (("C", "0, 0, 0, 0, 0, 1"), ("R", "1, 1, 0, -1, 1, 0")):
            self.import_deck(f"held_{kind}", CUBE + transform.format(kind, points) +
                             step.format("*BOUNDARY\n7, 2, 2, 0.1\n7, 1, 1, 0.2\n"))
            row = self.run_imported(f"held_{kind}")[-1]
            self.expect_close(row["ux_node_7"], 0.1 / 2**0.5, 1e-9)
            self.expect_close(row["uy_node_7"], 0.3 / 2**0.5, 1e-9)

    def test_a_bolt_by_force_by_length_and_locked(self):
        """A bar of two cubes between walls, cut in the middle."""
        bar = CUBE.replace("*BOUNDARY\n", "*NODE\n9, 0, 0, 2\n10, 1, 0, 2\n11, 1, 1, 2\n12, 0, 1, 2\n100, 0, 0, 0\n*ELEMENT, "
                           "TYPE=C3D8, ELSET=Cube\n2, 5, 6, 7, 8, 9, 10, 11, 12\n*NSET, NSET=ends\n1, 2, 3, 4, 9, 10, 11, 12\n"
                           "*SURFACE, NAME=Cut\n1, S2\n*PRE-TENSION SECTION, SURFACE=Cut, NODE=100\n0, 0, 1\n*BOUNDARY\nends, 3\n"
                           "9, 1\n12, 1\n9, 2\n10, 2\n")
        prints = "*NODE PRINT, NSET=Nall\nU\n*EL PRINT, ELSET=Cube\nS\n"
        self.import_deck("force", bar + f"*STEP\n*STATIC\n*CLOAD\n100, 1, 300.\n{prints}*END STEP\n")
        row = self.run_imported("force")[-1]
        for element in (1, 2):
            self.expect_close(row[f"stress_zz_element_{element}"], 300, 1e-8)
        self.expect_close(row["uz_node_7"], -0.003, 1e-8)  # that of the upper part, as in CalculiX
        self.import_deck("length", bar + f"*STEP\n*STATIC\n*BOUNDARY\n100, 1, 1, 0.004\n{prints}*END STEP\n")
        self.expect_close(self.run_imported("length")[-1]["stress_zz_element_1"], 0.002 * 1e5, 1e-8)
        locked = bar.replace("*SOLID", "*CREEP\n1e-9, 3, 0\n*SOLID")
        self.import_deck("locked", locked + f"*STEP\n*STATIC\n*CLOAD\n100, 1, 300.\n*END STEP\n*STEP\n*VISCO\n0.1, 10.\n"
                         f"*BOUNDARY, FIXED\n100, 1\n{prints}*END STEP\n")
        self.assertIn("preload = { force = 300 }", (self.directory / "imported" / "locked.toml").read_text())
        rows = self.run_imported("locked")
        self.expect_close(rows[0]["stress_zz_element_1"], 300, 1e-8)
        relaxed = (300**-2 + 2 * 1e5 * 1e-9 * 10) ** -0.5  # of s' = -E A s^3
        self.expect_close(rows[-1]["stress_zz_element_1"], relaxed, 1e-4)

    def test_supports_of_some_steps(self):
        """Stretched by 0.001, released, and pulled; with creep it keeps what has crept while it was stretched."""
        held = "*BOUNDARY, OP=NEW\nx0, 1\ny0, 2\nz0, 3\n"
        prints = "*NODE PRINT, NSET=Nall\nU\n*EL PRINT, ELSET=Cube\nS\n*END STEP\n"
        top = "*BOUNDARY\n5, 3, 3, 0.001\n6, 3, 3, 0.001\n7, 3, 3, 0.001\n8, 3, 3, 0.001\n"
        pulled = "*DLOAD\nCube, P2, -50.\n"
        self.import_deck("elastic", CUBE + f"*STEP\n*STATIC\n{top}{prints}*STEP\n*STATIC\n{held}{pulled}{prints}"
                         f"*STEP\n*STATIC\n{top}{prints}")
        self.assertIn("until = 1", (self.directory / "imported/elastic.toml").read_text())
        rows = self.run_imported("elastic")
        for row, u, s in zip(rows[1:], (0.001, 0.0005, 0.001), (100, 50, 100), strict=True):
            self.expect_close(row["uz_node_7"], u, 1e-7)
            self.expect_close(row["stress_zz_element_1"], s, 1e-7)
        self.import_deck("creep", CUBE.replace("*SOLID", "*CREEP\n1e-9, 3, 0\n*SOLID") + f"*STEP\n*VISCO\n1, 10\n{top}{prints}"
                         f"*STEP\n*VISCO\n1, 10\n{held}{prints}")
        rows = self.run_imported("creep")
        relaxed = (100**-2 + 2 * 1e5 * 1e-9 * 10) ** -0.5  # of s' = -E A s^3
        self.expect_close(rows[-2]["stress_zz_element_1"], relaxed, 1e-4)
        self.assertAlmostEqual(rows[-1]["stress_zz_element_1"], 0, delta=1e-6)
        self.expect_close(rows[-1]["uz_node_7"], 0.001 - relaxed / 1e5, 1e-4)

    def test_held_where_it_is(self):
        """It creeps under a load and is then held where it is: the stress relaxes, whatever becomes of the load."""
        top = "*NSET, NSET=top, GENERATE\n5, 8\n"
        self.import_deck("held", CUBE.replace("*SOLID", "*CREEP\n1e-9, 3, 0\n*SOLID") + top + "*STEP\n*VISCO\n1, 10\n*DLOAD\nCube, P2, -100.\n*END STEP\n"
                         "*STEP\n*VISCO\n1, 10\n*DLOAD, OP=NEW\n*BOUNDARY, FIXED\ntop, 3\n*NODE PRINT, NSET=Nall\nU\n*EL PRINT, ELSET=Cube\nS\n*END STEP\n")
        self.assertIn("relative = true", (self.directory / "imported/held.toml").read_text())
        rows = self.run_imported("held")
        self.expect_close(rows[-1]["uz_node_7"], 0.011, 1e-5)
        self.expect_close(rows[-1]["stress_zz_element_1"], (100**-2 + 2 * 1e5 * 1e-9 * 10) ** -0.5, 1e-4)
        # Resumed after the begin of the support, it knows what was reached then.
        for options in (["--set", "time.end=15", "--set", "time.output=[15]"], ["--resume"]):
            subprocess.run([PROGRAM, "run", "imported/held.toml", "--output", "resumed", *options], cwd=self.directory, check=True,
                           capture_output=True, timeout=LONGEST)
        resumed = (self.directory / "resumed/history.csv").read_text().splitlines()[-1].split(",")
        whole = (self.output / "history.csv").read_text().splitlines()[-1].split(",")
        for a, b in zip(resumed, whole, strict=True):
            self.assertAlmostEqual(float(a), float(b), delta=1e-4 * max(abs(float(b)), 1e-6))

    def test_a_body_set_free_that_is_pushed(self):
        deck = CUBE.replace("z0, 3\n", "") + ("*STEP\n*STATIC\n*BOUNDARY\nz0, 3\n*DLOAD\nCube, P2, 1.\n*END STEP\n"
                                              "*STEP\n*STATIC\n*BOUNDARY, OP=NEW\nx0, 1\ny0, 2\n*END STEP\n")
        self.import_deck("flies", deck)
        done = subprocess.run([PROGRAM, "run", str(self.directory / "imported/flies.toml"), "--output", str(self.output)],
                              capture_output=True, text=True, timeout=LONGEST)
        self.assertEqual(done.returncode, 3)
        self.assertSays(done.stderr, "body 'Cube'", "translation along z", "t = 2")

    def test_friction_that_changes(self):
        above = "*NODE\n" + "".join(f"{n + 10}, {x}, {y}, {z + 1}\n" for n, (x, y, z) in enumerate(
            [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]))
        self.import_deck("friction", CUBE + above + "*ELEMENT, TYPE=C3D8, ELSET=Above\n2, 10, 11, 12, 13, 14, 15, 16, 17\n"
                         "*SOLID SECTION, ELSET=Above, MATERIAL=Steel\n*SURFACE, NAME=Foot\nAbove, S1\n*SURFACE, NAME=Top\nCube, S2\n"
                         "*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=HARD\n*FRICTION\n0.2, 1e6\n"
                         "*CONTACT PAIR, INTERACTION=I\nFoot, Top\n*STEP\n*STATIC\n*DLOAD\nAbove, P2, 50.\n*END STEP\n*STEP\n*STATIC\n"
                         "*CHANGE FRICTION, INTERACTION=I\n*FRICTION\n0.1, 1e6\n*END STEP\n")
        self.assertIn("friction = { t = [0, 1, 1], values = [0.2, 0.2, 0.1] }", (self.directory / "imported/friction.toml").read_text())

    def test_axisymmetric_force_and_pressure(self):
        """A force is that of the whole circumference: 9 on pi (4 - 1)."""
        self.import_deck("ring", "*NODE\n1, 1, 0\n2, 2, 0\n3, 2, 1\n4, 1, 1\n5, 1.5, 0\n6, 2, 0.5\n7, 1.5, 1\n8, 1, 0.5\n*ELEMENT, TYPE=CAX8, "
                         "ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8\n*NSET, NSET=Low\n1, 2, 5\n*BOUNDARY\nLow, 2\n*MATERIAL, NAME=M\n*ELASTIC\n1000, 0.\n"
                         "*SOLID SECTION, ELSET=E, MATERIAL=M\n*STEP\n*STATIC\n*CLOAD\n4, 2, 1.\n3, 2, 2.\n7, 2, 6.\n*EL PRINT, ELSET=E\nS\n*END STEP\n"
                         "*STEP\n*STATIC\n*CLOAD, OP=NEW\n*DLOAD\nE, P3, 1.\n*END STEP\n")
        rows = self.run_imported("ring")
        self.expect_close(rows[1]["stress_yy_element_1"], 9 / (3 * math.pi), 1e-8)
        self.expect_close(rows[2]["stress_yy_element_1"], -1, 1e-8)

    def test_rigid_body(self):
        """The top of the cube as a rigid plate: pulled at a reference node, and turned by another."""
        rigid = "*NODE\n100, 0.5, 0.5, 3\n101, 0, 0, 0\n*NSET, NSET=top, GENERATE\n5, 8\n*RIGID BODY, NSET=top, REF NODE=100, ROT NODE=101\n"
        step = "*BOUNDARY\n101, 1, 3\n*STEP\n*STATIC\n{}*NODE PRINT, NSET=Nall\nU\n*END STEP\n"
        self.import_deck("pulled", CUBE + rigid + step.format("*CLOAD\n100, 3, 50.\n"))
        row = self.run_imported("pulled")[-1]
        for node in (5, 6, 7, 8):
            self.expect_close(row[f"uz_node_{node}"], 0.0005, 1e-8)
        self.import_deck("turned", CUBE.replace("x0, 1\n", "1, 1\n").replace("y0, 2\n", "1, 2\n2, 2\n") + rigid +
                         step.format("*BOUNDARY\n101, 3, 3, 0.01\n100, 1, 2\n"))
        row = self.run_imported("turned")[-1]
        self.expect_close(row["ux_node_7"], -0.005, 1e-9)
        self.expect_close(row["uy_node_7"], 0.005, 1e-9)

    def test_couplings(self):
        """The top of the cube follows a node, as a whole or in the mean; the force and the moment there act on it."""
        coupling = ("*NODE\n100, 2.5, 0.5, 1\n*SURFACE, NAME=Top\nCube, S2\n*COUPLING, CONSTRAINT NAME=c, REF NODE=100, SURFACE=Top\n"
                    "*{}\n")
        step = "*STEP\n*STATIC\n{}*NODE PRINT, NSET=Nall\nU\n*END STEP\n"
        for name, kind, table in (("whole", "KINEMATIC\n1, 3", "rigid"), ("mean", "DISTRIBUTING", "coupling"),
                                  ("all", "DISTRIBUTING\n1, 6", "coupling")):
            # The force at an arm of 2, and the moment that takes it back to the middle.
            self.import_deck(name, CUBE + coupling.format(kind) + step.format("*CLOAD\n100, 3, 50.\n100, 5, 100.\n"))
            self.assertIn(f"[[{table}]]", (self.directory / f"imported/{name}.toml").read_text())
            row = self.run_imported(name)[-1]
            for node in (5, 6, 7, 8):
                self.expect_close(row[f"uz_node_{node}"], 0.0005, 1e-6)
        # A motion of the mean leaves the surface free to become narrower.
        self.import_deck("moved", CUBE + coupling.format("DISTRIBUTING") + step.format("*BOUNDARY\n100, 3, 3, 0.001\n100, 4, 6\n"))
        self.expect_close(self.run_imported("moved")[-1]["uz_node_7"], 0.001, 1e-6)
        for number, (wrong, fact) in enumerate((("KINEMATIC\n3, 3", "displacements"), ("EMBEDDED ELEMENT", "this kind"))):
            done = self.import_deck(f"wrong_{number}", CUBE + coupling.format(wrong) + step.format(""), 2)
            self.assertSays(done.stderr, fact)

    def test_older_kinematic_coupling(self):
        text = CUBE + "*NODE\n100, 0.5, 0.5, 3\n*NSET, NSET=top, GENERATE\n5, 8\n*KINEMATIC COUPLING, REF NODE=100\ntop, {}\n"
        step = "*STEP\n*STATIC\n*CLOAD\n100, 3, 50.\n*NODE PRINT, NSET=Nall\nU\n*END STEP\n"
        self.import_deck("older", text.format("1, 6") + step)
        self.assertIn("[[rigid]]", (self.directory / "imported/older.toml").read_text())
        self.expect_close(self.run_imported("older")[-1]["uz_node_7"], 0.0005, 1e-8)
        self.assertSays(self.import_deck("partly", text.format("3, 3") + step, 2).stderr, "partly.inp:", "*KINEMATIC COUPLING", "1 to 3")

    def test_mean_rotation(self):
        """The top of the cube turns by 1e-3 about z; displacements of CalculiX 2.20."""
        text = (CUBE.replace("x0, 1\ny0, 2\nz0, 3\n", "z0, 1, 3\n").replace("1e5, 0.", "1e5, 0.3") + "*NODE\n90, 0, 0, 1.\n*MPC\n"
                "MEANROT, 5, 5, 5, 6, 6, 6, 7, 7, 7, 8, 8, 8, 90\n")
        step = "*STEP\n*STATIC\n*BOUNDARY\n90, 1, 1, 1e-3\n*NODE PRINT, NSET=Nall\nU\n*END STEP\n"
        self.import_deck("turned", text + step)
        row = self.run_imported("turned")[-1]
        for node, x, y in ((5, 5e-4, -5e-4), (6, 5e-4, 5e-4), (7, -5e-4, 5e-4), (8, -5e-4, -5e-4)):
            self.expect_close(row[f"ux_node_{node}"], x, 1e-9)
            self.expect_close(row[f"uy_node_{node}"], y, 1e-9)
        done = self.import_deck("nowhere", text.replace("90, 0, 0, 1.", "90, 0, 0, 0") + step, 2)
        self.assertSays(done.stderr, "nowhere.inp:", "*MPC: MEANROT", "axis")

    def test_sector(self):
        """A quarter of a thick square tube under pressure, with one element: the cut faces are linked."""
        text = ("*NODE, NSET=Nall\n1, 1, 0, 0\n2, 2, 0, 0\n3, 0, 2, 0\n4, 0, 1, 0\n5, 1, 0, 1\n6, 2, 0, 1\n7, 0, 2, 1\n8, 0, 1, 1\n"
                "*ELEMENT, TYPE=C3D8, ELSET=Sector\n1, 1, 2, 3, 4, 5, 6, 7, 8\n*SURFACE, NAME=low\nSector, S3\n*SURFACE, NAME=high\nSector, S5\n"
                "*TIE, NAME=T, CYCLIC SYMMETRY\nhigh, low\n*CYCLIC SYMMETRY MODEL, N=4, TIE=T\n0, 0, 0, 0, 0, 1\n*BOUNDARY\nNall, 3\n"
                "2, 2\n*MATERIAL, NAME=M\n*ELASTIC\n1e5, 0.3\n*SOLID SECTION, ELSET=Sector, MATERIAL=M\n*STEP\n*STATIC\n*DLOAD\n"
                "Sector, P6, 10.\n*NODE PRINT, NSET=Nall\nU\n*END STEP\n")
        self.import_deck("sector", text)
        self.assertIn('between = ["low", "high"]', (self.directory / "imported" / "sector.toml").read_text())
        row = self.run_imported("sector")[-1]
        self.expect_close(row["uy_node_4"], row["ux_node_1"], 1e-9)
        self.assertGreater(row["ux_node_1"], 0)

    def test_ties_of_matching_nodes_make_one_mesh(self):
        second = "".join(f"{n}, {x}, {y}, {z}\n" for n, (x, y, z) in enumerate(
            [(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1), (0, 0, 2), (1, 0, 2), (1, 1, 2), (0, 1, 2)], start=21))
        self.import_deck("matching", CUBE + "*NODE, NSET=Nall\n" + second + "*ELEMENT, TYPE=C3D8R, ELSET=Second\n2, 21, 22, 23, 24, 25, "
                         "26, 27, 28\n*SOLID SECTION, ELSET=Second, MATERIAL=Steel\n*SURFACE, NAME=a\nSecond, S1\n*SURFACE, NAME=b\nCube, S2\n"
                         "*TIE, NAME=T\na, b\n*STEP\n*STATIC\n*DLOAD\nSecond, P2, -100.\n*NODE PRINT, NSET=Nall\nU\n*END STEP\n")
        text = (self.directory / "imported" / "matching.toml").read_text()
        self.assertNotIn("contacts", text)
        self.assertEqual(text.count("[bodies."), 1)
        self.expect_close(self.run_imported("matching")[-1]["uz_node_27"], 0.002, 1e-8)

    def test_reference_points_of_an_assembly_have_numbers_of_their_own(self):
        """As Abaqus/CAE writes them: node 1 of the assembly is not node 1 of its instance."""
        sets, material = CUBE[CUBE.index("*NSET, NSET=x0"):CUBE.index("*BOUNDARY")], CUBE[CUBE.index("*MATERIAL"):CUBE.index("*SOLID")]
        mesh = CUBE[:CUBE.index("*NSET, NSET=x0")]
        deck = ("*HEADING\n*PART, NAME=Blk\n" + mesh + sets + "*NSET, NSET=top, GENERATE\n5, 8\n*SOLID SECTION, ELSET=Cube, MATERIAL=Steel\n*END PART\n"
                "*ASSEMBLY, NAME=A\n*INSTANCE, NAME=I, PART=Blk\n*END INSTANCE\n*NODE\n1, 0, 0, 30.\n*NSET, NSET=RP\n1,\n"
                "*EQUATION\n2\nI.top, 3, 1., RP, 3, -1.\n*END ASSEMBLY\n" + material + "*BOUNDARY\nI.x0, 1\nI.y0, 2\nI.z0, 3\n*STEP\n*STATIC\n"
                "*CLOAD\nRP, 3, 50.\n*NODE PRINT, NSET=I.top\nU\n*END STEP\n")
        self.import_deck("assembly", deck)
        self.expect_close(self.run_imported("assembly")[-1]["uz_node_7"], 0.0005, 1e-8)

    def test_what_would_change_the_model_is_refused(self):
        step = "*STEP\n*STATIC\n*DLOAD\n{}*END STEP\n"
        done = self.import_deck("coupled", CUBE + "*COUPLING, REF NODE=1, SURFACE=S, CONSTRAINT NAME=C\n*KINEMATIC\n" + step.format("Cube, P2, 1.\n"), 2)
        self.assertSays(done.stderr, "coupled.inp:", "*COUPLING: ")
        plane = ("*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n*ELEMENT, TYPE=CPE4, ELSET=Cube\n1, 1, 2, 3, 4\n*BOUNDARY\n1, 1, 2\n2, 2\n" +
                 CUBE[CUBE.index("*MATERIAL"):].replace("*SOLID", "*DENSITY\n1e-9\n*SOLID"))
        done = self.import_deck("turning", plane + step.format("Cube, CENTRIF, 1., 0, 0, 0, 0, 1., 0\n"), 2)
        self.assertSays(done.stderr, "turning.inp:", "*DLOAD: ", "CENTRIF", "axis")

    def test_a_deck_that_prints_nothing_gets_no_probes_and_a_line_says_so(self):
        step = "*STEP\n*STATIC\n*DLOAD\nCube, P2, -100.\n*NODE FILE\nU\n{}*END STEP\n"
        for name, prints, has_probes in (("silent", "*EL FILE\nS\n", False), ("heat", "*NODE PRINT, NSET=Nall\nNT\n", False),
                                         ("printing", "*EL PRINT, ELSET=Cube\nS\n", True)):
            done = self.import_deck(name, CUBE + step.format(prints))
            text = (self.directory / "imported" / f"{name}.toml").read_text()
            self.assertEqual("\n[[probes]]\n" in text, has_probes)
            for found in (done.stdout, text):
                self.assertEqual("add [[probes]]" in found, not has_probes, found)
            if not has_probes:
                line = CUBE.count("\n") + 1
                self.assertSays(done.stdout, f"{name}.inp:{line}: *STEP: ", "*NODE PRINT", "U", "RF")

    def test_plasticity(self):
        tables = {"*PLASTIC\n100, 0\n150, 0.05\n": 100 + 1000 * 0.02,
                  "*PLASTIC, HARDENING=KINEMATIC\n100, 0\n150, 0.05\n": 100 + 1000 * 0.02,
                  "*PLASTIC, HARDENING=COMBINED, DATA TYPE=PARAMETERS, NUMBER BACKSTRESSES=1\n100, 1000, 0\n": 100 + 1000 * 0.02,
                  "*PLASTIC\n100\n": 100}
        load = "*STEP\n*STATIC\n1, 1\n*BOUNDARY\nz1, 3, 3, {}\n*EL PRINT, ELSET=Cube\nS, PEEQ\n*END STEP\n"
        for i, (table, stress) in enumerate(tables.items()):
            with self.subTest(table):
                text = CUBE.replace("1e5, 0.\n", "1e5, 0.\n" + table) + "*NSET, NSET=z1\n5, 6, 7, 8\n"
                self.import_deck(f"plastic{i}", text + load.format(stress / 1e5 + 0.02))
                rows = self.run_imported(f"plastic{i}")
                self.assertAlmostEqual(max(value for name, value in rows[-1].items() if "zz" in name.lower() or "szz" in name), stress, delta=1e-4 * stress)
        done = self.import_deck("falls", CUBE.replace("1e5, 0.\n", "1e5, 0.\n*PLASTIC\n100, 0\n90, 0.1\n") + load.format(0.1).replace("z1", "x0"), 2)
        self.assertSays(done.stderr, "falls.inp:", "*PLASTIC: ", "fall")

    def test_what_makes_no_model(self):
        done = self.import_deck("impossible", CUBE + "*CYCLIC HARDENING\n200\n*MPC\nMEANROT, 1, 2\n*MODEL CHANGE\n*STEP\n*DYNAMIC\n*END STEP\n", 2)
        self.assertSays(done.stderr, "impossible.inp:26: *CYCLIC HARDENING: ", "plasticity", "impossible.inp:30: *MODEL CHANGE: ",
                        "impossible.inp:32: *DYNAMIC: ", "*STATIC", "*VISCO")
        self.assertFalse((self.directory / "imported").exists())
        self.assertSays(self.import_missing().stderr, ".inp", "No such file")

    def import_missing(self):
        return subprocess.run([PROGRAM, "import", "none.inp"], capture_output=True, text=True, timeout=LONGEST)

    def test_memory_is_less_than_three_times_the_mesh(self):
        n = 60
        number = lambda i, j, k: 1 + i + (n + 1) * (j + (n + 1) * k)
        grid = lambda m: ((i, j, k) for k in range(m) for j in range(m) for i in range(m))
        with open(self.directory / "large.inp", "w") as deck:
            deck.write("*NODE, NSET=Nall\n")
            deck.writelines(f"{number(i, j, k)}, {i}, {j}, {k}\n" for i, j, k in grid(n + 1))
            deck.write("*ELEMENT, TYPE=C3D8, ELSET=Block\n")
            deck.writelines(f"{e}, " + ", ".join(str(number(i + a, j + b, k + c)) for c in (0, 1)
                                                 for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))) + "\n"
                            for e, (i, j, k) in enumerate(grid(n), 1))
            deck.write(CUBE[CUBE.index("*MATERIAL"):].replace("ELSET=Cube", "ELSET=Block") +
                       "*BOUNDARY\n1, 1, 3\n*STEP\n*STATIC\n*CLOAD\n9, 1, 1.\n*END STEP\n")
        started = subprocess.Popen([PROGRAM, "import", "large.inp", "--no-check"], cwd=self.directory, stdout=subprocess.DEVNULL)
        _, status, used = os.wait4(started.pid, 0)
        started.returncode = status
        self.assertEqual(status, 0)
        mesh = (self.directory / "large.msh").stat().st_size
        self.assertGreater(mesh, 20e6)
        of_the_program = 20e6
        self.assertLess(1024 * used.ru_maxrss, of_the_program + 3 * mesh)

    def test_nothing_is_overwritten(self):
        text = CUBE + "*STEP\n*STATIC\n*DLOAD\nCube, P2, -100.\n*END STEP\n"
        self.import_deck("twice", text)
        self.assertSays(self.import_deck("twice", text, 2).stderr, "imported/twice.", "--output")


@unittest.skipUnless(EXAMPLES.exists(), "needs the Debian package calculix-ccx-test")
class ImportOfCalculix(ImportTest):
    """Values of the .dat.ref files that come with the decks."""

    def test_values(self):
        """At nodes at the end of the last step."""
        for name, node, component, body, value, relative in (
                ("planestrain2", 3, "y", "Eall", 4.333333e-4, 1e-5),
                ("beam20p", 5, "y", "B1", 0.0872254, 0.01),  # 27 integration points there, 8 here
                ("c3d15", 112, "z", None, -1.034483e-6, 1e-5),
                ("achtelc", 40, "z", None, 1.942302e-5, 1e-4),
                ("axial", 12, "x", None, 6.804776e-5, 0.005),
                ("beamt2", 5, "x", None, -0.01025425, 1e-4),
                ("contactenergy", 3, "z", "Emast", -1.904762e-5, 1e-4),
                ("beampfix", 117, "y", None, 0.4710545, 1e-4),
                ("beampdepmpc", 22, "y", None, 9.760898e-3, 1e-4),
                ("segmentf", 53, "z", None, 2.422908e-2, 1e-4),
                ("segment1", 5, "y", None, 7.074657e-6, 1e-4),
                ("beampo1", 5, "y", None, 8.422891e-2, 1e-4),
                ("beampo2", 5, "y", None, 4.631743e-2, 1e-4),
                ("beamptied2", 142, "y", None, 0.0876882, 1e-3),
                ("achtel2", 3, "z", None, 1.138229e-3, 1e-5)):
            with self.subTest(name):
                text = deck_text(name)
                self.import_deck(name, text)
                of_body = f'body = "{body}"\n' if body else ""
                probe = f'[[probes]]\nname = "u"\nquantity = "displacement_{component}"\nat = {position_of_node(text, node)}\n'
                self.expect_close(self.run_imported(name, probe + of_body)[-1]["u"], value, relative)

    def test_stresses_that_the_decks_print(self):
        for name, probe, value in (("planestrain2", "stress_zz_element_1", 30.0), ("c3d15", "stress_zz_element_17", -20.0)):
            with self.subTest(name):
                self.import_deck(name, deck_text(name))
                self.expect_close(self.run_imported(name)[-1][probe], value, 1e-5)

    def test_every_deck_becomes_a_model_or_is_refused_with_reasons(self):
        statuses = collections.Counter()
        for path in sorted([*EXAMPLES.glob("*.inp"), *EXAMPLES.glob("*.inp.gz")]):
            name = path.name.split(".inp")[0]
            (self.directory / f"{name}.inp").write_text(deck_text(name))
            done = subprocess.run([PROGRAM, "import", f"{name}.inp", "--output", "all"], cwd=self.directory,
                                  capture_output=True, text=True, timeout=LONGEST)
            self.assertIn(done.returncode, (0, 2), f"{name}: {done.stderr}")
            self.assertEqual(done.returncode == 2, done.stderr.startswith("error: "), name)
            statuses[done.returncode] += 1
            if done.returncode == 0:
                check = subprocess.run([PROGRAM, "check", f"all/{name}.toml"], cwd=self.directory, capture_output=True,
                                       text=True, timeout=LONGEST)
                self.assertEqual(check.returncode, 0, f"{name}: {check.stderr}")
        self.assertEqual(statuses, {0: 110, 2: 245})


if __name__ == "__main__":
    unittest.main()
