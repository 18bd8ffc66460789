"""NAFEMS R0027, test 7 (thick cylinder under internal pressure, plane strain) for 100 h on meshes of every kind of element, read from
.msh files: the creep strain grows to a hundred times the elastic strain and more, and the stress must stay steady."""

import csv
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

from box_mesh import BoxMesh
from waiting import LONGEST

PROGRAM = os.environ["CREEPCONTACT_PROGRAM"]
ANGLE = math.radians(10)
CONFIG = """
[mesh]
file = "cylinder.msh"
[bodies.wall]
region = "wall"
material = "steel"
[materials.steel]
young_modulus = 200e3
poisson_ratio = 0.3
[[materials.steel.creep]]
law = "norton"
A = 3.125e-14
n = 5
[[loads]]
on = "wall_x0"
pressure = 200
[time]
end = 100
tolerance = 1e-3
output = [1, 10]
[[probes]]
name = "bore"
quantity = "stress_theta"
at = [100, 0, 2.5]
[[probes]]
name = "rim"
quantity = "stress_theta"
at = [200, 0, 2.5]
[[probes]]
name = "smallest_mean"
quantity = "hydrostatic"
body = "wall"
reduce = "min"
[[probes]]
name = "largest_mean"
quantity = "hydrostatic"
body = "wall"
reduce = "max"
""" + "".join(f'[[supports]]\non = "wall_{side}"\ndisplacement = {{ normal = 0 }}\n' for side in ("y0", "y1", "z0", "z1"))


def cylinder(n_wall, n_around):
    def shape(x, y, z):
        radius, angle = 100 + 100 * x / n_wall, ANGLE * y / n_around
        return radius * math.cos(angle), radius * math.sin(angle), 5 * z
    return shape


def steady(r, n=5):
    """Hoop and mean stress."""
    scale = 200 / (2**(2 / n) - 1)
    part = (200 / r)**(2 / n)
    return scale * (1 - (1 - 2 / n) * part), scale * (1 - (1 - 1 / n) * part)


class Locking(unittest.TestCase):
    def history(self, kind, n_wall):
        mesh = BoxMesh()
        mesh.add("wall", kind, (n_wall, 2, 1), cylinder(n_wall, 2))
        with tempfile.TemporaryDirectory() as directory:
            place = pathlib.Path(directory)
            mesh.write(place / "cylinder.msh")
            (place / "case.toml").write_text(CONFIG)
            done = subprocess.run([PROGRAM, "run", "case.toml", "--output", "out", "--quiet"], cwd=place,
                                  capture_output=True, text=True, timeout=LONGEST)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(place / "out" / "history.csv", newline="", encoding="utf-8") as file:
                return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]

    def test_stress_stays_steady(self):
        largest = steady(200)[0]
        for kind, n_wall in (("hex8", 40), ("hex20", 20), ("hex27", 20), ("wedge15", 20), ("tet10", 20)):
            for row in self.history(kind, n_wall)[1:]:
                with self.subTest(kind, time=row["time"]):
                    self.assertAlmostEqual(row["bore"], steady(100)[0], delta=0.02 * largest)
                    self.assertAlmostEqual(row["rim"], steady(200)[0], delta=0.02 * largest)
                    self.assertAlmostEqual(row["smallest_mean"], steady(100)[1], delta=0.05 * largest)
                    self.assertAlmostEqual(row["largest_mean"], steady(200)[1], delta=0.05 * largest)


if __name__ == "__main__":
    unittest.main()
