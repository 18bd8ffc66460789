"""creepcontact plot: pictures of a small run, and what it says of directories that hold none."""

import os
import struct
import subprocess
import unittest
import xml.etree.ElementTree

from test_runs import PROGRAM, RunTest
from waiting import LONGEST


class Plot(RunTest):
    def plot(self, *more, **environment):
        return subprocess.run([PROGRAM, "plot", *more], cwd=self.directory, capture_output=True, text=True, timeout=LONGEST,
                              env={**os.environ, **environment})

    def texts(self, picture):
        root = xml.etree.ElementTree.parse(picture).getroot()
        return {"".join(text.itertext()).strip() for text in root.iter("{http://www.w3.org/2000/svg}text")}

    def test_pictures_of_a_run(self):
        self.run_short("--quiet")
        done = self.plot("out")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout.split(), [f"out/plots/{name}.{kind}" for name in ("history", "steps") for kind in ("svg", "png")])
        plots = self.output / "plots"
        history, steps = self.texts(plots / "history.svg"), self.texts(plots / "steps.svg")
        self.assertLessEqual({"fit_pressure", "disc_hoop_stress", "rim_displacement", "time (h)",
                              "stress (MPa)", "displacement (mm)"}, history)
        self.assertLessEqual({"step length (h)", "order", "Schwarz iterations", "active contacts"}, steps)
        for name in ("history.png", "steps.png"):
            content = (plots / name).read_bytes()
            self.assertEqual(content[:8], b"\x89PNG\r\n\x1a\n")
            width, height = struct.unpack(">II", content[16:24])
            self.assertTrue(600 < width < 1600 and 300 < height < 1600, (width, height))

        # a choice of probes, elsewhere
        done = self.plot("out", "--probes", "rim_displacement", "--output", "chosen", "--log-time", "yes")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        chosen = self.texts(self.directory / "chosen" / "history.svg")
        self.assertIn("rim_displacement", chosen)
        self.assertNotIn("fit_pressure", chosen)
        self.assertIn("set logscale x", (self.directory / "chosen" / "history.gp").read_text())

        self.expect_error(self.plot("out", "--probes", "fit_presure"), 2, "'fit_presure'", "'fit_pressure'")
        self.expect_error(self.plot("out", "--log-time", "ja"), 2, "--log-time: ", "'ja'")
        self.expect_error(self.plot("out", PATH="/nonexistent"), 2, "gnuplot", "apt-get install gnuplot-nox")

    def test_events_are_lines_with_their_names(self):
        events = "events=[{ name = 'slack', when = 'fit_pressure < 64.55' }, { name = 'never', when = 'fit_pressure < 0' }]"
        self.run_short("--quiet", "--set", events)
        times = self.summary()["events"]
        self.assertIsNone(times["never"])
        self.assertTrue(0 < times["slack"] < 10, times)
        done = self.plot("out")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for picture in ("history", "steps"):
            self.assertIn("slack", self.texts(self.output / "plots" / f"{picture}.svg"))
            self.assertNotIn("never", self.texts(self.output / "plots" / f"{picture}.svg"))
            self.assertIn(f"set arrow 10 from first {times['slack']:.6g}"[:30],
                          (self.output / "plots" / f"{picture}.gp").read_text())

    def test_tables_for_spreadsheets(self):
        self.run_short("--quiet", "--set", "output.separator=;", "--set", "output.decimal=,")
        self.assertTrue((self.output / "history.csv").read_text().startswith("time;fit_pressure;"))
        done = self.plot("out")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("fit_pressure", self.texts(self.output / "plots" / "history.svg"))

    def test_directories_without_a_run(self):
        self.expect_error(self.plot("none"), 2, "directory 'none'")
        self.output.mkdir()
        self.expect_error(self.plot("out"), 2, "history.csv", "'out'")
        (self.output / "history.csv").write_text("time,a\n0,1\n")
        self.expect_error(self.plot("out"), 2, "1 row;")
        # a run that failed before its first output time has steps to look at
        names = "step,order,rhs_evaluations,elastic_solves,schwarz_iterations,active_contacts,error_estimate"
        (self.output / "steps.csv").write_text(f"time,{names}\n1,1,1,1,1,0,0,0\n3,2,1,1,1,0,0,0\n")
        done = self.plot("out")
        self.assertEqual((done.returncode, done.stdout.split()), (0, ["out/plots/steps.svg", "out/plots/steps.png"]))
        self.assertSays(done.stderr, "history.csv", "1 row; ")

    def test_a_run_without_summary(self):
        self.output.mkdir()
        (self.output / "history.csv").write_text("time,a_b\n0,1\n1,2\n")
        done = self.plot("out")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertSays(done.stderr, "warning: out/summary.json: ")
        self.assertIn("a_b", self.texts(self.output / "plots" / "history.svg"))


if __name__ == "__main__":
    unittest.main()
