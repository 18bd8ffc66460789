"""The script of docs/paraview draws the deformed bodies: what it says, and what is in the picture."""

import pathlib
import subprocess
import sys
import unittest

from vtkmodules.vtkIOImage import vtkPNGReader

from box_mesh import BoxMesh
from test_fields import ONE_BODY, FieldTest
from waiting import LONGEST

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "docs" / "paraview" / "deformed.py"
SMALL = ("--size", "320", "240")


class Picture(FieldTest):
    """The end of a bar of 6 x 1 x 2 is pulled by 0.01 (1 + z): the stress is not uniform."""

    def setUp(self):
        super().setUp()
        mesh = BoxMesh()
        mesh.add("bar", "hex20", (6, 1, 2), lambda x, y, z: (x, y, z))
        self.compute('units = "mm, N, MPa, h"\n' + ONE_BODY
                     + '[[supports]]\non = "bar_x1"\ndisplacement = { x = "0.01*(1 + z)" }\n', mesh)

    def draw(self, *options, status=0):
        done = subprocess.run(["xvfb-run", "-a", sys.executable, "-B", str(SCRIPT), str(self.output), *options],
                              capture_output=True, text=True, timeout=LONGEST)
        self.assertEqual(done.returncode, status, done.stderr)
        return done.stdout if status == 0 else done.stderr

    def pixels(self, name="deformed.png"):
        """(columns, rows, {(column, row): colour of those that are not white})"""
        reader = vtkPNGReader()
        reader.SetFileName(str(self.output / name))
        reader.Update()
        image = reader.GetOutput()
        width, height, _ = image.GetDimensions()
        colours = {(i, j): tuple(image.GetScalarComponentAsDouble(i, j, 0, c) for c in range(3))
                   for i in range(width) for j in range(height)}
        return width, height, {at: colour for at, colour in colours.items() if colour != (255, 255, 255)}

    def test_last_time_with_a_factor_that_suits(self):
        said = self.draw(*SMALL)
        last = self.grids()[-1]
        stresses = last.values("point", "von_mises")
        self.assertIn(f"von_mises from {min(stresses):.6g} to {max(stresses):.6g} at t = 1000 h", said)
        # A twentieth of the diagonal, 0.05 sqrt(41) = 0.32, over 0.03: 10.7, and 10 is the next below.
        self.assertTrue(said.endswith("displacements x 10\n"), said)
        width, height, drawn = self.pixels()
        self.assertEqual((width, height), (320, 240))
        # The bodies fill the room left of the scale from side to side, and leave the rim of the window free.
        bar = [i for (i, j) in drawn if i < 0.82 * width and j > 0.2 * height]
        self.assertLess(min(bar), 0.06 * width)
        self.assertGreater(max(bar), 0.76 * width)
        self.assertFalse([at for at in drawn if at[0] == 0 or at[1] in (0, height - 1)])
        # Both ends of the scale: dark blue and yellow.
        self.assertTrue([c for c in drawn.values() if c[2] > 60 and c[0] < 100 and c[1] < 60])
        self.assertTrue([c for c in drawn.values() if c[0] > 200 and c[1] > 180 and c[2] < 100])

    def test_options(self):
        first = self.draw("--time", "0.3", "--factor", "3", "--field", "creep_strain_equivalent", "--range", "0",
                          "1e-6", "--view", "0", "-1", "0", "--picture", str(self.output / "first.png"), *SMALL)
        self.assertIn("creep_strain_equivalent from 0 to 1e-06 at t = 0 h, displacements x 3", first)
        # No creep strain at the start: the bar, seen from the side, has the one colour of the lower end.
        _, _, drawn = self.pixels("first.png")
        inside = [drawn[at] for at in drawn if 60 < at[0] < 200 and 110 < at[1] < 140]
        self.assertGreater(len(inside), 1000)
        for channel in zip(*inside):
            self.assertLessEqual(max(channel) - min(channel), 3)

    def test_mistakes(self):
        said = self.draw("--field", "stress", status=1)
        self.assertSays(said, "'stress'", "von_mises")
        self.assertSays(self.draw("--field", "gap", status=1), "contact.pvd: ")


if __name__ == "__main__":
    unittest.main()
