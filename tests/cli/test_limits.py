"""Limits of memory and of numbers: a sentence and a status, promptly; neither a signal nor an endless wait."""

import resource
import signal
import unittest

from process_case import ProcessTest
from study_case import BASE

MEGABYTE = 1 << 20


class MemoryLimits(ProcessTest):
    def limited(self, kind, megabytes, *arguments):
        return self.call(*arguments, preexec_fn=lambda: resource.setrlimit(kind, 2 * (megabytes * MEGABYTE,)))

    def expect_done_or_a_sentence(self, kind, sizes, command="run", *more):
        statuses = []
        for size in sizes:
            done = self.limited(kind, size, command, "cube.toml", *more)
            statuses.append(done.returncode)
            if done.returncode in (127, -signal.SIGINT):  # there is no room for the libraries: they speak before main
                self.assertRegex(done.stderr, "shared librar|OpenBLAS")
            elif done.returncode != 0:
                self.assertIn(done.returncode, (3, 4), f"{size} MB: {done.stderr}")
                self.assertRegex(done.stderr, r"(?m)^error: .*memory", f"{size} MB")
        return statuses

    def test_address_space(self):
        statuses = self.expect_done_or_a_sentence(resource.RLIMIT_AS, [*range(25, 750, 50), 2000])
        self.assertEqual(statuses[-1], 0)
        self.assertIn(3, statuses)
        self.expect_done_or_a_sentence(resource.RLIMIT_AS, range(50, 450, 100), "check")

    def test_data(self):
        statuses = self.expect_done_or_a_sentence(resource.RLIMIT_DATA, [*range(10, 250, 40), 1000])
        self.assertEqual(statuses[-1], 0)

    def test_a_model_that_is_too_large_is_refused_with_numbers(self):
        self.write("cube.geo", (self.directory / "cube.geo").read_text().replace("= 2;", "= 13;").replace(
            "Layers{1}", "Layers{12}"))
        self.write("cube.toml", BASE.replace("order = 1", "order = 2"))
        # How much the libraries take is theirs to say: the first limit at which nothing but the model is too large.
        for size in range(200, 1000, 100):
            done = self.limited(resource.RLIMIT_AS, size, "run", "cube.toml", "--output", "out", "--threads", "1")
            self.assertNotEqual(done.returncode, 0, f"{size} MB")
            if "(ulimit -v)" in done.stderr and "cube.geo: " in done.stderr:
                break
        self.assertEqual(done.returncode, 3, done.stderr)
        # What it needs, the parts of that, what is left, the limit and what of it is in use.
        self.assertRegex(done.stderr, r"error: cube\.geo: .* \d+ MB.*\(factors \d+ MB, contact matrices 0 MB, .* 134 MB\).* \d+ MB.*"
                                      r" \(ulimit -v\) .*\d+ MB.* \d+ MB.*\n")
        self.assertFalse(self.output.exists())
        warned = self.limited(resource.RLIMIT_AS, size, "check", "cube.toml")
        self.assertEqual(warned.returncode, 0, warned.stderr)
        self.assertLineSays(warned.stdout, "warning: ", " MB", "(factors ", "(ulimit -v)")


class NumberLimits(ProcessTest):
    def expect_refused(self, *arguments, facts):
        done = self.call(*arguments)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertSays(done.stderr, *facts)

    def test_threads_and_jobs(self):
        for number in ("2000000000", "0", "-1", "100000"):
            self.expect_refused("run", "cube.toml", "-j", number, facts=[f"--threads: {number}", "1 to "])
        for number in ("2000000000", "0", "-1"):
            self.expect_refused("study", "study.toml", "--jobs", number, facts=[f"--jobs: {number}", "1 to 1000"])
        self.expect_refused("run", "cube.toml", "--threads", "99999999999999999999", facts=["--threads"])

    def test_configuration(self):
        for override in ("time.output={count=2147483647}", "supports.3.displacement.x={t=[0],values=[1],period=1e-300}",
                         "contact_solver.max_iterations=2147483647", "time.step=1e-300",
                         ".".join("a" * 50000) + "=1"):
            self.expect_refused("check", "cube.toml", "--set", override, facts=["error: --set " + override[:20]])


if __name__ == "__main__":
    unittest.main()
