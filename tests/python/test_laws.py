"""Creep laws of the user, in Python and compiled, against the same ones of the library."""

import ctypes
import traceback
import unittest

import numpy as np

import creepcontact as cc
from cases import Case, shrink_fit

A, n = 2e-18, 5.0


def norton(q):
    return A * q**n


class UserLaws(Case):
    def assertClose(self, run, other, rtol=1e-6):
        np.testing.assert_allclose(run.history["fit_pressure"], other.history["fit_pressure"], rtol=rtol)

    def with_rate(self, *arguments, set=None, **more):
        model = shrink_fit(**(set or {}))
        model.set_rate("rotor", *arguments, **more)
        return model

    def test_one_of_the_stress(self):
        by_name = shrink_fit().run()
        for model in (self.with_rate(norton), self.with_rate(norton, lambda q: (A * n * q ** (n - 1), 0.0)),
                      self.with_rate(lambda *q: A * q[0] ** n, uses=["q"])):
            self.assertClose(model.run(), by_name)

    def test_implicit(self):
        by_name = shrink_fit(**{"time.integrator": "cvode_bdf"}).run()
        calls = {"rate": 0, "derivative": 0}

        def rate(q):
            calls["rate"] += 1
            return norton(q)

        def derivative(q):
            calls["derivative"] += 1
            return A * n * q ** (n - 1), np.zeros_like(q)

        self.assertClose(self.with_rate(rate, derivative, set={"time.integrator": "cvode_bdf"}).run(), by_name, 1e-5)
        self.assertGreater(calls["derivative"], 0)
        self.assertClose(self.with_rate(rate, set={"time.integrator": "cvode_bdf"}).run(), by_name, 1e-5)

    def test_hardening_and_time(self):
        def hardening(q, eps):
            return 0.5 * (1e-12 * q**3) ** 2 / eps

        def ageing(q, t, T):
            return 1e-15 * q**4 * (1 + np.exp(-t / 50)) * np.ones_like(T)

        for rate, formula in ((hardening, "0.5*(1e-12*q^3)^2/eps"), (ageing, "1e-15*q^4*(1 + exp(-t/50))")):
            expression = shrink_fit(**{"materials.rotor.creep": [{"law": "expression", "rate": formula}]}).run()
            self.assertClose(self.with_rate(rate).run(), expression, 1e-5)

    def test_compiled(self):
        function = ctypes.CFUNCTYPE(ctypes.c_double, *[ctypes.c_double] * 4)(lambda q, T, t, eps: norton(q))

        class Compiled:  # as numba.cfunc makes it
            address = ctypes.cast(function, ctypes.c_void_p).value

        self.assertClose(self.with_rate(Compiled(), uses=["q"]).run(), shrink_fit().run())

    def test_it_stays_when_keys_change(self):
        model = self.with_rate(lambda q: 0 * q)
        model["contacts[0].gap"] = -0.05
        elastic = model.variant({"materials.wheel.creep": []}).run().history["fit_pressure"]
        self.assertEqual(elastic[0], elastic[-1])

    def test_exceptions_are_those_of_the_user(self):
        def broken(q):
            raise LookupError("no data for this stress")

        def late(q, t):
            if t[0] > 1:
                raise LookupError("no data for this time")
            return norton(q)

        for rate in (broken, late):
            for integrator in ("auto", "cvode_bdf", "explicit_euler"):
                step = {"time.step": 10} if integrator == "explicit_euler" else {}
                with self.subTest(rate=rate, integrator=integrator):
                    try:
                        self.with_rate(rate, set={"time.integrator": integrator} | step).run()
                    except LookupError:
                        self.assertIn("raise LookupError", traceback.format_exc())
                    else:
                        self.fail("the exception is lost")

    def test_wrong_shapes_and_values(self):
        for rate, fact in ((lambda q: np.ones(3), "3 values for"), (lambda q: "fast", "not an array of numbers"), (lambda q: {}, "not an array of numbers")):
            with self.subTest(fact=fact), self.assertRaises((ValueError, TypeError)) as caught:
                self.with_rate(rate).run()
            self.assertSays(caught.exception, fact)
        with self.assertRaises(cc.Error):
            self.with_rate(lambda q: np.nan * q).run()
        with self.assertRaisesRegex(ValueError, "found: stress"):
            self.with_rate(lambda stress: stress)
        with self.assertRaisesRegex(cc.ConfigError, "did you mean 'rotor'"):
            shrink_fit().set_rate("roter", norton)


if __name__ == "__main__":
    unittest.main()
