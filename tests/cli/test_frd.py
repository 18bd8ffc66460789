"""Results as CalculiX writes them, read by its own programs."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

from process_case import PROGRAM
from test_runs import RunTest
from waiting import LONGEST

ROOT = pathlib.Path(__file__).resolve().parents[2]
DECK = ROOT / "docs" / "tutorial_deck" / "press_fit.inp"


def fields(text):
    """{(name, time): {node: values}} of the results in a .frd, by the columns of the format."""
    found, name, time = {}, "", 0.0
    for line in text.splitlines():
        if line.startswith("  100C"):
            time = float(line[12:24])
        elif line.startswith(" -4"):
            name = line[5:13].strip()
            found[name, time] = {}
        elif line.startswith(" -1") and name:
            found[name, time][int(line[3:13])] = [float(line[i:i + 12]) for i in range(13, len(line), 12)]
        elif line.startswith(" -3"):
            name = ""
    return found


class Frd(RunTest):
    def run_deck(self, *options):
        subprocess.run([PROGRAM, "import", str(DECK), "--output", "imported"], cwd=self.directory, check=True,
                       capture_output=True, timeout=LONGEST)
        done = subprocess.run([PROGRAM, "run", "imported/press_fit.toml", "--output", str(self.output), "--set", "output.frd=true",
                               *options], cwd=self.directory, capture_output=True, text=True, timeout=LONGEST)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_numbers_of_the_deck_and_values_of_the_probes(self):
        self.run_deck()
        text = (self.output / "fields.frd").read_text()
        found = fields(text)
        for row in self.table("history.csv"):
            displacement = found["DISP", row["time"]]
            self.assertEqual(sorted(displacement), [*range(1, 9), *range(11, 29)])
            self.assertAlmostEqual(displacement[11][0], row["ux_node_11"], delta=1e-5 * row["ux_node_11"])
        self.assertEqual(sorted(found["CONTACT", 0.0]), [11, 18, 22])  # the bore
        for gap, pressure in found["CONTACT", 0.0].values():
            self.assertAlmostEqual(gap, 0, delta=1e-8)
            self.assertAlmostEqual(pressure, 38.5, delta=0.3)
        self.assertGreater(found["PE", 1000.0][11][0], 1e-4)
        self.assertEqual(found["PE", 1000.0][1][0], 0)
        elements = re.findall(r"(?m)^ -1 +(\d+) +(\d+) +0 +(\d+)\n -2(.*)$", text)
        self.assertEqual([(element, kind, body) for element, kind, body, _ in elements],
                         [("1", "10", "1"), ("2", "10", "2"), ("3", "10", "2"), ("4", "10", "2")])
        self.assertEqual(elements[0][3].split(), ["1", "3", "8", "6", "2", "5", "7", "4"])

    def test_without_other_field_files(self):
        self.run_deck("--set", "output.fields=false")
        self.assertTrue((self.output / "fields.frd").exists())
        self.assertFalse((self.output / "fields.pvd").exists())

    @unittest.skipUnless(shutil.which("cgx"), "needs the Debian package calculix-cgx")
    def test_calculix_graphix_reads_it(self):
        self.run_deck()
        (self.output / "probe.fbd").write_text("read fields.frd\nseta probe n 11\ngraph probe time DISP D1\ngraph probe time CONTACT CPRESS\nexit\n")
        environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        subprocess.run(["cgx", "-bg", "probe.fbd"], cwd=self.output, env=environment, capture_output=True, timeout=LONGEST, check=True)
        rows = [[float(field) for field in line.split()[2:5:2]] for line in (self.output / "graph_0.out").read_text().splitlines()]
        for (time, value), row in zip(rows, self.table("history.csv"), strict=True):
            self.assertAlmostEqual(time, row["time"])
            self.assertAlmostEqual(value, row["ux_node_11"], delta=1e-5 * row["ux_node_11"])
        pressure = float((self.output / "graph_1.out").read_text().splitlines()[0].split()[4])
        self.assertAlmostEqual(pressure, 38.5, delta=0.3)


@unittest.skipUnless(shutil.which("ccx"), "needs the Debian package calculix-ccx")
class CalculixStudy(unittest.TestCase):
    def test_both_programs_agree_and_one_costs_less(self):
        done = subprocess.run([sys.executable, "-B", str(ROOT / "studies/calculix/compare.py"), "--coarse", "--program", str(PROGRAM),
                               str(ROOT / "configs/imported/shrink_fit.inp"), "1001", "x"], capture_output=True, text=True, timeout=LONGEST)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = re.findall(r"(?m)^\| (\S+) \| (\d+) \| (\S+) \| (\S+) \|$", done.stdout)
        theirs, ours = rows[:3], rows[3:]
        self.assertLess(float(theirs[1][2]), float(theirs[0][2]))
        self.assertLess(10 * float(ours[1][2]), float(theirs[1][2]))  # 3e-5 against 4e-3
        self.assertLess(float(re.search(r"difference (\S+)", done.stdout)[1]), 1e-3)


if __name__ == "__main__":
    unittest.main()
