"""States of contact with friction that are hard to find: coarse faces, bodies held by contact alone, slip fronts."""

import csv
import itertools
import unittest

from box_mesh import BoxMesh
from process_case import ProcessTest

# A block pressed onto a larger one, each of few quadratic elements: lengths, place of the small one on the large one,
# elements, moduli, Poisson's ratios, friction, pressure. The larger block is the slave.
PAIRS = [
    (((18.0, 18.2, 6.0), (11.4, 11.6, 3.9)), (3.3, 3.3), ((3, 3, 3), (1, 1, 2)), (1.38e5, 5.8e4), (0, 0.45), 0.15, 51.3),
    (((11.13, 11.31, 8.78), (5.24, 5.12, 7.18)), (2.46, 1.32), ((3, 3, 2), (1, 1, 1)), (4.8e4, 3.53e4), (0.2, 0.3), 0.15, 71.8),
    (((15.29, 15.86, 10.75), (11.61, 11.94, 6.28)), (3.49, 1.66), ((3, 3, 3), (1, 1, 1)), (3.86e4, 2.71e3), (0.45, 0), 0.05, 11.3),
    (((13.81, 12.31, 5.33), (10.57, 7.77, 9.21)), (1.79, 1.74), ((4, 4, 2), (1, 1, 1)), (7.86e4, 3.41e5), (0, 0.45), 0.05, 4.78),
    (((13.24, 16.2, 4.07), (10.5, 11.81, 11.99)), (0.72, 0.88), ((2, 2, 2), (1, 1, 2)), (2.18e5, 3.15e5), (0, 0.45), 0.05, 12.1),
    (((15.81, 11.95, 11.72), (12.17, 7.01, 8.97)), (0.78, 1.09), ((3, 3, 3), (1, 1, 2)), (2.37e5, 829), (0.45, 0.45), 0.2, 16.1),
    (((11.93, 14.5, 9.59), (5.77, 10.8, 5.23)), (0.9, 1.64), ((3, 3, 2), (1, 1, 2)), (1.84e5, 8.88e5), (0, 0.45), 0.05, 41.8),
    (((17.07, 18.46, 11.61), (11.15, 8.89, 11.76)), (5.43, 5.49), ((3, 3, 3), (1, 1, 2)), (3.95e4, 7.28e4), (0, 0.45), 0.1, 5.01),
]

PAIR = """[mesh]
file = "pair.msh"
allow_locking = true
[bodies.low]
region = "low"
material = "low"
[bodies.top]
region = "top"
material = "top"
[materials.low]
young_modulus = {moduli[0]}
poisson_ratio = {ratios[0]}
[materials.top]
young_modulus = {moduli[1]}
poisson_ratio = {ratios[1]}
[[supports]]
on = "low_z0"
displacement = {{ x = 0, y = 0, z = 0 }}
[[supports]]
on = "top_z1"
displacement = {{ x = 0, y = 0 }}
[[loads]]
on = "top_z1"
pressure = {pressure}
[[contacts]]
name = "c"
between = ["low_z1", "top_z0"]
slave = "low_z1"
friction = {friction}
[time]
end = 1
"""

# A bar on a stiff foundation, pulled, let go, pushed and pulled again at its end.
BAR = """[mesh]
file = "bar.msh"
allow_locking = true
[bodies.bar]
region = "bar"
material = "soft"
[bodies.base]
region = "base"
material = "stiff"
[materials.soft]
young_modulus = 1e5
poisson_ratio = 0
[materials.stiff]
young_modulus = 1e11
poisson_ratio = 0
[[supports]]
on = "base_z0"
displacement = { x = 0, z = 0 }
[[supports]]
on = "bar_z1"
displacement = { z = 0 }
[[loads]]
on = "bar_x1"
traction = ["t < 1 ? 600 * t : (t < 2 ? 600 * (3 - 2 * t) : 600 * (2 * t - 5))", 0, 0]
[[contacts]]
name = "c"
between = ["bar_z0", "base_z1"]
gap = -0.003
friction = 0.1
[time]
end = 3
output = [0.5, 1, 1.2, 1.4, 1.6, 1.8, 2, 2.3, 2.6]
breakpoints = [1, 2]
[output]
fields = false
[[probes]]
name = "end"
quantity = "displacement_x"
on = "bar_x1"
""" + "".join(f'[[supports]]\non = "{side}"\ndisplacement = {{ y = 0 }}\n'
              for side in ("bar_y0", "bar_y1", "base_y0", "base_y1"))


class FrictionStates(ProcessTest):
    def test_pairs_of_coarse_blocks_have_a_state(self):
        for (low, top), (x0, y0), counts, moduli, ratios, friction, pressure in PAIRS:
            with self.subTest(low=low):
                mesh = BoxMesh()
                place = [[length / n for length, n in zip(lengths, of)] for lengths, of in zip((low, top), counts)]
                mesh.add("low", "hex20", counts[0], lambda x, y, z, s=place[0]: (s[0] * x, s[1] * y, s[2] * z))
                mesh.add("top", "hex20", counts[1], lambda x, y, z, s=place[1], h=low[2]:
                         (x0 + s[0] * x, y0 + s[1] * y, h + s[2] * z))
                mesh.write(self.directory / "pair.msh")
                self.write("pair.toml", PAIR.format(
                    moduli=moduli, ratios=ratios, friction=friction, pressure=pressure))
                done = self.call("check", "--start", "pair.toml")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertNotIn("no state", done.stdout)

    def test_a_slip_front_passes_many_nodes_in_few_iterations(self):
        mesh = BoxMesh()
        mesh.add("bar", "hex20", (60, 1, 2), lambda x, y, z: (x / 2, y / 2, z / 2))
        mesh.add("base", "hex20", (60, 1, 1), lambda x, y, z: (x / 2, y / 2, z - 1))
        mesh.write(self.directory / "bar.msh")
        self.write("bar.toml", BAR)
        log = self.directory / "contact.csv"
        done = self.call("run", "bar.toml", "--output", "out", "--quiet", "--log-contact", str(log))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("converge", done.stderr)
        with open(log, encoding="utf-8") as file:
            for _, rows in itertools.groupby(csv.DictReader(file), lambda row: row["contact_solve"]):
                methods = [row["method"] for row in rows]
                self.assertEqual(set(methods), {"newton"})
                self.assertLess(len(methods), 80)
        with open(self.output / "history.csv", encoding="utf-8") as file:
            end = {float(row["time"]): float(row["end"]) for row in csv.DictReader(file)}
        # A bar slips over P / (mu p): P^2 / (2 E h mu p), and as much to the other side; solids are within 1 % of it.
        for time, sign in ((1, 1), (2, -1), (3, 1)):
            self.assertAlmostEqual(end[time], sign * 600**2 / (2 * 1e5 * 30), delta=6e-4)


if __name__ == "__main__":
    unittest.main()
