"""Results in memory and in directories are the same."""

import gc
import pickle
import unittest

import numpy as np

import creepcontact as cc
from cases import Case, shrink_fit


class Results(Case):
    def test_memory_and_directory(self):
        model = shrink_fit(**{"events": [{"name": "half", "when": "fit_pressure < 60"}],
                              "criteria": [{"name": "holds", "probe": "fit_pressure", "min": 10}]})
        memory, directory = model.run(), model.run(output=self.directory / "out")
        self.assertIsNone(memory.directory)
        self.assertTrue((self.directory / "out" / "summary.json").is_file())
        for one in (memory, directory):
            self.assertEqual(one.status, "completed")
            self.assertEqual(set(one.events), {"half"})
            self.assertTrue(one.criteria["holds"]["met"])
            self.assertEqual(one.times, [0, 1, 100, 1000])
        self.assertEqual(memory.criteria, directory.criteria)
        np.testing.assert_array_equal(memory.mesh.points, directory.mesh.points)
        self.assertEqual(list(memory.mesh.cells), list(directory.mesh.cells))
        for kind, nodes in memory.mesh.cells.items():
            np.testing.assert_array_equal(nodes, directory.mesh.cells[kind])
        self.assertEqual(memory.mesh.bodies, ["shaft", "disc"])
        for time in (0, 100):
            mine, theirs = memory.fields(time), directory.fields(time)
            self.assertEqual(sorted(mine), sorted(theirs))
            for name in mine:
                np.testing.assert_allclose(mine[name], theirs[name], rtol=1e-6, atol=1e-7 * max(1e-30, abs(mine[name]).max()))
        self.assertEqual(memory.fields()["stress"].shape, (len(memory.mesh.points), 6))
        self.assertEqual(memory.fields()["displacement"].shape, (len(memory.mesh.points), 3))
        self.assertEqual(len(memory.contact_mesh.points), len(memory.fields().contacts["contact_pressure"]))
        self.assertEqual(sum(map(len, memory.mesh.cells.values())), len(memory.fields().cells["body"]))

    def test_groups_are_where_they_should_be(self):
        mesh = shrink_fit().start().mesh
        np.testing.assert_allclose(mesh.points[mesh.groups["symmetry_x"]][:, 0], 0, atol=1e-9)

    def test_arrays_outlive_the_run(self):
        run = shrink_fit().run()
        field, pressure = run.fields()["von_mises"], run.history["fit_pressure"]
        copies = field.copy(), pressure.copy()
        del run
        gc.collect()
        np.testing.assert_array_equal(field, copies[0])
        np.testing.assert_array_equal(pressure, copies[1])
        with self.assertRaises(ValueError):
            field[0] = 1  # it is a view of what the run has

    def test_what_is_not_there(self):
        run = shrink_fit().run()
        with self.assertRaisesRegex(KeyError, "at: 0, 1, 100, 1000"):
            run.fields(50)
        with self.assertRaisesRegex(KeyError, "von_mises"):
            run.fields()["von_misses"]
        with self.assertRaises(cc.ConfigError):
            cc.open(self.directory)
        with self.assertRaisesRegex(KeyError, "no fields"):
            shrink_fit(**{"output.fields": False}).run().fields()

    def test_pickled(self):
        for run in (shrink_fit().run(), shrink_fit().run(output=self.directory / "out")):
            again = pickle.loads(pickle.dumps(run))
            np.testing.assert_array_equal(again.history, run.history)
            np.testing.assert_array_equal(again.fields(100)["stress"], run.fields(100)["stress"])
            np.testing.assert_array_equal(again.mesh.points, run.mesh.points)
            self.assertEqual(again.summary["status"], "completed")

    def test_meshio(self):
        try:
            import meshio
        except ImportError:
            self.skipTest("meshio is missing")
        run = shrink_fit().run(output=self.directory / "out")
        mine = run.mesh.to_meshio(run.fields())
        self.assertIsInstance(mine, meshio.Mesh)
        volume = 0
        for block in mine.cells:  # hexahedra with corners first: the order of their nodes is right if volumes are positive
            self.assertEqual(block.type, "hexahedron20")
            corners = mine.points[block.data[:, :8]]
            edges = corners[:, [1, 3, 4]] - corners[:, [0]]
            volume += np.linalg.det(edges).min()
        self.assertGreater(volume, 0)


if __name__ == "__main__":
    unittest.main()
