"""`creepcontact study` in parts: shards, killed and made again, gathered; lists of commands; scripts for Slurm."""

import csv
import fcntl
import os
import shutil
import subprocess
import unittest

from study_case import PROGRAM, StudyTest
from waiting import LONGEST, wait_until

STUDY = """base = "cube.toml"
set = { output.fields = false }
[random]
samples = 12
[[random.keys]]
key = "materials.steel.creep[0].A"
distribution = "lognormal"
median = 3.125e-14
factor = 2.0
[[random.keys]]
key = "contact_solver.tolerance"
distribution = "uniform"
min = 1e-9
max = 2e-9
"""
PER_SHARD = 'keep = "shard"\n'
# Runs that last until they are killed.
SLOW = STUDY.replace("output.fields = false", 'output.fields = false, time.integrator = "explicit_euler", time.step = 1e-6')


class Shards(StudyTest):
    def setUp(self):
        super().setUp()
        self.write("study.toml", STUDY)

    def shard(self, text, *more):
        return self.call("study", "study.toml", "--shard", text, *more)

    def gather(self, *more):
        return self.call("study", "study.toml", "--gather", *more)

    def quantiles(self, directory=None):
        with open((directory or self.output) / "quantiles.csv", newline="") as file:
            return list(csv.DictReader(file))

    def whole(self):
        """The quantiles of the study made in one go."""
        done = self.call("study", "study.toml", "--output", "whole")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("12 of 12 runs succeeded", done.stdout, done.stderr)
        return self.quantiles(self.directory / "whole")

    def expect_same(self, found, expected):
        """Which samples are computed together decides the last digits."""
        self.assertEqual(len(found), len(expected))
        for row, other in zip(found, expected):
            self.assertEqual(list(row), list(other))
            for name in row:
                value = float(other[name]) if other[name] else None
                if value is None:
                    self.assertEqual(row[name], "")
                else:
                    self.assertAlmostEqual(float(row[name]), value, delta=1e-9 * max(abs(value), 1e-300), msg=name)

    def test_shards_are_gathered_to_the_same_tables(self):
        for number in (2, 1, 3):
            done = self.shard(f"{number}/3")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("4 of 4 runs succeeded", done.stdout)
        self.assertFalse((self.output / "study.csv").exists())
        done = self.gather()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("12 of 12 runs succeeded", done.stdout)
        self.expect_same(self.quantiles(), self.whole())

    def test_one_file_per_shard_gives_the_same_tables(self):
        expected = self.whole()
        self.write("study.toml", PER_SHARD + STUDY)
        for number in (1, 2):
            self.assertEqual(self.shard(f"{number}/2").returncode, 0)
        self.assertEqual(list((self.output / "runs").iterdir()), [])
        self.assertEqual(len(list(self.output.glob("shards/*/runs.h5"))), 2)
        done = self.gather()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.expect_same(self.quantiles(), expected)
        self.assertTrue(all(row["status"] == "completed" and int(row["steps"]) > 0 for row in self.rows()))

        # A study in one go would make them again.
        done = self.call("study", "study.toml")
        self.expect_error(done, 2, "files of its 2 shards", "--shard i/2", "--gather", "--output")

        # What is there is kept; a lost shard is made again, alone.
        written = {path: path.stat().st_mtime_ns for path in self.output.glob("shards/*/runs.h5")}
        done = self.shard("1/2")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual({path: path.stat().st_mtime_ns for path in self.output.glob("shards/*/runs.h5")}, written)
        with open(self.output / "shards" / "002" / "runs.h5", "r+b") as file:
            file.truncate(2000)
        done = self.gather()
        self.expect_error(done, 4, "002/runs.h5", "6 of 12 runs succeeded", "6 are missing: run_002, run_004", "i = 2")
        self.assertEqual(self.shard("2/2").returncode, 0)
        self.assertEqual(self.gather().returncode, 0)
        self.expect_same(self.quantiles(), expected)

    def test_a_study_that_keeps_files_of_shards_has_a_report(self):
        self.write("study.toml", PER_SHARD + STUDY)
        for shard in ("1/2", "2/2"):
            self.assertEqual(self.shard(shard).returncode, 0)
        self.assertEqual(self.gather().returncode, 0)
        done = self.call("report", "results/study")
        self.assertEqual(done.returncode, 0, done.stderr)
        page = (self.output / "report.html").read_text(encoding="utf-8")
        self.assertSays(page, "Scatter", "cloud_stress", "fan_stress", "files of shards")

    def test_a_shard_that_is_killed_is_made_again_alone(self):
        self.assertEqual(self.shard("1/2").returncode, 0)
        first = self.written()
        process = subprocess.Popen([PROGRAM, "study", "study.toml", "--shard", "2/2", "--jobs", "1"], cwd=self.directory,
                                   stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        wait_until(lambda: len(self.written()) > len(first), "a run of the second shard is finished", pause=0)
        process.kill()
        process.wait(timeout=LONGEST)
        wait_until(lambda: not self.has_running_run(), "its run ends too")
        kept = self.written()
        done = self.gather()
        self.expect_error(done, 4, " are missing: run_", "--shard i/2 with i = 2")
        there = [row for row in self.rows() if row["status"] == "completed"]
        self.assertGreaterEqual(len(there), len(first))
        self.assertLess(len(there), 12)
        for row in there:  # whole ones only
            self.assertNotEqual(row["stress_end"], "")
        self.assertEqual(self.shard("2/2").returncode, 0)
        again = self.written()
        self.assertEqual({name: again[name] for name in first}, first)
        self.assertEqual(len(again), 12)
        done = self.gather()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.expect_same(self.quantiles(), self.whole())
        self.assertTrue(set(kept) <= set(again))

    def has_running_run(self):
        for directory in (self.output / "runs").iterdir():
            handle = os.open(directory, os.O_RDONLY)
            try:
                fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                return True
            finally:
                os.close(handle)
        return False

    def test_another_number_of_shards_is_refused(self):
        self.assertEqual(self.shard("1/6").returncode, 0)
        self.expect_error(self.shard("1/4"), 2, "6 shards", "--shard i/6", "/4", "--output", "results/study/shards")
        self.expect_error(self.shard("7/6"), 2, "--shard: '7/6'", "i from 1 to N")
        self.expect_error(self.shard("half"), 2, "--shard: 'half'", "3/16")

    def test_two_at_once_are_refused(self):
        self.write("study.toml", SLOW)
        process = subprocess.Popen([PROGRAM, "study", "study.toml", "--shard", "1/2", "--jobs", "1"], cwd=self.directory,
                                   stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        steps = self.output / "runs" / "run_001" / "steps.csv"
        wait_until(lambda: steps.exists() and steps.stat().st_size > 1000, "the first run makes steps")
        self.expect_error(self.shard("1/2"), 2, "shards/001", "another creepcontact")
        # A gathering does not wait for shards, but for another gathering.
        done = self.gather()
        self.expect_error(done, 4, "0 of 12 runs succeeded", "12 are missing")
        lock = os.open(self.output, os.O_RDONLY)
        self.addCleanup(os.close, lock)
        fcntl.flock(lock, fcntl.LOCK_EX)
        self.expect_error(self.gather(), 2, "results/study", "another creepcontact")
        process.kill()
        process.wait(timeout=LONGEST)
        wait_until(lambda: not self.has_running_run(), "its run ends too")

    def test_lines_of_the_list_make_the_runs(self):
        done = self.call("study", "study.toml", "--list", "--output", "by hand's")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lines = done.stdout.splitlines()
        self.assertEqual(len(lines), 12)
        self.assertFalse((self.directory / "by hand's").exists())
        for line in lines:
            ran = subprocess.run(["sh", "-c", line], cwd="/", capture_output=True, text=True, timeout=LONGEST)
            self.assertEqual(ran.returncode, 0, ran.stderr)
        done = self.gather("--output", "by hand's")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.expect_same(self.quantiles(self.directory / "by hand's"), self.whole())

    def test_gathering_nothing(self):
        self.expect_error(self.gather(), 2, "results/study", "shards")
        self.expect_error(self.call("study", "study.toml", "--run", "run_013"), 2, "'run_013'", "run_001 to run_012")
        self.expect_error(self.call("study", "study.toml", "--gather", "--list"), 2, "--list", "--gather")

    def test_the_script_for_slurm_submits_shards_and_then_gathers(self):
        done = self.call("study", "study.toml", "--slurm", "--shards", "3")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        # A stand-in runs each job at once and tells an identifier, as sbatch --parsable does.
        tools = self.directory / "tools"
        tools.mkdir()
        sbatch = tools / "sbatch"
        sbatch.write_text("""#!/bin/sh
echo "$@" >> "$(dirname "$0")/calls"
cat > "$(dirname "$0")/job"
tasks=$(printf '%s\\n' "$@" | sed -n 's/^--array=1-//p')
for task in $(seq "${tasks:-1}"); do SLURM_ARRAY_TASK_ID=$task sh "$(dirname "$0")/job" >> "$(dirname "$0")/output" || exit 1; done
echo "17;cluster"
""")
        sbatch.chmod(0o755)
        ran = subprocess.run(["sh", "-s", "--", "--time=10"], input=done.stdout, cwd="/", capture_output=True, text=True,
                             timeout=LONGEST, env=dict(os.environ, PATH=f"{tools}:{os.environ['PATH']}"))
        self.assertEqual(ran.returncode, 0, ran.stderr)
        calls = (tools / "calls").read_text().splitlines()
        self.assertEqual(len(calls), 2)
        self.assertSays(calls[0], "--array=1-3", "--time=10")
        self.assertSays(calls[1], "--dependency=afterany:17", "--time=10")
        self.assertEqual(ran.stdout.splitlines(), ["shards: job 17", "gathering: job 17"])
        self.assertNotIn("cluster", calls[1])
        self.assertEqual(len(self.quantiles()), 4)
        self.assertEqual({row["status"] for row in self.rows()}, {"completed"})

    def test_no_more_shards_than_runs(self):
        done = self.call("study", "study.toml", "--slurm", "--shards", "100")
        self.assertSays(done.stdout, "--array=1-12")
        done = self.call("study", "study.toml", "--shard", "100/100")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertSays(done.stdout, "fewer runs than shards")

    @unittest.skipUnless(shutil.which("parallel"), "GNU parallel is not installed")
    def test_gnu_parallel_takes_the_list(self):
        lines = self.call("study", "study.toml", "--list").stdout
        ran = subprocess.run(["parallel", "--will-cite", "-j2"], input=lines, cwd="/", capture_output=True, text=True,
                             timeout=LONGEST)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertEqual(self.gather().returncode, 0)


if __name__ == "__main__":
    unittest.main()
