"""A study of a cube of one element, and how to run it."""

import csv
import os
import pathlib
import subprocess
import tempfile
import unittest

from says import Says
from waiting import LONGEST

PROGRAM = os.environ["CREEPCONTACT_PROGRAM"]

GEOMETRY = """Point(1) = {0, 0, 0}; Point(2) = {100, 0, 0}; Point(3) = {100, 100, 0}; Point(4) = {0, 100, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve{1, 2, 3, 4} = 2; Transfinite Surface{1}; Recombine Surface{1};
out[] = Extrude {0, 0, 100} { Surface{1}; Layers{1}; Recombine; };
Physical Volume("cube") = {out[1]};
Physical Surface("z0") = {1}; Physical Surface("y0") = {out[2]}; Physical Surface("x1") = {out[3]};
Physical Surface("x0") = {out[5]};
"""

# Stretched and held: sigma = (200^-4 + 4 A E t)^(-1/4).
BASE = """[mesh]
file = "cube.geo"
order = 1
[bodies.cube]
region = "cube"
material = "steel"
[materials.steel]
young_modulus = 200e3
poisson_ratio = 0.3
creep = [{ law = "norton", A = 3.125e-14, n = 5 }]
[[supports]]
on = "x0"
displacement = { x = 0 }
[[supports]]
on = "y0"
displacement = { y = 0 }
[[supports]]
on = "z0"
displacement = { z = 0 }
[[supports]]
on = "x1"
displacement = { x = 0.1 }
[time]
end = 0.4
output = [0.1, 0.2]
[[probes]]
name = "stress"
quantity = "stress_xx"
body = "cube"
"""

STUDY = """title = "How much error a step buys"
base = "cube.toml"
set = { time.beta = 0.5, output.fields = false }
[[axes]]
key = "time.integrator"
values = ["explicit_euler", "beta_euler"]
[[axes]]
key = "time.step"
values = [0.005, 0.0025]
[[runs]]
set = { "time.integrator" = "beta_euler", "time.step" = 0.4 }
"""
REFERENCE = """[reference]
set = { "time.integrator" = "cvode_bdf", "time.tolerance" = 1e-8 }
"""
COMPARE = """[compare]
quantities = ["stress"]
"""


class StudyTest(Says, unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.directory = pathlib.Path(scratch.name)
        self.output = self.directory / "results" / "study"
        self.write("cube.geo", GEOMETRY)
        self.write("cube.toml", BASE)

    def write(self, name, text):
        (self.directory / name).write_text(text)

    def study(self, text=STUDY + REFERENCE + COMPARE, *more):
        self.write("study.toml", text)
        return self.call("study", "study.toml", *more)

    def call(self, *arguments):
        return subprocess.run([PROGRAM, *arguments], cwd=self.directory, capture_output=True, text=True, timeout=LONGEST)

    def rows(self):
        with open(self.output / "study.csv", newline="") as file:
            return list(csv.DictReader(file))

    def written(self):
        """When each run wrote its summary."""
        return {path.parent.name: path.stat().st_mtime_ns for path in self.output.glob("runs/*/summary.json")}

    def expect_error(self, done, status, *facts):
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertSays(done.stderr, *facts)
