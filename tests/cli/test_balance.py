"""Loads in balance but for round-off, in any units: what is round-off is judged by the loads."""

import unittest

from process_case import ProcessTest
from test_signals import read_rows

# Two blocks without friction side by side on a base, under a beam. Their bulging pushes them apart.
GEOMETRY = """
Macro Piece
  p = newp; Point(p) = {x0, y0, 0}; Point(p + 1) = {x1, y0, 0}; Point(p + 2) = {x1, y1, 0}; Point(p + 3) = {x0, y1, 0};
  l = newl; Line(l) = {p, p + 1}; Line(l + 1) = {p + 1, p + 2}; Line(l + 2) = {p + 2, p + 3}; Line(l + 3) = {p + 3, p};
  c = newll; Curve Loop(c) = {l, l + 1, l + 2, l + 3}; s = news; Plane Surface(s) = {c};
  Transfinite Curve{l, l + 2} = nx + 1; Transfinite Curve{l + 1, l + 3} = ny + 1; Transfinite Surface{s};
  Recombine Surface{s};
Return
size = SIZE;
x0 = -8 * size; x1 = 8 * size; y0 = -4 * size; y1 = 0; nx = 8; ny = 2; Call Piece;
Physical Surface("base") = {s}; Physical Curve("base_foot") = {l}; Physical Curve("base_top") = {l + 2};
x0 = -4 * size; x1 = 0; y0 = 0; y1 = 2 * size; nx = 3; ny = 2; Call Piece;
Physical Surface("l") = {s}; Physical Curve("l_foot") = {l}; Physical Curve("l_right") = {l + 1};
Physical Curve("l_top") = {l + 2};
x0 = 0; x1 = 4 * size; Call Piece;
Physical Surface("r") = {s}; Physical Curve("r_foot") = {l}; Physical Curve("r_left") = {l + 3};
Physical Curve("r_top") = {l + 2};
x0 = -6 * size; x1 = 6 * size; y0 = 2 * size; y1 = 3 * size; nx = 8; ny = 1; Call Piece;
Physical Surface("beam") = {s}; Physical Curve("beam_foot") = {l}; Physical Curve("beam_top") = {l + 2};
"""

MODEL = """analysis = "plane_strain"
[mesh]
file = "blocks.geo"
order = 2
[materials.m]
young_modulus = %(modulus)r
poisson_ratio = 0.3
[[supports]]
on = "base_foot"
displacement = { x = 0, y = 0 }
[[supports]]
on = "beam_top"
displacement = { x = 0 }
[[loads]]
on = "beam_top"
pressure = "%(load)r * (30 + 10 * (x / %(size)r)^2 / 36)"
[time]
end = 1
[output]
fields = false
[[probes]]
name = "left"
quantity = "contact_force_y"
on = "l_foot"
[[probes]]
name = "right"
quantity = "contact_force_y"
on = "r_foot"
[[probes]]
name = "between"
quantity = "contact_pressure"
on = "l_right"
reduce = "max"
"""
BODIES = "".join(f'[bodies.{name}]\nregion = "{name}"\nmaterial = "m"\n' for name in ("base", "l", "r", "beam"))
CONTACTS = "".join(f'[[contacts]]\nname = "c{i}"\nbetween = ["{slave}", "{master}"]\n' for i, (slave, master) in enumerate(
    [("l_foot", "base_top"), ("r_foot", "base_top"), ("l_top", "beam_foot"), ("r_top", "beam_foot"),
     ("l_right", "r_left")]))


class Balance(ProcessTest):
    def test_blocks_pushed_apart_in_any_units(self):
        for size, load in ((1.0, 1.0), (1.0, 1e-6), (1.0, 1e6), (1e-3, 1e6), (1e3, 1.0)):
            with self.subTest(size=size, load=load):
                self.write("blocks.geo", GEOMETRY.replace("SIZE", repr(size)))
                self.write("blocks.toml", MODEL % {"modulus": 2e5 * load, "load": load, "size": size} + BODIES + CONTACTS)
                done = self.call("run", "blocks.toml", "--output", "out", "--quiet")
                self.assertEqual(done.returncode, 0, done.stderr)
                last = read_rows(self.output / "history.csv")[-1]
                for block in ("left", "right"):
                    self.assertAlmostEqual(abs(last[block]) / (load * size), 200, delta=1e-5)
                self.assertLess(last["between"], 1e-9 * load)


if __name__ == "__main__":
    unittest.main()
