"""Models: their keys, what they refuse, what is kept between runs."""

import os
import pickle
import signal
import threading
import traceback
import unittest

import numpy as np

import creepcontact as cc
from cases import CONFIGS, SHORT, Case, shrink_fit

BLOCK = """
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Transfinite Curve "*" = 2; Transfinite Surface "*"; Recombine Surface "*"; Transfinite Volume "*";
Physical Volume("block") = {1};
Physical Surface("left") = {1}; Physical Surface("right") = {2}; Physical Surface("front") = {3}; Physical Surface("bottom") = {5};
"""
#: A block that is pulled by 100 MPa and creeps by 1e-12 q^3.
PULLED = {
    "units": "mm, N, MPa, h, degC",
    "mesh": {"file": "block.geo", "order": 2},
    "bodies": {"block": {"region": "block", "material": "steel"}},
    "materials": {"steel": {"young_modulus": 2e5, "poisson_ratio": 0.3, "creep": [{"law": "norton", "A": 1e-12, "n": 3}]}},
    "supports": [{"on": "left", "displacement": {"x": 0}}, {"on": "front", "displacement": {"y": 0}},
                 {"on": "bottom", "displacement": {"z": 0}}],
    "loads": [{"on": "right", "pressure": np.float64(-100)}],
    "time": {"end": 1000, "output": np.array([10.0, 1000.0])},
    "probes": [{"name": "strain", "quantity": "creep_strain_xx", "at": (1, 0.5, 0.5), "body": "block"}],
}


class Models(Case):
    def pulled(self, **set):
        (self.directory / "block.geo").write_text(BLOCK)
        return cc.Model(PULLED, set=set, directory=self.directory)

    def test_of_a_dict(self):
        run = self.pulled().run()
        np.testing.assert_array_equal(run.history["time"], [0, 10, 1000])
        np.testing.assert_allclose(run.history["strain"], 1e-12 * 100**3 * run.history["time"], rtol=1e-6)
        self.assertEqual(run.status, "completed")

    def test_of_a_file_as_the_command_runs_it(self):
        self.command("run", CONFIGS / "shrink_fit.toml", "--output", "out", "--quiet", "--set", "time.end=1000", "--set",
                     "time.output=[1, 100, 1000]")
        by_command, by_module = cc.open(self.directory / "out"), shrink_fit().run()
        self.assertEqual(by_command.history.dtype, by_module.history.dtype)
        for name in by_command.history.dtype.names:
            np.testing.assert_array_equal(by_command.history[name], by_module.history[name])
        for name in by_command.steps.dtype.names:
            np.testing.assert_array_equal(by_command.steps[name], by_module.steps[name])
        self.assertEqual(by_command.summary["contacts"], by_module.summary["contacts"])

    def test_keys_are_attributes(self):
        model = shrink_fit()
        self.assertEqual(model.time.end, 1000)
        self.assertEqual(model.contacts[0].gap, -0.09)
        self.assertEqual(model.materials.rotor.creep[0].A, 2e-18)
        self.assertEqual(model["contacts[0].gap"], -0.09)
        self.assertEqual(model.time.tolerance, 1e-4)  # the default
        self.assertIsNone(model["time.tolerance"])
        self.assertEqual(list(model.bodies), ["shaft", "disc"])
        self.assertIn("end", dir(model.time))
        self.assertIn("rotor", dir(model.materials))
        self.assertIn("contacts", dir(model))
        self.assertSays(type(model.time).end.__doc__, "Allowed: ")

        model.contacts[0].gap = -0.05
        self.assertEqual(model.contacts[0].gap, -0.05)
        model["materials.rotor.creep[0].A"] = 1e-18
        self.assertEqual(model.materials["rotor"].creep[0].A, 1e-18)
        self.assertSays(model.to_toml(), "gap = -0.05")
        with self.assertRaisesRegex(AttributeError, "no key 'ende'"):
            model.time.ende = 5
        with self.assertRaisesRegex(AttributeError, "no key 'times'"):
            model.times = {}
        with self.assertRaises(IndexError):
            model.contacts[1]
        with self.assertRaisesRegex(KeyError, "rotor"):
            model.materials["roter"]

    def test_what_is_not_allowed_changes_nothing(self):
        model = shrink_fit()
        with self.assertRaises(cc.ConfigError) as caught:
            model.time.tolerance = -1
        mistake, = caught.exception.mistakes
        self.assertEqual(mistake.key, "time.tolerance")
        self.assertEqual(model.time.tolerance, 1e-4)
        for wrong in (float("nan"), object(), {1: 2}):
            with self.subTest(wrong=wrong), self.assertRaises((TypeError, ValueError)):
                model.contacts[0].gap = wrong
        self.assertEqual(model.contacts[0].gap, -0.09)

    def test_mistakes_one_by_one(self):
        file = self.directory / "bad.toml"
        file.write_text((CONFIGS / "shrink_fit.toml").read_text().replace("poisson_ratio", "poison_ratio")
                        .replace('law = "norton"', 'law = "nortn"'))
        with self.assertRaises(cc.ConfigError) as caught:
            cc.Model(file)
        mistakes = caught.exception.mistakes
        self.assertGreater(len(mistakes), 2)
        self.assertTrue(all(m.line > 0 and m.file == str(file) for m in mistakes), mistakes)
        self.assertIn("did you mean 'poisson_ratio'", " ".join(m.text for m in mistakes))
        with self.assertRaises(cc.ConfigError):
            cc.Model(self.directory / "none.toml")
        with self.assertRaises(TypeError):
            cc.Model({"time": {"end": {1, 2}}})

    def test_check(self):
        self.assertSays(shrink_fit().check(), "no mistakes found", "body 'shaft'")
        self.assertSays(shrink_fit().check(start=True), "contact 'fit'")
        with self.assertRaises(cc.ModelError) as caught:
            shrink_fit(**{"supports[0].on": "nowhere"}).check()
        self.assertSays(caught.exception, "nowhere")

    def test_start(self):
        model = shrink_fit()
        start = model.start()
        np.testing.assert_array_equal(start.history["time"], [0])
        fields = start.fields()
        self.assertEqual(len(fields["von_mises"]), len(start.mesh.points))
        np.testing.assert_allclose(start.history["fit_pressure"][0], model.run().history["fit_pressure"][0], rtol=1e-12)

    def test_the_mesh_and_the_factors_are_kept(self):
        model = shrink_fit()
        fresh = [shrink_fit(**{"materials.rotor.creep[0].A": A}).run() for A in (1e-18, 4e-18)]
        kept = []
        for A in (1e-18, 4e-18):
            model["materials.rotor.creep[0].A"] = A
            kept.append(model.run())
        for one, other in zip(fresh, kept):
            for name in one.history.dtype.names:
                np.testing.assert_array_equal(one.history[name], other.history[name])
        self.assertEqual(model.counters, {"meshes_read": 1, "factorizations": 2, "factors_found": 2})  # of two bodies
        self.assertEqual([run.summary["factorizations"] for run in kept], [2, 0])
        self.assertEqual(model.variant({"contacts[0].gap": -0.05}).run().summary["factorizations"], 0)
        # Another stiffness is factored again, another mesh is read again.
        model.materials.rotor.young_modulus = 1.9e5
        self.assertEqual(model.run().summary["factorizations"], 1)
        model["mesh.parameters"] = {"n_disc": 6}
        model.run()
        self.assertEqual(model.counters["meshes_read"], 2)

    def test_after_a_run_that_failed(self):
        # Far beyond the stable step, once the interference grows.
        model = shrink_fit(**{"time.integrator": "beta_euler", "time.step": 100, "time.end": 1e4, "time.output": [100, 200],
                              "contacts[0].gap": {"t": [200, 300], "values": [-0.09, -0.9]}, "mesh.order": 1})
        with self.assertRaises(cc.SolverError) as caught:
            model.run()
        self.assertEqual(caught.exception.run.status, "failed")
        self.assertEqual(list(caught.exception.run.history["time"]), [0, 100, 200])
        sound = model.variant(SHORT | {"time.integrator": "auto", "contacts[0].gap": -0.09, "mesh.order": 2}).run()
        np.testing.assert_array_equal(sound.history["fit_pressure"], shrink_fit().run().history["fit_pressure"])

    def test_two_models_in_two_threads(self):
        gaps, runs = (-0.05, -0.08), {}

        def work(gap):
            runs[gap] = shrink_fit(**{"contacts[0].gap": gap}).run()

        threads = [threading.Thread(target=work, args=(gap,)) for gap in gaps]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for gap in gaps:
            alone = shrink_fit(**{"contacts[0].gap": gap}).run()
            np.testing.assert_array_equal(runs[gap].history["fit_pressure"], alone.history["fit_pressure"])

    def test_models_are_not_pickled(self):
        with self.assertRaisesRegex(TypeError, "pickle"):
            pickle.dumps(shrink_fit())


class Messages(Case):
    def test_they_go_to_logging(self):
        with self.assertLogs("creepcontact", "INFO") as logged:
            shrink_fit().run()
        self.assertTrue(any("contact 'fit'" in line for line in logged.output), logged.output)

    def test_warnings_belong_to_their_run(self):
        warned = shrink_fit(**{"contact_solver.tolerance": 1e-3})
        runs = {}
        threads = [threading.Thread(target=lambda k=k, m=m: runs.setdefault(k, m.run()))
                   for k, m in (("loud", warned), ("quiet", shrink_fit()))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertTrue(runs["loud"].warnings)
        self.assertEqual(runs["quiet"].warnings, [])


class Observers(Case):
    def test_progress(self):
        seen = []
        run = shrink_fit().run(progress=lambda time, share: seen.append((time, share)))
        self.assertEqual(len(seen), len(run.steps))
        self.assertEqual(seen[-1], (1000, 1))

    def test_states(self):
        outer = self

        class Watch:
            times, last, outputs = [], None, []

            def on_step(self, state):
                self.times.append(state.time)
                outer.assertGreater(state.step, 0)
                self.last = state

            def on_output(self, state):
                self.outputs.append((state.time, state.probes["fit_pressure"]))

        watch = Watch()
        run = shrink_fit().run(observers=[watch])
        self.assertEqual(watch.times, list(run.steps["time"]))
        self.assertEqual(watch.outputs, list(zip(run.history["time"], run.history["fit_pressure"])))
        with self.assertRaisesRegex(RuntimeError, "only within the call"):
            watch.last.time

    def test_one_that_stops(self):
        class Stop:
            def on_step(self, state):
                return state.probes["fit_pressure"] > 64.5

        run = shrink_fit().run(observers=[Stop()])
        self.assertEqual(run.status, "completed")
        self.assertLess(run.summary["time_reached"], 1000)
        self.assertLessEqual(run.history["fit_pressure"][-1], 64.5)

    def test_one_that_raises(self):
        class Broken:
            def on_step(self, state):
                return {}[state.time]

        for observer in (Broken(), type("OnOutput", (), {"on_output": Broken.on_step})()):
            with self.subTest(observer=observer):
                try:
                    shrink_fit().run(observers=[observer])
                except KeyError:
                    self.assertIn("return {}[state.time]", traceback.format_exc())
                else:
                    self.fail("the exception is lost")

    def test_ctrl_c(self):
        model = shrink_fit(**{"time.end": 1e6, "time.output": [1e6]})
        with self.assertRaises(KeyboardInterrupt) as caught:
            model.run(progress=lambda time, share: os.kill(os.getpid(), signal.SIGINT) if share > 0 and time < 10 else None)
        self.assertEqual(caught.exception.run.status, "interrupted")
        self.assertEqual(model.run().status, "completed")

    def test_wrong_arguments(self):
        for wrong in (0, -1, 1.5, "two", True):
            with self.subTest(threads=wrong), self.assertRaises(ValueError):
                shrink_fit().run(threads=wrong)
        with self.assertRaises(ValueError):
            shrink_fit().run(resume=True)
        with self.assertRaises(TypeError):
            shrink_fit().run(progress=3)


if __name__ == "__main__":
    unittest.main()
