"""A run killed outright (SIGKILL) again and again and resumed each time ends as the run that was left alone."""

import csv
import os
import pathlib
import random
import re
import signal
import subprocess
import tempfile
import time
import unittest

from waiting import LONGEST, wait_until

PROGRAM = os.environ["CREEPCONTACT_PROGRAM"]

GEOMETRY = """SetFactory("OpenCASCADE");
Box(1) = {0, 0, -2, 2, 1, 2};
Box(2) = {0, 0, 0, 2, 1, 1};
Transfinite Curve{1:24} = 3;
Transfinite Curve{9:12} = 4;
Transfinite Curve{21:24} = 5;
Transfinite Surface{1:12};
Recombine Surface{1:12};
Transfinite Volume{1:2};
Physical Volume("lower") = {1};
Physical Volume("upper") = {2};
Physical Surface("lower_top") = {6};
Physical Surface("upper_bottom") = {11};
Physical Surface("bottom") = {5};
Physical Surface("top") = {12};
Physical Surface("symmetry_x") = {1, 7};
Physical Surface("symmetry_y") = {3, 9};
"""

# The contact opens from one side and closes again; the load jumps at t = 1.
CONFIGURATION = """
[mesh]
file = "blocks.geo"
order = 1
[bodies]
lower = { region = "lower", material = "soft" }
upper = { region = "upper", material = "hard" }
[materials.soft]
young_modulus = 100
poisson_ratio = 0.3
creep = [{ law = "norton", A = 1e-3, n = 4 }]
[materials.hard]
young_modulus = 200
poisson_ratio = 0.3
creep = [{ law = "norton", A = 1e-3, n = 4 }]
[[supports]]
on = "symmetry_x"
displacement = { x = 0 }
[[supports]]
on = "symmetry_y"
displacement = { y = 0 }
[[supports]]
on = "bottom"
displacement = { z = 0 }
[[supports]]
on = "top"
displacement = { z = { t = [0, 1, 1, 4], values = [-0.02, -0.025, -0.035, -0.04] } }
[[contacts]]
between = ["lower_top", "upper_bottom"]
gap = "0.02*x*sin(2*t)"
[time]
end = 4
output = { count = 10 }
[output]
checkpoint_seconds = 0
[[probes]]
name = "pressure"
quantity = "contact_pressure"
on = "upper_bottom"
[[probes]]
name = "force"
quantity = "reaction_z"
on = "bottom"
"""


class KillTest(unittest.TestCase):
    kills = 15

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.directory = pathlib.Path(scratch.name)
        (self.directory / "blocks.geo").write_text(GEOMETRY)
        (self.directory / "case.toml").write_text(CONFIGURATION)
        self.random = random.Random(20120611)

    def start(self, output, settings, *more):
        overrides = [part for setting in settings for part in ("--set", setting)]
        # One thread: with its neighbours asleep or not, a library may add in another order.
        return subprocess.Popen([PROGRAM, "run", str(self.directory / "case.toml"), "--quiet", "--threads", "1",
                                 "--output", str(self.directory / output), *overrides, *more],
                                stderr=subprocess.PIPE, text=True)

    def end(self, process):
        errors = process.communicate(timeout=LONGEST)[1]
        self.assertEqual(process.returncode, 0, errors)

    def resume_option(self, output):
        return ["--resume"] if (self.directory / output / "checkpoint.h5").exists() else []

    def killed_run(self, output, settings, seconds, kills):
        """Kills the run up to so many times, then lets it end. Returns how often it was killed."""
        killed = 0
        while killed < kills:
            process = self.start(output, settings, *self.resume_option(output))
            time.sleep(self.random.uniform(0, seconds))
            process.send_signal(signal.SIGKILL)
            errors = process.communicate()[1]
            if process.returncode == 0:
                return killed
            self.assertEqual(process.returncode, -signal.SIGKILL, errors)
            killed += 1
        self.end(self.start(output, settings, *self.resume_option(output)))
        return killed

    def table(self, output, name):
        with open(self.directory / output / name, newline="") as file:
            return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]

    def listed_fields(self, output):
        text = (self.directory / output / "fields.pvd").read_text()
        return re.findall(r'timestep="([^"]*)".*?file="([^"]*)"', text)

    def check(self, integrator, *settings, compare=None):
        settings = [f"time.integrator={integrator}", *settings]
        begin = time.monotonic()
        self.end(self.start("whole", settings))
        seconds = time.monotonic() - begin
        total = runs = 0
        while total < self.kills:
            output = f"parts_{runs}"
            total += self.killed_run(output, settings, 0.6 * seconds, self.kills - total)
            runs += 1
            self.compare_tables(output)
            (compare or self.compare_text)(output)

    def compare_tables(self, output):
        steps = [row["time"] for row in self.table(output, "steps.csv")]
        self.assertEqual(steps, sorted(set(steps)))
        times = [row["time"] for row in self.table("whole", "history.csv")]
        self.assertEqual([row["time"] for row in self.table(output, "history.csv")], times)
        fields = self.listed_fields(output)
        self.assertEqual(fields, self.listed_fields("whole"))
        self.assertEqual(len(fields), len(times))
        for _, file in fields:
            self.assertTrue((self.directory / output / file).read_bytes().rstrip().endswith(b"</VTKFile>"), file)

    def compare_text(self, output):
        for name in ("history.csv", "steps.csv"):
            self.assertEqual((self.directory / output / name).read_text(),
                             (self.directory / "whole" / name).read_text())


class KilledExactly(KillTest):
    def test_arkode_erk(self):
        self.check("arkode_erk", "time.tolerance=1e-6")

    def test_beta_euler(self):
        self.check("beta_euler", "time.step=0.037", "time.inner_tolerance=1e-7", "time.beta=0.5")


class KilledWithinTolerance(KillTest):
    """CVODE begins anew with every start; that must add no error to speak of to the run's own."""

    kills = 10
    tolerance = 1e-4

    def error(self, output):
        pairs = list(zip(self.table(output, "history.csv"), self.table("accurate", "history.csv")))
        return max(max(abs(one[name] - other[name]) for one, other in pairs) / max(abs(other[name]) for _, other in pairs)
                   for name in ("pressure", "force"))

    def compare_errors(self, output):
        self.assertLess(self.error(output), self.error("whole") + 3 * self.tolerance)

    def test_cvode_bdf(self):
        self.end(self.start("accurate", ["time.tolerance=1e-8", "output.checkpoint_seconds=30"]))
        self.check("cvode_bdf", f"time.tolerance={self.tolerance}", compare=self.compare_errors)


class Damage(KillTest):
    """A checkpoint that is cut short or changed in one bit is not used."""

    def setUp(self):
        super().setUp()
        self.settings = ["time.integrator=arkode_erk", "time.tolerance=1e-6"]
        self.output = self.directory / "parts"
        process = self.start("parts", self.settings)
        steps = self.output / "steps.csv"
        wait_until(lambda: steps.exists() and steps.read_text().count("\n") >= 60, "60 steps", pause=0.005)
        process.send_signal(signal.SIGKILL)
        process.communicate()
        self.files = [self.output / "checkpoint.h5", self.output / "checkpoint.previous.h5"]

    def resume(self):
        process = self.start("parts", self.settings, "--resume")
        errors = process.communicate(timeout=LONGEST)[1]
        return process.returncode, errors

    def resume_and_compare(self, warning):
        status, errors = self.resume()
        self.assertEqual(status, 0, errors)
        self.assertIn(warning, errors)
        self.assertRegex(errors, r"(?m)^warning: .*previous.* t = ")
        self.end(self.start("whole", self.settings))
        self.compare_tables("parts")
        self.compare_text("parts")

    def damage(self, file):
        content = bytearray(file.read_bytes())
        if self.random.random() < 0.5:
            content[self.random.randrange(len(content))] ^= 1 << self.random.randrange(8)
        else:
            del content[self.random.randrange(len(content)):]
        file.write_bytes(content)

    def test_previous_one_is_used(self):
        self.damage(self.files[0])
        self.resume_and_compare("checkpoint.h5'")

    def test_missing_newest_one(self):
        self.files[0].unlink()
        self.resume_and_compare("No such file")

    def test_both_damaged(self):
        before = (self.output / "history.csv").read_text()
        for file in self.files:
            self.damage(file)
        status, errors = self.resume()
        self.assertEqual(status, 2, errors)
        self.assertIn("--resume", errors)
        self.assertEqual((self.output / "history.csv").read_text(), before)


if __name__ == "__main__":
    unittest.main()
