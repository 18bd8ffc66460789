"""creepcontact check --start and --fields: the state at t = 0, the refusals of a run, the files and the picture."""

import pathlib
import re
import subprocess
import unittest

from test_runs import PROGRAM, SHORT, RunTest
from waiting import LONGEST

CONFIGS = pathlib.Path(__file__).resolve().parents[2] / "configs"


class StartCheck(RunTest):
    def test_says_what_the_run_begins_with(self):
        done = self.call("check", "--start")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(list(self.directory.iterdir()), [])
        self.run_short("--quiet")
        summary = self.summary()
        force = re.search(r"contact 'fit': .*force ([\d.e+]+) N, .*pressure ([\d.]+) MPa, ", done.stdout)
        initial = summary["contacts"]["fit"]["initial_normal_force"]
        self.assertAlmostEqual(float(force[1]), initial, delta=1e-3 * initial)
        self.assertGreaterEqual(float(force[2]), 0.999 * self.table("history.csv")[0]["fit_pressure"])
        for body, results in summary["bodies"].items():
            stress = re.search(rf"body '{body}': .*stress ([\d.]+) MPa at .*; .* ([\d.e+]+) h \((\S+) time.end\), .* ([\d.e+]+) h", done.stdout)
            initial = results["initial_von_mises"]
            self.assertAlmostEqual(float(stress[1]), initial, delta=1e-3 * initial)
            self.assertAlmostEqual(float(stress[2]) / 1e6, float(stress[3]), delta=0.06 * float(stress[3]))
            self.assertLess(float(stress[4]), float(stress[2]))

    def test_run_and_check_refuse_the_same(self):
        (self.directory / "file").write_text("")
        out = ("--output", str(self.output))
        for status, options in ((3, (*out, "--set", "contacts.0.gap=0")),
                                (2, ("--output", "file")), (2, ("--output", "file/below")),
                                (2, (*out, "--resume")), (2, (*out, "--threads", "0"))):
            refused = [self.call(command, *options, *more) for command, more in
                       (("run", ()), ("check", ()), ("check", ("--start",)))]
            errors = [[line for line in done.stderr.splitlines() if line.startswith("error: ")] for done in refused]
            self.assertEqual([done.returncode for done in refused], [status] * 3, errors)
            self.assertTrue(errors[0])
            self.assertEqual(errors, errors[:1] * 3)
        self.assertFalse(self.output.exists())

    def test_resume_from_a_checkpoint(self):
        self.run_short("--quiet")
        options = ("--output", str(self.output), *SHORT, "--resume")
        self.assertEqual(self.call("check", *options).returncode, 0)
        self.expect_error(self.call("check", *options, "--set", "contacts.0.gap=-0.08"), 2, "checkpoint.h5: ", "contacts[0].gap", "-0.08")


class Remarks(RunTest):
    """What is allowed and seldom meant is said by check and run; the examples give no cause."""

    REMARKS = ("Young's modulus of body '", "coefficient of friction", "generalised plane strain: ", r"no \[\[cyclic\]\]", "beyond its edges")

    def test_examples_have_none(self):
        for config in sorted(CONFIGS.glob("*.toml")):
            with self.subTest(config.stem):
                done = subprocess.run([PROGRAM, "check", str(config), "--output", str(self.output)], cwd=self.directory,
                                      capture_output=True, text=True, timeout=LONGEST)
                self.assertEqual(done.returncode, 0, done.stderr)
                for remark in self.REMARKS:
                    self.assertNotRegex(done.stdout, remark)


class ModelView(RunTest):
    def view(self, *more):
        done = self.call("check", "--fields", "--output", str(self.output), *more)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done

    def colours(self, file):
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOImage import vtkPNGReader
        reader = vtkPNGReader()
        reader.SetFileName(str(file))
        reader.Update()
        return {tuple(map(int, rgb)) for rgb in vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())}

    def test_files_and_picture(self):
        done = self.view()
        written = re.findall(r"(?m)^written: (.*)$", done.stdout)
        self.assertEqual(written, [str(self.output / name) for name in
                                   ("model.pvd", "groups.pvd", "plots/model.png")])
        for name in ("model", "groups"):
            self.assertEqual(len(re.findall("<DataSet", (self.output / f"{name}.pvd").read_text())), 2)
        arrays = {"model": ("body", "support", "load"),
                  "groups": ("body", "group", "support", "load", "contact", "gap", "distance")}
        for name, expected in arrays.items():
            content = (self.output / name / f"{name}_0001.vtu").read_bytes()
            for array in expected:
                self.assertIn(f'Name="{array}"'.encode(), content)
        # The families of colours: blue supports, green contacts.
        colours = self.colours(self.output / "plots" / "model.png")
        self.assertTrue([1 for red, green, blue in colours if blue > 1.5 * max(red, green)])
        self.assertTrue([1 for red, green, blue in colours if green > 1.5 * max(red, blue)])
        self.assertEqual({path.name for path in self.output.iterdir()},
                         {"model.pvd", "model", "groups.pvd", "groups", "plots"})


if __name__ == "__main__":
    unittest.main()
