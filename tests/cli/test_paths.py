"""Paths that lead nowhere: the path and the reason, whatever command meets them."""

import os
import subprocess
import unittest

from process_case import ProcessTest
from study_case import BASE
from waiting import LONGEST

LONG = "n" * 300
LOOP, TOO_LONG = "Too many levels of symbolic links", "File name too long"


class Paths(ProcessTest):
    def setUp(self):
        super().setUp()
        for name in ("loop", "loop.geo", "loop.csv"):
            os.symlink(name, self.directory / name)
        self.write("file", "")

    def expect_refused(self, arguments, *texts, statuses=(2,), **more):
        done = self.call(*arguments, **more)
        self.assertIn(done.returncode, statuses, f"{arguments}: {done.stderr}")
        for text in (*texts, "error: "):
            self.assertIn(text, done.stderr, arguments)
        self.assertNotIn("filesystem error", done.stderr)

    def test_arguments(self):
        for command in ("run", "check", "study", "plot"):
            self.expect_refused([command, "loop"], "loop", LOOP)
            self.expect_refused([command, LONG], LONG, TOO_LONG)
        self.expect_refused(["check", "file/a.toml"], "file/a.toml", "Not a directory")
        self.expect_refused(["check", "/dev/zero"], "/dev/zero", "a device")

    def test_output_directories(self):
        self.write("study.toml", 'base = "cube.toml"\n[[runs]]\nset = { "time.end" = 1 }\n')
        for command in (["run", "cube.toml"], ["run", "cube.toml", "--resume"], ["study", "study.toml"]):
            self.expect_refused([*command, "--output", "loop"], "loop", LOOP)
            self.expect_refused([*command, "--output", LONG], LONG, TOO_LONG)
            self.expect_refused([*command, "--output", "file"], "file")
            self.expect_refused([*command, "--output", "file/below"], "file/below")
        # Files are never written through a link: it is replaced.
        done = self.call("run", "cube.toml", "--output", "out", "--log-contact", "loop")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertFalse((self.directory / "loop").is_symlink())

    def test_files_that_a_configuration_names(self):
        for name, reason in (("loop.geo", LOOP), (LONG + ".geo", TOO_LONG), ("file/a.geo", "file/a.geo")):
            self.expect_refused(["check", "cube.toml", "--set", f"mesh.file={name}"], name, reason, statuses=(2, 3))
        for name, reason in (("loop.csv", LOOP), (LONG, TOO_LONG), ("none.h5", "No such file")):
            self.write("hot.toml", BASE + f'[temperature]\nfile = "{name}"\n')
            self.expect_refused(["check", "hot.toml"], name, reason, statuses=(2, 3))

    def test_a_missing_directory_for_temporary_files(self):
        done = subprocess.run([os.environ["CREEPCONTACT_PROGRAM"], "check", "cube.toml"], cwd=self.directory, text=True,
                              capture_output=True, timeout=LONGEST, env={**os.environ, "TMPDIR": "/nonexistent"})
        if done.returncode != 0:  # a program that needs none may do without
            self.assertIn(done.returncode, (2, 3))
            self.assertIn("'/nonexistent' (TMPDIR)", done.stderr)

    @unittest.skipIf(os.geteuid() != 0, "only root can become another user")
    def test_directories_that_may_not_be_searched(self):
        closed = self.directory / "closed"
        closed.mkdir()
        (closed / "cube.toml").write_text(BASE)
        closed.chmod(0o700)
        for path in (self.directory, self.temporary):
            path.chmod(0o777)

        def nobody():
            os.setgroups([])
            os.setgid(65534)
            os.setuid(65534)

        for command in (["check", "closed/cube.toml"], ["plot", "closed/out"],
                        ["run", "cube.toml", "--output", "closed/out"]):
            self.expect_refused(command, "closed/", "Permission denied", preexec_fn=nobody)


if __name__ == "__main__":
    unittest.main()
