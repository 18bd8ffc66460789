"""creepcontact-mpi on several processes, more than there are cores: the results of one process, and errors that end all."""

import csv
import json
import os
import pathlib
import re
import signal
import subprocess

import process_case
from test_examples import EveryExample
from waiting import LONGEST, wait_until

ROOT = pathlib.Path(__file__).resolve().parents[2]
MPI_PROGRAM = os.environ["CREEPCONTACT_MPI_PROGRAM"]
MPIEXEC = os.environ["CREEPCONTACT_MPIEXEC"]


def history(directory):
    with open(directory / "history.csv", encoding="utf-8") as file:
        names, *rows = csv.reader(file)
    return names, [[float(value) for value in row] for row in rows]


class MpiTest(process_case.ProcessTest):
    def on(self, processes, *arguments, **more):
        """Starts creepcontact-mpi on so many processes; 0: creepcontact."""
        program = [process_case.PROGRAM] if processes == 0 else [MPIEXEC, "-n", str(processes), MPI_PROGRAM]
        process = subprocess.Popen([*program, *map(str, arguments)], cwd=self.directory, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, **more)
        self.addCleanup(self.end, process)
        return process

    def done(self, processes, *arguments, **more):
        process = self.on(processes, *arguments, **more)
        output, errors = process.communicate(timeout=LONGEST)
        return subprocess.CompletedProcess(arguments, process.returncode, output, errors)

    def run_example(self, processes, example, output, *settings):
        done = self.done(processes, "run", ROOT / "configs" / f"{example}.toml", "--quiet", "--output", output,
                         *[word for setting in settings for word in ("--set", setting)])
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.directory / output

    def expect_the_same(self, first, second, difference=1e-8):
        names, rows = history(first)
        same_names, same_rows = history(second)
        self.assertEqual(names, same_names)
        self.assertEqual(len(rows), len(same_rows))
        for column, name in enumerate(names):
            scale = max(abs(row[column]) for row in rows)
            for row, same in zip(rows, same_rows):
                self.assertLessEqual(abs(row[column] - same[column]), difference * scale, f"{name} at t = {row[0]}")

    def expect_equal_runs(self, example, processes, *settings, difference=1e-8):
        serial = self.run_example(0, example, "serial", *settings)
        for n in processes:
            spread = self.run_example(n, example, f"on_{n}", *settings)
            self.expect_the_same(serial, spread, difference)
            steps = [len((directory / "steps.csv").read_text().splitlines()) for directory in (serial, spread)]
            self.assertEqual(steps[0], steps[1], f"{n} processes")


class MpiResults(MpiTest):
    def test_shrink_fit_by_every_integrator(self):
        for integrator in ("auto", "cvode_adams", "cvode_bdf", "arkode_erk", "explicit_euler", "beta_euler"):
            with self.subTest(integrator):
                self.expect_equal_runs("shrink_fit", (2,), f"time.integrator={integrator}", "time.end=1e4")

    def test_heat_alone(self):
        for n, output in ((0, "serial"), (2, "spread")):
            done = self.done(n, "heat", ROOT / "docs" / "tutorial_heat" / "hot_fit.toml", "--quiet", "--output", output, "--set",
                             "time.end=12", "--set", "time.output=[]")
            self.assertEqual(done.returncode, 0, done.stderr)
        self.expect_the_same(self.directory / "serial", self.directory / "spread")

    def test_processes_without_elements(self):
        self.expect_equal_runs("pressed_blocks", (1, 4), "time.integrator=cvode_bdf", "time.end=10")
        self.expect_equal_runs("pressed_blocks", (3,), "time.integrator=beta_euler", "time.end=10")

    def test_jumps_over_cycles_and_a_resumed_run(self):
        week = 168
        settings = ("--set", f"time.output=[{10 * week}, {30 * week}]", "--set", "output.fields=false")
        for part, *resumed in ((30, ), (60, "--resume")):
            for n, output in ((0, "serial"), (2, "spread")):
                done = self.done(n, "run", ROOT / "configs" / "shrink_fit_cycles.toml", "--quiet", "--output", output, *resumed,
                                 "--set", f"time.end={part * week}", *settings)
                self.assertEqual(done.returncode, 0, done.stderr)
            self.expect_the_same(self.directory / "serial", self.directory / "spread")
            cycles = [(self.directory / output / "cycles.csv").read_text().splitlines() for output in ("serial", "spread")]
            self.assertEqual(*([line.split(",")[:4] for line in lines] for lines in cycles))
            # Iterations end at a threshold, which rounding passes one earlier or later.
            for serial, spread in zip(*([int(line.split(",")[4]) for line in lines[1:]] for lines in cycles)):
                self.assertAlmostEqual(spread, serial, delta=0.1 * serial)
            self.assertLess(len(cycles[0]), 0.6 * part)

    def expect_equal_cubes(self, *settings):
        """One element on two processes, of which one has none."""
        arguments = [word for setting in ("mesh.order=2", *settings) for word in ("--set", setting)]
        warnings = []
        for n, output in ((0, "serial"), (2, "spread")):
            done = self.done(n, "run", "cube.toml", "--quiet", "--output", output, *arguments)
            self.assertEqual(done.returncode, 0, done.stderr)
            warnings.append([line for line in done.stderr.splitlines() if line.startswith("warning: ")])
        self.expect_the_same(self.directory / "serial", self.directory / "spread")
        self.assertEqual(warnings[0], warnings[1])
        return warnings[0]

    def test_a_law_that_fits_the_mean_stress_where_there_is_no_element(self):
        self.expect_equal_cubes("materials.steel.creep=[{law='kachanov_rabotnov', A=3.125e-14, n=5, B=1e-12, r=4, phi=4, "
                                "alpha=0.5}]")

    def test_warnings_of_points_of_any_process(self):
        warnings = self.expect_equal_cubes("temperature.value='20+x*t'", "materials.steel.young_modulus="
                                           "{T=[0,40], values=[200e3,199e3]}")
        self.assertEqual(len(warnings), 1)
        self.assertSays(warnings[0], "young_modulus", "(0 .. 40)")

    def test_fields_and_reports_are_written_as_by_one_process(self):
        # A checkpoint at the end alone: how many a run writes by the clock depends on how busy the machine is.
        directories = [self.run_example(n, "shrink_fit", f"of_{n}", "time.end=10", "output.checkpoint_seconds=1e9")
                       for n in (0, 3)]
        names = [sorted(path.name for path in directory.iterdir()) for directory in directories]
        self.assertEqual(names[0], names[1])
        self.assertIn("fields.pvd", names[0])


class MpiContact(MpiTest):
    @staticmethod
    def coarse(example):
        return [f"mesh.parameters.{key}={value}" for key, value in EveryExample.COARSE[example].items()]

    def test_ball_on_block(self):
        self.expect_equal_runs("ball_on_block", (4,), "mesh.parameters.h=0.8", "time.end=10")

    def test_blade_root(self):
        self.expect_equal_runs("blade_root", (2,), "time.end=1e4")
        # Later, Adams' steps are at the limit of stability: rounding grows there, in a single process too.
        self.expect_equal_runs("blade_root", (2,), "time.end=1e4", "time.integrator=cvode_adams")

    def test_stiffness_that_changes_in_time(self):
        self.expect_equal_runs("start_stop_cycles", (3,), "time.end=200")

    def test_preloads_and_friction(self):
        self.expect_equal_runs("bolted_flange", (2,), "time.end=10", *self.coarse("bolted_flange"))
        self.expect_equal_runs("press_fit_torque", (3,), "time.end=100", *self.coarse("press_fit_torque"))

    def test_a_gasket_that_creeps(self):
        # Preloads are found to 1e-9 of their force, which the creep of the gasket amplifies.
        self.expect_equal_runs("gasketed_flange", (2,), "time.end=100", "time.output=[10, 50]", "output.fields=false",
                               *self.coarse("gasketed_flange"), difference=5e-8)


class MpiPlasticity(MpiTest):
    """Plastic strains are iterated: equal within what that leaves."""
    PRECISION = 1e-6

    def run_bolt(self, processes, output, *more):
        done = self.done(processes, "run", ROOT / "configs" / "bolt_tightened_past_yield.toml", "--quiet", "--output", output,
                         "--set", "time.output=[0.02, 0.05, 2]", *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.directory / output

    def test_a_bolt_that_yields_and_is_resumed(self):
        for processes, output in ((0, "serial"), (3, "spread")):  # both end a step there
            self.run_bolt(processes, output, "--set", "time.end=2")
        serial = self.run_bolt(0, "serial", "--set", "time.end=100", "--resume")
        spread = self.run_bolt(2, "spread", "--set", "time.end=100", "--resume")
        self.expect_the_same(serial, spread, self.PRECISION)
        yielded = [json.loads((directory / "summary.json").read_text())["plastic_strain"]["bolt"] for directory in (serial, spread)]
        self.assertAlmostEqual(yielded[1]["largest"] / yielded[0]["largest"], 1, delta=self.PRECISION)
        self.assertAlmostEqual(yielded[1]["volume_share"], yielded[0]["volume_share"], delta=1e-9)

    def test_multigrid_is_refused(self):
        done = self.done(1, "run", ROOT / "configs" / "bolt_tightened_past_yield.toml", "--set", "linear_solver.method=multigrid")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertSays(done.stderr, "plasticity", "multigrid")


class MpiMultigrid(MpiTest):
    """linear_solver.method = "multigrid": another approximation on every number of processes, the same results."""

    def expect_results_of_factors(self, example, processes, difference, *settings):
        direct = self.run_example(0, example, "direct", *settings)
        for n in processes:
            multigrid = self.run_example(n, example, f"multigrid_{n}", "linear_solver.method=multigrid", *settings)
            self.expect_the_same(direct, multigrid, difference)

    def test_shrink_fit(self):
        self.expect_results_of_factors("shrink_fit", (1, 3), 3e-5, "time.end=1e4")

    def test_stiffness_that_changes(self):
        self.expect_results_of_factors("start_stop_cycles", (2,), 5e-5, "time.end=200", "time.output=[0, 100, 200]")

    def test_an_implicit_method(self):
        self.expect_results_of_factors("shrink_fit", (2,), 1e-4, "time.integrator=cvode_bdf", "time.end=1e4",
                                       "time.output=[0, 1e3, 1e4]")

    def test_friction(self):
        self.expect_results_of_factors("pressed_blocks", (2,), 1e-4, "contacts.0.friction=0.2")

    def test_resumes_with_the_other_method(self):
        settings = ["time.output=[0, 1e2, 1e4]"]
        whole = self.run_example(0, "shrink_fit", "whole", *settings, "time.end=1e4")
        for first, second in (("direct", "multigrid"), ("multigrid", "direct")):
            self.run_example(2, "shrink_fit", first, "time.output=[0, 1e2]", "time.end=1e2",
                             f"linear_solver.method={first}")
            done = self.done(1, "run", ROOT / "configs" / "shrink_fit.toml", "--quiet", "--resume", "--output", first,
                             "--set", settings[0], "--set", "time.end=1e4", "--set", f"linear_solver.method={second}")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.expect_the_same(whole, self.directory / first, 1e-4)


    def test_the_start_is_checked_by_one_process(self):
        words = ("check", ROOT / "configs" / "shrink_fit.toml", "--start", "--set")
        done = [self.done(1, *words, f"linear_solver.method={method}") for method in ("direct", "multigrid")]
        start = [re.search(r"start \(t = 0\):\n.*largest von Mises stress (\S+)", one.stdout, re.DOTALL) for one in done]
        self.assertTrue(all(start), done)
        self.assertAlmostEqual(float(start[0][1]) / float(start[1][1]), 1, delta=1e-4)


class MpiEnds(MpiTest):
    def expect_error(self, processes, status, facts, *arguments, **more):
        done = self.done(processes, *arguments, **more)
        self.assertEqual(done.returncode, status, done.stderr)
        errors = [line for line in done.stderr.splitlines() if line.startswith("error: ")]
        self.assertEqual(len(errors), 1, done.stderr)
        self.assertSays(errors[0], *facts)

    def test_mistakes_are_named_once(self):
        self.expect_error(3, 2, ["none.toml: ", "No such file"], "run", "none.toml")
        self.expect_error(2, 2, ["time.toll: ", "unknown"], "run", "cube.toml", "--set", "time.toll=1")
        self.expect_error(2, 2, ["creepcontact-mpi", "studies"], "study", "study.toml")

    def test_what_cannot_be_spread_is_refused_with_a_reason(self):
        fit = ROOT / "configs" / "shrink_fit.toml"
        self.expect_error(2, 2, ["time.linear_solver", "tangent", "several processes"], "run", fit, "--output", "out",
                          "--set", "time.integrator=cvode_bdf", "--set", "time.linear_solver=tangent")
        self.expect_error(1, 2, ["time.linear_solver", "tangent", "factors"], "run", fit, "--output", "out", "--set",
                          "time.integrator=cvode_bdf", "--set", "time.linear_solver=tangent", "--set",
                          "linear_solver.method=multigrid")
        self.expect_error(0, 2, ["linear_solver.method", "multigrid", "creepcontact-mpi"], "run", fit, "--output", "out", "--set",
                          "linear_solver.method=multigrid")
        self.expect_error(2, 2, ["linear_solver.method", "multigrid", "'check --start'", "one process"], "check", fit, "--start",
                          "--set", "linear_solver.method=multigrid")
        self.expect_error(2, 2, ["contact_solver.dense_limit_mb"], "run", fit, "--output", "out", "--set",
                          "contact_solver.dense_limit_mb=1e-6")
        self.expect_error(2, 2, ["mean stress"], "run",
                          "cube.toml", "--output", "out", "--set", "materials.steel.creep=[{law='kachanov_rabotnov', "
                          "A=3.125e-14, n=5, B=1e-12, r=4, phi=4, alpha=0.5}]")

    def test_an_error_at_the_points_of_any_process_is_one_of_all(self):
        for place in ("10*x", "10*y"):
            self.expect_error(3, 4, ["t = ", "material 'chromium_steel'", "body 'plate' at ("], "run",
                              ROOT / "configs" / "plate_with_hole.toml", "--output", "out", "--set",
                              f"temperature.value='{place}'", "--set", "materials.chromium_steel.creep="
                              "[{law='expression', rate='1e-20*q^5*sqrt(50-T)'}]")

    def test_mpirun_of_the_serial_program(self):
        process = subprocess.run([MPIEXEC, "-n", "2", process_case.PROGRAM, "run", "cube.toml"], cwd=self.directory,
                                 text=True, capture_output=True, timeout=LONGEST)
        self.assertEqual(process.returncode, 2)
        self.assertEqual(process.stderr.count("error: "), 1, process.stderr)
        self.assertSays(process.stderr, "mpirun", "2 processes", "creepcontact-mpi")

    def test_other_files_on_one_process(self):
        """As on machines without a common file system."""
        text = (self.directory / "cube.toml").read_text()
        self.write("first.sh", f'#!/bin/sh\ncd "$OMPI_COMM_WORLD_RANK" && exec "{MPI_PROGRAM}" "$@"\n')
        os.chmod(self.directory / "first.sh", 0o755)
        for rank, change in ((0, ""), (1, "# another\n")):
            (self.directory / str(rank)).mkdir()
            self.write(f"{rank}/cube.toml", change + text)
            self.write(f"{rank}/cube.geo", (self.directory / "cube.geo").read_text())
        process = subprocess.run([MPIEXEC, "-n", "2", "./first.sh", "run", "cube.toml"], cwd=self.directory, text=True,
                                 capture_output=True, timeout=LONGEST)
        self.assertEqual(process.returncode, 2, process.stderr)
        self.assertSays(process.stderr, "process 1", "configuration", "process 0")

    def test_full_disk_keeps_what_is_complete(self):
        self.write("limited.sh", f'#!/bin/sh\ntrap "" XFSZ\nulimit -f 60\nexec "{MPI_PROGRAM}" "$@"\n')
        os.chmod(self.directory / "limited.sh", 0o755)
        # Over TCP: Open MPI's shared memory is a file too.
        process = subprocess.run([MPIEXEC, "--mca", "btl", "self,tcp", "-n", "2", "./limited.sh", "run",
                                  ROOT / "configs" / "shrink_fit.toml", "--output", "full"], cwd=self.directory, text=True,
                                 capture_output=True, timeout=LONGEST)
        self.assertNotEqual(process.returncode, 0)
        self.assertRegex(process.stderr, "error: .*File too large")

    def wait_for_rows(self, directory, process, rows=4):
        def written():
            return (directory / "checkpoint.h5").exists() and \
                len((directory / "history.csv").read_text().splitlines()) > rows

        wait_until(lambda: process.poll() is not None or written(), f"{rows} rows")

    def test_killed_and_resumed_on_other_numbers_of_processes(self):
        settings = ("output.checkpoint_seconds=0", "time.end=1e4")
        whole = self.run_example(0, "blade_root", "whole", *settings)
        arguments = [ROOT / "configs" / "blade_root.toml", "--output", "killed",
                     *[word for setting in settings for word in ("--set", setting)]]
        killed = self.directory / "killed"
        process = self.on(2, "run", *arguments)
        self.wait_for_rows(killed, process)
        workers = subprocess.run(["pgrep", "-P", str(process.pid)], capture_output=True, text=True).stdout.split()
        os.kill(int(workers[-1]), signal.SIGKILL)
        process.communicate(timeout=LONGEST)
        self.assertNotEqual(process.returncode, 0)
        process = self.on(3, "run", *arguments, "--resume")
        self.wait_for_rows(killed, process, 12)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=LONGEST)
        done = self.done(0, "run", *arguments, "--resume")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.expect_the_same(whole, killed)


if __name__ == "__main__":
    process_case.unittest.main()
