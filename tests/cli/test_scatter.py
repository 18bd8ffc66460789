"""`creepcontact study` with random keys: quantiles of a bar against the closed form, events, correlations, mistakes."""

import csv
import math
import pathlib
import re
import signal
import statistics
import subprocess
import unittest

from study_case import BASE, PROGRAM, StudyTest
from waiting import LONGEST, wait_until

STUDIES = pathlib.Path(__file__).resolve().parents[2] / "studies"

MODULUS, EXPONENT, MEDIAN, FACTOR = 200e3, 5, 3.125e-14, 2.0

EVENT = """[[events]]
name = "slack"
when = "stress < 90"
[[criteria]]
name = "strong"
probe = "stress"
min = 80
"""

STUDY = """title = "A bar of many melts"
base = "cube.toml"
set = { output.fields = false, time.tolerance = 1e-5 }
[random]
samples = 64
seed = 3
[[random.keys]]
key = "materials.steel.creep[0].A"
distribution = "lognormal"
median = 3.125e-14
factor = 2.0
"""
SECOND_KEY = """[[random.keys]]
key = "supports[3].displacement.x"
distribution = "uniform"
min = 0.08
max = 0.12
"""
COMPARE = """[compare]
quantities = ["stress"]
"""


def stress(constant, time, start=200.0):
    """Of a bar that is stretched and held, under Norton's law."""
    return (start**(1 - EXPONENT) + (EXPONENT - 1) * constant * MODULUS * time)**(-1 / (EXPONENT - 1))


def constant_of(probability):
    return MEDIAN * FACTOR**statistics.NormalDist().inv_cdf(probability)


class Scatter(StudyTest):
    def setUp(self):
        super().setUp()
        self.write("cube.toml", BASE + EVENT)

    def table(self, name):
        with open(self.output / name, newline="") as file:
            return list(csv.DictReader(file))

    def test_quantiles_of_a_bar_in_closed_form(self):
        done = self.study(STUDY + COMPARE)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("64 of 64 runs succeeded", done.stdout)
        rows = self.table("quantiles.csv")
        self.assertEqual([float(row["time"]) for row in rows], [0, 0.1, 0.2, 0.4])
        for row in rows[1:]:
            time = float(row["time"])
            self.assertEqual(row["samples"], "64")
            # The stress falls as A grows. Each of 64 strata has one sample.
            for name, probability, tolerance in (("q05", 0.95, 0.012), ("q50", 0.5, 0.004), ("q95", 0.05, 0.012)):
                exact = stress(constant_of(probability), time)
                self.assertAlmostEqual(float(row[f"stress_{name}"]), exact, delta=tolerance * exact)
            self.assertLess(float(row["stress_q50_low"]), stress(MEDIAN, time))
            self.assertGreater(float(row["stress_q50_high"]), stress(MEDIAN, time))
            self.assertEqual(row["stress_q05_low"], "")  # 64 samples do not bound it from below

        for row in self.table("study.csv"):
            exact = stress(float(row["materials.steel.creep[0].A"]), 0.4)
            self.assertAlmostEqual(float(row["stress_end"]), exact, delta=2e-4 * exact)

        # Below 90 MPa at the time t: A > (90^-4 - 200^-4)/(4 E t).
        def probability(limit, time):
            constant = (limit**-4 - 200**-4) / (4 * MODULUS * time)
            return 1 - statistics.NormalDist().cdf(math.log(constant / MEDIAN) / math.log(FACTOR))
        rows = self.table("probabilities.csv")
        for row in rows[1:]:
            exact = probability(90, float(row["time"]))
            self.assertAlmostEqual(float(row["slack"]), exact, delta=1.01 / 64)
            self.assertLess(float(row["slack_low"]), exact)
            self.assertGreater(float(row["slack_high"]), exact)
        self.assertEqual([row["not_met_strong"] for row in rows[:-1]], ["", "", ""])
        self.assertAlmostEqual(float(rows[-1]["not_met_strong"]), probability(80, 0.4), delta=1.01 / 64)

        text = (self.output / "study.md").read_text()
        self.assertSays(text, "## Scatter", "64 samples", "sobol", "lognormal, median 3.125e-14, factor 2",
                        "criterion `strong`", "stress_end", "-1.00", "## Runs", "20 of 64", "## Pictures")
        for picture in ("fan_stress", "histogram_stress", "cloud_stress", "probabilities"):
            self.assertIn(f"![{picture}]({picture}.svg)", text)
            self.assertEqual((self.output / f"{picture}.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual([row["samples"] for row in self.table("convergence.csv")], ["8", "16", "32", "64"])

        done = self.call("report", str(self.output))
        self.assertEqual(done.returncode, 0, done.stderr)
        page = (self.output / "report.html").read_text()
        self.assertSays(page, "<h2>Scatter</h2>", "64 of 64 samples were computed", "fan_stress")

    def test_more_samples_keep_those_that_there_are(self):
        small = STUDY.replace("samples = 64", "samples = 4")
        self.assertEqual(self.study(small).returncode, 0)
        first, samples = self.written(), self.table("samples.csv")
        done = self.study(small.replace("samples = 4", "samples = 6"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.table("samples.csv")[:4], samples)
        written = self.written()
        self.assertEqual({name: written[name] for name in first}, first)
        self.assertEqual(len(written), 6)
        # All probes of the base, since there is no [compare].
        self.assertIn("stress_end", self.rows()[0])
        self.expect_error(self.study(small.replace("seed = 3", "seed = 4")), 2, "results/study", "--output")

    def test_two_keys_and_axes(self):
        text = STUDY.replace("samples = 64", "samples = 24") + SECOND_KEY
        axes = '[[axes]]\nkey = "time.end"\nvalues = [0.2, 0.4]\n'
        done = self.study(text + axes + COMPARE)
        self.assertEqual(done.returncode, 0, done.stderr)
        samples = self.table("samples.csv")
        keys = list(samples[0])[1:]
        self.assertEqual([[row[key] for key in keys] for row in samples[:24]],
                         [[row[key] for key in keys] for row in samples[24:]])
        ends = [row for row in self.table("quantiles.csv") if row["time"] in ("0.2", "0.4")]
        self.assertEqual([(row["time.end"], row["time"]) for row in ends], [("0.2", "0.2"), ("0.4", "0.2"), ("0.4", "0.4")])
        indices = {row["result"]: row for row in self.table("sobol_indices.csv") if row["time.end"] == "0.4"}
        # With a long time the start is forgotten: the creep constant decides. At the start it is the displacement.
        self.assertGreater(float(indices["stress_end"][keys[0]]), 0.9)
        self.assertGreater(float(indices["stress_max"][keys[1]]), 0.99)
        self.assertGreater(float(indices["stress_end"]["quality"]), 0.95)
        ranks = {row["result"]: row for row in self.table("correlation.csv") if row["time.end"] == "0.4"}
        self.assertLess(float(ranks["stress_end"][keys[0]]), -0.9)
        self.assertAlmostEqual(float(ranks["stress_max"][keys[1]]), 1, delta=1e-9)

    def test_a_sample_that_fails_is_a_row(self):
        # An explicit Euler step beyond stability fails for the large constants alone.
        text = STUDY.replace("samples = 64", "samples = 16").replace(
            "time.tolerance = 1e-5", 'time.integrator = "beta_euler", time.step = 0.02, time.beta = 0.5')
        done = self.study(text.replace("factor = 2.0", "factor = 40.0"))
        self.assertEqual(done.returncode, 0, done.stderr)
        statuses = [row["status"] for row in self.rows()]
        self.assertGreater(statuses.count("failed"), 0)
        self.assertGreater(statuses.count("completed"), 0)
        self.assertSays((self.output / "study.md").read_text(), f"{statuses.count('completed')} of 16 samples",
                        f"{statuses.count('failed')} failed")
        self.assertEqual(self.table("quantiles.csv")[-1]["samples"], str(statuses.count("completed")))

    def test_a_normal_constant_is_refused_before_the_runs(self):
        text = STUDY.replace('"lognormal"', '"normal"').replace("median = ", "mean = ").replace(
            "factor = 2.0", "deviation = 1.5e-14")
        self.expect_error(self.study(text), 2, "study.toml:8:7: random.keys[0].key: ", "materials.steel.creep[0].A",
                          "normal, mean 3.125e-14", "negative with a probability of 1.9 %", '"lognormal"', '"triangular"')
        self.assertFalse(self.output.exists())

    def test_the_constants_of_a_fit(self):
        scatter = (1.1, 0.95, 1.05, 0.9, 1.0)
        rates = [f"{stress},{factor * MEDIAN * stress**EXPONENT}" for stress, factor in zip((80, 110, 140, 170, 200), scatter)]
        self.write("rates.csv", "\n".join(["stress [MPa],creep_rate [1/h]", *rates]) + "\n")
        done = self.call("fit", "rates.csv", "--law", "norton", "--output", "fitted.toml")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("fitted_scatter.toml", done.stdout)
        found = (self.directory / "fitted_scatter.toml").read_text()
        constants = dict(zip(("A", "n"), map(float, re.search(r"values = \[(.*)\]", found)[1].split(","))))
        self.write("cube.toml", BASE.replace("A = 3.125e-14, n = 5", f"A = {constants['A']}, n = {constants['n']}"))
        text = STUDY[:STUDY.index("key = ")].replace("samples = 64", "samples = 16")
        text += 'key = "materials.steel.creep[0]"\nfit = "fitted_scatter.toml"\n'
        done = self.study(text + COMPARE)
        self.assertEqual(done.returncode, 0, done.stderr)
        samples = self.table("samples.csv")
        keys = [f"materials.steel.creep[0].{key}" for key in ("A", "n")]
        self.assertEqual(list(samples[0]), ["run", *keys])
        # A larger exponent goes with a smaller factor.
        by_factor = sorted(samples, key=lambda row: float(row[keys[0]]))
        self.assertGreater(float(by_factor[0][keys[1]]), float(by_factor[-1][keys[1]]))
        self.assertSays((self.output / "study.md").read_text(), "have the correlation -0.9", "The keys are correlated")
        self.assertFalse((self.output / "sobol_indices.csv").exists())
        self.write("cube.toml", BASE)
        self.expect_error(self.study(text, "--output", "other"), 2, "study.toml:7:1: random.keys[0]: ", "the fit found",
                          "cube.toml has 3.125e-14")

    def test_a_fit_with_batches_gives_samples_of_new_ones(self):
        factors = {"a": 0.4, "b": 0.8, "c": 1.1, "d": 1.9, "e": 2.6, "f": 0.6}
        rates = [f"{stress},{factor * reading * MEDIAN * stress**EXPONENT},{name}" for name, factor in factors.items()
                 for stress, reading in zip((80, 120, 180), (1.02, 0.97, 1.01))]
        self.write("rates.csv", "\n".join(["stress [MPa],creep_rate [1/h],batch", *rates]) + "\n")
        done = self.call("fit", "rates.csv", "--law", "norton", "--output", "fitted.toml")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertSays(done.stdout, "factor on A of each batch", "from batch to batch")
        found = (self.directory / "fitted_scatter.toml").read_text()
        deviation = float(re.search(r"\[batches\].*?deviation = ([\d.e-]+)", found, re.S)[1])
        logs = [math.log(factor) for factor in factors.values()]
        self.assertAlmostEqual(deviation, statistics.stdev(logs), delta=0.01)
        constants = dict(zip(("A", "n"), map(float, re.search(r"values = \[(.*)\]", found)[1].split(","))))
        self.write("cube.toml", BASE.replace("A = 3.125e-14, n = 5", f"A = {constants['A']}, n = {constants['n']}"))
        text = STUDY[:STUDY.index("key = ")] + 'key = "materials.steel.creep[0]"\nfit = "fitted_scatter.toml"\n'
        self.assertEqual(self.study(text + COMPARE).returncode, 0)
        sampled = [math.log(float(row["materials.steel.creep[0].A"])) for row in self.table("samples.csv")]
        # A new batch about the mean of six, which is not known better.
        self.assertAlmostEqual(statistics.stdev(sampled) / (deviation * math.sqrt(1 + 1 / 6)), 1, delta=0.1)
        self.write("fitted_scatter.toml", found.replace('key = "A"', 'key = "B"'))
        self.expect_error(self.study(text, "--output", "other"), 2, "random.keys[0]", "[batches]", "fit")


class Together(StudyTest):
    """Samples that one process computes, against those that have a process each."""

    KEYS = STUDY.replace("samples = 64", "samples = 12") + SECOND_KEY + COMPARE

    def setUp(self):
        super().setUp()
        self.write("cube.toml", BASE + EVENT)

    def histories(self, directory):
        return {path.parent.name: path.read_text() for path in (self.directory / directory).glob("runs/*/history.csv")}

    def expect_same(self, first, second, within):
        self.assertEqual(sorted(first), sorted(second))
        for name in first:
            for a, b in zip(first[name].splitlines()[1:], second[name].splitlines()[1:], strict=True):
                for x, y in zip(a.split(","), b.split(","), strict=True):
                    self.assertAlmostEqual(float(x), float(y), delta=within * max(abs(float(x)), 1e-300))

    def test_samples_are_those_of_single_runs(self):
        for together, output in (("1", "single"), ("5", "five"), ("16", "all")):
            done = self.study(self.KEYS, "--together", together, "--output", output)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("12 of 12 runs succeeded", done.stdout)
        single = self.histories("single")
        self.assertEqual(len(single), 12)
        self.expect_same(single, self.histories("five"), 1e-9)
        self.expect_same(single, self.histories("all"), 1e-9)

    def test_they_are_the_same_for_any_number_of_threads(self):
        for jobs in ("1", "2"):
            self.assertEqual(self.study(self.KEYS, "--jobs", jobs, "--output", f"jobs{jobs}").returncode, 0)
        self.assertEqual(self.histories("jobs1"), self.histories("jobs2"))

    def test_messages_belong_to_their_runs(self):
        text = self.KEYS.replace("time.tolerance = 1e-5", 'time.integrator = "beta_euler", time.step = 0.02, time.beta = 0.5')
        done = self.study(text.replace("factor = 2.0", "factor = 40.0"))
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = self.rows()
        for run, row in enumerate(rows, 1):
            log = (self.output / f"runs/run_{run:03}/run.log").read_text()
            self.assertEqual("error: " in log, row["status"] == "failed", (row["status"], log))
        self.assertEqual({row["status"] for row in rows}, {"failed", "completed"})
        self.assertEqual(self.call("study", "study.toml", "--together", "1").returncode, 0)  # those that failed, once more
        self.assertEqual([(row["status"], row["message"]) for row in self.rows()],
                         [(row["status"], row["message"]) for row in rows])

    def test_an_interrupted_study_goes_on(self):
        text = self.KEYS.replace("time.tolerance = 1e-5", 'time.integrator = "explicit_euler", time.step = 2e-5')
        self.write("study.toml", text)
        process = subprocess.Popen([PROGRAM, "study", "study.toml"], cwd=self.directory, stderr=subprocess.PIPE, text=True)
        wait_until(lambda: any(self.output.glob("runs/*/steps.csv")), "a first step")
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=LONGEST)
        self.assertEqual(process.returncode, 130, errors)
        self.assertSays(errors, "run the same command to continue")
        done = self.study(text)
        self.assertEqual(done.returncode, 0, done.stderr)
        done = self.study(text, "--output", "whole")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.expect_same(self.histories("whole"), self.histories("results/study"), 1e-9)

    def test_mistakes(self):
        self.expect_error(self.study(self.KEYS, "--together", "0"), 2, "--together", "1 to 64")
        self.expect_error(self.study(self.KEYS.replace('"materials.steel.creep[0].A"', '"time.end"')), 2, "'time.end'", "describe the model")
        self.expect_error(self.study(self.KEYS.replace("[random]\n", "[random]\nquantiles = []\n")), 2, "random.quantiles", "an empty list")
        done = self.study(self.KEYS.replace("creep[0].A", "creep[0].B"))
        self.expect_error(done, 2, "unknown key")
        self.assertNotIn("reaches", done.stderr)


class ScatterExamples(StudyTest):
    """The studies of the examples still run, with two samples."""

    def expect_runs(self, name, settings):
        text = (STUDIES / name / "study.toml").read_text().replace("samples = 64", "samples = 2")
        text = text.replace("../../configs", str(STUDIES.parent / "configs"))
        done = self.study(text.replace("[set]\n", "[set]\n" + settings))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([row["status"] for row in self.rows()], ["completed"] * 2)
        self.assertTrue((self.output / "quantiles.csv").exists())

    def test_scatter_of_a_bolted_joint(self):
        coarse = dict(n_around=2, n_hole=2, n_face=2, n_seat=2, n_bearing=1, n_thickness=2, n_shank=2)
        self.expect_runs("bolt_scatter", "".join(f"mesh.parameters.{key} = {n}\n" for key, n in coarse.items()))

    def test_tolerances_of_a_fit(self):
        self.expect_runs("fit_tolerances", "")


if __name__ == "__main__":
    unittest.main()
