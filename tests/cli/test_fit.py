"""creepcontact fit: from a file of tests to a run with the law."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["CREEPCONTACT_PROGRAM"]
CONFIGS = pathlib.Path(__file__).parents[2] / "configs"

RUN = """[mesh]
file = "block.geo"
[bodies.block]
region = "all"
material = "steel"
[[supports]]
on = "bottom"
displacement = { x = 0, y = 0, z = 0 }
[[loads]]
on = "top"
traction = [0, 0, 300]
[time]
end = 1e-3
output = [1e-3]
integrator = "cvode_bdf"
"""
GEO = """SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Physical Volume("all") = {1};
Physical Surface("bottom") = {5};
Physical Surface("top") = {6};
Transfinite Curve {:} = 2; Transfinite Surface {:}; Transfinite Volume {:}; Recombine Surface {:};
"""


class Fit(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = pathlib.Path(directory.name)

    def fit(self, data, *arguments):
        if isinstance(data, str):
            path = self.directory / "data.csv"
            path.write_text(data, encoding="utf-8")
            data = path
        return subprocess.run([PROGRAM, "fit", str(data), *arguments], capture_output=True, text=True, timeout=100,
                              cwd=self.directory)

    def refused(self, data, *arguments):
        done = self.fit(data, *arguments)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        return done.stderr

    def test_constants_of_the_example(self):
        done = self.fit(CONFIGS / "creep_tests.csv", "--law", "kachanov_rabotnov")
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = {words[0]: words for line in done.stdout.split("correlation")[0].splitlines()
                if len(words := line.split()) > 4}
        for key, truth in {"A": 2e-17, "n": 5, "B": 4e-15, "r": 4.5, "phi": 6}.items():
            low, high = float(rows[key][2]), float(rows[key][4])
            self.assertTrue(low / 1.3 < truth < high * 1.3, done.stdout)
            self.assertLess(low, float(rows[key][1]))
        self.assertIn("[[materials.fitted.creep]]\nlaw = \"kachanov_rabotnov\"", done.stdout)

    def test_the_block_runs_and_its_range_is_watched(self):
        done = self.fit(CONFIGS / "creep_tests.csv", "--law", "norton", "--material", "steel", "--young-modulus", "1.5e5",
                        "--output", "steel.toml")
        self.assertEqual(done.returncode, 2)  # the strain is creep strain, below the elastic one
        self.assertIn("is below the elastic strain", done.stderr)
        data = "time [h],stress [MPa],creep_strain\n" + "".join(
            f"{t},{s},{1e-16 * s**5 * t * f}\n" for s in (50, 100, 150) for t, f in ((10, 1.02), (100, 0.97), (1000, 1.01)))
        done = self.fit(data, "--law", "norton", "--material", "steel", "--young-modulus", "1.5e5", "--output", "steel.toml")
        self.assertEqual(done.returncode, 0, done.stderr)
        for picture in ("creep.png", "residuals.png"):
            self.assertGreater((self.directory / "steel_plots" / picture).stat().st_size, 5000)
        (self.directory / "block.geo").write_text(GEO, encoding="utf-8")
        block = (self.directory / "steel.toml").read_text(encoding="utf-8")
        (self.directory / "run.toml").write_text(RUN + block, encoding="utf-8")
        run = subprocess.run([PROGRAM, "run", "run.toml", "-o", "out"], capture_output=True, text=True, timeout=100,
                             cwd=self.directory)
        self.assertEqual(run.returncode, 0, run.stderr)
        warnings = json.loads((self.directory / "out/summary.json").read_text(encoding="utf-8"))["warnings"]
        self.assertEqual(len([w for w in warnings if "is above the tests of material 'steel'" in w and "50 .. 150" in w]), 1)
        (self.directory / "run.toml").write_text((RUN + block).replace("end = 1e-3", "end = 1e4"), encoding="utf-8")
        check = subprocess.run([PROGRAM, "check", "run.toml"], capture_output=True, text=True, timeout=100,
                               cwd=self.directory)
        self.assertIn("the run ends at t = 10000, 10 times the longest of its tests", check.stdout + check.stderr)

    def test_bad_rows_are_named(self):
        message = self.refused("time [h],stress [MPa],strain [%]\n1,100,0.1\n2,100,abc\n3,-100,0.2\n4,100\n5,100,0.3\n",
                               "--law", "norton")
        self.assertIn("data.csv:5: 2 cells under 3 columns", message)
        message = self.refused("time [h],stress [MPa],strain [%]\n1,100,0.1\n2,100,abc\n3,-100,0.2\n5,100,0.3\n2,100,0.4\n",
                               "--law", "norton")
        self.assertIn("data.csv:3: column 'strain [%]': 'abc' is not a number", message)
        self.assertIn("data.csv:4: stress -100; allowed: stresses > 0", message)
        self.assertIn("data.csv:6: time 2 after 5 in line 5", message)

    def test_units_that_cannot_be(self):
        self.assertIn("the unit 'MPa' is none of a time", self.refused("time [MPa],stress,strain\n1,100,1\n", "--law", "norton"))
        self.assertIn("more than 100 %", self.refused("time,stress,strain\n1,100,1.5\n", "--law", "norton"))

    def test_one_stress(self):
        message = self.refused("time,stress,strain\n1,100,0.001\n2,100,0.002\n3,100,0.0031\n", "--law", "norton")
        self.assertIn("all tests are at the stress 100: they cannot tell A and n apart", message)
        done = self.fit("time,stress,strain\n1,100,0.001\n2,100,0.002\n3,100,0.0031\n", "--law", "norton", "--set", "n=5")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_rupture_needs_damage(self):
        self.assertIn("the law does not rupture", self.refused("time,stress\n100,100\n50,120\n30,150\n", "--law", "norton"))

    def test_a_foreign_file_is_kept(self):
        (self.directory / "mine.toml").write_text("title = 'mine'\n", encoding="utf-8")
        self.assertIn("was not written by this command",
                      self.refused("time,stress,strain\n1,1,1\n", "--law", "norton", "--output", "mine.toml"))


if __name__ == "__main__":
    unittest.main()
