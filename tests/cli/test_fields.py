"""Field files read back by VTK: arrays, times, elements of every kind, deformed places, means over bodies."""

import math
import subprocess
import unittest

from box_mesh import CELLS, BoxMesh
from test_runs import PROGRAM, RunTest
from vtk_fields import Grid, collection, jacobians
from waiting import LONGEST

SYMMETRY = "".join(f'[[supports]]\non = "{{0}}_{axis}0"\ndisplacement = {{{{ {axis} = 0 }}}}\n' for axis in "xyz")
ONE_BODY = """
[mesh]
file = "mesh.msh"
allow_locking = true
[bodies.bar]
region = "bar"
material = "steel"
[materials.steel]
young_modulus = 1e3
poisson_ratio = 0.3
[[materials.steel.creep]]
law = "norton"
A = 1e-9
n = 3
[time]
end = 1e3
output = [1]
""" + SYMMETRY.format("bar")


def form_of(kind):
    return kind.rstrip("0123456789")


def ring(n):
    """A quarter of a ring, radii 1 and 2, thickness 1/2, from a lattice of 2 x n x 1."""
    def shape(x, y, z):
        angle = math.pi / 2 * y / n
        return (1 + x / 2) * math.cos(angle), (1 + x / 2) * math.sin(angle), 0.5 * z
    return shape


class FieldTest(RunTest):
    def compute(self, config, mesh):
        mesh.write(self.directory / "mesh.msh")
        (self.directory / "case.toml").write_text(config)
        done = subprocess.run([PROGRAM, "run", "case.toml", "--output", str(self.output), "--quiet"],
                              cwd=self.directory, capture_output=True, text=True, timeout=LONGEST)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.history = self.table("history.csv")

    def grids(self, name="fields"):
        return [Grid(file) for _, file in collection(self.output / f"{name}.pvd")]

    def expect_all(self, values, exact, tolerance):
        """@param tolerance  absolute, of every component of every value"""
        for value in values:
            for found, wanted in zip(value, exact, strict=True):
                self.assertAlmostEqual(found, wanted, delta=tolerance)


class FieldElements(FieldTest):
    """A bar 3 x 1 x 2 pulled by 10: strain 10/E + A 10^3 t along it, in every kind of element the same."""

    VTK = {"tet4": "vtkTetra", "tet10": "vtkQuadraticTetra", "wedge6": "vtkWedge", "wedge15": "vtkQuadraticWedge",
           "hex8": "vtkHexahedron", "hex20": "vtkQuadraticHexahedron", "hex27": "vtkTriQuadraticHexahedron"}

    def test_bar(self):
        for kind in CELLS:
            with self.subTest(kind):
                mesh = BoxMesh()
                mesh.add("bar", kind, (2, 1, 1), lambda x, y, z: (1.5 * x, y, 2 * z))
                self.compute(ONE_BODY + '[[loads]]\non = "bar_x1"\ntraction = [10, 0, 0]\n', mesh)
                for (time, _), grid in zip(collection(self.output / "fields.pvd"), self.grids(), strict=True):
                    self.check_cells(grid, kind)
                    self.check_state(grid, 1e-9 * 1e3 * time)

    def test_bent_cells_are_the_ring_but_for_parabolas_in_place_of_arcs(self):
        n, volume = 3, math.pi / 4 * 3 * 0.5
        for kind in ("tet10", "wedge15", "hex20", "hex27"):
            with self.subTest(kind):
                mesh = BoxMesh()
                mesh.add("bar", kind, (2, n, 1), ring(n))
                self.compute(ONE_BODY + '[[loads]]\non = "bar_x1"\npressure = 1\n', mesh)
                sign, form = (-1 if kind == "wedge15" else 1), form_of(kind)
                parts = [(sign * jacobian, weight) for cell in self.grids()[0].cells()
                         for jacobian, weight in jacobians(cell, form)]
                self.assertGreater(min(parts)[0], 0)
                total = sum(jacobian * weight for jacobian, weight in parts)
                self.assertAlmostEqual(total, volume, delta=(math.pi / 4 / n)**4 / 15 * volume)

    def check_cells(self, grid, kind):
        form, volume = form_of(kind), 6 / grid.data.GetNumberOfCells()
        for cell in grid.cells():
            self.assertEqual(cell.GetClassName(), self.VTK[kind])
            # A node out of its place bends the cell. The parametric axes of VTK's wedges are left-handed: the bottom
            # must look outward, say VTK's faces.
            sign = -1 if form == "wedge" else 1
            for jacobian, _ in jacobians(cell, form):
                self.assertAlmostEqual(sign * jacobian, volume * {"hex": 1, "wedge": 2, "tet": 6}[form], delta=1e-11)
        self.assertAlmostEqual(grid.enclosed(), 6, delta=1e-12)
        if kind != "hex27":
            for size in grid.sizes():
                self.assertAlmostEqual(size, volume, delta=1e-12)

    def check_state(self, grid, creep):
        along, across = 1e-2 + creep, -0.3e-2 - creep / 2
        moved = grid.warped()
        for (x, y, z), found in zip(grid.points(), moved.points()):
            self.expect_all([found], (x * (1 + along), y * (1 + across), z * (1 + across)), 1e-9)
        # in VTK, surfaces have single precision
        self.assertAlmostEqual(moved.enclosed(), 6 * (1 + along) * (1 + across)**2, delta=1e-6)
        for where in ("point", "cell"):
            self.expect_all(grid.values(where, "stress"), (10, 0, 0, 0, 0, 0), 1e-7)
            self.expect_all(grid.values(where, "creep_strain"), (creep, -creep / 2, -creep / 2, 0, 0, 0), 1e-10)
            self.expect_all([grid.values(where, "von_mises")], [10] * len(grid.values(where, "von_mises")), 1e-7)
            self.assertEqual(set(grid.values(where, "body")), {0})
        for equivalent in grid.values("point", "creep_strain_equivalent"):
            self.assertAlmostEqual(equivalent, creep, delta=1e-10)


class FieldMeans(FieldTest):
    """Means of the element fields over a body are those of the integration points, which the probes have."""

    COMPONENTS = ("xx", "yy", "zz", "xy", "yz", "zx")

    def compare(self, config, mesh, kind, tolerance):
        """@param tolerance  relative to the difference between the largest and the smallest value in the body"""
        for field in ("stress", "creep_strain"):
            for component in self.COMPONENTS:
                config += f'[[probes]]\nname = "{field}_{component}"\nquantity = "{field}_{component}"\nbody = "bar"\n'
        self.compute(config, mesh)
        grids = [grid.tetrahedra() if kind == "hex27" else grid for grid in self.grids()]
        for row, grid in zip(self.history, grids, strict=True):
            for field in ("stress", "creep_strain"):
                means, values = grid.mean("cell", field), grid.values("cell", field)
                spread = max(max(column) - min(column) for column in zip(*values))
                self.assertEqual(spread > 0, field == "stress" or row["time"] > 0)
                for component, mean in zip(self.COMPONENTS, means, strict=True):
                    self.assertAlmostEqual(mean, row[f"{field}_{component}"], delta=tolerance * spread, msg=component)
        return grids

    def test_flat_sides(self):
        # Volumes are exact, here and in VTK: rounding is left.
        def shape(x, y, z):
            return x + 0.5 * max(x - 1, 0), y, 0.5 * z + 0.2 * max(z - 1, 0)  # cells of different sizes
        for kind in CELLS:
            with self.subTest(kind):
                mesh = BoxMesh()
                mesh.add("bar", kind, (3, 2, 2), shape)
                self.compare(ONE_BODY + '[[loads]]\nbody = "bar"\nbody_force = ["5*x", 1, 2]\n', mesh, kind, 1e-11)

    def test_bent_sides(self):
        # VTK integrates between chords from node to node. With the angle a between the nodes, the caps that these cut
        # off at the radii r between cells are r^2 (1 - sin(a)/a) out of r_outer^2 - r_inner^2 = 3: volume that changes
        # to the next cell or is lost. The mean cannot move by more than that part of the range of values.
        n = 6
        for kind in CELLS:
            with self.subTest(kind):
                linear = kind in ("tet4", "wedge6", "hex8")  # polygons for the program too
                angle = math.pi / 2 / n / (1 if linear else 2)
                caps = (1 + 1.5**2 + 2**2) / 3 * (1 - math.sin(angle) / angle)
                mesh = BoxMesh()
                mesh.add("bar", kind, (2, n, 1), ring(n))
                # The last side of the lattice, not the first, is the plane x = 0.
                config = ONE_BODY.replace('"bar_x0"', '"bar_y1"') + '[[loads]]\non = "bar_x0"\npressure = 10\n'
                for grid in self.compare(config, mesh, kind, 1e-11 if linear else caps):
                    sizes = grid.sizes()
                    self.assertGreater(min(sizes), 0)
                    self.assertAlmostEqual(sum(sizes), math.pi / 4 * 3 * 0.5 * math.sin(angle) / angle, delta=1e-12)


if __name__ == "__main__":
    unittest.main()
