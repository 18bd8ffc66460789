"""`creepcontact study` over and over: what is kept, what is made anew, interruption, two at once."""

import json
import shutil
import signal
import subprocess
import unittest

from study_case import BASE, COMPARE, PROGRAM, REFERENCE, STUDY, StudyTest
from waiting import LONGEST, wait_until


class StudyResume(StudyTest):
    finished = STUDY[:STUDY.index("[[runs]]")] + REFERENCE + COMPARE

    def test_finished_runs_are_kept(self):
        self.assertEqual(self.study(self.finished).returncode, 0)
        first, table = self.written(), self.rows()
        self.assertEqual(len(first), 5)
        done = self.study("# the same but for this line\n" + self.finished)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(self.written(), first)
        self.assertEqual(self.rows(), table)

    def test_another_base_is_run_anew(self):
        self.assertEqual(self.study(self.finished).returncode, 0)
        first = self.written()
        self.write("cube.toml", BASE.replace("displacement = { x = 0.1 }", "displacement = { x = 0.09 }"))
        self.assertEqual(self.study(self.finished).returncode, 0)
        for name, when in self.written().items():
            self.assertGreater(when, first[name], name)

    def test_a_run_that_is_missing_is_made(self):
        self.assertEqual(self.study(self.finished).returncode, 0)
        first = self.written()
        (self.output / "runs" / "run_002" / "summary.json").unlink()
        self.assertEqual(self.study(self.finished).returncode, 0)
        changed = {name for name, when in self.written().items() if when != first[name]}
        self.assertEqual(changed, {"run_002"})

    def test_interruption(self):
        text = ('base = "cube.toml"\nset = { output.fields = false, time.integrator = "explicit_euler" }\n'
                '[[axes]]\nkey = "time.step"\nvalues = [1e-6, 2e-6, 4e-6]\n')
        self.write("study.toml", text)
        process = subprocess.Popen([PROGRAM, "study", "study.toml", "--jobs", "2"], cwd=self.directory,
                                   stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        steps = [self.output / "runs" / name / "steps.csv" for name in ("run_001", "run_002")]
        wait_until(lambda: all(path.exists() and path.stat().st_size > 1000 for path in steps), "both runs make steps")
        process.send_signal(signal.SIGINT)
        errors = process.communicate(timeout=LONGEST)[1]
        self.assertEqual(process.returncode, 130, errors)
        self.assertIn("interrupted: 0 of 3 runs succeeded", errors)
        self.assertEqual([row["status"] for row in self.rows()], ["interrupted", "interrupted", "not started"])
        for path in steps:
            self.assertTrue((path.parent / "checkpoint.h5").exists())
        reached = json.loads((steps[0].parent / "summary.json").read_text())["time_reached"]
        self.assertGreater(reached, 0)
        # The same command goes on from there: what lies in the directory of a run that begins anew is removed.
        sentinel = steps[0].parent / "sentinel"
        sentinel.touch()
        lengths = [path.stat().st_size for path in steps]
        process = subprocess.Popen([PROGRAM, "study", "study.toml", "--jobs", "2"], cwd=self.directory,
                                   stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        wait_until(lambda: all(path.stat().st_size > length + 1000 for path, length in zip(steps, lengths)),
                   "both runs go on")
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=LONGEST), 130)
        self.assertTrue(sentinel.exists())
        self.assertGreater(json.loads((steps[0].parent / "summary.json").read_text())["time_reached"], reached)

    def test_interruption_as_early_as_can_be(self):
        """Signals that the runs get before they have handlers for them are not lost."""
        self.write("study.toml", 'base = "cube.toml"\nset = { time.integrator = "explicit_euler" }\n'
                                 '[[axes]]\nkey = "time.step"\nvalues = [1e-6, 2e-6]\n')
        for _ in range(3):
            process = subprocess.Popen([PROGRAM, "study", "study.toml", "--jobs", "2"], cwd=self.directory,
                                       stderr=subprocess.PIPE, text=True)
            log = self.output / "runs" / "run_001" / "run.log"  # made just before its run
            wait_until(log.exists, "the first run begins", pause=0)
            process.send_signal(signal.SIGINT)
            errors = process.communicate(timeout=LONGEST)[1]
            self.assertEqual(process.returncode, 130, errors)
            self.assertIn("interrupted: 0 of 2 runs succeeded", errors)
            self.assertIn(self.rows()[0]["status"], ("interrupted", "not started"))
            shutil.rmtree(self.output)

    def test_two_at_once_and_death(self):
        text = ('base = "cube.toml"\n[[runs]]\n'
                'set = { time.integrator = "explicit_euler", time.step = 1e-6 }\n')
        self.write("study.toml", text)
        process = subprocess.Popen([PROGRAM, "study", "study.toml"], cwd=self.directory, stderr=subprocess.DEVNULL)
        steps = self.output / "runs" / "run_001" / "steps.csv"
        wait_until(lambda: steps.exists() and steps.stat().st_size > 1000, "the run makes steps")
        self.expect_error(self.study(text), 2, "another creepcontact")
        second = subprocess.run([PROGRAM, "run", "cube.toml", "--output", steps.parent], cwd=self.directory,
                                capture_output=True, text=True, timeout=LONGEST)
        self.assertEqual(second.returncode, 2)
        self.assertIn("another creepcontact", second.stderr)
        process.kill()
        process.wait()
        # Its run ends by itself, with a checkpoint.
        summary = steps.parent / "summary.json"
        wait_until(lambda: json.loads(summary.read_text())["message"].startswith("interrupted"), "the run ends")

    def test_a_lost_history_is_made_anew(self):
        self.assertEqual(self.study(self.finished).returncode, 0)
        (self.output / "runs" / "run_002" / "history.csv").unlink()
        self.assertEqual(self.study(self.finished).returncode, 0)
        self.assertEqual([row["status"] for row in self.rows()], ["completed"] * 4)


if __name__ == "__main__":
    unittest.main()
