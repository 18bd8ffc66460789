"""Arrays of the field files as documented, those of contact, and the surfaces of contact.pvd, read back by VTK."""

import math
import pathlib
import re
import unittest

from box_mesh import BoxMesh
from test_fields import SYMMETRY, FieldTest
from vtk_fields import Grid, collection, without_unit

RESULTS = pathlib.Path(__file__).resolve().parents[2] / "docs" / "results.md"
STEEL = """
[materials.steel]
young_modulus = 1e3
poisson_ratio = 0.3
conductivity = 1
"""
DAMAGE = """
[[materials.steel.creep]]
law = "kachanov_rabotnov"
A = 1e-6
n = 3
B = 1e-6
r = 3
phi = 3
[[materials.steel.creep]]
law = "strain_hardening"
A = 1e-9
n = 2
m = 0.5
[[materials.steel.creep]]
law = "kelvin_voigt"
compliance = 1e-9
time = 1
[materials.steel.rupture]
rupture_time = "1e7/q^3"
"""


def two_bodies(first, second, contact):
    bodies = "".join(f'[bodies.{name}]\nregion = "{name}"\nmaterial = "steel"\n' for name in (first, second))
    return ('units = "mm, N, MPa, h"\n[mesh]\nfile = "mesh.msh"\n' + bodies + STEEL
            + f'[[contacts]]\nname = "joint"\n{contact}\n')


def documented(heading, where):
    """{name: components} of a table in the documentation of the results."""
    section = RESULTS.read_text(encoding="utf-8").split(f"## `{heading}")[1].split("\n## ")[0]
    table = section.split(f"| {where} data ")[1].split("\n\n")[0].splitlines()[2:]
    return {name: int(re.search(r"\d", count).group()) for _, names, count, *_ in (line.split("|") for line in table)
            for name in re.findall("`([^`]+)`", names)}


class FieldArrays(FieldTest):
    """A punch of 1 x 1 in the middle of a block of 3 x 3 x 1, which carries the multipliers; damage, life and heat."""

    def setUp(self):
        super().setUp()
        mesh = BoxMesh()
        mesh.add("block", "hex20", (3, 3, 1), lambda x, y, z: (x, y, z))
        mesh.add("punch", "hex20", (1, 1, 1), lambda x, y, z: (1 + x, 1 + y, 1 + z))
        config = two_bodies("block", "punch", 'between = ["block_z1", "punch_z0"]\nslave = "block_z1"\nfriction = 0.1\nconductance = 1')
        config += '[heat]\nstart = "steady"\ntemperatures = [{ on = "block_z0", value = 0 }, { on = "punch_z1", value = 1 }]\n'
        config += SYMMETRY.format("block")
        config += '[[supports]]\non = "punch_z1"\ndisplacement = { x = 0, y = 0, z = -0.01 }\n'
        config += "[time]\nend = 100\noutput = [1, 10]\n" + DAMAGE
        self.compute(config, mesh)

    def test_arrays_are_the_documented_ones(self):
        for name in ("fields", "contact"):
            for grid in self.grids(name):
                for where in ("point", "cell"):
                    self.assertEqual(grid.components(where), documented(f"{name}.pvd", where))
        self.assertEqual(self.grids()[0].texts("bodies"), ["block", "punch"])
        self.assertEqual(self.grids()[0].field("bodies"), [0, 1])
        self.assertEqual(self.grids("contact")[0].texts("contacts"), ["joint"])

    def test_times_are_those_of_the_history(self):
        for name in ("fields", "contact"):
            listed = collection(self.output / f"{name}.pvd")
            self.assertEqual([time for time, _ in listed], [row["time"] for row in self.history])
            for time, file in listed:
                self.assertEqual(Grid(file).field("TimeValue"), [time])
                self.assertEqual(Grid(file).texts("units"), ["mm", "N", "MPa", "h"])

    def test_meshio_reads_the_files(self):
        try:
            import meshio
        except ImportError:
            self.skipTest("Python has no meshio (Debian package python3-meshio)")
        for name in ("fields", "contact"):
            _, file = collection(self.output / f"{name}.pvd")[-1]
            read, grid = meshio.read(file), Grid(file)
            self.assertEqual(set(map(without_unit, read.point_data)), set(documented(f"{name}.pvd", "point")))
            self.assertIn("TimeValue", read.field_data)
            self.assertEqual(list(map(tuple, read.points)), grid.points())
            for array in set(read.point_data) - {"gap [mm]"}:  # which has NaN
                self.assertEqual([tuple(value) if len(value) > 1 else value[0] for value in read.point_data[array]],
                                 grid.values("point", without_unit(array)), array)

    def test_ranges(self):
        first, *_, last = self.grids()
        for where in ("point", "cell"):
            for name in last.components(where):
                for value in last.values(where, name):
                    for part in value if isinstance(value, tuple) else (value,):
                        self.assertTrue(math.isfinite(part), name)
            self.assertEqual(set(last.values(where, "body")), {0, 1})
            self.assertGreater(min(last.values(where, "von_mises")), 0)
            self.assertLess(max(last.values(where, "von_mises")), 1e3 * 0.01 * 3)
        for name in ("creep_strain_equivalent", "damage", "life_fraction"):
            self.assertEqual(set(first.values("point", name)), {0})
            self.assertGreaterEqual(min(last.values("point", name)), 0)
            self.assertGreater(max(last.values("point", name)), 1e-4)
        self.assertLess(max(last.values("point", "damage")), 1)
        # Creep takes stress off: the multipliers push less, and none of them pulls.
        for name in ("fields", "contact"):
            pressures = [grid.values("point", "contact_pressure") for grid in self.grids(name)]
            self.assertGreaterEqual(min(map(min, pressures)), 0)
            self.assertGreater(max(pressures[0]), max(pressures[-1]))
            self.assertGreater(max(pressures[-1]), 1)

    def test_surface_and_bodies_agree(self):
        for grid, surface in zip(self.grids(), self.grids("contact"), strict=True):
            pressure, gap = surface.values("point", "contact_pressure"), surface.values("point", "gap")
            on_bodies = {}
            for place, body, *values in zip(grid.points(), grid.values("point", "body"),
                                            *(grid.values("point", name) for name in ("contact_pressure", "gap"))):
                on_bodies[place, body] = tuple(values)
            self.assertEqual(surface.data.GetNumberOfCells(), 9)
            for place, p, g in zip(surface.points(), pressure, gap, strict=True):
                self.assertEqual(on_bodies.pop((place, 0)), (p, 0 if math.isnan(g) else g))
                # Beside the punch nothing is opposite; nodes between a corner under it and one beside it have the mean.
                beside = max(0, *(1 - x for x in place[:2]), *(x - 2 for x in place[:2]))
                self.assertEqual(math.isnan(g), beside > 0)
                self.assertEqual(p == 0, beside > 0.5)
            self.assertEqual(set(on_bodies.values()), {(0, 0)})


class FieldEdge(FieldTest):
    """A block pressed by a lid, beside a wall that it does not reach: two contacts share an edge of the block."""

    def test_each_contact_keeps_its_own_at_the_common_edge(self):
        mesh = BoxMesh()
        mesh.add("block", "hex20", (2, 1, 2), lambda x, y, z: (x / 2, y, z / 2))
        mesh.add("lid", "hex20", (1, 1, 1), lambda x, y, z: (x, y, 1 + z))
        mesh.add("wall", "hex20", (1, 1, 1), lambda x, y, z: (1 + x, y, z))
        config = two_bodies("block", "lid", 'between = ["block_z1", "lid_z0"]\nslave = "block_z1"')
        config += '[bodies.wall]\nregion = "wall"\nmaterial = "steel"\n'
        config += '[[contacts]]\nname = "side"\nbetween = ["block_x1", "wall_x0"]\nslave = "block_x1"\ngap = 0.5\n'
        config += SYMMETRY.format("block")
        config += '[[supports]]\non = "lid_z1"\ndisplacement = { x = 0, y = 0, z = -0.01 }\n'
        config += '[[supports]]\non = "wall_x1"\ndisplacement = { x = 0, y = 0, z = 0 }\n[time]\nend = 1\n'
        self.compute(config, mesh)
        surface, grid = self.grids("contact")[0], self.grids()[0]
        self.assertEqual(surface.texts("contacts"), ["joint", "side"])
        self.assertEqual(surface.values("cell", "contact"), [0, 0, 1, 1])
        pressure = [value for place, value in zip(surface.points(), surface.values("point", "contact_pressure"))
                    if (place[0], place[2]) == (1, 1)]
        self.assertEqual(len(pressure), 6)
        self.assertGreater(min(pressure[:3]), 1)
        self.assertEqual(pressure[3:], [0, 0, 0])
        on_bodies = [value for place, body, value in zip(grid.points(), grid.values("point", "body"),
                                                         grid.values("point", "contact_pressure"))
                     if (place[0], place[2], body) == (1, 1, 0)]
        self.assertEqual(sorted(on_bodies), sorted(pressure[:3]))


class FieldFit(FieldTest):
    """A disc, radii 2 and 3, on a shaft, radii 1 and 2, interference 0.002, in plane strain: Lame's solution."""

    def test_fit(self):
        factor, ratio = 2 / (1e3 / 0.91), 0.3 / 0.7  # R/E', nu' of plane strain
        out, into = factor * (13 / 5 + ratio), factor * (5 / 3 - ratio)  # of the two surfaces under unit pressure
        pressure = 0.002 / (out + into)
        for kind in ("tet10", "wedge15", "hex20", "hex27"):
            with self.subTest(kind):
                self.compute(*self.case(kind))
                grid, surface = self.grids()[0], self.grids("contact")[0]
                for value in surface.values("point", "contact_pressure"):
                    self.assertAlmostEqual(value, pressure, delta=0.02 * pressure)
                self.assertLess(max(map(abs, surface.values("point", "gap"))), 1e-9)
                self.assertEqual(set(surface.values("cell", "contact")), {0})
                row = self.history[0]
                # The multipliers' own mean weighs the nodes by what the master covers of them, not quite as VTK does.
                pressures = surface.values("point", "contact_pressure")
                mean = surface.mean("point", "contact_pressure")
                self.assertAlmostEqual(mean, row["pressure"], delta=0.1 * (max(pressures) - min(pressures)))
                self.assertAlmostEqual(mean, pressure, delta=2e-3 * pressure)
                on_bodies = grid.values("point", "contact_pressure")
                self.assertEqual(sum(value > 0 for value in on_bodies), surface.data.GetNumberOfPoints())
                # Warping takes the fit to where the two surfaces meet.
                radii = [math.hypot(x, y) for x, y, _ in surface.warped().points()]
                for radius in radii:
                    self.assertAlmostEqual(radius, 2 + out * pressure, delta=5e-3 * out * pressure)
                bodies, places = grid.values("point", "body"), grid.points()
                for body, place, moved in zip(bodies, places, grid.warped().points(), strict=True):
                    if abs(math.hypot(place[0], place[1]) - 2) < 1e-9:
                        change = out * pressure if body == 1 else -into * pressure
                        self.assertAlmostEqual(math.hypot(moved[0], moved[1]), 2 + change, delta=5e-3 * abs(change))

    @staticmethod
    def case(kind):
        def ring(inner, cells, around):
            def shape(x, y, z):
                angle, radius = math.pi / 2 * y / around, inner + x / cells
                return radius * math.cos(angle), radius * math.sin(angle), 0.2 * z
            return shape
        mesh, planes = BoxMesh(), {"x": "y1", "y": "y0"}
        config = two_bodies("shaft", "disc", 'between = ["shaft_x1", "disc_x0"]\nslave = "disc_x0"\ngap = -0.002')
        for body, inner, around in (("shaft", 1, 8), ("disc", 2, 7)):
            mesh.add(body, kind, (3, around, 1), ring(inner, 3, around))
            for axis, side in (("x", "y1"), ("y", "y0"), ("z", "z0"), ("z", "z1")):
                config += f'[[supports]]\non = "{body}_{side}"\ndisplacement = {{ {axis} = 0 }}\n'
        config += '[time]\nend = 1\n[[probes]]\nname = "pressure"\nquantity = "contact_pressure"\non = "disc_x0"\n'
        return config, mesh


if __name__ == "__main__":
    unittest.main()
