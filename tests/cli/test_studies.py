"""The studies still run, and their tables say what the runs came to."""

import csv
import pathlib
import subprocess
import sys
import tempfile
import unittest

from test_runs import PROGRAM
from waiting import LONGEST

STUDY = pathlib.Path(__file__).resolve().parents[2] / "studies" / "integrators"
sys.path.insert(0, str(STUDY))
import tables  # noqa: E402


def rows_of(points, status="completed"):
    return [{"status": status, "error": str(error), "elastic_solves": str(solves), "method": "any"}
            for error, solves in points]


class IntegratorStudy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as directory:
            command = [sys.executable, "-B", str(STUDY / "run.py"), PROGRAM, "--fast", "--output", directory]
            done = subprocess.run(command, cwd=directory, capture_output=True, text=True, timeout=LONGEST)
            if done.returncode != 0:
                raise AssertionError(done.stderr)
            with open(pathlib.Path(directory) / "runs.csv", newline="") as file:
                cls.rows = list(csv.DictReader(file))
            cls.text = (pathlib.Path(directory) / "tables.md").read_text()

    def runs(self, method):
        return [(float(row["error"]), int(row["elastic_solves"])) for row in self.rows if row["method"] == method]

    def test_every_method_has_two_runs(self):
        methods = {row["method"] for row in self.rows}
        self.assertEqual({method.split(",")[0] for method in methods},
                         {"auto", "cvode_bdf", "cvode_adams", "log_adams", "arkode_erk", "arkode_dirk",
                          "explicit_euler", "beta_euler"})
        for method in methods:
            self.assertEqual(len(self.runs(method)), 2, method)
        self.assertEqual({row["status"] for row in self.rows}, {"completed"})

    def test_smaller_errors_cost_more(self):
        for method in {row["method"] for row in self.rows}:
            (loose, few), (tight, many) = self.runs(method)
            self.assertLess(0, tight, method)
            self.assertLess(tight, loose, method)
            self.assertLess(loose, 0.1, method)
            self.assertLess(few, many, method)

    def test_auto_stays_with_log_adams_while_stress_relaxes(self):
        with_choice = [(error, solves + 1) for error, solves in self.runs("log_adams")]
        self.assertEqual(self.runs("auto"), with_choice)
        self.assertEqual({row["changed_method"] for row in self.rows}, {"0"})

    def test_tables_show_every_run(self):
        for row in self.rows:
            cell = f"{float(row['error']):.1e}, {row['elastic_solves']}".replace("e-0", "e-")
            lines = [line for line in self.text.splitlines() if line.startswith(f"| {row['method']} |")]
            self.assertTrue(any(cell in line for line in lines), f"{row['method']}: {cell}")

    def test_cost_is_interpolated(self):
        rows = rows_of([(1e-2, 100), (1e-4, 400)])
        self.assertEqual(tables.solves_cell(rows, 1e-3), "200")
        self.assertEqual(tables.solves_cell(rows, 1e-2), "≤ 100")
        self.assertEqual(tables.solves_cell(rows, 1e-5), "> 400")

    def test_lucky_runs_do_not_count(self):
        lucky = rows_of([(1e-6, 50), (1e-2, 100), (1e-4, 400)])
        self.assertEqual(tables.solves_cell(lucky, 1e-3), "200")

    def test_runs_that_did_not_end(self):
        stopped = rows_of([("", 5003)], "> 5000")
        self.assertEqual(tables.solves_cell(stopped, 1e-3), "> 5000")
        self.assertEqual(tables.solves_cell(rows_of([(1e-2, 100)]) + stopped, 1e-3), "> 5000")
        self.assertEqual(tables.solves_cell(rows_of([("", 7)], "gave up"), 1e-3), "gave up")


if __name__ == "__main__":
    unittest.main()
