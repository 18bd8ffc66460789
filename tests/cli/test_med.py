"""Meshes of Salome: boxes of every kind of element give the same displacements as .med and as .msh."""

import pathlib
import subprocess
import tempfile
import unittest

import numpy
import meshio

from box_mesh import BoxMesh
from says import Says
from study_case import PROGRAM
from waiting import LONGEST

CONFIG = """[mesh]
file = "{file}"
allow_locking = true
[bodies.box]
region = "box"
material = "steel"
[materials.steel]
young_modulus = 1e5
poisson_ratio = 0.3
[[supports]]
on = "box_x0"
displacement = {{ x = 0, y = 0, z = 0 }}
[[loads]]
on = "box_x1"
traction = [100, 30, -20]
[time]
end = 1
[[probes]]
name = "u"
quantity = "displacement_y"
on = "{probe}"
"""
meshio._mesh.topological_dimension.setdefault("wedge15", 3)  # forgotten there

# The corners of a cell, and the nodes on its edges, seen in a mirror.
MIRRORED = {"tetra": [0, 2, 1, 3], "tetra10": [0, 2, 1, 3, 6, 5, 4, 7, 9, 8], "hexahedron": [0, 3, 2, 1, 4, 7, 6, 5],
            "hexahedron20": [0, 3, 2, 1, 4, 7, 6, 5, 11, 10, 9, 8, 15, 14, 13, 12, 16, 19, 18, 17],
            "wedge": [0, 2, 1, 3, 5, 4], "wedge15": [0, 2, 1, 3, 5, 4, 8, 7, 6, 11, 10, 9, 12, 14, 13]}


def bent(x, y, z):
    return (2 * x + 0.1 * y * z, y + 0.05 * x * x, z - 0.1 * x * y)


class Med(Says, unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.directory = pathlib.Path(scratch.name)

    def msh(self, kind):
        box = BoxMesh()
        box.add("box", kind, (2, 1, 1), bent)
        box.write(self.directory / "box.msh")
        return meshio.read(self.directory / "box.msh")

    def write_med(self, read, mirrored=False, corner=False, more=()):
        names = {data[0]: name for name, data in read.field_data.items()}
        family = {number: -i for i, number in enumerate(sorted(names), 1)}
        cells, tags = [], []
        for block, numbers in zip(read.cells, read.cell_data["gmsh:physical"]):
            order = MIRRORED.get(block.type) if mirrored else None
            cells.append((block.type, block.data if order is None else block.data[:, order]))
            tags.append([family[number] for number in numbers])
        kinds = sorted({kind for kind, data in cells}, reverse=True)  # one block of each, as in files
        made = meshio.Mesh(read.points, [(kind, numpy.concatenate([data for own, data in cells if own == kind])) for kind in kinds],
                           cell_data={"cell_tags": [numpy.array(sum((t for t, (own, _) in zip(tags, cells) if own == kind), []))
                                                    for kind in kinds]})
        made.cell_tags = {family[number]: [name] for number, name in names.items()}
        if corner:
            at = numpy.argmax(read.points.sum(axis=1))
            made.point_data["point_tags"] = numpy.where(numpy.arange(len(read.points)) == at, 1, 0)
            made.point_tags = {1: ["corner"]}
        meshio.write(self.directory / "box.med", made)

    def call(self, command, file, probe="box_x1", *options):
        (self.directory / "box.toml").write_text(CONFIG.format(file=file, probe=probe))
        return subprocess.run([PROGRAM, command, "box.toml", *options], cwd=self.directory, capture_output=True, text=True,
                              timeout=LONGEST)

    def displacement(self, file, probe="box_x1"):
        done = self.call("run", file, probe, "--output", "results", "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        return float((self.directory / "results/history.csv").read_text().split(",")[-1])

    def test_every_kind_of_element(self):
        for kind in ("tet4", "tet10", "wedge6", "wedge15", "hex8", "hex20"):
            read = self.msh(kind)
            expected = self.displacement("box.msh")
            self.assertGreater(abs(expected), 1e-5)
            for mirrored in (False, True):
                with self.subTest(kind, mirrored=mirrored):
                    self.write_med(read, mirrored)
                    self.assertAlmostEqual(self.displacement("box.med") / expected, 1, delta=1e-9)

    def test_groups_of_nodes(self):
        self.write_med(self.msh("hex20"), corner=True)
        self.assertNotAlmostEqual(self.displacement("box.med", "corner"), self.displacement("box.med"), delta=1e-7)

    def test_files_that_are_none(self):
        self.write_med(self.msh("hex8"))
        whole = (self.directory / "box.med").read_bytes()
        for content in (b"", b"no mesh", whole[:2000], whole[:len(whole) // 2]):
            (self.directory / "box.med").write_bytes(content)
            done = self.call("check", "box.med")
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertSays(done.stderr, "error: ", "box.med")

    def test_cells_that_are_not_known_are_told(self):
        read = self.msh("hex8")
        read.points = numpy.vstack([read.points, [[9, 9, 9]]])
        number = read.field_data["box"][0]
        read.cells.append(meshio.CellBlock("pyramid", numpy.array([[0, 1, 2, 3, len(read.points) - 1]])))
        read.cell_data["gmsh:physical"].append(numpy.array([number]))
        self.write_med(read)
        self.assertSays(self.call("check", "box.med").stderr, "warning: ", "box.med", "left out", "PYRA5")


if __name__ == "__main__":
    unittest.main()
