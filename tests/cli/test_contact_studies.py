"""What the studies of contact and of meshes say holds for small cases of them."""

import importlib.util
import pathlib
import sys
import unittest

from studies import STUDIES, numbers, order, run_study, select

sys.dont_write_bytecode = True


def module(name):
    """A module of a study, by its path relative to studies/."""
    path = STUDIES / name
    spec = importlib.util.spec_from_file_location(pathlib.Path(name).stem, path)
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    return loaded


class SchwarzParameterStudy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rows = run_study("schwarz_parameter/fast.toml")
        cls.theory = module("schwarz_parameter/theory.py")

    def iterations(self, **settings):
        return numbers(select(self.rows, **settings), "schwarz_iterations")

    def constant(self, alpha, modulus):
        return self.iterations(contact_solver__alpha=alpha, materials__upper__young_modulus=modulus)

    def test_sweeps_are_those_of_theory(self):
        for alpha in (0.5, 0.3):
            for modulus in (50, 55, 65, 300):
                expected = self.theory.iterations_of_run(alpha, modulus / 10)
                self.assertEqual(self.constant(alpha, modulus), [expected], f"alpha {alpha}, modulus {modulus}")

    def test_limits(self):
        self.assertAlmostEqual(self.theory.limit(0.5), 3 + 8**0.5, 12)
        self.assertTrue(self.theory.sweeps(0.5, 5.8)[1])
        self.assertFalse(self.theory.sweeps(0.5, 5.9)[1])
        self.assertAlmostEqual(self.theory.limit(0.3), 23.74, 2)
        self.assertAlmostEqual(self.theory.limit_of_weights(1), 3 + 8**0.5, 12)

    def test_best_constant(self):
        for ratio in (2, 10, 100):
            best = self.theory.best_alpha(ratio)
            self.assertAlmostEqual(self.theory.rate(best, ratio), 1 - 2 * best, 6)
            for other in (0.97 * best, 1.03 * best):
                self.assertGreater(self.theory.rate(other, ratio), self.theory.rate(best, ratio))

    def test_weights_know_the_moduli(self):
        self.assertEqual(self.constant("diagonal", 300), [4])

    def test_weights_do_not_know_the_heights(self):
        def of(acceleration):
            return self.iterations(contact_solver__acceleration=acceleration, contact_solver__alpha="diagonal",
                                   mesh__parameters__n=4)
        low, high = of("none")
        self.assertLess(low, 30)
        self.assertGreater(high, 1000)
        self.assertLessEqual(max(of("anderson")), 12)
        self.assertEqual(of("cg"), [2, 2])


class ContactToleranceStudy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rows = run_study("contact_tolerance/fast.toml")

    def column(self, integrator, name):
        """At contact tolerances of 1e-2, 1e-5 and 1e-10; time.tolerance is 1e-4."""
        return numbers(select(self.rows, time__integrator=integrator), name)

    def test_a_tenth_of_the_tolerance_is_enough(self):
        for integrator in ("cvode_bdf", "cvode_adams"):
            for name in ("elastic_solves", "error_fit_pressure"):
                _, tenth, tight = self.column(integrator, name)
                self.assertLess(abs(tenth - tight), 0.15 * tight, f"{integrator}: {name}")

    def test_error_control_pays_for_noise(self):
        for integrator in ("cvode_bdf", "cvode_adams"):
            loose, _, tight = self.column(integrator, "elastic_solves")
            self.assertGreater(loose, 2 * tight, integrator)
            loose, _, tight = self.column(integrator, "error_fit_pressure")
            self.assertGreater(loose, 10 * tight, integrator)

    def test_fixed_steps_do_not(self):
        self.assertEqual(len(set(self.column("explicit_euler", "elastic_solves"))), 1)
        loose, _, tight = self.column("explicit_euler", "error_fit_pressure")
        self.assertLess(abs(loose - tight), 0.1 * tight)

    def test_iterations_saved(self):
        for integrator in ("cvode_bdf", "cvode_adams"):
            _, tenth, tight = self.column(integrator, "schwarz_iterations")
            self.assertLess(tenth, tight, integrator)


class FitMeshStudy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rows = run_study("mesh/fast.toml")

    def orders(self, mesh_order):
        for element in (0, 1, 2):
            coarse, fine = select(self.rows, mesh__parameters__element=element, mesh__order=mesh_order)
            yield element, -order(coarse, fine, "mesh.parameters.n", "error_fit_pressure"), fine

    def test_linear_elements(self):
        for element, observed, fine in self.orders(1):
            self.assertAlmostEqual(observed, 2, delta=0.15, msg=f"element {element}")
            self.assertLess(float(fine["error_fit_pressure"]), 3e-3)

    def test_quadratic_elements(self):
        for element, observed, fine in self.orders(2):
            self.assertLess(float(fine["error_fit_pressure"]), 2e-5)
            if element > 0:  # hexahedra are at the rounding of the bodies' distance already
                self.assertGreater(observed, 3, f"element {element}")

    def test_stress(self):
        for element, mesh_order, column, bound in ((0, 1, "error_hoop_inside", 5e-3), (0, 1, "error_hoop_at_edge", 1e-2),
                                                   (0, 2, "error_hoop_inside", 2e-5), (0, 2, "error_hoop_at_edge", 1e-4),
                                                   (1, 2, "error_hoop_inside", 2e-4), (2, 2, "error_hoop_inside", 1e-4)):
            row, = select(self.rows, mesh__parameters__element=element, mesh__order=mesh_order, mesh__parameters__n=8)
            self.assertLess(float(row[column]), bound, f"element {element}, order {mesh_order}, {column}")


class SectionMeshStudy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rows = run_study("mesh/fast_sections.toml")

    def of(self, element, mesh_order, analysis="axisymmetric"):
        return select(self.rows, analysis=analysis, mesh__parameters__element=element, mesh__order=mesh_order)

    def test_order_of_the_pressure(self):
        for element, mesh_order, expected, delta in ((0, 1, 2, 0.1), (0, 2, 4, 0.2), (1, 2, 4, 0.3)):
            coarse, fine = self.of(element, mesh_order)
            observed = -order(coarse, fine, "mesh.parameters.n", "error_fit_pressure")
            self.assertAlmostEqual(observed, expected, delta=delta, msg=f"element {element}, order {mesh_order}")

    def test_pressure(self):
        for element, mesh_order, analysis, bound in ((0, 1, "axisymmetric", 2e-4), (0, 2, "axisymmetric", 1e-7),
                                                     (1, 1, "axisymmetric", 2e-4), (1, 2, "axisymmetric", 1e-7),
                                                     (0, 2, "plane_strain", 4e-8)):
            fine = self.of(element, mesh_order, analysis)[-1]
            self.assertLess(float(fine["error_fit_pressure"]), bound, f"element {element}, order {mesh_order}, {analysis}")

    def test_stress(self):
        for element, mesh_order, column, bound in ((0, 1, "error_hoop_at_edge", 2e-3), (0, 1, "error_hoop_bore", 4e-3),
                                                   (0, 2, "error_hoop_at_edge", 1e-5), (0, 2, "error_hoop_bore", 1e-4),
                                                   (1, 2, "error_hoop_at_edge", 1e-4), (1, 2, "error_hoop_bore", 2e-4)):
            _, fine = self.of(element, mesh_order)
            self.assertLess(float(fine[column]), bound, f"element {element}, order {mesh_order}, {column}")


class CreepingFitMeshStudy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rows = run_study("mesh/fast_creep.toml")

    def test_orders(self):
        for element, mesh_order, least, most in ((0, 1, 1.9, 2.1), (1, 1, 1.2, 1.9), (1, 2, 3.0, 4.5)):
            rows = select(self.rows, mesh__parameters__element=element, mesh__order=mesh_order)
            observed = -order(*rows, "mesh.parameters.n", "error_fit_pressure")
            self.assertLess(least, observed, f"element {element}, order {mesh_order}")
            self.assertLess(observed, most, f"element {element}, order {mesh_order}")

    def test_linear_hexahedra_keep_the_stress(self):
        row, = select(self.rows, mesh__parameters__element=0, mesh__order=1, mesh__parameters__n=8)
        self.assertLess(float(row["error_hoop_at_edge"]), 5e-3)


class LineContactMeshStudy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rows = run_study("mesh/fast_hertz.toml")

    def errors(self, element, mesh_order, quantity):
        return numbers(select(self.rows, mesh__parameters__element=element, mesh__order=mesh_order),
                       f"error_{quantity}")

    def test_peak_pressure(self):
        for element, mesh_order in ((0, 1), (0, 2), (1, 2)):
            coarse, fine = self.errors(element, mesh_order, "peak_pressure")
            self.assertLess(fine, 0.006, f"element {element}, order {mesh_order}")
            self.assertGreater(coarse, 5 * fine, f"element {element}, order {mesh_order}")

    def test_peak_pressure_of_linear_wedges(self):
        coarse, fine = self.errors(1, 1, "peak_pressure")
        self.assertLess(max(coarse, fine), 0.08)  # at the plane of symmetry alone

    def test_width(self):
        # Linear wedges lock: the contact itself is off by as much.
        for element, mesh_order, bound in ((0, 1, 0.03), (0, 2, 0.005), (1, 1, 0.075), (1, 2, 0.005)):
            for error in self.errors(element, mesh_order, "area"):
                self.assertLess(error, bound, f"element {element}, order {mesh_order}")


if __name__ == "__main__":
    unittest.main()
