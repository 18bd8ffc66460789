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
        done = self.call("run", "cube.toml", "--output", "out", "--set", "time.tolerance=4e-8", "--set", "output.fields=false", *more)
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

    def test_a_start_that_is_singular_on_one_side_alone_is_refused(self):
        self.write("cube.toml", (BASE + MORE).replace('law = "norton"', 'law = "time_hardening", m = 1'))
        done = self.call("run", "cube.toml", "--set", 'sensitivity.keys=["materials.steel.creep[0].m"]')
        self.assertEqual(done.returncode, 2, done.stderr)
        for fact in ("sensitivity.keys", "materials.steel.creep[0].m", "infinite rate", "another value"):
            self.assertIn(fact, done.stderr)

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
                (["mesh.order"], ("'mesh.order'", "what the mesh is made of", "[[axes]]")),
                (["mesh.parameters.h"], ("'mesh.parameters.h'", "what the mesh is made of")),
                (["supports[0].displacement.x.values[4]"], ("part of the value of 'supports[0].displacement.x'",)),
                (["bodies.cube.material"], ("is \"steel\"", "a number")),
                (["supports[0].displacement.x"], ("is 0", "sensitivity.changes")),
                ([A, A], ("named twice",)),
                ([A, A.replace("[0]", " . 00")], ("named twice",)),
                (["materials.steel.poisson_ratio", "nothing"], ("sensitivity.keys[1]", "'nothing'"))):
            done = self.call("check", "cube.toml", "--set", f"sensitivity.keys={json.dumps(keys)}")
            self.assertEqual(done.returncode, 2, keys)
            self.assertSays(done.stderr, *facts)
        done = self.call("check", "cube.toml", "--set", f"sensitivity.keys={json.dumps([A.replace('[0]', ' . 00')])}")
        self.assertEqual(done.returncode, 0, done.stderr)
        done = self.call("run", "cube.toml", "--output", "out", "--set", "sensitivity.changes=[1]")
        self.assertEqual(done.returncode, 2)
        self.assertSays(done.stderr, "1 changes of 4 keys", "one for each key")
        done = self.call("run", "cube.toml", "--output", "out", "--set", "materials.steel.poisson_ratio=0.4999999",
                         "--set", 'sensitivity.keys=["materials.steel.poisson_ratio"]')
        self.assertEqual(done.returncode, 2)
        self.assertSays(done.stderr, "cannot be changed both up and down", "poisson_ratio")
        self.assertFalse(self.output.exists())

    def test_times_at_which_something_jumps_have_no_derivatives(self):
        self.write("cube.toml", BASE + '[[supports]]\non = "x1"\ndisplacement = { y = 0 }\nfrom = 0.2\n[sensitivity]\nkeys = ["supports[4].from"]\n')
        done = self.call("run", "cube.toml", "--output", "out")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertSays(done.stderr, "supports[4].from", "t = 0.2", "change no times")


# Two cubes between ends that are held, pressed together by 1e6 N from t = 0.1 on. Rates of their stress q: q = (100^-4 + 4 A E (t - 0.1))^(-1/4).
TWO = """SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 100, 100, 100}; Box(2) = {100, 0, 0, 100, 100, 100};
Physical Volume("left") = {1}; Physical Volume("right") = {2};
Physical Surface("x0") = {1}; Physical Surface("y0") = {3, 9}; Physical Surface("z0") = {5, 11};
Physical Surface("from_left") = {2}; Physical Surface("from_right") = {7}; Physical Surface("x2") = {8};
Transfinite Curve{:} = 2; Transfinite Surface{:}; Recombine Surface{:}; Transfinite Volume{:};
"""
PRESSED = """[mesh]
file = "two.geo"
order = 1
[bodies.left]
region = "left"
material = "steel"
[bodies.right]
region = "right"
material = "other"
[materials.steel]
young_modulus = 200e3
poisson_ratio = 0.3
creep = [{ law = "norton", A = 3.125e-13, n = 5 }]
[materials.other]
young_modulus = 200e3
poisson_ratio = 0.3
creep = [{ law = "norton", A = 3.125e-13, n = 5 }]
[[supports]]
on = "x0"
displacement = { x = 0 }
[[supports]]
on = "x2"
displacement = { x = 0 }
[[supports]]
on = "y0"
displacement = { y = 0 }
[[supports]]
on = "z0"
displacement = { z = 0 }
[[contacts]]
name = "joint"
between = ["from_left", "from_right"]
preload = { force = 1e6, at = 0.1 }
[time]
end = 1
output = [0.1, 0.4]
tolerance = 1e-7
[[probes]]
name = "stress"
quantity = "von_mises"
body = "left"
[[probes]]
name = "force"
quantity = "contact_force_x"
on = "from_right"
[[probes]]
name = "length"
quantity = "displacement_x"
at = [100, 50, 50]
body = "left"
[sensitivity]
keys = ["materials.steel.creep[0].A", "materials.steel.creep[0].n", "materials.other.young_modulus", "contacts[0].preload.force"]
"""


class SensitivityOfContact(ProcessTest):
    KEYS = {"materials.steel.creep[0].A": 3.125e-13, "materials.steel.creep[0].n": 5, "materials.other.young_modulus": 200e3,
            "contacts[0].preload.force": 1e6}

    def setUp(self):
        super().setUp()
        self.write("two.geo", TWO)
        self.write("two.toml", PRESSED)

    def derivatives(self, *more):
        done = self.call("run", "two.toml", "--output", "out", "--set", "output.fields=false", *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.output / "sensitivity.csv", newline="") as file:
            return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]

    def test_a_preload_given_later(self):
        last = self.derivatives()[-1]
        self.assertEqual(last["time"], 1)
        t = 0.9

        def q(force, a, e):  # both cubes: q' = -(E1 E2/(E1 + E2)) (A1 + A2) q^5
            series = 200e3 * e / (200e3 + e)
            return ((force / 1e4)**-4 + 4 * series * (a + 3.125e-13) * t)**(-1 / 4)
        h = 1e-5
        for key, changed in (("contacts[0].preload.force", lambda f: q(1e6 * f, 3.125e-13, 200e3)),
                             ("materials.steel.creep[0].A", lambda f: q(1e6, 3.125e-13 * f, 200e3)),
                             ("materials.other.young_modulus", lambda f: q(1e6, 3.125e-13, 200e3 * f))):
            expected = (changed(1 + h) - changed(1 - h)) / (2 * h)
            self.assertAlmostEqual(last[f"d_stress__{key}"] * self.KEYS[key] / expected, 1, delta=1e-5, msg=key)
            self.assertAlmostEqual(last[f"d_force__{key}"] * self.KEYS[key] / (1e4 * expected), 1, delta=1e-5, msg=key)

    def expect_agreement(self):
        """Where equilibria are not linear, models with more and less of each value run next to it: here for a stress that nothing reaches."""
        linear = self.derivatives()
        beside = self.derivatives("--set", "materials.steel.plasticity.yield_stress=1e6")
        self.assertEqual([row["time"] for row in linear], [row["time"] for row in beside])
        sizes = {"stress": 100, "force": 1e6, "length": 0.1}
        changes = {key: one["change"] for key, one in json.loads((self.output / "summary.json").read_text())["sensitivity"].items()}
        for one, other in zip(linear, beside, strict=True):
            for probe, size in sizes.items():
                for key, change in changes.items():
                    found, expected = (change * row[f"d_{probe}__{key}"] for row in (one, other))
                    self.assertAlmostEqual(found, expected, delta=2e-6 * size, msg=(probe, key, one["time"]))
        return linear

    def test_models_next_to_the_run_agree(self):
        self.expect_agreement()

    def test_heat_and_loads_on_a_body_that_contact_holds(self):
        held = '[[supports]]\non = "x2"\ndisplacement = { x = 0 }\n'
        load = ('[temperature]\nvalue = "400 + 100*t + x"\n[[loads]]\non = "x2"\ntraction = ["-100*(1 + t)", 0, 0]\n'
                '[[loads]]\nbody = "right"\nbody_force = [-1e-3, 0, 0]\n')
        text = PRESSED.replace(held, load).replace("poisson_ratio = 0.3\n", "poisson_ratio = 0.3\nthermal_expansion = 1.2e-5\nreference_temperature = 20\n")
        text = text.replace("preload = { force = 1e6, at = 0.1 }", "gap = 0.02").replace("A = 3.125e-13, n = 5", "A = 3e-12, n = 5, activation_energy = 12e3, absolute_zero = -273")
        self.write("two.toml", text[:text.index("keys = ")] + """keys = ["loads[1].body_force[0]", "contacts[0].gap", "materials.steel.thermal_expansion",
  "materials.other.poisson_ratio", "supports[0].displacement.x", "materials.steel.reference_temperature"]
changes = [1e-3, 0.01, 1e-5, 0.3, 0.1, 100]
""")
        last = self.expect_agreement()[-1]
        self.assertAlmostEqual(last["d_force__loads[1].body_force[0]"], -1e6, delta=1)
        self.assertAlmostEqual(last["d_force__contacts[0].gap"], 0, delta=1e-2)
        self.assertAlmostEqual(last["d_length__supports[0].displacement.x"], 1, delta=1e-8)
        self.assertAlmostEqual(last["d_length__materials.steel.thermal_expansion"], 100 * (400 + 100 + 50 - 20), delta=1)

    def test_a_resumed_run_has_the_preloads_of_before(self):
        whole = self.derivatives()[-1]
        self.derivatives("--set", "time.end=0.5", "--set", "time.output=[0.1, 0.4]")
        resumed = self.derivatives("--resume", "--set", "time.output=[0.1, 0.4]")[-1]
        for name in whole:
            self.assertAlmostEqual(resumed[name] / whole[name], 1, delta=1e-5, msg=name)


if __name__ == "__main__":
    unittest.main()
