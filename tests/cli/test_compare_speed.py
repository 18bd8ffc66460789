"""scripts/compare_speed: two programs in turn, and what happens if one of them fails."""

import pathlib
import subprocess
import sys
import unittest

from process_case import PROGRAM, ProcessTest
from waiting import LONGEST

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts/compare_speed"


class CompareSpeed(ProcessTest):
    def compare(self, *arguments):
        return subprocess.run([sys.executable, str(SCRIPT), "--repeat", "1", "--markdown", *map(str, arguments),
                               str(self.directory / "cube.toml")], capture_output=True, text=True, timeout=LONGEST)

    def failing(self):
        program = self.directory / "failing"
        program.write_text("#!/bin/sh\necho 'error: it cannot' >&2\nexit 1\n")
        program.chmod(0o755)
        return program

    def cells(self, done):
        return [cell.strip() for cell in done.stdout.splitlines()[-1].strip("|").split("|")]

    def test_a_program_against_itself_has_equal_counts(self):
        done = self.compare(PROGRAM, PROGRAM)
        self.assertEqual(done.returncode, 0, done.stderr)
        example, seconds, steps, solves, _, _, solve_ratio = self.cells(done)
        self.assertEqual(example, "cube")
        for counts in (steps, solves):
            old, new = map(int, counts.split(" → "))
            self.assertEqual(old, new)
            self.assertGreater(old, 0)
        self.assertTrue(all(float(value) > 0 for value in seconds.split(" → ")))
        self.assertEqual(float(solve_ratio), 1)

    def test_a_new_program_that_fails_is_a_failure(self):
        done = self.compare(PROGRAM, self.failing())
        self.assertEqual(done.returncode, 1)
        self.assertIn("it cannot", self.cells(done)[1])

    def test_an_old_program_that_fails_is_none(self):
        done = self.compare(self.failing(), PROGRAM)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("it cannot", self.cells(done)[2])


if __name__ == "__main__":
    unittest.main()
