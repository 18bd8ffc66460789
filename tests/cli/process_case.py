"""A small run, and how to start and end its process."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from says import Says
from study_case import BASE, GEOMETRY
from waiting import LONGEST

PROGRAM = os.environ["CREEPCONTACT_PROGRAM"]


class ProcessTest(Says, unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.directory = pathlib.Path(scratch.name)
        self.output = self.directory / "out"
        self.temporary = self.directory / "temporary"
        self.temporary.mkdir()
        self.write("cube.geo", GEOMETRY)
        self.write("cube.toml", BASE)

    def write(self, name, text):
        (self.directory / name).write_text(text)

    def start(self, *arguments, **more):
        process = subprocess.Popen([PROGRAM, *arguments], cwd=self.directory, text=True,
                                   **{"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **more},
                                   env={**os.environ, "TMPDIR": str(self.temporary)})
        self.addCleanup(self.end, process)
        return process

    @staticmethod
    def end(process):
        if process.poll() is None:
            process.kill()
        process.communicate()

    def call(self, *arguments, **more):
        process = self.start(*arguments, **more)
        output, errors = process.communicate(timeout=LONGEST)
        return subprocess.CompletedProcess(arguments, process.returncode, output, errors)

    def status(self):
        return json.loads((self.output / "summary.json").read_text())["status"]

    def pipe(self, name):
        """A named pipe: whoever opens it for writing waits until the program opens it for reading."""
        (self.directory / name).unlink(missing_ok=True)
        os.mkfifo(self.directory / name)
        return self.directory / name
