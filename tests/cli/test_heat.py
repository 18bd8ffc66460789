"""What check, run and report say of heat."""

import html
import json
import pathlib
import re
import shutil
import unittest

from process_case import ProcessTest
from test_signals import read_rows

ROOT = pathlib.Path(__file__).resolve().parents[2]


SLAB_GEO = """
Point(1) = {0, 0, 0};
l[] = Extrude{0, 0.01, 0}{Point{1}; Layers{1};};
s[] = Extrude{0, 0, 0.01}{Curve{l[1]}; Layers{1}; Recombine;};
v[] = Extrude{0.03, 0, 0}{Surface{s[1]}; Layers{8}; Recombine;};
Physical Volume("slab") = {v[1]}; Physical Surface("left") = {s[1]}; Physical Surface("right") = {v[0]};
Physical Surface("side") = {v[2]};
"""
# Time in hours.
SLAB = """[mesh]
file = "slab.geo"
order = 2
[bodies.slab]
region = "slab"
material = "m"
[materials.m]
conductivity = 40
heat_capacity = 500
density = 8000
[heat]
start = 50
time_unit = 3600
%s
[time]
end = 20
output = [10]
[output]
fields = false
[[probes]]
name = "left"
quantity = "temperature"
on = "left"
[[probes]]
name = "right"
quantity = "temperature"
on = "right"
[[probes]]
name = "side_flow"
quantity = "heat_flow"
on = "side"
"""


class HeatOfASlab(ProcessTest):
    def heat(self, flows, *more, program="heat"):
        self.write("slab.geo", SLAB_GEO)
        self.write("slab.toml", SLAB % flows)
        run = self.call(program, "slab.toml", "--output", "out", *more)
        if run.returncode != 0:
            return run, {}, {}
        rows = read_rows(self.directory / "out/history.csv")
        return run, {float(row["time"]): row for row in rows}, json.loads((self.directory / "out/summary.json").read_text())

    def test_a_smooth_pulse_is_seen(self):
        steady = (550 - 50) / (1 / 1000 + 0.03 / 40 + 1 / 200)  # the slab follows within a minute
        for film in ('coefficient = 1000, fluid = "50 + 500*exp(-(t - 10)^2)"',
                     'coefficient = "1000*exp(-(t - 10)^2)", fluid = 550'):
            _, rows, _ = self.heat('films = [{ on = "left", %s }, { on = "right", coefficient = 200, fluid = 50 }]' % film)
            self.assertAlmostEqual(float(rows[10]["left"]), 550 - steady / 1000, delta=1)
            self.assertAlmostEqual(float(rows[20]["left"]), 50, delta=0.1)

    def test_a_pulse_that_is_short_against_the_run_is_seen(self):
        pulse = "exp(-((t - 5000)/30)^2)"
        _, rows, _ = self.heat(f'films = [{{ on = "left", coefficient = 1000, fluid = "50 + 500*{pulse}" }}, '
                               '{ on = "right", coefficient = 200, fluid = 50 }]',
                               "--set", "time.end=1e4", "--set", "time.output=[5000]")
        self.assertAlmostEqual(float(rows[5000]["left"]), 475.926, delta=0.1)

    def test_where_nothing_holds_it_heat_accumulates(self):
        rise = 3600 * 1000 / (500 * 8000 * 0.03)
        _, rows, summary = self.heat('fluxes = [{ on = "left", value = 1000 }]', "--set", "time.end=1", "--set", "time.output=[]")
        # The profile of a constant flux is q L/k (1/3 at the heated side, -1/6 at the other).
        self.assertAlmostEqual(float(rows[1]["left"]), 50 + rise + 1000 * 0.03 / 40 / 3, delta=1e-3)
        self.assertAlmostEqual(float(rows[1]["right"]), 50 + rise - 1000 * 0.03 / 40 / 6, delta=1e-3)
        self.assertAlmostEqual(summary["heat"]["stored"], 1000 * 1e-4, delta=1e-8)
        _, rows, _ = self.heat('films = [{ on = "left", coefficient = 1000, fluid = 50 }]')
        self.assertAlmostEqual(float(rows[20]["left"]), 50, delta=1e-6)

    def test_flows_of_one_surface_have_their_own_names(self):
        _, _, summary = self.heat('films = [{ on = "left", coefficient = 1000, fluid = 60 }, '
                                  '{ on = "left", coefficient = 100, fluid = 20 }]')
        flows = summary["heat"]["flows"]
        self.assertEqual(len(flows), 2)
        self.assertAlmostEqual(sum(flows.values()), 0, delta=1e-6 * max(flows.values()))

    def test_a_surface_beside_a_given_temperature_has_only_its_own_flow(self):
        _, rows, summary = self.heat('films = [{ on = "side", coefficient = 50, fluid = 20 }]\n'
                                     'temperatures = [{ on = "left", value = 100 }]')
        (film,) = (flow for name, flow in summary["heat"]["flows"].items() if "film" in name)
        self.assertAlmostEqual(float(rows[20]["side_flow"]), -film, delta=1e-9)

    def test_impossible_values_are_named(self):
        for flows, *facts in (
            ('films = [{ on = "left", coefficient = "0 - 5 + 0*T", fluid = 20 }]', "film on 'left' of body 'slab'", "-5"),
            ('films = [{ on = "left", coefficient = "(t - 1)^0.5", fluid = 20 }]', "film on 'left'", "nan", "t = 0"),
            ('stefan_boltzmann = 5.67e-8\nabsolute_zero = -273.15\n'
             'radiation = [{ on = "left", emissivity = 0.8, ambient = -300 }]', "-300", "absolute_zero"),
            ('stefan_boltzmann = 5.67e-8\nabsolute_zero = -273.15\n'
             'radiation = [{ on = "left", emissivity = "2 + 0*T", ambient = 20 }]', "radiation on 'left'", "emissivities"),
        ):
            run, _, _ = self.heat(flows)
            self.assertNotEqual(run.returncode, 0)
            self.assertSays(run.stderr, *facts)
        run, _, _ = self.heat('temperatures = [{ on = "left", value = 300 }, { on = "left", value = 100 }]')
        self.assertSays(run.stderr, "warning", "300", "100", "the last one counts")

    def test_a_wrong_value_of_a_required_key_is_one_error(self):
        for key, value in (("materials.m.conductivity", '"4*"'), ("materials.m.heat_capacity", "-1"),
                           ("materials.m.density", '"a"'), ("heat.time_unit", "0")):
            run, _, _ = self.heat('films = [{ on = "left", coefficient = 1000, fluid = 60 }]', "--set", f"{key}={value}")
            self.assertEqual(run.returncode, 2)
            self.assertEqual(run.stderr.count("error:"), 1, run.stderr)
            self.assertSays(run.stderr, key)

    def test_jumps_that_elements_do_not_follow_are_told(self):
        for flows, *facts in (
            ('temperatures = [{ on = "left", value = 100 }]', "given temperature of 'left'", "jumps by 50", "undershoot"),
            ('films = [{ on = "left", coefficient = { t = [0, 10, 10, 20], values = [0, 0, 9e4, 9e4] }, fluid = 60 }]',
             "film on 'left'", "element Biot number 8.4", "jumps by 10", "coefficient"),
        ):
            run, _, _ = self.heat(flows)
            self.assertSays(run.stderr, *facts)
        run, _, _ = self.heat('temperatures = [{ on = "left", value = { t = [0, 5], values = [50, 100] } }]')
        self.assertNotIn("warning", run.stderr)

    def test_units_that_no_solid_has_are_told(self):
        film = 'films = [{ on = "left", coefficient = 1000, fluid = 60 }]'
        units = 'units="m, N, Pa, h, degC"'
        run, _, _ = self.heat(film, "--set", units)
        self.assertNotIn("diffusivity of body", run.stderr)
        for wrong in ("heat.time_unit=1", 'units="mm, N, MPa, h, degC"', "materials.m.density=8e-6"):
            run, _, _ = self.heat(film, "--set", units, "--set", wrong)
            self.assertSays(run.stderr, "the diffusivity of body 'slab'", "m^2/s", "heat.time_unit")

    def test_days_that_are_alike_are_not_all_integrated(self):
        times = ("--set", "time.end=2000", "--set", "time.output=[486, 990, 1999]")
        course = "{ t = [0, 2, 8, 10], values = [50, 550, 550, 50], period = 24 }"
        day = f'films = [{{ on = "left", coefficient = 5, fluid = {course} }}]'
        run, rows, _ = self.heat(day, *times)
        self.assertSays(run.stdout + run.stderr, "they repeat every 24")
        # That the last day differs does not change those before it.
        other = day.replace("= 5,", '= "t > 1990 ? 6 : 5",')
        run, expected, _ = self.heat(other, *times)
        self.assertNotIn("they repeat", run.stdout + run.stderr)
        for t in (486, 990):
            for side in ("left", "right"):
                self.assertAlmostEqual(float(rows[t][side]), float(expected[t][side]), delta=0.1)
        self.assertGreater(abs(float(rows[1999]["left"]) - float(expected[1999]["left"])), 1)

    def test_what_concerns_creep_alone_does_not_concern_heat(self):
        films = 'films = [{ on = "left", coefficient = 1000, fluid = 60 }]'
        run, _, _ = self.heat(films, "--set", "time.cycle=5")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.write("slab.toml", SLAB.replace("order = 2", "order = 1") % films)
        self.write("slab.geo", SLAB_GEO.replace("Recombine;", ""))
        creeping = [f"materials.m.{key}" for key in ("young_modulus=2e5", "poisson_ratio=0.3",
                                                      'creep=[{ law = "norton", A = 1e-20, n = 5 }]')]
        run = self.call("heat", "slab.toml", "--output", "out2", *(word for one in creeping for word in ("--set", one)))
        self.assertEqual(run.returncode, 0, run.stderr)


class Heat(ProcessTest):
    def copied(self, *files):
        for file in files:
            shutil.copy(ROOT / file, self.directory)

    def test_a_joint_that_loses_its_pressure_at_the_speed_of_heat(self):
        self.copied("configs/shrink_fit_heat.toml", "configs/shrink_fit_heat.geo")
        check = self.call("check", "shrink_fit_heat.toml", "--start")
        self.assertSays(check.stdout, "film on 'rim'", "coefficient up to 5", "element Biot number 1.4", "see --start")
        run = self.call("run", "shrink_fit_heat.toml", "--output", "out")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertSays(run.stderr, "contact 'fit' loses the last", "at the speed of heat")
        self.assertSays(run.stdout, "balance: ", "contact 'fit' lost its pressure at the speed of heat")
        heat = json.loads((self.directory / "out/summary.json").read_text())["heat"]
        (loss,) = heat["sudden_losses"]
        self.assertEqual(loss["contact"], "fit")
        self.assertAlmostEqual(loss["time"], 22950, delta=20)
        self.assertLess(loss["time"] - loss["since"], 3)
        self.assertLess(abs(heat["rest"]), 1e-6 * max(map(abs, heat["flows"].values())))
        report = self.call("report", "out", "--output", "page.html")
        self.assertEqual(report.returncode, 0, report.stderr)
        page = html.unescape((self.directory / "page.html").read_text())
        for text in ("at the speed of heat", "comes back through pressure and conductance", "Heat that flows at the end",
                     "missing in the sum", "element Biot number", "What heats and cools", "film, coefficient 5",
                     "3*(p/50)^0.95", "How long a change of temperature takes"):
            self.assertIn(text, page)

    def test_a_cold_joint_without_stress_starts(self):
        self.copied("configs/shrink_fit_heat.toml", "configs/shrink_fit_heat.geo")
        run = self.call("run", "shrink_fit_heat.toml", "--output", "out", "--set", "contacts[0].gap=0", "--set", "time.end=100",
                        "--set", "time.output=[]")
        self.assertEqual(run.returncode, 0, run.stderr)

    def test_a_pulse_is_seen_where_the_temperature_is_part_of_the_state(self):
        self.copied("configs/shrink_fit_heat.toml", "configs/shrink_fit_heat.geo")
        fluid = '"min(20 + 107.5*t, 450) - 300*exp(-((t - 5000)/30)^2)"'
        rows = {}
        for tolerance in ("1e-3", "1e-5"):
            run = self.call("run", "shrink_fit_heat.toml", "--output", tolerance, "--set", f"heat.films[0].fluid={fluid}", "--set",
                            "time.end=1e4", "--set", "time.output=[5000]", "--set", f"time.tolerance={tolerance}")
            self.assertEqual(run.returncode, 0, run.stderr)
            rows[tolerance] = read_rows(self.directory / tolerance / "history.csv")[1]
        self.assertLess(rows["1e-5"]["inner_temperature"], 300)
        self.assertAlmostEqual(rows["1e-3"]["inner_temperature"], rows["1e-5"]["inner_temperature"], delta=0.5)

    def test_a_run_goes_on_with_another_tolerance_of_the_heat(self):
        self.copied("docs/tutorial_heat/hot_fit.toml", "docs/tutorial_heat/hot_fit.geo")
        first = self.call("run", "hot_fit.toml", "--output", "out", "--set", "time.end=10", "--set", "time.output=[]")
        self.assertEqual(first.returncode, 0, first.stderr)
        again = self.call("run", "hot_fit.toml", "--output", "out", "--resume", "--set", "time.end=20", "--set", "time.output=[]",
                          "--set", "heat.tolerance=3e-5")
        self.assertEqual(again.returncode, 0, again.stderr)

    def test_a_negative_conductance_is_named(self):
        self.copied("docs/tutorial_heat/hot_fit.toml", "docs/tutorial_heat/hot_fit.geo")
        run = self.call("heat", "hot_fit.toml", "--set", 'contacts[0].conductance="1 - t/1000"', "--output", "out")
        self.assertNotEqual(run.returncode, 0)
        self.assertSays(run.stderr, "contact 'fit'", "the conductance is -", "not negative")

    def test_check_has_the_steady_state_of_the_end(self):
        self.copied("docs/tutorial_heat/hot_fit.toml", "docs/tutorial_heat/hot_fit.geo")
        text = self.call("check", "hot_fit.toml").stdout
        self.assertSays(text, "steady state with what acts at t = 100000", "446.", "532.", "balance: ")
        # 140 K over the resistances of the rings, their surfaces and the fit
        flow = float(re.search(r"film on 'rim' of body 'ring' +([-0-9.]+)", text)[1])
        self.assertAlmostEqual(flow / 701124, 1, delta=1e-4)

    def test_where_nothing_flows_no_rounding_is_reported(self):
        self.copied("docs/tutorial_heat/hot_fit.toml", "docs/tutorial_heat/hot_fit.geo")
        run = self.call("heat", "hot_fit.toml", "--set", 'heat.start="steady"', "--set", "time.end=0", "--output", "out")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertNotIn("balance: ", run.stdout)
        heat = json.loads((self.directory / "out/summary.json").read_text())["heat"]
        self.assertEqual(set(heat["flows"].values()), {0})
        self.assertEqual(heat["rest"], 0)

    def test_other_data_than_those_kept_are_named(self):
        self.copied("docs/tutorial_heat/hot_fit.toml", "docs/tutorial_heat/hot_fit.geo")
        keep = ["heat", "hot_fit.toml", "--set", 'heat.keep="kept"', "--set", "time.end=1", "--set", "time.output=[]", "--output"]
        self.call(*keep, "one")
        again = self.call(*keep, "two", "--set", "heat.films[1].coefficient=3")
        self.assertSays(again.stdout + again.stderr, "coefficient of the film on 'rim' of body 'ring'", "was 2", "is now 3")


if __name__ == "__main__":
    unittest.main()
