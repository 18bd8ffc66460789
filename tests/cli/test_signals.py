"""Signals outside the time loop: the program ends at once, with a sentence and the status 130, and leaves nothing."""

import signal
import unittest

from process_case import ProcessTest
from study_case import BASE

SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


class SignalStages(ProcessTest):
    def expect_interrupted(self, process, number):
        errors = process.communicate(timeout=50)[1]
        self.assertEqual(process.returncode, 130, errors)
        self.assertEqual([line for line in errors.splitlines() if line.startswith("error: ")],
                         [f"error: interrupted ({number.name}): ended before there were results to save"])
        self.assertFalse(self.output.exists())
        self.assertEqual(list(self.temporary.iterdir()), [])

    def interrupted_at(self, pipe, *arguments):
        """Signals come where the program waits for what is in the pipe."""
        for number in SIGNALS:
            process = self.start(*arguments)
            with open(self.pipe(pipe), "w"):
                process.send_signal(number)
                self.expect_interrupted(process, number)

    def test_while_a_configuration_is_read(self):
        for command in (["check"], ["run", "--output", "out"]):
            self.interrupted_at("pipe.toml", *command, "pipe.toml")

    def test_while_the_model_is_built(self):
        self.write("cube.toml", BASE + '[temperature]\nfile = "pipe.csv"\n')
        for command in (["check"], ["run", "--output", "out"]):
            self.interrupted_at("pipe.csv", *command, "cube.toml")

    def test_while_a_study_is_read_and_planned(self):
        self.interrupted_at("pipe.toml", "study", "pipe.toml", "--output", "out")
        self.write("study.toml", 'base = "pipe.toml"\n[[axes]]\nkey = "time.end"\nvalues = [1, 2]\n')
        self.interrupted_at("pipe.toml", "study", "study.toml", "--output", "out")

    def test_while_pictures_are_drawn(self):
        (self.directory / "run").mkdir()
        self.interrupted_at("run/history.csv", "plot", "run", "--output", "out")

    def test_before_main(self):
        for number in SIGNALS:
            process = self.start("check", "cube.toml",
                                 preexec_fn=lambda: signal.pthread_sigmask(signal.SIG_BLOCK, SIGNALS))
            process.send_signal(number)
            self.expect_interrupted(process, number)

    def test_nohup(self):
        process = self.start("run", "pipe.toml", "--output", "out", "--quiet",
                             preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        with open(self.pipe("pipe.toml"), "w") as pipe:
            process.send_signal(signal.SIGHUP)
            pipe.write(BASE)
        self.assertEqual(process.communicate(timeout=50)[1], "")
        self.assertEqual((process.returncode, self.status()), (0, "completed"))


if __name__ == "__main__":
    unittest.main()
