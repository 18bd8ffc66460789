"""creepcontact report and picture: what they say of runs of all kinds, and how a report shows itself in a browser."""

import html
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess

from test_runs import PROGRAM, RunTest
from waiting import LONGEST

VIEWER = pathlib.Path(PROGRAM).resolve().parents[1] / "viewer"


class ReportTest(RunTest):
    def program(self, *words, **environment):
        return subprocess.run([PROGRAM, *words], cwd=self.directory, capture_output=True, text=True, timeout=LONGEST,
                              env={**os.environ, **environment})

    WITHOUT_PICTURES = {"PATH": "/nonexistent", "DISPLAY": ""}  # nor plots: their programs are not found

    def report(self, *words, **environment):
        done = self.program("report", *words, **environment)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    @staticmethod
    def text_of(page):
        """Without markup, scripts and data."""
        page = re.sub(r"<(script|style)\b.*?</\1>", " ", page, flags=re.S)
        return html.unescape(re.sub(r"\s+", " ", re.sub(r"<[^>]*>", " ", page)))


class Report(ReportTest):
    def test_a_run(self):
        self.run_short("--quiet", "--set", 'materials.wheel.sources="ISO 7 & a <test>"')
        self.assertIn("out/report.html", self.report("out"))
        page = (self.output / "report.html").read_text()
        self.assertNotRegex(re.sub(r"<script>.*?</script>", "", page, flags=re.S), r'(src|href)="(?!data:|#)')
        text = self.text_of(page)
        summary = self.summary()
        force = summary["contacts"]["fit"]
        self.assertIn(f"{force['initial_normal_force']:.5g} N at the start to", text)
        for said in ("Shrink fit: a disc relaxes on its shaft", "Young's modulus", "rate = A q^n", "symmetry_x", "disc_bore",
                     "ISO 7 & a <test>", "(interference)", "fit_pressure", "The run gave no warnings.",
                     "relative accuracy asked for the stress", json.loads((self.output / "model.json").read_text())["fingerprint"]):
            self.assertIn(said, text)
        self.assertGreaterEqual(page.count("data:image/svg+xml;base64,"), 4)  # histories, two creep laws, steps
        self.assertLess(summary["accuracy"]["equilibrium_residual"], 1e-9)

        # elsewhere, and what is missing on the machine is said in the page too
        out = self.report("out", "--output", "a/b.html", **self.WITHOUT_PICTURES)
        self.assertLineSays(out, "note: ", "plots", "gnuplot")
        self.assertIn("apt-get install gnuplot-nox", self.text_of((self.directory / "a" / "b.html").read_text()))

    def test_several_runs(self):
        self.run_short("--quiet")
        shutil.copytree(self.output, self.directory / "other")
        self.report("out", "other", "--output", "both.html", **self.WITHOUT_PICTURES)
        text = self.text_of((self.directory / "both.html").read_text())
        self.assertIn("Comparison of 2 runs", text)
        self.assertIn("normal force of fit, end", text)

    def test_runs_that_came_to_no_end_or_are_of_another_version(self):
        self.run_short("--quiet")
        summary = self.output / "summary.json"
        whole = json.loads(summary.read_text())
        summary.write_text(json.dumps({**whole, "status": "interrupted", "time_reached": 1.0}))
        self.report("out", **self.WITHOUT_PICTURES)
        self.assertIn("The run was interrupted at t = 1 h", self.text_of((self.output / "report.html").read_text()))
        summary.write_text(json.dumps({**whole, "status": "failed", "message": "no step could be made"}))
        self.report("out", **self.WITHOUT_PICTURES)
        self.assertIn("failed at t = 10 h: no step could be made", self.text_of((self.output / "report.html").read_text()))
        # an earlier version: no model.json, no entries of later versions
        (self.output / "model.json").unlink()
        for name in ("accuracy", "warnings"):
            whole.pop(name, None)
        summary.write_text(json.dumps(whole))
        self.assertLineSays(self.report("out", **self.WITHOUT_PICTURES), "note: ", "model.json")
        page = (self.output / "report.html").read_text()
        self.assertIn('"name":"von_mises"', page)
        self.assertIn("Runs of this version do not record what they warned of.", self.text_of(page))
        summary.unlink()
        self.assertLineSays(self.report("out", **self.WITHOUT_PICTURES), "note: ", "summary.json")
        shutil.rmtree(self.output / "fields")
        self.assertLineSays(self.report("out", **self.WITHOUT_PICTURES), "note: ", "fields")

    def test_what_is_no_run(self):
        for words, facts in ((("nowhere",), ("directory 'nowhere'",)), ((".",), ("'.'", "output directory")),
                             (("file.toml",), ("'file.toml'", "creepcontact run file.toml"))):
            (self.directory / "file.toml").write_text("")
            for command in ("report", "picture"):
                self.expect_error(self.program(command, *words), 2, *facts)
        (self.directory / "study").mkdir()
        (self.directory / "study" / "study.csv").write_text("")
        self.expect_error(self.program("report", "study"), 2, "'study'", "study/runs/run_001")

    def test_damaged_fields_are_named(self):
        self.run_short("--quiet")
        file = self.output / "fields" / "fields_0001.vtu"
        file.write_bytes(file.read_bytes()[:2000])
        self.expect_error(self.program("report", "out"), 3, "fields_0001.vtu")

    def test_warnings_are_kept(self):
        self.run_short("--quiet", "--set", "time.integrator=explicit_euler", "--set", "time.step=1e9")
        warnings = self.summary().get("warnings", [])
        self.report("out", **self.WITHOUT_PICTURES)
        text = self.text_of((self.output / "report.html").read_text())
        self.assertTrue(warnings)
        for warning in warnings:
            self.assertIn(warning, text)


class ReportInBrowser(ReportTest):
    """Opened in headless Chromium: interaction, accessibility, print, without WebGL and without script."""

    def check(self, page):
        done = subprocess.run(["node", VIEWER / "test" / "check_report.mjs", page, "--expect-viewer"], capture_output=True,
                              text=True, timeout=LONGEST)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_solid(self):
        self.run_short("--quiet", "--set", "time.end=1e5", "--set", "time.output=[1, 1e3, 1e5]")
        self.report("out")
        self.check(self.output / "report.html")

    def test_section_and_comparison(self):
        section = pathlib.Path(__file__).resolve().parents[2] / "configs" / "shrink_fit_section.toml"
        done = self.program("run", section, "--output", "section", "--quiet", "--set", "time.output=[1]", "--set", "time.end=1")
        self.assertEqual(done.returncode, 0, done.stderr)
        shutil.copytree(self.directory / "section", self.directory / "again")
        self.report("section", "again", "--output", "both.html")
        self.check(self.directory / "both.html")


class PictureOfFields(ReportTest):
    def picture(self, *words):
        done = self.program("picture", "out", *words)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def size(self, path):
        content = (self.directory / path).read_bytes()
        self.assertEqual(content[:8], b"\x89PNG\r\n\x1a\n")
        return struct.unpack(">II", content[16:24])

    def test_fields_times_and_views(self):
        self.run_short("--quiet")
        self.assertEqual(self.picture(), "out/plots/von_mises.png\n")
        self.assertEqual(self.size("out/plots/von_mises.png"), (1200, 900))
        whole = (self.output / "plots" / "von_mises.png").read_bytes()
        said = self.picture("--field", "contact_pressure", "--time", "1.2", "--warp", "30", "--size", "640x480", "--view", "-x",
                            "--output", "p.png")
        self.assertLineSays(said, "note: ", "fields", "1")
        self.assertEqual(self.size("p.png"), (640, 480))
        for words in (("--body", "disc"), ("--time", "0"), ("--warp", "50"), ("--range", "0,1000"), ("--field", "mesh")):
            self.picture(*words, "--output", "other.png")
            self.assertNotEqual((self.directory / "other.png").read_bytes(), whole, words)
        for words, fact in ((("--field", "von_mise"), "'von_mises'"), (("--body", "disk"), "'disc'"), (("--view", "top"), "iso, x"),
                            (("--range", "5"), "0,150"), (("--size", "9x9"), "1200x900"), (("--output", "a.jpg"), "PNG")):
            self.expect_error(self.program("picture", "out", *words), 2, words[1], fact)


if __name__ == "__main__":
    import unittest

    unittest.main()
