"""Standard output that nobody reads, that is full, or closed."""

import os
import unittest

from process_case import ProcessTest
from waiting import LONGEST

FULL = "error: ", "standard output", "No space left on device"


class StandardOutput(ProcessTest):
    run_arguments = ("run", "cube.toml", "--output", "out")

    def test_a_closed_pipe_ends_nothing(self):
        for streams in (["stdout"], ["stdout", "stderr"]):
            reader, writer = os.pipe()
            os.close(reader)
            done = self.call(*self.run_arguments, **{stream: writer for stream in streams})
            os.close(writer)
            self.assertEqual((done.returncode, self.status()), (0, "completed"), done.stderr)

    def test_a_long_list_for_few_lines(self):
        reader, writer = os.pipe()
        process = self.start("list", "keys", "--markdown", stdout=writer)
        os.close(writer)
        os.read(reader, 10)
        os.close(reader)
        errors = process.communicate(timeout=LONGEST)[1]
        self.assertEqual((process.returncode, errors), (0, ""))

    def test_a_full_disk_is_an_error(self):
        with open("/dev/full", "w") as full:
            for arguments in (["list", "keys"], ["--version"], ["run", "--help"], ["check", "cube.toml"]):
                done = self.call(*arguments, stdout=full)
                self.assertEqual(done.returncode, 4, arguments)
                self.assertSays(done.stderr, *FULL)
            done = self.call(*self.run_arguments, stdout=full)
            self.assertEqual((done.returncode, self.status()), (4, "completed"))
            self.assertSays(done.stderr, *FULL, "; ")
            wrong = self.call("chekc", stdout=full)
            self.assertEqual((wrong.returncode, wrong.stderr.count("error: ")), (2, 1))

    def test_closed_descriptors_are_no_files(self):
        done = self.call(*self.run_arguments)
        history = (self.output / "history.csv").read_text()
        done = self.call(*self.run_arguments, preexec_fn=lambda: [os.close(number) for number in (0, 1, 2)])
        self.assertEqual((done.returncode, self.status()), (0, "completed"))
        self.assertEqual((self.output / "history.csv").read_text(), history)


if __name__ == "__main__":
    unittest.main()
