"""Surfaces of several bodies in one rigid motion, and surfaces whose mean motion follows a point, against closed forms."""

import unittest

from process_case import ProcessTest
from test_signals import read_rows

BARS_GEO = """SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 1, 10}; Rectangle(2) = {2, 0, 0, 1, 20};
Transfinite Curve{:} = 3; Transfinite Curve{2, 4, 6, 8} = 6; Transfinite Surface{1, 2}; Recombine Surface{1, 2};
Physical Surface("b1") = {1}; Physical Surface("b2") = {2};
Physical Curve("foot") = {1, 5}; Physical Curve("t1") = {3}; Physical Curve("t2") = {7}; Physical Curve("heads") = {3, 7};
Physical Point("corner") = {1};
"""
BARS = """analysis = "plane_stress"
[mesh]
file = "bars.geo"
[bodies.b1]
region = "b1"
material = "m"
[bodies.b2]
region = "b2"
material = "m"
[materials.m]
young_modulus = 1e5
poisson_ratio = 0.3
[[materials.m.creep]]
law = "norton"
A = 1e-14
n = 5
[[supports]]
on = "foot"
displacement = { y = 0 }
%s
[time]
end = 1000
output = [1, 10]
[[probes]]
name = "s1"
quantity = "stress_yy"
body = "b1"
[[probes]]
name = "s2"
quantity = "stress_yy"
body = "b2"
"""

BLOCK_GEO = """SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 10, 10, 20};
Transfinite Curve{:} = 4; Transfinite Surface{:}; Transfinite Volume{1}; Recombine Surface{:};
Physical Volume("block") = {1}; Physical Surface("foot") = {5}; Physical Surface("head") = {6};
Physical Point("a") = {2}; Physical Point("b") = {6}; Physical Curve("edge") = {10};
"""
BLOCK = """[mesh]
file = "block.geo"
[bodies.block]
region = "block"
material = "m"
[materials.m]
young_modulus = 1e5
poisson_ratio = 0.3
[[supports]]
on = "foot"
displacement = { z = 0%s }
[[supports]]
on = "a"
displacement = { x = 0, y = 0 }
[[supports]]
on = "b"
displacement = { y = 0 }
[[coupling]]
on = "%s"
%s
[time]
end = 1
[[probes]]
name = "force"
quantity = "section_force_z"
body = "block"
section = { origin = [5, 5, 10], normal = [0, 0, 1] }
[[probes]]
name = "moment_y"
quantity = "section_moment_y"
body = "block"
origin = [5, 5, 10]
section = { origin = [5, 5, 10], normal = [0, 0, 1] }
[[probes]]
name = "moment_z"
quantity = "section_moment_z"
body = "block"
origin = [5, 5, 10]
section = { origin = [5, 5, 10], normal = [0, 0, 1] }
[[probes]]
name = "least"
quantity = "stress_zz"
body = "block"
reduce = "min"
[[probes]]
name = "largest"
quantity = "stress_zz"
body = "block"
reduce = "max"
"""


class Couplings(ProcessTest):
    def results(self, geo, text):
        self.write("bars.geo" if geo is BARS_GEO else "block.geo", geo)
        self.write("model.toml", text)
        run = self.call("run", "model.toml", "--output", "out")
        self.assertEqual(run.returncode, 0, run.stderr)
        return [{key: float(value) for key, value in row.items()} for row in read_rows(self.directory / "out/history.csv")]

    def test_one_rigid_motion_of_two_bodies(self):
        for motion in ('[[rigid]]\non = "heads"\nrotation = { z = 0 }\ndisplacement = { x = 0 }\n',
                       '[[rigid]]\non = ["t1", "t2"]\nreference = [1, 15, 0]\nmotion = { x = 0, rz = 0 }\n'):
            for load in ('[[loads]]\non = "t1"\ntraction = [0, 200, 0]\n', ""):
                if not load:  # the same force at the reference point
                    motion += "force = [0, 200, 0]\n"
                rows = self.results(BARS_GEO, BARS % (motion + load))
                # E u / 10 and E u / 20, together 200; then creep lets them share.
                self.assertAlmostEqual(rows[0]["s1"], 400 / 3, delta=0.02 * 133)
                self.assertAlmostEqual(rows[0]["s2"], 200 / 3, delta=0.02 * 67)
                self.assertAlmostEqual(rows[0]["s1"] + rows[0]["s2"], 200, delta=0.5)
                self.assertAlmostEqual(rows[-1]["s1"], 106.92, delta=1.1)
                self.assertAlmostEqual(rows[-1]["s2"], 93.08, delta=1.1)

    def test_the_mean_motion_of_two_bodies(self):
        held = '[[supports]]\non = "corner"\ndisplacement = { x = 0 }\n[[supports]]\non = "t2"\ndisplacement = { x = 0 }\n'
        rows = self.results(BARS_GEO, (BARS % (held + '[[coupling]]\non = ["t1", "t2"]\nmotion = { y = 0.01 }\n')).replace(
            "A = 1e-14", "A = 0"))
        # Both have the same stress: s (10 + 20) / E / 2 = 0.01
        for name in ("s1", "s2"):
            self.assertAlmostEqual(rows[0][name], 2000 / 30, delta=0.01 * 67)

    def test_a_force_and_a_moment_are_distributed(self):
        couple = 'origin = [30, 5, 20]\nforce = [0, 0, -100]\nmoment = [0, 0, 70]\n'
        (row,) = self.results(BLOCK_GEO, BLOCK % (", x = 0, y = 0", "head", couple))[:1]
        self.assertAlmostEqual(row["force"], -100, delta=1e-7)
        self.assertAlmostEqual(abs(row["moment_y"]), 100 * 25, delta=1e-5)
        self.assertAlmostEqual(abs(row["moment_z"]), 70, delta=1e-5)

    def test_the_surface_deforms_freely(self):
        for couple in ("force = [0, 0, 2000]\n", "motion = { z = 0.004 }\n"):
            (row,) = self.results(BLOCK_GEO, BLOCK % ("", "head", couple))[:1]
            for name in ("least", "largest"):
                self.assertAlmostEqual(row[name], 20, delta=1e-6, msg=couple)

    def test_mistakes_are_named(self):
        self.write("block.geo", BLOCK_GEO)
        for on, couple, *facts in (
            ("edge", "moment = [0, 1, 0]\nmotion = { ry = 0 }", "moment", "prescribed"),
            ("nothing", "force = [0, 0, 1]", "nothing"),
            ("head", "origin = [0, 0, 0]\nreference = [0, 0, 0]\nforce = [0, 0, 1]", "reference", "origin"),
            ("head", "motion = { z = 1 }\ndisplacement = { z = 1 }", "motion"),
            ("a", "moment = [0, 0, 1]", "rotation about z", "line"),
        ):
            self.write("model.toml", BLOCK % ("", on, couple))
            done = self.call("check", "model.toml")
            self.assertIn(done.returncode, (2, 3), (on, couple))
            self.assertSays(done.stderr, *facts)


class ScaledTemperature(ProcessTest):
    """One field of temperatures and an amplitude in time."""

    def test_stress_follows_the_scale(self):
        self.write("block.geo", BLOCK_GEO)
        self.write("field.csv", "x,y,z,T\n" + "".join(f"{x},{y},{z},{20 + 10 * z}\n" for x in (0, 10) for y in (0, 10)
                                                       for z in (0, 20)))
        text = (BLOCK % ("", "head", "motion = { z = 0 }")).replace(
            "poisson_ratio = 0.3", "poisson_ratio = 0.3\nthermal_expansion = 1e-5\nreference_temperature = 20").replace(
            "end = 1\n", "end = 1\noutput = [0.25, 0.5]\n")
        for scale, shares in (('scale = "2*t"\n', (0.5, 1, 2)), ("scale = { t = [0, 0.5], values = [1, 0] }\n", (0.5, 0, 0))):
            self.write("model.toml", text + f'[temperature]\nfile = "field.csv"\nscale_about = 20\n{scale}')
            run = self.call("run", "model.toml", "--output", "out", "--quiet")
            self.assertEqual(run.returncode, 0, run.stderr)
            rows = read_rows(self.directory / "out/history.csv")
            self.assertEqual(len(rows), 4)
            for row, share in zip(rows[1:], shares):
                # The mean of 10 z over the length is 100: held at both ends, E alpha 100.
                self.assertAlmostEqual(float(row["force"]), -1e5 * 1e-5 * 100 * share * 100, delta=0.01 * 10000)
        self.write("model.toml", text + '[temperature]\nvalue = "100"\nscale = 2\n')
        self.assertSays(self.call("check", "model.toml").stderr, "scale", "file")


if __name__ == "__main__":
    unittest.main()
