"""`creepcontact study` on a cube of one element: orders, a run that fails, curves, mistakes."""

import re
import subprocess
import unittest

from study_case import COMPARE, PROGRAM, REFERENCE, STUDY, StudyTest


class StudyRuns(StudyTest):
    def test_errors_orders_and_a_failed_run(self):
        done = self.study()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("4 of 5 runs succeeded", done.stdout)
        self.assertEqual(len([line for line in done.stderr.splitlines() if line.startswith("info: run_")]), 5)
        rows = self.rows()
        self.assertEqual(list(rows[0]), ["time.integrator", "time.step", "error_stress", "stress_start", "stress_end",
                                         "stress_min", "stress_max", "status", "message", "steps", "elastic_solves",
                                         "schwarz_iterations", "wall_seconds", "rejected_steps",
                                         "convergence_failures"])
        self.assertEqual([row["status"] for row in rows], ["completed"] * 4 + ["failed"])
        self.assertEqual([row["steps"] for row in rows[:4]], ["80", "160", "80", "160"])
        self.assertSays(rows[4]["message"], "beta_euler: ", "inner_tolerance")
        self.assertEqual(rows[4]["error_stress"], "")
        errors = [float(row["error_stress"]) for row in rows[:4]]
        self.assertAlmostEqual(errors[0] / errors[1], 2, delta=0.1)
        self.assertAlmostEqual(errors[2] / errors[3], 4, delta=0.2)
        text = (self.output / "study.md").read_text()
        self.assertTrue(text.startswith("# How much error a step buys\n"))
        orders = dict(re.findall(r"\| (\w+) \| stress \|[^|]*\| ([\d.]+) \|", text))
        self.assertAlmostEqual(float(orders["explicit_euler"]), 1, delta=0.05)
        self.assertAlmostEqual(float(orders["beta_euler"]), 2, delta=0.05)

    def test_closed_form_agrees_with_the_reference_run(self):
        closed = '[reference]\nexpressions = { stress = "(200^-4 + 4*3.125e-14*200e3*t)^(-1/4)" }\n'
        self.assertEqual(self.study().returncode, 0)
        by_run = [float(row["error_stress"]) for row in self.rows()[:4]]
        done = self.study(STUDY + closed + COMPARE, "--output", "other", "--jobs", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.output = self.directory / "other"
        for first, second in zip(by_run, self.rows()):
            self.assertAlmostEqual(first, float(second["error_stress"]), delta=1e-6)

    def test_a_warning_is_the_message_of_a_run_that_succeeded(self):
        runs = ('base = "cube.toml"\n[[runs]]\nset = { time.integrator = "explicit_euler", time.step = 0.05 }\n'
                '[[runs]]\nset = { time.integrator = "explicit_euler", time.step = 0.01 }\n')
        self.assertEqual(self.study(runs).returncode, 0)
        warned, quiet = self.rows()
        self.assertRegex(warned["message"], "^warning: explicit_euler: .*stable")
        self.assertEqual((warned["status"], quiet["message"]), ("completed", ""))
        self.assertEqual(self.study(runs).returncode, 0)  # kept, and said again
        self.assertEqual(self.rows()[0]["message"], warned["message"])

    def test_pictures_of_curves(self):
        text = STUDY.replace("[[runs]]", """[[runs]]
label = "Adams & more"
set = { "time.integrator" = "cvode_adams" }
axes = [{ key = "time.tolerance", values = [1e-3, 1e-4] }]
[[runs]]""")
        done = self.study(text + REFERENCE + COMPARE + '[plot]\nshow = ["elastic_solves"]\n')
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([row["time.tolerance"] for row in self.rows()[4:6]], ["0.001", "0.0001"])
        for name in ("error_stress_over_time_step", "error_stress_over_time_tolerance", "error_stress_over_wall_seconds",
                     "error_stress_over_elastic_solves", "elastic_solves_over_time_step"):
            self.assertIn(f"![{name}]({name}.svg)", (self.output / "study.md").read_text())
            self.assertEqual((self.output / f"{name}.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        solves = (self.output / "error_stress_over_elastic_solves.svg").read_text()
        for curve in ("explicit_euler", "beta_euler", "Adams &amp; more"):
            self.assertIn(curve, solves)

    def test_results_are_compared_without_a_reference(self):
        text = ('base = "cube.toml"\nset = { output.fields = false }\n[[axes]]\nkey = "supports.3.displacement.x"\n'
                'values = [0.1, 0.05]\n') + COMPARE
        done = self.study(text)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = self.rows()
        self.assertNotIn("error_stress", rows[0])
        for row, start in zip(rows, (200, 100)):
            values = [float(row[f"stress_{part}"]) for part in ("start", "end", "min", "max")]
            self.assertAlmostEqual(values[0], start, delta=1e-6 * start)
            end = (start**-4 + 4 * 3.125e-14 * 200e3 * 0.4)**-0.25
            self.assertAlmostEqual(values[1], end, delta=1e-3 * end)
            self.assertEqual(values[2:], [values[1], values[0]])
        text = (self.output / "study.md").read_text()
        self.assertNotIn("Reference", text)
        for name in ("history_stress", "stress_end_over_supports_3_displacement_x"):
            self.assertIn(f"![{name}]({name}.svg)", text)
        self.assertIn("x = 0.05", (self.output / "history_stress.svg").read_text())

        done = self.call("plot", str(self.output))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout.split(), [str(self.output / f"plots/history_stress.{kind}") for kind in ("svg", "png")])
        self.assertIn("x = 0.05", (self.output / "plots" / "history_stress.svg").read_text())
        done = self.call("plot", *(str(self.output / "runs" / name) for name in ("run_001", "run_002")))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout.split(), ["plots/history_stress.svg", "plots/history_stress.png"])
        picture = (self.directory / "plots" / "history_stress.svg").read_text()
        self.assertTrue("run_001" in picture and "run_002" in picture)
        self.expect_error(self.call("plot", str(self.output), "cube"), 2, "results/study", "study")

    def test_a_csv_as_reference(self):
        self.assertEqual(self.study().returncode, 0)
        by_run = [row["error_stress"] for row in self.rows()]
        self.write("known.csv", (self.output / "runs" / "reference" / "history.csv").read_text())
        done = self.study(STUDY + '[reference]\ncsv = "known.csv"\n' + COMPARE, "--output", "other")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.output = self.directory / "other"
        self.assertEqual([row["error_stress"] for row in self.rows()], by_run)

    def test_zipped_axes_and_no_reference(self):
        text = STUDY.replace("[[runs]]", '[[axes]]\nkey = "time.end"\nvalues = [0.4, 0.2]\nzip = "a"\n[[runs]]')
        text = text.replace("values = [0.005, 0.0025]", 'values = [0.005, 0.0025]\nzip = "a"')
        self.assertEqual(self.study(text).returncode, 0)
        self.assertEqual([row["steps"] for row in self.rows()[:4]], ["80", "80", "80", "80"])

    def test_no_successful_run(self):
        done = self.study('base = "cube.toml"\n[[runs]]\nset = { time.integrator = "beta_euler", time.step = 0.4 }\n')
        self.expect_error(done, 4, "0 of 1 ")
        self.assertEqual(self.rows()[0]["status"], "failed")

    def test_a_reference_that_gives_up(self):
        self.expect_error(self.study(STUDY + '[reference]\nset = { time.integrator = "beta_euler", time.step = 0.4 }\n'
                                     + COMPARE), 4, "error: ", "reference", "beta_euler: ")
        self.assertEqual(list(self.written()), ["reference"])


class StudyMistakes(StudyTest):
    def test_run_and_study_mixed_up(self):
        self.write("study.toml", STUDY)
        for command in ("run", "check"):
            self.expect_error(self.call(command, "study.toml"), 2, "error: study.toml: ", "creepcontact study study.toml")
        self.expect_error(self.call("study", "cube.toml"), 2, "error: cube.toml: ", "creepcontact run cube.toml")

    def test_wrong_axis_key(self):
        self.expect_error(self.study(STUDY.replace('"time.step"\nvalues', '"time.stepp"\nvalues')), 2,
                          "error: study.toml:8:7: axes[1].key: time.stepp: ", "'step'")
        self.assertFalse(self.output.exists())

    def test_all_in_one_go(self):
        text = STUDY.replace("0.0025", "-1").replace('"beta_euler"]', '"beta_eulr"]') + REFERENCE
        self.expect_error(self.study(text + COMPARE.replace("stress", "strain")), 2,
                          "study.toml:6:29: axes[0].values[1]: time.integrator: ", "'beta_eulr'", "'beta_euler'",
                          "study.toml:9:18: axes[1].values[1]: time.step: ", "-1", "> 0",
                          "study.toml:15:15: compare.quantities[0]: ", "'strain'", "cube.toml", "stress")

    def test_another_study_in_the_directory(self):
        single = 'base = "cube.toml"\n[[runs]]\nset = { time.step = 0.2 }\n'
        self.assertEqual(self.study(single).returncode, 0)
        self.expect_error(self.study(single.replace("0.2", "0.3")), 2, "results/study", "--output")

    def test_runs_of_somebody_else_in_the_directory(self):
        (self.directory / "runs").mkdir()
        self.expect_error(self.study(STUDY, "--output", "."), 2, "'./runs'", "--output")

    def test_references_that_cannot_be_read(self):
        text = STUDY + '[reference]\ncsv = "known.csv"\n' + COMPARE
        self.expect_error(self.study(text), 2, "known.csv: ", "No such file")
        self.write("known.csv", "time,strain\n0,0\n")
        self.expect_error(self.study(text), 2, "known.csv: ", "'stress'", "time, strain")

    def test_command_line(self):
        self.expect_error(self.study(STUDY, "--jobs", "0"), 2, "--jobs: 0", "1 to 1000")
        done = subprocess.run([PROGRAM, "study", "none.toml"], cwd=self.directory, capture_output=True, text=True)
        self.expect_error(done, 2, "none.toml: ", "No such file or directory")


if __name__ == "__main__":
    unittest.main()
