"""creepcontact report and picture: what they say of runs of all kinds, and how a report shows itself in a browser."""

import html
import json
import os
import pathlib
import re
import resource
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
        found = re.search(r"goes from ([\d.]+(?: \d{3})*) (k?)N at the start to", text)
        self.assertTrue(found, text[:2000])
        shown = float(found[1].replace(" ", "")) * (1e3 if found[2] else 1)
        self.assertAlmostEqual(shown / force["initial_normal_force"], 1, delta=0.005)
        self.assertNotRegex(text[:text.index("Bodies and mesh")], r"\d[eE][+-]\d|-0 %")
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

    LOGO = '<svg xmlns="http://www.w3.org/2000/svg" width="40" height="20"><rect width="40" height="20" fill="#246"/></svg>'

    def test_texts_of_the_configuration(self):
        (self.directory / "logo.svg").write_text(self.LOGO)
        texts = {"title": "Tightness of a fit", "project": "P <1>", "drawing": "D 2", "revision": "C", "author": "A. Author",
                 "checker": "C. Checker", "logo": str(self.directory / "logo.svg"),
                 "purpose": "Does it **hold**? <script>alert(1)</script> [x](javascript:alert(2))", "assumptions": "- no friction",
                 "assessment": "It *does*."}
        settings = [word for key, text in texts.items() for word in ("--set", f"report.{key}={json.dumps(text)}")]
        self.run_short("--quiet", *settings, "--set", "report.appendix=false")
        (self.directory / "logo.svg").unlink()  # the output directory is enough
        self.report("out", **self.WITHOUT_PICTURES)
        page = (self.output / "report.html").read_text()
        text = self.text_of(page)
        for said in ("Tightness of a fit", "Project P <1>", "Drawing D 2", "Revision C", "Author A. Author", "Checked by C. Checker"):
            self.assertIn(said, text)
        for part in ('<img class="logo" src="data:image/svg+xml;base64,', "<strong>hold</strong>", "<li>no friction</li>",
                     "<em>does</em>", "&lt;script&gt;alert(1)"):
            self.assertIn(part, page)
        self.assertNotIn("javascript:", page.split("<script>")[0])
        self.assertNotIn("Appendix", text)
        self.assertNotIn("elastic solves", text)
        order = [page.index(f'<section id="{part}"') for part in ("question", "answer", "histories", "pictures", "inputs", "accuracy")]
        self.assertEqual(order, sorted(order))

    def test_wrong_logos(self):
        (self.directory / "logo.txt").write_text("no image")
        for logo, fact in (("logo.txt", "PNG"), ("missing.png", "No such file")):
            done = self.call("check", "--set", f"report.logo={json.dumps(str(self.directory / logo))}")
            self.expect_error(done, 2, "report.logo", logo, fact)

    def test_new_texts_of_a_run_that_has_ended(self):
        self.run_short("--quiet")
        self.run_short("--quiet", "--resume", "--set", 'report.assessment="It holds."')
        self.report("out", **self.WITHOUT_PICTURES)
        self.assertIn("Assessment It holds.", self.text_of((self.output / "report.html").read_text()))

    def test_criteria_come_first(self):
        self.run_short("--quiet")
        summary = self.output / "summary.json"
        whole = json.loads(summary.read_text())
        whole["criteria"] = {"seal": {"met": False, "kind": "min", "demand": "seal, at least 12 MPa", "unit": "MPa", "found": 11.2,
                                      "allowed": 12, "utilisation": 12 / 11.2, "time": 10, "body": "disc", "place": [1, 2, 3]},
                             "later": {"met": None, "demand": "at t = 1e6", "kind": "max", "unit": ""}}
        summary.write_text(json.dumps(whole))
        self.report("out", **self.WITHOUT_PICTURES)
        page = (self.output / "report.html").read_text()
        text = self.text_of(page)
        for said in ("0 of 2 criteria are met. NOT met: seal.", "seal, at least 12 MPa", "11.2 MPa", "≥ 12 MPa", "107 %", "disc (1, 2, 3) mm",
                     "not judged"):
            self.assertIn(said, text)
        self.assertLess(page.index('id="criteria"'), page.index('id="answer"'))
        shutil.copytree(self.output, self.directory / "other")
        self.report("out", "other", "--output", "both.html", **self.WITHOUT_PICTURES)
        self.assertIn("NOT met (107 %)", self.text_of((self.directory / "both.html").read_text()))

    def test_markup_in_any_text_is_text(self):
        self.run_short("--quiet", "--set", 'report.project="p"', "--set", 'report.purpose="q"', "--set", 'report.assessment="r"')
        mark = "<script>alert(7)</script>\"'><img src=x onerror=alert(8)>"

        def marked(value, key=""):
            if isinstance(value, dict):
                names = key in ("probes", "contacts", "bodies", "events", "criteria", "life_fraction", "sources")
                return {name + (mark if names else ""): marked(one, name) for name, one in value.items()}
            if isinstance(value, list):
                return [marked(one, key) for one in value]
            return value + mark if isinstance(value, str) and key not in ("status", "kind", "value", "key", "array") else value

        for name in ("summary.json", "model.json"):
            file = self.output / name
            whole = json.loads(file.read_text())
            if name == "summary.json":
                whole.update(warnings=["w"], message="m", events={"e": 1.0, "f": None}, life_fraction={"disc": {"largest": 0.5, "place": [0, 0, 0]}},
                             criteria={"c": {"met": True, "demand": "d", "unit": "MPa", "found": 1, "allowed": 2, "utilisation": 0.5,
                                             "time": 1, "body": "b"}})
            file.write_text(json.dumps(marked(whole)))
        history = self.output / "history.csv"
        head, rest = history.read_text().split("\n", 1)
        history.write_text(head + mark.replace(",", "").replace('"', "") + "\n" + rest)
        shutil.copytree(self.output, self.directory / "other")
        for words in (("out", "--output", "one.html"), ("out", "other", "--output", "two.html")):
            self.report(*words)
            page = (self.directory / words[-1]).read_text()
            self.assertIn("&lt;script&gt;alert(7)", page)
            self.assertNotIn("<script>alert(7)", page)
            self.assertNotIn("<img src=x", page)

    def test_a_study_is_its_runs(self):
        for i, gap in enumerate(("-0.05", "-0.1"), 1):
            self.run_short("--quiet", "--set", f"contacts.0.gap={gap}")
            shutil.copytree(self.output, self.directory / "study" / "runs" / f"run_00{i}")
        (self.directory / "study" / "study.csv").write_text("contacts.0.gap,status\n")
        (self.directory / "study" / "study.md").write_text("# Gaps & fits\n\ntext\n")
        (self.directory / "study" / "runs" / "run_003").symlink_to(self.output)  # not followed
        self.assertIn("study/report.html", self.report("study", **self.WITHOUT_PICTURES))
        page = (self.directory / "study" / "report.html").read_text()
        text = self.text_of(page)
        for said in ("Gaps & fits", "gap = -0.05", "gap = -0.1", "Inputs that are not the same in all runs", "fit_pressure, smallest … largest",
                     "(differs)", "Accuracy of all runs"):
            self.assertIn(said, text)
        self.assertNotIn("run_003", text)
        self.assertEqual(text.count("Young's modulus"), 2)  # inputs once: of both materials

    def test_a_disk_that_takes_no_more(self):
        self.run_short("--quiet")
        self.report("out", **self.WITHOUT_PICTURES)
        before = (self.output / "report.html").read_bytes(), sorted(p.name for p in self.output.iterdir())
        limit = 10000  # bytes of any file
        done = subprocess.run([PROGRAM, "report", "out"], cwd=self.directory, capture_output=True, text=True, timeout=LONGEST,
                              env={**os.environ, **self.WITHOUT_PICTURES},
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        self.assertNotEqual(done.returncode, 0)
        self.assertLineSays(done.stderr, "error: ", "report.html")
        self.assertEqual(((self.output / "report.html").read_bytes(), sorted(p.name for p in self.output.iterdir())), before)

    def test_rows_are_compared_by_their_names(self):
        self.run_short("--quiet")
        shutil.copytree(self.output, self.directory / "more")
        record = json.loads((self.directory / "more" / "model.json").read_text())
        supports, = (table for section in record["sections"] for table in section["tables"] if table["title"] == "Supports")
        supports["rows"].insert(0, ["rim", "z = 0"])
        (self.directory / "more" / "model.json").write_text(json.dumps(record))
        marks = {}
        for order in (("out", "more"), ("more", "out")):
            self.report(*order, "--output", "both.html", **self.WITHOUT_PICTURES)
            marks[order[0]] = re.findall(r"(\w+) \((differs|not in all runs)\)",
                                         self.text_of((self.directory / "both.html").read_text()))
        self.assertEqual(marks, {"out": [], "more": [("rim", "not in all runs")]})

    def test_a_large_study_is_cut(self):
        self.run_short("--quiet")
        for i in range(1, 27):
            shutil.copytree(self.output, self.directory / "study" / "runs" / f"run_{i:03}")
        (self.directory / "study" / "study.csv").write_text("status\n")
        self.assertLineSays(self.report("study", **self.WITHOUT_PICTURES), "note: ", "26 runs", "first 24", "study.csv")
        text = self.text_of((self.directory / "study" / "report.html").read_text())
        self.assertIn("Comparison of 24 runs", text)
        self.assertIn("The study has 26 runs", text)
        self.assertNotIn("run_025", text)

    def test_pdf(self):
        self.run_short("--quiet")
        said = self.report("out", "--pdf")
        self.assertIn("out/report.pdf", said)
        self.assertTrue((self.output / "report.pdf").read_bytes().startswith(b"%PDF-"))
        self.assertFalse((self.output / "report.html").exists())
        target = self.directory / "elsewhere"
        target.write_text("kept")
        (self.directory / "a.pdf").symlink_to(target)
        self.report("out", "--output", "a.pdf", PATH="/usr/bin")
        self.assertEqual(target.read_text(), "kept")  # not written through the link
        self.assertTrue((self.directory / "a.pdf").read_bytes().startswith(b"%PDF-"))
        self.expect_error(self.program("report", "out", "--pdf", **self.WITHOUT_PICTURES), 2, "--pdf", "chromium", "print")

    def test_a_browser_that_fails(self):
        self.run_short("--quiet")
        (self.directory / "bin").mkdir()
        browser = self.directory / "bin" / "chromium"
        browser.write_text("#!/bin/sh\necho no screen >&2\nexit 3\n")
        browser.chmod(0o755)
        self.expect_error(self.program("report", "out", "--pdf", PATH=str(self.directory / "bin"), DISPLAY=""), 4, "--pdf", "no screen")
        self.assertFalse((self.output / "report.pdf").exists())

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
        self.expect_error(self.program("report", "study"), 2, "'study'", "'study/runs'")
        self.expect_error(self.program("picture", "study"), 2, "'study'", "study/runs/run_001")

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
