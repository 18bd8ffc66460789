"""The larger examples on coarse meshes: every force that a hand can work out is there, at every time."""

import csv
import math
import pathlib
import subprocess
import unittest

from test_runs import PROGRAM, RunTest
from waiting import LONGEST

CONFIGS = pathlib.Path(__file__).resolve().parents[2] / "configs"
SHORT = {"time.end": "100", "time.output": "[1, 10]", "output.fields": "false"}


class ExampleTest(RunTest):
    def history(self, name, changes=None, **parameters):
        settings = SHORT | (changes or {}) | {f"mesh.parameters.{key}": str(value) for key, value in parameters.items()}
        options = [part for key, value in settings.items() for part in ("--set", f"{key}={value}")]
        done = subprocess.run([PROGRAM, "run", str(CONFIGS / name), "--output", str(self.output), *options],
                              cwd=self.directory, capture_output=True, text=True, timeout=LONGEST)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = self.table("history.csv")
        if not changes:
            self.assertEqual([row["time"] for row in rows], [0, 1, 10, 100])
        return rows

    def expect_close(self, value, reference, relative):
        self.assertAlmostEqual(value, reference, delta=relative * abs(reference))


class EveryExample(RunTest):
    """To its end with the settings that the file leaves alone, on a coarse mesh where that saves seconds."""

    COARSE = {"bolted_flange": dict(n_around=2, n_hole=2, n_face=2, n_seat=2, n_bearing=1, n_thickness=2, n_shank=2),
              "casing_flange": dict(n_side=2, n_middle=2, n_seat=2, n_bearing=2, n_wall=2, n_height=3, n_ring=4, n_shank=2,
                                    n_nut=1, n_heel=2, n_land=1),
              "gasketed_flange": dict(n_around=2, n_wall=1, n_gasket=2, n_hole=2, n_seat=2, n_bearing=1, n_thickness=2, n_shank=2),
              "blade_root": dict(n_blade=2, n_disc=2, n_blade_flank=3, n_disc_flank=2, n_width=1),
              "bladed_disc": dict(size=24, n_width=2, n_shroud=2), "ball_on_block": dict(h=0.8),
              "press_fit_torque": dict(around_shaft=12, around_hub=8, n_length=2, n_hub=2),
              "shrink_fit_cycles": dict(n_shaft=2, n_hub=3), "shrink_fit_section": dict(h=30, h_fit=12),
              "steam_pipe": dict(n_wall=4, n_length=4), "viscoelastic_indenter": dict(n_block=18, n_depth=10),
              "valve_seat_cycles": dict(size=3), "valve_startup": dict(size=16)}
    UNTIL_RUPTURE = ("omega_pipe",)
    COARSE_CAD = {"valve_from_step": ("mesh.size=30", "mesh.sizes=[]")}

    def test_ends_with_the_default_integrator_at_any_tolerance(self):
        for config in sorted(CONFIGS.glob("*.toml")):
            for tolerance in ("1e-2", "1e-4"):
                with self.subTest(config.stem, tolerance=tolerance):
                    options = [f"time.tolerance={tolerance}", "output.fields=false"]
                    options += [f"mesh.parameters.{key}={value}" for key, value in self.COARSE.get(config.stem, {}).items()]
                    options += self.COARSE_CAD.get(config.stem, ())
                    done = subprocess.run([PROGRAM, "run", str(config), "--output", str(self.output)] +
                                          [part for option in options for part in ("--set", option)],
                                          cwd=self.directory, capture_output=True, text=True, timeout=LONGEST)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertNotIn("warning: time integration ", done.stderr)  # nothing failed
                    summary = self.summary()
                    status = "ruptured" if config.stem in self.UNTIL_RUPTURE else "completed"
                    self.assertEqual((summary["status"], summary["integrator"]), (status, "auto"))
                    self.assertLessEqual(summary["convergence_failures"], summary["steps"] / 10)


class ValveFromStep(ExampleTest):
    def test_forces_balance(self):
        done = subprocess.run([PROGRAM, "run", CONFIGS / "valve_from_step.toml", "--output", self.output, "--quiet"],
                              cwd=self.directory, capture_output=True, text=True, timeout=LONGEST)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.output / "history.csv", newline="") as file:
            rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
        for row in rows:
            self.expect_close(row["stud_force"] - row["joint_force"], 10 * math.pi * 39.8**2 / 4, 1e-3)
        self.expect_close(rows[0]["stud_force"], 1e5, 1e-9)
        self.expect_close(rows[-1]["stud_force"], 33200, 0.02)


class BoltedFlange(ExampleTest):
    def test_forces_balance(self):
        rows = self.history("bolted_flange.toml", n_around=2, n_hole=2, n_face=2, n_seat=2, n_bearing=1, n_thickness=2,
                            n_shank=2)
        thrust = 4 * math.pi * 100**2 / 24  # of the pressure on the closed end of half a sector
        for row in rows:
            self.expect_close(row["nut_force"], -row["head_force"], 1e-9)
            self.expect_close(row["head_force"] - row["joint_force"], thrust, 1e-6)
            self.expect_close(row["shank_force"], row["head_force"], 1e-9)
            self.expect_close(row["clamping"], 24 * row["shank_force"], 1e-12)
        forces = [row["head_force"] for row in rows]
        self.assertEqual(forces, sorted(forces, reverse=True))
        self.assertGreater(forces[-1], 1e4)


class GasketedFlange(ExampleTest):
    COARSE = EveryExample.COARSE["gasketed_flange"]
    NO_CREEP = {"materials.flange_steel.creep": "[]", "materials.bolt_steel.creep": "[]", "time.end": "8", "time.output": "[]",
                "gaskets.spiral_wound.relaxation": "{ factor = 1, pressure = 80, stiffness = 1e6, area = 4762, time = 4 }"}
    AREA = math.pi * (131**2 - 117**2) / 24
    THRUST = 3 * math.pi * 117**2 / 24  # of half a sector

    def test_forces_balance(self):
        rows = self.history("gasketed_flange.toml", {"time.output": "[4, 8, 12]"}, **self.COARSE)
        self.expect_close(rows[0]["bolt_force"], 35e3, 1e-8)
        for row in rows:
            self.expect_close(row["bolt_force"] - min(1, row["time"] / 8) * self.THRUST, row["gasket_force"], 1e-3)
            self.expect_close(row["gasket_mean"], row["gasket_force"] / self.AREA, 1e-3)
            self.expect_close(row["gasket_pressure"], row["gasket_mean"], 1e-2)
        forces = [row["gasket_force"] for row in rows]
        self.assertEqual(forces, sorted(forces, reverse=True))

    def test_springs_in_series(self):
        by_pressure = self.history("gasketed_flange.toml", self.NO_CREEP | {"temperature.value": "20"}, **self.COARSE)
        self.expect_close(by_pressure[0]["closure"], 0.86005, 1e-4)
        self.expect_close(by_pressure[-1]["gasket_force"], 29.28e3, 1e-2)
        by_heat = self.history("gasketed_flange.toml", self.NO_CREEP | {"loads": "[]"}, **self.COARSE)
        self.expect_close(by_heat[-1]["gasket_force"], 30.54e3, 1e-2)


class CasingFlange(ExampleTest):
    COARSE = EveryExample.COARSE["casing_flange"]

    def test_forces_balance(self):
        rows = self.history("casing_flange.toml", {"time.output": "[4, 8, 16, 30]"}, **self.COARSE)
        for row in rows:
            steam = 4 * min(1, row["time"] / 8) * 300 * 70
            self.expect_close(row["nut_force"], row["bolt_force"], 1e-8)
            self.assertAlmostEqual(row["bolt_force"] - row["seal_force"] - row["heel_force"], steam, delta=1e-3)
            self.expect_close(row["seal_pressure"], row["seal_force"] / self.seal_area(), 1e-6)
            self.expect_close(row["seal_at_bolt"] + row["seal_between_bolts"], 2 * row["seal_pressure"], 0.02)
        self.expect_close(rows[0]["bolt_force"], 4e5, 1e-8)
        self.assertGreater(rows[1]["bolt_force"], 1.2 * rows[0]["bolt_force"])  # the bolt lags behind
        self.assertLess(rows[-1]["bolt_force"], rows[3]["bolt_force"])          # and creeps

    def test_hot_forces_follow_the_modulus(self):
        changes = {"loads": "[]", "temperature.value": '"20 + 480*min(1, t/8)"', "time.end": "16", "time.output": "[8]",
                   "materials.casing_steel.creep": "[]", "materials.bolt_steel.creep": "[]"}
        cold, warm, late = self.history("casing_flange.toml", changes, **self.COARSE)
        for name in ("bolt_force", "seal_force", "heel_force"):
            self.expect_close(warm[name], cold[name] * 1.75 / 2.11, 1e-3)
            self.expect_close(late[name], warm[name], 1e-6)

    def test_leak_is_an_event(self):
        self.history("casing_flange.toml", {"time.end": "2e4", "time.output": "[]", "time.tolerance": "1e-3"}, **self.COARSE)
        self.expect_close(self.summary()["events"]["leak"], 10.7e3, 0.1)

    @staticmethod
    def seal_area():
        return (math.sqrt((300 + 60 + 25)**2 - (160 + 25 - 4)**2) - 300) * 70


class BoltInputs(ExampleTest):
    """Derivatives of a bolt that relaxes by Norton's law, and of the time at which half of its force is lost."""

    PRELOAD, A, N = "contacts[0].preload.force", "materials.bolt_steel.creep[0].A", "materials.bolt_steel.creep[0].n"
    BOLT, SLEEVE = "materials.bolt_steel.young_modulus", "materials.sleeve_steel.young_modulus"
    VALUES = {PRELOAD: 39e3, A: 9.1e-26, N: 8, BOLT: 175e3, SLEEVE: 175e3}

    def test_derivatives_are_those_by_hand(self):
        history = self.history("bolt_inputs.toml", {"time.end": "1e5", "time.output": "[1, 100, 1000, 1e4]"})
        derivatives = self.table("sensitivity.csv")
        self.assertEqual([row["time"] for row in derivatives], [row["time"] for row in history])
        relative = [{key: row[f"d_bolt_force__{key}"] * value / of["bolt_force"] for key, value in self.VALUES.items()}
                    for row, of in zip(derivatives, history)]
        self.expect_close(relative[0][self.PRELOAD], 1, 1e-9)
        for found in relative[1:]:  # the force depends on A*E*t
            self.expect_close(found[self.BOLT] + found[self.SLEEVE], found[self.A], 2e-3)
        last, force = relative[-1], history[-1]["bolt_force"]
        stress, first = force / (math.pi * 7.05**2), 39e3 / (math.pi * 7.05**2)
        kept = (stress / first)**7
        self.expect_close(force, 16.2e3, 0.01)
        self.assertLess(last[self.PRELOAD], 2 * kept)
        self.expect_close(last[self.A], -(1 - kept) / 7, 5e-3)
        self.expect_close(last[self.N] / 8, -(math.log(stress) + (1 - kept) / 7 - kept * math.log(first)) / 7, 5e-3)

    def test_the_time_of_the_event_is_inverse_to_the_rate(self):
        self.history("bolt_inputs.toml", {"time.end": "1e5", "time.output": "[]"})
        summary = self.summary()
        time = summary["events"]["half_of_the_force"]
        found = {key: summary["sensitivity"][key]["events"]["half_of_the_force"] * value / time
                 for key, value in self.VALUES.items()}
        self.expect_close(found[self.A], -1, 1e-3)
        self.expect_close(found[self.BOLT] + found[self.SLEEVE], -1, 1e-3)
        kept = 0.5**7
        self.assertTrue(7 * kept < found[self.PRELOAD] < 14 * kept / (1 - kept), found[self.PRELOAD])


class ScatterStudies(RunTest):
    """studies/bolt_scatter and studies/fit_tolerances with few samples on coarse meshes."""

    def quantiles(self, name, samples, **parameters):
        text = (CONFIGS.parent / "studies" / name / "study.toml").read_text(encoding="utf-8")
        coarse = "".join(f"mesh.parameters.{key} = {value}\n" for key, value in parameters.items())
        for old, new in (('"../../configs/', f'"{CONFIGS}/'), ("samples = 64", f"samples = {samples}"),
                         ("[set]\n", "[set]\n" + coarse)):
            self.assertIn(old, text)
            text = text.replace(old, new)
        study = self.directory / f"{name}.toml"
        study.write_text(text, encoding="utf-8")
        done = subprocess.run([PROGRAM, "study", str(study), "--output", str(self.output)], cwd=self.directory, capture_output=True,
                              text=True, timeout=LONGEST)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"{samples} of {samples} runs succeeded", done.stdout)
        with open(self.output / "quantiles.csv", newline="") as file:
            rows = [{key: float(value) for key, value in row.items() if value} for row in csv.DictReader(file)]
        return rows[0], rows[-1]

    def shares(self, result):
        with open(self.output / "sobol_indices.csv", newline="") as file:
            return next(row for row in csv.DictReader(file) if row["result"] == result)

    def test_the_steel_of_the_bolts_decides(self):
        first, last = self.quantiles("bolt_scatter", 16, **EveryExample.COARSE["bolted_flange"])
        self.assertGreater(first["head_force_q50"], 2 * last["head_force_q50"])
        for row in (first, last):
            quantiles = [row[f"head_force_q{percent}"] for percent in ("05", "50", "95")]
            self.assertEqual(quantiles, sorted(quantiles))
        self.assertGreater(float(self.shares("head_force_end")["materials.bolt_steel.creep[0].A"]), 0.7)

    def test_tolerances_are_forgotten(self):
        first, last = self.quantiles("fit_tolerances", 8, **EveryExample.COARSE["shrink_fit_section"])
        widths = [row["fit_pressure_q95"] - row["fit_pressure_q05"] for row in (first, last)]
        self.assertLess(widths[1], 0.5 * widths[0])


class PressFitTorque(ExampleTest):
    COARSE = dict(around_shaft=12, around_hub=12, n_length=2, n_hub=2)

    def test_torque_is_that_of_the_load(self):
        rows = self.history("press_fit_torque.toml", **self.COARSE)
        self.assertAlmostEqual(rows[0]["torque"], 0, delta=1)
        for row in rows[1:]:
            self.expect_close(row["torque"], 2.5e6, 2e-3)
            self.assertLess(row["torque"], 0.15 * row["pressure"] * 2 * math.pi * 50**2 * 40)
            self.assertLessEqual(row["shear_max"], 0.15 * 1.5 * row["pressure"])

    def test_slides_off_above_the_limit(self):
        options = ["contacts[0].friction=0.05", "output.fields=false"]
        options += [f"mesh.parameters.{key}={value}" for key, value in self.COARSE.items()]
        done = subprocess.run([PROGRAM, "run", str(CONFIGS / "press_fit_torque.toml"), "--output", str(self.output)] +
                              [part for option in options for part in ("--set", option)],
                              cwd=self.directory, capture_output=True, text=True, timeout=LONGEST)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertSays(done.stderr, "body 'hub'", "rotation", "(0, 0, 1)", "t = ", "friction")
        limit = 0.05 * self.table("history.csv")[0]["pressure"] * 2 * math.pi * 50**2 * 40
        self.expect_close(self.summary()["time_reached"], limit / 2.5e6, 2e-2)  # the torque grows as min(t, 1)


class BladeRoot(ExampleTest):
    def test_flanks_carry_the_blade(self):
        rows = self.history("blade_root.toml", n_blade=2, n_disc=2, n_blade_flank=3, n_disc_flank=2, n_width=1)
        for row in rows:
            self.expect_close(row["force_1"] + row["force_2"], self.pull(), 1e-6)
            self.assertGreater(min(row["force_1"], row["force_2"]), 1e3)

    def test_friction_carries_a_part_of_the_load(self):
        friction = {f"contacts[{i}].friction": "0.15" for i in (0, 1)}
        rows = self.history("blade_root.toml", friction, n_blade=2, n_disc=2, n_blade_flank=3, n_disc_flank=2, n_width=1)
        for row in rows:
            self.expect_close(row["force_1"] + row["force_2"], self.pull(), 1e-6)
            self.expect_close(row["pressure_1"], row["force_1"] / (3.5 * 15 * 1.15), 2e-2)  # all of the flank slips
        self.assertGreater(self.summary()["contacts"]["flank_1"]["dissipated_energy"], 0)

    def test_section_carries_the_same(self):
        rows = self.history("blade_root_section.toml", n_blade=2, n_disc=2, n_blade_flank=3, n_disc_flank=2)
        for row in rows:
            self.expect_close(row["force_1"] + row["force_2"], self.pull(), 1e-6)
            self.expect_close(row["pressure_1"], row["force_1"] / (3.5 * 15), 1e-3)
            self.assertLess(row["axial_strain"], 0)

    def test_section_is_close_to_the_solid(self):
        sizes = dict(n_blade=2, n_disc=2, n_blade_flank=3, n_disc_flank=2)
        solid = self.history("blade_root.toml", n_width=1, **sizes)[0]
        section = self.history("blade_root_section.toml", **sizes)[0]
        for probe, relative in (("force_1", 0.01), ("groove_mises", 0.02), ("neck_mises", 0.08), ("root_displacement", 0.04)):
            self.expect_close(section[probe], solid[probe], relative)

    @staticmethod
    def pull():
        """Traction on the top of the root and centrifugal force of the root: quarter of a root, parameters of the .geo."""
        fillet, clearance, width, top = 1.5, 0.3, 15, 305
        k = fillet / math.sqrt(2)
        upper = 275 + 3.5 + 4 * k - clearance + 6
        half_width = [5, 8, 8, 4.5, 4.5, 10.5, 10.5, 7, 7 + k - fillet, 7 + k - fillet]
        radius = [275 - 2 * k + clearance - 3, 275 - 2 * k + clearance, 275, 278.5, 278.5 + 2 * k,
                  upper - 2 * k + clearance, upper, upper + 3.5, upper + 3.5 + k, top]
        moment = 0  # integral of the radius over the profile: trapezia, less the segments that the fillets cut off
        for (x0, y0), (x1, y1) in zip(zip(half_width, radius), zip(half_width[1:], radius[1:])):
            moment += (y1 - y0) / 6 * (x0 * y0 + (x0 + x1) * (y0 + y1) + x1 * y1)
        for angle, centre in ((math.pi / 2, 278.5 + k), (math.pi / 4, upper + 3.5 + k)):
            segment = fillet**2 / 2 * (angle - math.sin(angle))
            distance = 4 * fillet * math.sin(angle / 2)**3 / (3 * (angle - math.sin(angle)))
            towards = math.pi if angle == math.pi / 2 else 9 / 8 * math.pi
            moment -= segment * (centre + distance * math.sin(towards))
        return 110 * half_width[-1] * width + 8.2e-9 * 523.6**2 * width * moment


class BladedDisc(ExampleTest):
    """One sector: what it exerts on the next one cancels in every sum."""
    COARSE = dict(size=16, n_width=4)

    def test_key_carries_the_torque_of_the_gas(self):
        for row in self.history("bladed_disc.toml", **self.COARSE):
            self.expect_close(row["key_force"], 0.3 * 30 * (265.92266**2 - 203.89914**2) / 2 / 80, 1e-4)

    def test_shrouds_push_each_other_outwards(self):
        tight = self.history("bladed_disc.toml", **self.COARSE)
        apart = self.history("bladed_disc.toml", {"contacts[0].gap": "1"}, **self.COARSE)
        for row, without in zip(tight, apart):
            self.assertEqual(without["shroud_force"], 0)
            pushed = row["blade_force"] - without["blade_force"]
            self.expect_close(pushed, 2 * row["shroud_force"] * math.sin(math.radians(5)), 0.01)  # and friction


class ShrinkFitSection(ExampleTest):
    PLAIN = dict(web=70, groove=0, shaft=70)
    RINGS = ({"time.end": "12", "time.output": "[]", "time.breakpoints": "[]"} |
             {"probes": '[{ name = "p", quantity = "contact_pressure", on = "disc_bore" }, '
                        '{ name = "force", quantity = "contact_force_x", on = "disc_bore" }, '
                        '{ name = "stress", quantity = "hydrostatic", body = "disc", reduce = "sum" }]'})

    @staticmethod
    def lame(rim):
        return 2.11e5 * 0.1 / (2 * 100) * (1 - (100 / rim)**2)

    def test_plain_disc_has_the_pressure_of_lame(self):
        cold, warm = self.history("shrink_fit_section.toml", self.RINGS, **self.PLAIN)
        self.expect_close(cold["p"], self.lame(300), 1e-4)
        self.expect_close(warm["p"], self.lame(300) * 1.765 / 2.11, 1e-3)

    def test_hub(self):
        cold, warm = self.history("shrink_fit_section.toml", self.RINGS)
        self.assertTrue(self.lame(165) < cold["p"] < self.lame(300), cold["p"])
        self.expect_close(warm["p"], cold["p"] * 1.765 / 2.11, 1e-3)
        for row in (cold, warm):
            self.expect_close(row["force"], 2 * math.pi * 100 * 70 * row["p"], 1e-6)
            self.expect_close(3 * row["stress"], 100 * row["force"], 1e-3)  # the virial of the contact forces

    def test_opens_at_the_second_start_up(self):
        rows = self.history("shrink_fit_section.toml", {"time.end": "200012", "time.output": "[8, 12, 199990, 200008]",
                                                        "time.tolerance": "1e-3"})
        whole = 2 * math.pi * 100 * 70
        for row, closed in zip(rows, (1, 1, 1, 1, 0.25, 1)):
            self.assertAlmostEqual(row["contact_area"] / whole, closed, delta=0.02)
        self.assertGreater(rows[4]["largest_gap"], 1e-3)
        self.expect_close(rows[3]["fit_pressure"], 36.6, 5e-3)


if __name__ == "__main__":
    unittest.main()
