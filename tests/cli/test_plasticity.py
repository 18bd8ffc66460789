"""Yielding as the program tells of it: the first load, limits of tables, loads and preloads that are too much, results."""

import json
import re

import process_case

BAR = """\
title = "bar"
units = "mm, N, MPa, h, degC"
[mesh]
file = "cube.geo"
[bodies.cube]
region = "cube"
material = "steel"
[materials.steel]
young_modulus = 2e5
poisson_ratio = 0.3
plasticity.curve = { plastic_strain = [0, 0.01], stress = [640, 800] }
[[supports]]
on = "x0"
displacement.x = 0
[[supports]]
on = "y0"
displacement.y = 0
[[supports]]
on = "z0"
displacement.z = 0
[[loads]]
on = "x1"
traction = [700, 0, 0]
[time]
end = 1
[output]
directory = "out"
fields = false
"""
STRETCHED = """\
[[supports]]
on = "x1"
displacement.x = { t = [0, 1], values = [0, %g] }
"""


class Plasticity(process_case.ProcessTest):
    def setUp(self):
        super().setUp()
        self.write("bar.toml", BAR)

    def run_bar(self, *settings):
        return self.call("run", "bar.toml", *[word for setting in settings for word in ("--set", setting)])

    def summary(self):
        return json.loads((self.output / "summary.json").read_text())

    def test_check_tells_of_the_first_load(self):
        done = self.call("check", "bar.toml", "--start", "--set", "materials.steel.yield_strength=640")
        self.assertEqual(done.returncode, 0, done.stderr)
        [body] = [line for line in done.stdout.splitlines() if "largest von Mises" in line]
        self.assertSays(body, "700 MPa", "yields", "0.00375")
        self.assertNotIn("elastic", body)
        self.assertEqual(done.stdout.count("yields"), 1)
        [change] = [line for line in done.stdout.splitlines() if "initial_substeps" in line]
        self.assertSays(change, "64", "32")
        self.assertLess(float(re.search(r"up to (\S+) %", change)[1]), 1e-6)

    def test_results_have_what_has_yielded(self):
        self.assertEqual(self.run_bar().returncode, 0)
        yielded = self.summary()["plastic_strain"]["cube"]
        self.assertAlmostEqual(yielded["largest"], 0.00375, delta=1e-8)
        self.assertAlmostEqual(yielded["volume_share"], 1)
        done = self.call("report", "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("has yielded in 100 % of its volume", next(self.directory.rglob("report.html")).read_text())

    def test_quantities_of_hardening(self):
        probes = ", ".join(f"{{name='{name}', quantity='{name}', body='cube', reduce='mean'}}"
                           for name in ("yield_stress", "back_stress_xx", "stress_xx", "plastic_strain_xx"))
        done = self.run_bar(f"probes=[{probes}]",
                            "materials.steel.plasticity={yield_stress=640, hardening_modulus=2000, "
                            "kinematic=[{C=6000}]}")
        self.assertEqual(done.returncode, 0, done.stderr)
        names, *_, last = [line.split(",") for line in (self.output / "history.csv").read_text().splitlines()]
        end = dict(zip(names, map(float, last)))
        self.assertAlmostEqual(end["plastic_strain_xx"], 60 / 8000, delta=1e-8)
        self.assertAlmostEqual(end["yield_stress"], 640 + 2000 * 60 / 8000, delta=1e-3)
        # Deviator: two thirds of the uniaxial back stress.
        self.assertAlmostEqual(end["back_stress_xx"], 2 / 3 * 6000 * 60 / 8000, delta=1e-3)

    def test_the_end_of_a_table_is_told_once(self):
        self.write("bar.toml", BAR[:BAR.index("[[loads]]")] + STRETCHED % 0.02 + BAR[BAR.index("[time]"):])
        done = self.run_bar()
        self.assertEqual(done.returncode, 0, done.stderr)
        [warning] = [line for line in done.stderr.splitlines() if "plasticity.curve" in line]
        self.assertSays(warning, "'steel'", "(0.01)", "last value")

    def test_a_first_load_beyond_the_limit(self):
        done = self.run_bar("loads.0.traction=[850, 0, 0]")
        self.assertEqual(done.returncode, 4)
        [error] = [line for line in done.stderr.splitlines() if line.startswith("error: ")]
        self.assertSays(error, "of the loads of t = 0", "'cube'", "flows")
        reached = float(re.search(r"(\S+) % of the loads", error)[1])
        self.assertAlmostEqual(reached, 100 * 800 / 850, delta=1)

    def test_a_yield_stress_of_t_needs_a_temperature(self):
        for given in ("plasticity={yield_stress={T=[20, 500], values=[640, 430]}}", "yield_strength={T=[20, 500], values=[640, 430]}",
                      "plasticity={curve=[{T=20, plastic_strain=[0], stress=[640]}, {T=500, plastic_strain=[0], stress=[430]}]}"):
            with self.subTest(given):
                done = self.run_bar(f"materials.steel.{given}")
                self.assertEqual(done.returncode, 2)
                self.assertSays(done.stderr, "depends on T", "[temperature]")
