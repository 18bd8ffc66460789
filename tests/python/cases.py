"""What the tests of the Python package share."""

import os
import pathlib
import subprocess
import tempfile
import unittest

import creepcontact as cc

CONFIGS = pathlib.Path(__file__).resolve().parents[2] / "configs"
PROGRAM = os.environ["CREEPCONTACT_PROGRAM"]
#: A shrink fit that takes tenths of a second.
SHORT = {"time.end": 1000, "time.output": [1, 100, 1000]}


def shrink_fit(**more):
    return cc.Model(CONFIGS / "shrink_fit.toml", set=SHORT | more)


class Case(unittest.TestCase):
    def setUp(self):
        self._temporary = tempfile.TemporaryDirectory()
        self.directory = pathlib.Path(self._temporary.name)
        self.addCleanup(self._temporary.cleanup)

    def command(self, *words):
        done = subprocess.run([PROGRAM, *map(str, words)], cwd=self.directory, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def assertSays(self, text, *facts):
        for fact in facts:
            self.assertIn(fact, str(text))
