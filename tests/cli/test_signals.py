"""Signals: outside the time loop the program ends at once, with a sentence and the status 130, and leaves nothing;
within a contact problem that takes minutes it gives that up and saves what there is."""

import csv
import json
import signal
import unittest

from box_mesh import BoxMesh
from process_case import ProcessTest
from study_case import BASE
from waiting import LONGEST, wait_until

SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


class SignalStages(ProcessTest):
    def expect_interrupted(self, process, number):
        errors = process.communicate(timeout=LONGEST)[1]
        self.assertEqual(process.returncode, 130, errors)
        said = [line for line in errors.splitlines() if line.startswith("error: ")]
        self.assertEqual(len(said), 1, errors)
        self.assertSays(said[0], f"({number.name})", "results")
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
        self.assertEqual(process.communicate(timeout=LONGEST)[1], "")
        self.assertEqual((process.returncode, self.status()), (0, "completed"))


# The blocks touch from t = 1 on. Sweeps so small would not converge in years, and are as many as may be.
SLOW = """[mesh]
file = "blocks.msh"
[bodies.low]
region = "low"
material = "steel"
[bodies.top]
region = "top"
material = "steel"
[materials.steel]
young_modulus = 2e5
poisson_ratio = 0.3
[[supports]]
on = "low_z0"
displacement = { x = 0, y = 0, z = 0 }
[[supports]]
on = "top_z1"
displacement = { x = 0, y = 0, z = "t < 1 ? 0 : -0.02" }
[[contacts]]
name = "c"
between = ["top_z0", "low_z1"]
gap = 0.01
[contact_solver]
acceleration = "none"
damping = 1e-9
max_iterations = 1000000
[time]
end = 3
output = [0.5, 2]
breakpoints = [1]
[output]
fields = false
[[probes]]
name = "force"
quantity = "contact_force_z"
on = "low_z1"
"""


def read_rows(path):
    with open(path, encoding="utf-8") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


class SlowContact(ProcessTest):
    def setUp(self):
        super().setUp()
        mesh = BoxMesh()
        mesh.add("low", "hex8", (12, 12, 2), lambda x, y, z: (x, y, z))
        mesh.add("top", "hex8", (12, 12, 2), lambda x, y, z: (x, y, 2.01 + z))
        mesh.write(self.directory / "blocks.msh")
        self.write("slow.toml", SLOW)

    def interrupted(self, number, *more):
        """The signal comes while the contact problem at t = 2 is being solved."""
        log = self.directory / "contact.csv"
        log.unlink(missing_ok=True)
        process = self.start("run", "slow.toml", "--output", "out", "--quiet", "--log-contact", str(log), *more)
        wait_until(lambda: process.poll() is not None or (log.exists() and log.read_text().count("\n") >= 100),
                   "100 sweeps")
        process.send_signal(number)
        return process.returncode, process.communicate(timeout=LONGEST)[1], process.returncode

    def test_a_contact_problem_is_given_up_and_the_run_can_be_resumed(self):
        for number in SIGNALS:
            before, errors, status = self.interrupted(number)
            self.assertIsNone(before)
            self.assertEqual(status, 130, errors)
            self.assertIn("--resume", errors)
            summary = json.loads((self.output / "summary.json").read_text())
            self.assertEqual((summary["status"], summary["time_reached"]), ("interrupted", 0.5))
            self.assertEqual([row["time"] for row in read_rows(self.output / "history.csv")], [0, 0.5])
        # Resumed, the problem is begun anew, and may be given up again.
        before, errors, status = self.interrupted(signal.SIGTERM, "--resume")
        self.assertEqual((before, status), (None, 130), errors)


if __name__ == "__main__":
    unittest.main()
