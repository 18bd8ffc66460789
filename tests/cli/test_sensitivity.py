"""Derivatives of results with respect to numbers of the configuration, against closed forms and other runs."""

import csv
import json
import re
import unittest

from process_case import ProcessTest
from study_case import BASE

A, N, E, U = "materials.steel.creep[0].A", "materials.steel.creep[0].n", "materials.steel.young_modulus", "supports[3].displacement.x"
VALUES = {A: 3.125e-14, N: 5, E: 200e3, U: 0.1}
LEVEL = 120  # of the event
MORE = """[[events]]
name = "low"
when = "stress < 120"
[sensitivity]
keys = ["materials.steel.creep[0].A", "materials.steel.creep[0].n", "materials.steel.young_modulus", "supports[3].displacement.x"]
"""


def stress(t, of):
    """A bar stretched by U/100 and held."""
    return ((of[E] * of[U] / 100)**(1 - of[N]) + (of[N] - 1) * of[A] * of[E] * t)**(-1 / (of[N] - 1))


def time_of_level(of):
    return (LEVEL**(1 - of[N]) - (of[E] * of[U] / 100)**(1 - of[N])) / ((of[N] - 1) * of[A] * of[E])


def derivative(function, key):
    h = 1e-5
    more, less = ({**VALUES, key: VALUES[key] * (1 + sign * h)} for sign in (1, -1))
    return (function(more) - function(less)) / (2 * h * VALUES[key])


class Sensitivity(ProcessTest):
    def setUp(self):
        super().setUp()
        self.write("cube.toml", BASE + MORE)

    def run_cube(self, *more):
        done = self.call("run", "cube.toml", "--output", "out", "--set", "time.tolerance=1e-7", "--set", "output.fields=false", *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def rows(self):
        with open(self.output / "sensitivity.csv", newline="") as file:
            return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]

    def summary(self):
        return json.loads((self.output / "summary.json").read_text())

    def expect_closed_form(self, row, keys, within):
        for key in keys:
            expected = derivative(lambda of: stress(row["time"], of), key)
            whole = VALUES[key] * expected  # with E the two effects cancel at t = 0.1
            self.assertAlmostEqual(VALUES[key] * row[f"d_stress__{key}"], whole, delta=within * max(abs(whole), 1), msg=(key, row["time"]))

    def test_a_relaxing_bar_against_the_closed_form(self):
        self.run_cube()
        rows = self.rows()
        self.assertEqual([row["time"] for row in rows], [0, 0.1, 0.2, 0.4])
        for row in rows:
            self.expect_closed_form(row, VALUES, 1e-6)
        found = self.summary()["sensitivity"]
        self.assertEqual(list(found), list(VALUES))
        for key in VALUES:
            self.assertEqual((found[key]["value"], found[key]["change"]), (VALUES[key], VALUES[key]))
            self.assertEqual(found[key]["probes"]["stress"], rows[-1][f"d_stress__{key}"])
            expected = derivative(time_of_level, key)
            self.assertAlmostEqual(found[key]["events"]["low"] / expected, 1, delta=1e-6)

    def test_the_report_tells_which_input_moves_most(self):
        self.run_cube()
        done = self.call("report", "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        page = (self.output / "report.html").read_text(encoding="utf-8")
        self.assertSays(page, "Which input moves the answer most", A, U)
        section = page[page.index('id="sensitivities"'):]
        section = section[:section.index("</section>")]
        row = re.search(r"stress.*?</tr>", section[section.rindex("most</th>"):], re.S)[0]
        cells = [re.sub("<[^>]*>", "", cell).strip() for cell in re.findall(r"<td.*?</td>", row, re.S)]
        n = 5 * derivative(lambda of: stress(0.4, of), N) / stress(0.4, VALUES)
        self.assertTrue(any(abs(float(cell) - n) < 1e-2 * abs(n) for cell in cells[:4] if cell != "-"), (cells, n))
        keys = sorted(VALUES)  # as the summary has them
        self.assertEqual(cells[-1], str(keys.index(N) + 1))

    def test_every_kind_of_integrator(self):
        for integrator in ("cvode_bdf", "cvode_adams", "arkode_erk", "arkode_dirk"):
            self.run_cube("--set", f"time.integrator={integrator}", "--set", "time.tolerance=1e-6")
            self.expect_closed_form(self.rows()[-1], VALUES, 1e-4)

    def test_the_results_are_those_without_derivatives(self):
        self.run_cube("--set", "time.tolerance=1e-4")
        with_them = self.summary()["probes"]["stress"]["end"]
        self.run_cube("--set", "time.tolerance=1e-4", "--set", "sensitivity.keys=[]")
        exact = stress(0.4, VALUES)
        self.assertLess(abs(with_them - exact), 1e-4 * 200)
        self.assertLess(abs(with_them - self.summary()["probes"]["stress"]["end"]), 1e-4 * 200)
        self.assertNotIn("sensitivity", self.summary())

    def test_a_resumed_run_goes_on_with_its_derivatives(self):
        self.run_cube("--set", "time.end=0.15", "--set", "time.output=[0.1]")
        self.run_cube("--resume", "--set", "time.output=[0.1]")
        rows = self.rows()
        self.assertEqual([row["time"] for row in rows], [0, 0.1, 0.15, 0.4])
        self.expect_closed_form(rows[-1], VALUES, 1e-6)
        self.assertAlmostEqual(self.summary()["sensitivity"][A]["events"]["low"] / derivative(time_of_level, A), 1, delta=1e-6)

    def test_another_integrator_goes_on_with_them_too(self):
        self.run_cube("--set", "time.end=0.15", "--set", "time.output=[0.1]")
        self.run_cube("--resume", "--set", "time.output=[0.1]", "--set", "time.integrator=cvode_bdf")
        self.expect_closed_form(self.rows()[-1], VALUES, 1e-4)

    def test_elastic_models_and_values_of_zero(self):
        self.run_cube("--set", "materials.steel.creep=[]", "--set", f'sensitivity.keys=["{E}", "supports[0].displacement.x"]',
                      "--set", "sensitivity.changes=[1e4, 0.01]", "--set", "events=[]")
        last = self.rows()[-1]
        self.assertAlmostEqual(last[f"d_stress__{E}"], 1e-3, delta=1e-9)
        self.assertAlmostEqual(last["d_stress__supports[0].displacement.x"], -2000, delta=2e-3)

    def test_loads_that_jump(self):
        force = ('[[loads]]\non = "x1"\ntraction = ["t < 0.1 ? 100 : 50", 0, 0]\n')
        self.write("cube.toml", BASE.replace('[[supports]]\non = "x1"\ndisplacement = { x = 0.1 }\n', force)
                   .replace('"stress_xx"', '"displacement_x"').replace('body = "cube"\n', 'at = [100, 100, 100]\n') +
                   f'[sensitivity]\nkeys = ["{A}", "{E}"]\n')
        self.run_cube()
        for row in self.rows():
            t = row["time"]
            creep = 100 * VALUES[A] * (100**5 * min(t, 0.1) + 50**5 * max(t - 0.1, 0))
            elastic = 100 * (100 if t < 0.1 else 50) / VALUES[E]
            self.assertAlmostEqual(row[f"d_stress__{A}"] * VALUES[A], creep, delta=1e-6 * 100 * VALUES[A] * 1e9)
            self.assertAlmostEqual(row[f"d_stress__{E}"] * VALUES[E], -elastic, delta=1e-7)

    def test_mistakes(self):
        for keys, facts in (
                (["materials.steel.creep[0].B"], ("sensitivity.keys[0]", f"did you mean '{A}'")),
                (["time.end"], ("'time.end'", "what describes the model")),
                (["mesh.order"], ("'mesh.order'", "what describes the model")),
                (["bodies.cube.material"], ("is \"steel\"", "a number")),
                (["supports[0].displacement.x"], ("is 0", "sensitivity.changes")),
                ([A, A], ("named twice",)),
                (["materials.steel.poisson_ratio", "nothing"], ("sensitivity.keys[1]", "'nothing'"))):
            done = self.call("check", "cube.toml", "--set", f"sensitivity.keys={json.dumps(keys)}")
            self.assertEqual(done.returncode, 2, keys)
            self.assertSays(done.stderr, *facts)
        done = self.call("run", "cube.toml", "--output", "out", "--set", "sensitivity.changes=[1]")
        self.assertEqual(done.returncode, 2)
        self.assertSays(done.stderr, "1 changes of 4 keys", "one for each key")
        done = self.call("run", "cube.toml", "--output", "out", "--set", "materials.steel.poisson_ratio=0.4999999",
                         "--set", 'sensitivity.keys=["materials.steel.poisson_ratio"]')
        self.assertEqual(done.returncode, 2)
        self.assertSays(done.stderr, "cannot be changed both up and down", "poisson_ratio")
        self.assertFalse(self.output.exists())


if __name__ == "__main__":
    unittest.main()
