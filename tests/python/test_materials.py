"""Laws and materials without a model, against closed forms."""

import pathlib
import tempfile
import unittest

import numpy as np

import creepcontact as cc
from cases import CONFIGS, Case


class Materials(Case):
    def test_rate(self):
        norton = cc.law("norton", A=2e-18, n=5)
        stress = np.array([[50.0, 100.0], [150.0, 200.0]])
        np.testing.assert_allclose(norton.rate(stress), 2e-18 * stress**5, rtol=1e-14)
        self.assertAlmostEqual(norton.rate(100.0), 2e-8, 20)
        self.assertEqual(norton.laws, ["norton"])

    def test_constants_of_the_temperature(self):
        T = np.array([450.0, 500.0, 550.0])
        by_table = cc.law("norton", A={"T": [400, 600], "values": [1e-20, 3e-20]}, n=4)
        np.testing.assert_allclose(by_table.rate(100.0, T), (1e-20 + 1e-22 * (T - 400)) * 100**4, rtol=1e-12)
        by_formula = cc.law("norton", A="1e-10*exp(-20000/(T + 273))", n=4)
        np.testing.assert_allclose(by_formula.rate(100.0, T), 1e-10 * np.exp(-20000 / (T + 273)) * 1e8, rtol=1e-12)

    def test_hardening(self):
        # strain hardening: eps = A q^n t^m, so that the rate is m (A q^n)^(1/m) eps^(1 - 1/m)
        A, n, m, q = 1e-10, 3.0, 0.4, 120.0
        law = cc.law("strain_hardening", A=A, n=n, m=m)
        strain = np.array([1e-4, 1e-3, 1e-2])
        np.testing.assert_allclose(law.rate(q, 0, 0, strain), m * (A * q**n) ** (1 / m) * strain ** (1 - 1 / m), rtol=1e-9)
        times = np.geomspace(1, 1e4, 9)
        np.testing.assert_allclose(law.creep_curve(q, times).strain, A * q**n * times**m, rtol=1e-6)

    def test_relaxation(self):
        # of Norton's law: q^(1-n) = q0^(1-n) + (n - 1) E A t
        A, n, E, q0 = 1e-15, 4.0, 1.8e5, 200.0
        times = np.array([0, 1, 10, 100, 1e4])
        exact = (q0 ** (1 - n) + (n - 1) * E * A * times) ** (1 / (1 - n))
        for law, more in ((cc.law("norton", A=A, n=n), {"young_modulus": E}), (cc.law("norton", E, A=A, n=n), {})):
            np.testing.assert_allclose(law.relaxation(q0, times, **more), exact, rtol=1e-5)
        with self.assertRaisesRegex(ValueError, "young_modulus"):
            cc.law("norton", A=A, n=n).relaxation(q0, times)

    def test_rupture(self):
        B, r, q = 1e-12, 3.0, 100.0
        curve = cc.law("kachanov_rabotnov", A=1e-15, n=4, B=B, r=r, phi=r).creep_curve(q, [1.0, 1e5, 1e6])
        self.assertAlmostEqual(curve.rupture / (1 / ((1 + r) * B * q**r)), 1, 3)
        self.assertTrue(np.isfinite(curve.strain[0]) and np.isnan(curve.strain[2]))

    def test_the_library(self):
        P91 = cc.material("grade_91/swindeman_1999")
        self.assertTrue(P91.source and P91.laws)
        self.assertIn("grade_91/swindeman_1999", cc.materials("grade_91"))
        low, high = P91.temperature_range
        middle = 0.5 * (low + high)
        stress = 100.0
        self.assertGreater(P91.rate(stress, middle, 1.0), 0)
        # in other units: the same rate per second
        si = cc.material("grade_91/swindeman_1999", units="m, N, Pa, s, K")
        np.testing.assert_allclose(3600 * si.rate(1e6 * stress, middle + 273.15, 3600.0), P91.rate(stress, middle, 1.0), rtol=1e-9)
        with self.assertRaisesRegex(cc.ConfigError, "did you mean"):
            cc.material("grade_19")

    def test_a_fit(self):
        fit = cc.fit(CONFIGS / "creep_tests.csv", "kachanov_rabotnov")
        self.assertEqual(list(fit.values), list(fit.low))
        self.assertTrue(all(fit.low[k] <= fit.values[k] <= fit.high[k] for k in fit.values))
        self.assertIn("law", fit.toml)
        self.assertIn("A", fit.values)
        held = cc.fit(CONFIGS / "creep_tests.csv", "kachanov_rabotnov", set={"n": 5})
        self.assertEqual(list(held.values), [k for k in fit.values if k != "n"])

    def test_a_fit_of_batches(self):
        with tempfile.TemporaryDirectory() as scratch:
            data = pathlib.Path(scratch) / "rates.csv"
            factors = {"a": 0.5, "b": 1.0, "c": 2.0, "d": 0.7, "e": 1.4}
            data.write_text("stress,rate,batch\n" + "".join(f"{q},{f * 1e-12 * q**3},{b}\n" for b, f in factors.items() for q in (50, 100)))
            fit = cc.fit(data, "norton")
        self.assertAlmostEqual(fit.values["n"], 3, delta=1e-6)
        self.assertEqual(list(fit.batches), list(factors))
        self.assertAlmostEqual(fit.batches["c"] / fit.batches["a"], 4, delta=1e-5)
        self.assertGreater(fit.batch_deviation, 0.4)

    def test_wrong_input(self):
        for call, error, fact in ((lambda: cc.law("nortn", A=1, n=1), cc.ConfigError, "norton"),
                                  (lambda: cc.law("norton", A=1, m=1), cc.ConfigError, "'m'"),
                                  (lambda: cc.law("norton", A=1), cc.ConfigError, "n"),
                                  (lambda: cc.law("norton", A="1 +", n=1), cc.ConfigError, "A"),
                                  (lambda: cc.law("norton", A=[1, 2], n=1), Exception, ""),
                                  (lambda: cc.law("norton", A=1e-9, n=3).creep_curve(1.0, [2.0, 1.0]), ValueError, "increase"),
                                  (lambda: cc.law("norton", A=1e-9, n=3).creep_curve(1.0, [[2.0]]), ValueError, "dimension"),
                                  (lambda: cc.law("norton", A=1e-9, n=3).rate("high"), Exception, ""),
                                  (lambda: cc.law("norton", A=1e-9, n=3).rate(np.ones(2), np.ones(3)), ValueError, ""),
                                  (lambda: cc.law("ageing", A=1e-9, n=3, m=0.5).rate(1.0), ValueError, "strain itself"),
                                  (lambda: cc.fit("none.csv", "norton"), cc.ConfigError, "none.csv")):
            with self.subTest(fact=fact), self.assertRaises(error) as caught:
                call()
            self.assertSays(caught.exception, fact)


if __name__ == "__main__":
    unittest.main()
