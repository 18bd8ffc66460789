"""Criteria on the command line: the table at the end, --strict, check --start, studies, names with any characters."""

import csv
import json
import unittest

from process_case import ProcessTest
from study_case import BASE

CRITERIA = """[[events]]
name = "half"
when = "stress < 100"
[[criteria]]
name = "holds"
probe = "stress"
min = 60
[[criteria]]
name = "at first <b>"
probe = "stress"
max = { t = [0, 1], values = [190, 190] }
until = 0.1
[[criteria]]
name = "later"
probe = "stress"
min = 1
from = 0.3
"""


class Criteria(ProcessTest):
    def setUp(self):
        super().setUp()
        self.write("cube.toml", BASE + CRITERIA)

    def summary(self):
        return json.loads((self.directory / "out/summary.json").read_text())["criteria"]

    def test_run(self):
        done = self.call("run", "cube.toml", "--output", "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertSays(done.stdout, "criterion 'at first <b>': NOT met: 200 found, at most 190", "(105 %) at t = 0")
        self.assertSays(done.stdout, "criterion 'holds': met: ", "at least 60", "at t = 0.4")
        found = self.summary()
        self.assertEqual({name: one["met"] for name, one in found.items()}, {"holds": True, "at first <b>": False, "later": True})
        end = (200**-4 + 4 * 3.125e-14 * 200e3 * 0.4)**-0.25
        self.assertAlmostEqual(found["holds"]["found"], end, delta=1e-3 * end)
        self.assertAlmostEqual(found["holds"]["utilisation"], 60 / end, delta=1e-3)
        self.assertEqual(found["at first <b>"]["time"], 0)

    def test_strict(self):
        done = self.call("run", "cube.toml", "--output", "out", "--strict")
        self.assertEqual(done.returncode, 5)
        self.assertSays(done.stderr, "error: criterion 'at first <b>': NOT met")
        self.assertNotIn("'holds'", done.stderr)
        done = self.call("run", "cube.toml", "--output", "out", "--strict", "--set", "criteria[1].max=300")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_an_early_end_leaves_criteria_unjudged(self):
        done = self.call("run", "cube.toml", "--output", "out", "--strict", "--set", "events[0].stop=true",
                         "--set", "criteria[1].max=300", "--set", "events[0].when=stress < 199")
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertSays(done.stderr, "criterion 'later': not judged")
        self.assertIsNone(self.summary()["later"]["met"])

    def test_start(self):
        done = self.call("check", "cube.toml", "--start")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertSays(done.stdout, "criterion 'at first <b>': NOT met")
        self.assertSays(done.stdout, "criterion 'holds': met: 200 found")
        self.assertNotIn("'later'", done.stdout)

    def test_study(self):
        self.write("study.toml", 'base = "cube.toml"\n[[axes]]\nkey = "supports[3].displacement.x"\nvalues = [0.05, 0.1]\n')
        done = self.call("study", "study.toml", "--output", "study")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.directory / "study/study.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertAlmostEqual(float(rows[1]["criterion_at first <b>"]), 200 / 190, delta=1e-6)
        self.assertAlmostEqual(float(rows[0]["criterion_at first <b>"]), 100 / 190, delta=1e-6)
        self.assertEqual(rows[0]["event_half"] != "", True)
        self.assertGreater(float(rows[1]["event_half"]), 0)


if __name__ == "__main__":
    unittest.main()
