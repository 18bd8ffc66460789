"""Whole runs over the command line: results, check, models that cannot run, interruption, a solver that gives up."""

import csv
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import unittest

from says import Says
from waiting import LONGEST, wait_until

PROGRAM = os.environ["CREEPCONTACT_PROGRAM"]
SHRINK_FIT = str(pathlib.Path(__file__).resolve().parents[2] / "configs" / "shrink_fit.toml")
SHORT = ("--set", "time.end=10", "--set", "time.output=[1, 10]")
STEPS = "time,step,order,rhs_evaluations,elastic_solves,schwarz_iterations,active_contacts,error_estimate"
SUMMARY = {"status", "time_reached", "integrator", "steps", "rejected_steps", "rhs_evaluations", "jacobian_products",
           "elastic_solves", "contact_solves", "schwarz_iterations", "factorizations", "bodies", "wall_seconds",
           "peak_memory_mb", "version"}


def arguments(command, *more):
    return [PROGRAM, command, SHRINK_FIT, *more]


class RunTest(Says, unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.directory = pathlib.Path(scratch.name)
        self.output = self.directory / "out"

    def call(self, command, *more):
        return subprocess.run(arguments(command, *more), cwd=self.directory, capture_output=True, text=True,
                              timeout=LONGEST)

    def run_short(self, *more):
        done = self.call("run", "--output", str(self.output), *SHORT, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def table(self, name):
        with open(self.output / name, newline="") as file:
            return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]

    def summary(self):
        return json.loads((self.output / "summary.json").read_text())

    def expect_error(self, done, status, *facts):
        self.assertEqual(done.returncode, status, done.stderr)
        errors = [line for line in done.stderr.splitlines() if not line.startswith(("info: ", "warning: "))]
        self.assertTrue(errors)
        for line in errors:
            self.assertTrue(line.startswith("error: "), line)
        self.assertSays(done.stderr, *facts)


class Results(RunTest):
    def test_all_files_and_columns(self):
        self.run_short("--quiet")
        names = {str(path.relative_to(self.output)) for path in self.output.rglob("*") if path.is_file()}
        fields = {kind: {f"{kind}/{kind}_{i:04}.vtu" for i in range(3)} for kind in ("fields", "contact")}
        self.assertEqual(names, {"history.csv", "steps.csv", "summary.json", "checkpoint.h5", "model.json", "model_view.json", "fields.pvd", "contact.pvd",
                                 *fields["fields"], *fields["contact"]})
        for kind, files in fields.items():
            collection = (self.output / f"{kind}.pvd").read_text()
            for name in files:
                self.assertIn(f'file="{name}"', collection)

        lines = (self.output / "history.csv").read_text().splitlines()
        self.assertEqual(lines[0], "time,fit_pressure,disc_hoop_stress,rim_displacement")
        history = self.table("history.csv")
        self.assertEqual([row["time"] for row in history], [0, 1, 10])
        pressure = [row["fit_pressure"] for row in history]
        self.assertEqual(pressure, sorted(pressure, reverse=True))
        self.assertGreater(pressure[-1], 10)

        self.assertEqual((self.output / "steps.csv").read_text().splitlines()[0], STEPS)
        steps = self.table("steps.csv")
        self.assertEqual(steps[-1]["time"], 10)

        summary = self.summary()
        self.assertLessEqual(SUMMARY, set(summary))
        self.assertEqual((summary["status"], summary["time_reached"]), ("completed", 10))
        self.assertEqual((summary["integrator"], summary["method"]), ("auto", "log_adams"))
        self.assertEqual(summary["steps"], len(steps))
        self.assertEqual(set(summary["bodies"]), {"shaft", "disc"})
        self.assertEqual(set(summary["bodies"]["disc"]), {"dofs", "elements", "integration_points", "initial_von_mises",
                                                          "largest_von_mises", "final_von_mises"})
        seconds = summary["wall_seconds"]
        total = seconds.pop("total")
        self.assertEqual(set(seconds), {"prepare", "factorize", "solve", "material", "contact", "integrate", "observe", "output"})
        self.assertAlmostEqual(sum(seconds.values()), total, delta=1e-9 * total)
        self.assertGreater(summary["peak_memory_mb"], 1)
        self.assertNotIn("message", summary)

    def test_log_of_the_contact_iterations(self):
        log = self.directory / "contact.csv"
        self.run_short("--quiet", "--log-contact", str(log))
        self.assertEqual(log.read_text().splitlines()[0],
                         "time,contact_solve,set_change,iteration,method,residual,active")
        with open(log, newline="") as file:
            rows = list(csv.DictReader(file))
        summary = self.summary()
        self.assertEqual(len(rows), summary["schwarz_iterations"])
        self.assertEqual({row["method"] for row in rows}, {"cg"})
        solves = [int(row["contact_solve"]) for row in rows]
        self.assertEqual(solves, sorted(solves))
        self.assertLessEqual(solves[-1], summary["contact_solves"])
        for row, following in zip(rows, rows[1:] + [None]):
            self.assertEqual(float(row["active"]), 20)
            ends = following is None or following["iteration"] == "1"
            self.assertEqual(float(row["residual"]) <= 1e-10, ends)

        log.unlink()
        self.run_short("--quiet")
        self.assertFalse(log.exists())

    def test_quiet_says_nothing(self):
        done = self.run_short("--quiet")
        self.assertEqual((done.stdout, done.stderr), ("", ""))

    def test_usual_run_says_how_it_went(self):
        done = self.run_short()
        self.assertRegex(done.stdout, r"^done: t = 10; results in ")
        self.assertIn(str(self.output), done.stdout)
        self.assertIn("body 'disc'", done.stderr)
        force = next(line for line in done.stdout.splitlines() if "normal force of contact 'fit'" in line).split()
        summary = self.summary()["contacts"]["fit"]
        for shown, key in zip(force[-5:-2], ("initial", "largest", "final")):
            self.assertAlmostEqual(float(shown), summary[f"{key}_normal_force"], delta=1e-4 * float(shown))
        self.assertRegex(done.stdout, r"(?m)^  \w+: \d+ steps .*, \d+ elastic solves, ")
        self.assertNotIn("material points", done.stdout)

    def test_verbose_adds_what_it_cost(self):
        self.assertRegex(self.run_short("--verbose").stdout, r"(?m)^  time +[\d.]+ s: .*factors \d+ %")

    def test_overrides_and_one_thread(self):
        self.run_short("--quiet", "--threads", "1", "--set", "time.integrator=explicit_euler", "--set", "time.step=2.5",
                       "--set", "contacts.0.gap=-0.045", "--set", "output.fields=false")
        self.assertEqual(self.summary()["integrator"], "explicit_euler")
        self.assertEqual([row["time"] for row in self.table("steps.csv")], [2.5, 5, 7.5, 10])
        self.assertFalse((self.output / "fields.pvd").exists())
        self.assertFalse((self.output / "contact.pvd").exists())
        half = self.table("history.csv")[0]["fit_pressure"]
        self.output = self.directory / "whole"
        self.run_short("--quiet", "--set", "output.fields=false")
        self.assertAlmostEqual(self.table("history.csv")[0]["fit_pressure"], 2 * half, delta=1e-6 * half)

    def test_threads_do_not_matter(self):
        histories = []
        for threads in ("1", "2"):
            self.output = self.directory / threads
            self.run_short("--quiet", "--threads", threads)
            histories.append(self.table("history.csv"))
        for one, two in zip(*histories):
            for name, value in one.items():
                self.assertAlmostEqual(two[name], value, delta=1e-7 * abs(value))


class Check(RunTest):
    def test_tells_about_the_model(self):
        done = self.call("check")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for text in ("body 'shaft': 48 hex20, 419 nodes", "body 'disc': 72 hex20, 592 nodes", "576 integration points",
                     "material 'wheel'", "rigid-body modes: none",
                     "contact 'fit': slave 'disc_bore' on 'disc', master 'shaft_outer' on 'shaft', 20 multipliers, gap -0.09 (interference)",
                     "estimated memory: ", "\nno mistakes found\n"):
            self.assertIn(text, done.stdout)
        self.assertEqual(list(self.directory.iterdir()), [])

    def test_contact_solved_worse_than_time_is_warned_of(self):
        loose = ("--set", "contact_solver.tolerance=1e-3")
        self.assertLineSays(self.call("check", *loose).stdout, "warning: ", "contact_solver.tolerance = 0.001", "time.tolerance = 0.0001")
        self.assertNotIn("contact_solver.tolerance", self.call("check", *loose, "--set", "time.integrator=explicit_euler").stdout)

    def test_follows_overrides(self):
        done = self.call("check", "--set", "mesh.order=1", "--set", "mesh.parameters.n_disc=2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("body 'disc': 18 hex8", done.stdout)


class ModelErrors(RunTest):
    def expect_model_error(self, *overrides, facts):
        options = [part for override in overrides for part in ("--set", override)]
        for command, more in (("check", []), ("run", ["--output", str(self.output)])):
            self.expect_error(self.call(command, *options, *more), 3, *facts)
        self.assertFalse(self.output.exists())

    def test_missing_groups(self):
        self.expect_model_error("supports.0.on=symetry_x", "contacts.0.between=['shaft_outer', 'disc_boer']", facts=[
            "supports[0].on: ", "'symetry_x'", "'symmetry_x'", "contacts[0].between[1]: ", "'disc_boer'", "'disc_bore'",
            "disc_bore, disc_rim, ends, shaft_bore, shaft_outer, symmetry_x, symmetry_y"])

    def test_missing_group_of_a_probe(self):
        self.expect_model_error("probes.0.on=shaft_bore", "probes.1.at=[0, 0, 5]", facts=[
            "shrink_fit.toml:", "probes[0]: ", "'shaft_bore'", "'disc_bore', 'shaft_outer'", "probes[1]: ", "(0, 0, 5)", "body 'disc'"])

    def test_free_body(self):
        self.expect_model_error("supports.0.displacement={z=0}", "contacts=[]", "probes=[]", facts=[
            "body 'shaft'", "translation along x"])

    def test_missing_mesh(self):
        self.expect_model_error("mesh.file=none.geo", facts=["none.geo"])


class Interruption(RunTest):
    def test_interrupt_and_resume(self):
        options = ("--output", str(self.output), "--quiet", "--set", "time.end=10", "--set", "time.output=[0.5, 1]",
                   "--set", "mesh.order=1", "--set", "output.fields=false")
        # As it stands, the run would take ten thousand steps.
        with subprocess.Popen(arguments("run", *options, "--set", "time.integrator=explicit_euler", "--set",
                                        "time.step=0.001"), stderr=subprocess.PIPE, text=True) as process:
            self.wait_for_steps(process, 5)
            process.send_signal(signal.SIGINT)
            errors = process.communicate(timeout=LONGEST)[1]
        self.assertEqual(process.returncode, 130, errors)
        self.assertIn("--resume", errors)
        summary = self.summary()
        self.assertEqual(summary["status"], "interrupted")
        steps = self.table("steps.csv")
        self.assertEqual(summary["time_reached"], steps[-1]["time"])
        self.assertLess(summary["time_reached"], 10)
        self.assertTrue((self.output / "checkpoint.h5").exists())

        done = self.call("run", *options, "--resume")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.table("steps.csv")[:len(steps)], steps)
        history = self.table("history.csv")
        self.assertEqual([row["time"] for row in history], [0, 0.5, 1, 10])
        self.assertEqual(self.summary()["status"], "completed")

    def wait_for_steps(self, process, count):
        steps = self.output / "steps.csv"
        wait_until(lambda: process.poll() is not None or (steps.exists() and steps.read_text().count("\n") > count),
                   f"{count} steps")
        self.assertIsNone(process.poll(), "the run has ended")

    def test_resume_without_a_checkpoint(self):
        done = self.call("run", "--output", str(self.output), "--resume", "--quiet")
        self.expect_error(done, 2, "checkpoint.h5")

    def test_resume_from_a_checkpoint_of_another_version(self):
        options = ("--output", str(self.output), "--quiet", "--set", "time.end=1", "--set", "time.output=[0.5, 1]", "--set",
                   "mesh.order=1", "--set", "output.fields=false")
        self.assertEqual(self.call("run", *options).returncode, 0)
        checkpoint = self.output / "checkpoint.h5"
        content = checkpoint.read_bytes()
        version = content.split(b"\n")[0].split()[-1]
        checkpoint.write_bytes(content.replace(b"checkpoint " + version, b"checkpoint %d" % (int(version) - 1), 1))
        (self.output / "checkpoint.previous.h5").unlink(missing_ok=True)
        history = self.table("history.csv")
        done = self.call("run", *options, "--resume")
        self.expect_error(done, 2, "--resume", "checkpoint.h5'", f"version {int(version) - 1}", f"version {int(version)}")
        self.assertEqual(self.table("history.csv"), history)


class SolverGivesUp(RunTest):
    def test_results_are_kept(self):
        # Far beyond the stable step, once the interference grows.
        done = self.call("run", "--output", str(self.output), "--set", "time.integrator=beta_euler", "--set",
                         "time.step=100", "--set", "time.end=1e4", "--set", "time.output=[100, 200]", "--set",
                         "contacts.0.gap={t=[200, 300], values=[-0.09, -0.9]}", "--set", "mesh.order=1")
        self.expect_error(done, 4, "beta_euler", str(self.output))
        history = self.table("history.csv")
        self.assertEqual([row["time"] for row in history], [0, 100, 200])
        summary = self.summary()
        self.assertEqual(summary["status"], "failed")
        self.assertIn("beta_euler", summary["message"])
        self.assertEqual(summary["time_reached"], self.table("steps.csv")[-1]["time"])


if __name__ == "__main__":
    unittest.main()
