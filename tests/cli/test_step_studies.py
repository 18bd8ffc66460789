"""What studies/step_size and studies/residual_correction claim, on their fast versions."""

import sys
import unittest

from studies import STUDIES, numbers, order, run_study, select

sys.path.insert(0, str(STUDIES / "step_size"))
import cost  # noqa: E402

BETAS = ("0.5", "0.75", "1.0")


class StepSizeStudy(unittest.TestCase):
    """Two rings in contact."""

    @classmethod
    def setUpClass(cls):
        cls.rows = run_study("step_size/fast.toml")

    def schemes(self):
        """(order, rows from the longer step to the shorter) of each scheme."""
        yield 1, select(self.rows, time__integrator="explicit_euler")
        for inner in ("", "newton"):
            for beta in BETAS:
                yield 2 if beta == "0.5" else 1, select(self.rows, time__beta=beta, time__inner=inner)

    def controlled(self, integrator):
        row, = select(self.rows, time__integrator=integrator, time__tolerance="0.001")
        return row

    def test_every_run_ends(self):
        self.assertEqual({row["status"] for row in self.rows}, {"completed"})

    def test_orders(self):
        for expected, (loose, tight) in self.schemes():
            found = order(loose, tight, "time.step_factor", "error_fit_pressure")
            self.assertAlmostEqual(found, expected, delta=0.2, msg=str(loose))

    def test_newton_and_fixed_point_agree(self):
        for beta in BETAS:
            for newton, plain in zip(select(self.rows, time__beta=beta, time__inner="newton"),
                                     select(self.rows, time__beta=beta, time__inner="")):
                errors = numbers([newton, plain], "error_fit_pressure")
                self.assertAlmostEqual(errors[0] / errors[1], 1, delta=2e-3)
                self.assertEqual(newton["steps"], plain["steps"])

    def test_implicit_steps_cost_several_times_as_much(self):
        explicit, = select(self.rows, time__integrator="explicit_euler", time__step_factor="0.1")
        for row in select(self.rows, time__integrator="beta_euler", time__step_factor="0.1"):
            self.assertGreater(int(row["elastic_solves"]), 3 * int(explicit["elastic_solves"]))

    def test_trapezoidal_rule_is_the_most_accurate_scheme(self):
        tight = {beta: float(select(self.rows, time__beta=beta, time__inner="")[1]["error_fit_pressure"])
                 for beta in BETAS}
        self.assertLess(10 * tight["0.5"], tight["0.75"])
        self.assertLess(1.5 * tight["0.75"], tight["1.0"])

    def test_error_control_is_cheaper(self):
        explicit, = select(self.rows, time__integrator="explicit_euler", time__step_factor="0.1")
        trapezoidal, = select(self.rows, time__beta="0.5", time__inner="", time__step_factor="0.1")
        auto = self.controlled("auto")
        for integrator in ("auto", "cvode_bdf", "cvode_adams", "arkode_erk", "arkode_dirk"):
            self.assertLess(float(self.controlled(integrator)["error_fit_pressure"]), 1e-3, integrator)
        self.assertLess(20 * float(auto["error_fit_pressure"]), float(explicit["error_fit_pressure"]))
        self.assertLess(float(auto["error_fit_pressure"]), float(trapezoidal["error_fit_pressure"]))
        self.assertLess(2 * int(auto["elastic_solves"]), int(trapezoidal["elastic_solves"]))

    def test_table_of_costs(self):
        rows = [{**row, "method": cost.method(row), "error": cost.error(row)} for row in self.rows]
        text = cost.tables(rows)
        few, many = numbers(select(self.rows, time__integrator="explicit_euler"), "elastic_solves")
        line, runs = [line for line in text.splitlines() if line.startswith("| explicit_euler |")]
        self.assertIn(f", {few:.0f}; 0.1: ", runs)
        self.assertTrue(few < int(line.split("|")[2]) < many, line)  # an error of 1e-2 lies between both runs
        self.assertIn(f"> {many:.0f}", line)


class StabilityStudy(unittest.TestCase):
    """The steady state of the thick cylinder."""

    @classmethod
    def setUpClass(cls):
        cls.rows = run_study("step_size/fast_stability.toml")

    def error(self, **settings):
        row, = select(self.rows, **settings)
        return float(row["error_hoop_100"])

    def test_explicit_euler_is_unstable_beyond_the_stable_step(self):
        for factor, least, most in (("1.0", 0, 1e-8), ("1.1", 0, 1e-8), ("1.3", 1e-3, 1), ("2.0", 1e-2, 10)):
            found = self.error(time__integrator="explicit_euler", time__step_factor=factor)
            self.assertTrue(least <= found <= most, f"{factor}: {found}")

    def test_fixed_steps_that_are_too_long_end_the_run(self):
        short, long = select(self.rows, time__integrator="explicit_euler", time__step_factor="")
        self.assertLess(float(short["error_hoop_100"]), 1e-8)
        self.assertEqual((long["status"], long["error_hoop_100"]), ("failed", ""))
        self.assertIn("stable step", long["message"])

    def test_implicit_euler_is_stable_with_any_step(self):
        for factor in ("2.0", "30.0"):
            self.assertLess(self.error(time__integrator="beta_euler", time__step_factor=factor), 1e-5)


class ResidualCorrectionStudy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rows = run_study("residual_correction/fast.toml")

    def pairs(self, inner):
        """Rows without and with correction, by inner tolerance."""
        return zip(*(select(self.rows, time__inner=inner, time__residual_correction=gamma) for gamma in ("0.0", "1.0")))

    def test_correction_takes_most_of_the_error_for_nothing(self):
        for inner, gain in (("fixed_point", 10), ("newton", 1000)):
            for without, corrected in self.pairs(inner):
                errors = numbers([without, corrected], "error_hoop_100")
                self.assertGreater(errors[0], gain * errors[1], inner)
                solves = numbers([without, corrected], "elastic_solves")
                self.assertAlmostEqual(solves[1] / solves[0], 1, delta=0.01)

    def test_residuals_follow_the_inner_tolerance(self):
        for gamma in ("0.0", "1.0"):
            loose, tight = select(self.rows, time__inner="fixed_point", time__residual_correction=gamma)
            self.assertAlmostEqual(order(loose, tight, "time.inner_tolerance", "error_hoop_100"), 1, delta=0.2)


if __name__ == "__main__":
    unittest.main()
